// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

// Step 2: peeling. Run a scene from a program of one's own, print the
// force-displacement curve and find the force peak and the pull-off. The driver
// that does the work is walked through in doc/results.md.

#include <deal.II/base/mpi.h>

#include <setae/fiber_problem.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <sstream>

using namespace Setae;

namespace
{
  // One point of the curve: the gap of the ends and the force that holds them.
  struct CurvePoint
  {
    double u_x;   // [length]
    double force; // [force]
  };

  // A sudden pull-off leaves nothing of the force between one step and the
  // next.
  constexpr double pulled_off = 1e-6;
} // namespace



int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const bool                               is_first =
    dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
  if (argc < 2)
    {
      if (is_first)
        std::cout << "Usage: step-2 peeling.prm [section/name=value ...]\n";
      return 1;
    }

  try
    {
      // A scene is text. What follows the name of the file on the command line
      // changes single entries, as --set does for the program `setae`.
      std::ifstream     file(argv[1]);
      std::stringstream text;
      text << file.rdbuf();
      AssertThrow(file, dealii::ExcFileNotOpen(argv[1]));
      const Scene scene =
        Scene::read(text.str(), argv[1], {argv + 2, argv + argc});

      // The pulled support moves by u; the fibers begin at the equilibrium gap,
      // so that the gap of the ends is u_x = u + g_eq.
      const double g_eq   = scene.interactions.at(0).equilibrium_gap;
      const double length = scene.fibers.at(0).length;

      // The constructor builds mesh, energy terms and constraints and checks
      // the scene. run() with a visitor calls it after each load step and
      // writes no files.
      FiberProblem            problem(scene, MPI_COMM_WORLD, std::cout);
      std::vector<CurvePoint> curve;
      const RunSummary summary = problem.run([&](const StepRecord &record) {
        for (const SupportReport &support : record.supports)
          if (support.name == "right")
            curve.push_back(
              {support.displacement[0] + g_eq, support.reaction[0]});
      });

      if (!is_first)
        return 0;

      // The unit of force of the paper is the load in the middle that deflects
      // a simply supported fiber by a quarter of its length. With large
      // rotations it is 1.364 times that of linear theory, 12 EI/l^2.
      const FiberParameters &fiber = scene.fibers.at(0);
      const double           EI =
        fiber.youngs_modulus * M_PI * std::pow(fiber.radius, 4) / 4.;
      const double unit = 1.364 * 12. * EI / (length * length);

      std::cout << "    u_x/l   force\n" << std::scientific;
      for (const CurvePoint &point : curve)
        std::cout << std::setprecision(4) << "  " << point.u_x / length << "  "
                  << std::setw(11) << point.force / unit << '\n';

      const auto peak =
        std::max_element(curve.begin(),
                         curve.end(),
                         [](const CurvePoint &a, const CurvePoint &b) {
                           return a.force < b.force;
                         });
      // The last point at which the fibers still hold each other.
      const auto last =
        std::find_if(curve.rbegin(), curve.rend(), [&](const CurvePoint &p) {
          return std::abs(p.force) > pulled_off * peak->force;
        });
      std::cout << std::defaultfloat << "\nForce peak " << peak->force / unit
                << " at u_x/l = " << peak->u_x / length << '\n';
      if (last == curve.rbegin())
        std::cout << "No pull-off up to u_x/l = " << last->u_x / length << '\n';
      else
        std::cout << "Pull-off after u_x/l = " << last->u_x / length
                  << ", force there " << last->force / unit << '\n';
      std::cout << summary.n_steps << " load steps, " << summary.n_iterations
                << " iterations, " << summary.n_snaps
                << " instabilities passed\n";
    }
  catch (const std::exception &exception)
    {
      std::cerr << exception.what() << '\n';
      return 1;
    }
  return 0;
}
