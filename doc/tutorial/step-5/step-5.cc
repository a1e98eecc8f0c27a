// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

// Step 5: two charged fibers snap into contact. Print where the energy is on
// the way, and how much of it the time integration loses: with and without
// numerical damping, and with a force that conserves it.

#include <deal.II/base/mpi.h>

#include <setae/fiber_problem.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <sstream>
#include <utility>

using namespace Setae;

namespace
{
  // The charge is switched on until this time and does work on the fibers;
  // from then on the total energy has to stay what it is.
  constexpr double ramp = 1e-3;

  // The table has every n-th time step.
  constexpr unsigned int table_interval = 10;

  void
  run(const Scene &scene, const bool is_first)
  {
    std::ostringstream log;
    FiberProblem       problem(scene, MPI_COMM_WORLD, log);
    if (is_first)
      std::cout << scene.dynamics.integrator
                << ", rho infinity = " << scene.dynamics.rho_infinity
                << "\n  time      kinetic     strain      interaction contact  "
                   "   total\n";

    double           reference = 0., drift = 0.;
    const RunSummary summary = problem.run([&](const StepRecord &record) {
      // The terms are strain, then the interactions in the order of the scene.
      const std::vector<double> &energies = record.evaluation.energies;
      const double               total    = record.motion->total_energy;
      if (std::abs(record.time - ramp) < 1e-9)
        reference = total;
      if (reference != 0.)
        drift = std::max(drift, std::abs(total / reference - 1.));
      if (!is_first || record.step % table_interval != 0)
        return;
      std::cout << std::scientific << std::setprecision(2) << "  "
                << record.time << std::setprecision(3) << "  "
                << record.motion->momenta.kinetic_energy;
      for (const double energy : energies)
        std::cout << "  " << energy;
      std::cout << "  " << total << '\n';
    });

    if (is_first)
      std::cout << "drift " << std::setprecision(1) << drift << " in "
                << summary.n_steps << " steps with " << summary.n_iterations
                << " iterations, smallest gap " << summary.smallest_gap
                << "\n\n"
                << std::defaultfloat;
  }
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
        std::cout << "Usage: step-5 snap.prm [section/name=value ...]\n";
      return 1;
    }

  try
    {
      std::ifstream     file(argv[1]);
      std::stringstream text;
      text << file.rdbuf();
      AssertThrow(file, dealii::ExcFileNotOpen(argv[1]));

      // The scene lasts minutes; this is its beginning, unless the command line
      // says otherwise.
      for (const auto &[integrator, rho_infinity] :
           {std::pair("generalized-alpha", "0.9"),
            std::pair("generalized-alpha", "1"),
            std::pair("energy-conserving", "1")})
        {
          std::vector<std::string> overrides = {"dynamics/end time=2e-3"};
          overrides.insert(overrides.end(), argv + 2, argv + argc);
          overrides.push_back(std::string("dynamics/integrator=") + integrator);
          overrides.push_back(std::string("dynamics/rho infinity=") +
                              rho_infinity);
          run(Scene::read(text.str(), argv[1], overrides), is_first);
        }
    }
  catch (const std::exception &exception)
    {
      std::cerr << exception.what() << '\n';
      return 1;
    }
  return 0;
}
