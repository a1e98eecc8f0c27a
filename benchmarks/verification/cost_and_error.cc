// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

// Cost and error of the full quadrature over two solid bodies as functions of
// the gap, down to where it stops being affordable, beside the section-section
// and the section-beam law: cylinders of slenderness 10 that are parallel or
// cross, and a bent one beside a straight one, R = 1, unit densities.
// Zero is returned if three digits at g/R = 0.1 take less than a minute for all
// of them. The ratio of run times is that at the error of SBIP: the tolerance
// of the full quadrature is then as large as the error that SBIP turned out to
// have.

#include <deal.II/base/mpi.h>
#include <deal.II/base/table_handler.h>

#include <setae/verification/verification.h>

#include <fstream>
#include <iostream>
#include <sstream>

namespace Setae
{
  namespace
  {
    constexpr double length = 20.;

    /** How the second fiber lies to the first one, which is on the x-axis. */
    struct Geometry
    {
      std::string name;
      std::string centerline; ///< at z = 0
      double      angle;      ///< 0: no exact energy is known
    };

    const Geometry geometries[] = {
      {"parallel", "s - l/2; 0; GAP", 0.},
      {"crossing, 45 deg",
       "(s - l/2)/sqrt(2); (s - l/2)/sqrt(2); GAP",
       M_PI / 4.},
      {"crossing, 90 deg", "0; s - l/2; GAP", M_PI / 2.},
      {"bent to a radius of 20 R",
       "l*sin((s - l/2)/l); 0; GAP + l*(1 - cos((s - l/2)/l))",
       0.}};

    /** Both fibers at rest with the given law. */
    Scene
    scene(const Geometry    &geometry,
          const double       gap,
          const unsigned int exponent,
          const std::string &law,
          const unsigned int n_cells)
    {
      std::ostringstream text;
      text << "set coordinates = "
           << (geometry.angle == 0. ? "x, z" : "x, y, z") << '\n'
           << "set constants = l = " << length << ", GAP = " << 2. + gap
           << "\nset verification = full 6D quadrature\n"
           << "subsection fibers\nset names = first, second\n";
      for (const bool is_first : {true, false})
        text << "subsection " << (is_first ? "first" : "second")
             << "\nset centerline = "
             << (is_first ? "s - l/2; 0; 0" : geometry.centerline)
             << "\nset length = " << length
             << "\nset radius = 1\nset cells = " << n_cells << "\nend\n";
      text
        << "end\nsubsection interactions\nset names = potential\n"
        << "subsection potential\nset law = " << law
        << "\nset source = first\nset target = second\nset exponents = "
        << exponent << "\nset prefactors = -1\nset cutoff = " << gap + 100.
        << "\nset switch width = 0.1\nset integration tolerance = 0\nend\nend\n";
      return Scene::read(text.str(), "benchmark.prm");
    }

    Verification
    evaluate(Scene scene, const FullQuadratureParameters &parameters)
    {
      scene.full_quadrature = parameters;
      const FiberSystem fibers(scene, MPI_COMM_SELF);
      State             state;
      state.displacement = fibers.initial;
      state.current      = fibers.initial;
      return verify(fibers, state).at(0);
    }

    /** For a law alone. */
    FullQuadratureParameters
    none()
    {
      FullQuadratureParameters parameters;
      parameters.max_n_cells = 0.;
      return parameters;
    }

    /**
     * Crossing infinite cylinders: the integrals along both axes are known,
     * those over the depths are Gauss-Chebyshev sums. What is beyond the ends
     * of finite ones is taken between the axes.
     */
    double
    exact_energy(const double gap, const double angle, const unsigned int m)
    {
      constexpr unsigned int n   = 2000;
      double                 sum = 0.;
      std::vector<double>    depth(n), weight(n);
      for (unsigned int i = 0; i < n; ++i)
        {
          const double theta = M_PI * (i + 1) / (n + 1);
          depth[i]           = std::cos(theta);
          weight[i] = 2. * M_PI / (n + 1) * std::sin(theta) * std::sin(theta);
        }
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = 0; j < n; ++j)
          sum += weight[i] * weight[j] *
                 std::pow(2. + gap - depth[i] - depth[j], 2. - m);
      const double infinite = 2. * M_PI / (m - 2.) / std::sin(angle) * sum;

      // Axis against axis: all minus what is within the ends (midpoint rule).
      const double d = 2. + gap;
      const double all =
        2. * M_PI / (m - 2.) / std::sin(angle) * std::pow(d, 2. - m);
      constexpr unsigned int n_axis = 1000;
      const double           h      = length / n_axis;
      double                 within = 0.;
      for (unsigned int i = 0; i < n_axis; ++i)
        for (unsigned int j = 0; j < n_axis; ++j)
          {
            const double s = (i + .5) * h - length / 2.,
                         t = (j + .5) * h - length / 2.;
            within +=
              h * h *
              std::pow(s * s + t * t - 2. * s * t * std::cos(angle) + d * d,
                       -.5 * m);
          }
      return -(infinite - M_PI * M_PI * (all - within));
    }



    class CostAndError
    {
    public:
      bool
      run()
      {
        for (const unsigned int exponent : {6, 12})
          for (const Geometry &geometry : geometries)
            for (const double gap : {10., 1., .3, .1, .03, .01})
              add(exponent, geometry, gap);
        for (const char *column : {"estimate",
                                   "true error",
                                   "SBIP error",
                                   "SSIP error",
                                   "pairs",
                                   "CPU time [s]",
                                   "time over SBIP"})
          {
            table.set_precision(column, 1);
            table.set_scientific(column, true);
          }
        table.set_precision("energy", 8);
        table.set_scientific("energy", true);
        table.write_text(std::cout, dealii::TableHandler::org_mode_table);
        std::cout << "At g/R = 0.1, an estimated error below 1e-3 takes "
                  << slowest << " s at most (required: 60 s).\n"
                  << "At the error of SBIP, the full quadrature takes "
                  << smallest_ratio << " to " << largest_ratio
                  << " times its run time (expected: 1e5).\n";
        return is_good && slowest < 60.;
      }

    private:
      void
      add(const unsigned int m, const Geometry &geometry, const double gap)
      {
        FullQuadratureParameters parameters;
        parameters.max_n_pairs = 3e10;
        const Verification beam =
          evaluate(scene(geometry, gap, m, "disk-cylinder", 16), parameters);
        const Verification sections =
          evaluate(scene(geometry, gap, m, "disk-disk", 64), none());
        const FullQuadrature &full = beam.full;
        if (!std::isfinite(full.error))
          {
            std::cout
              << geometry.name << ", m = " << m << ", gap " << gap
              << ": stops being affordable here, more than 1e6 cells or "
                 "3e10 pairs of points (one minute)\n";
            return;
          }

        // Exact, or else with a tolerance that is a hundred times smaller.
        double     reference = std::numeric_limits<double>::quiet_NaN();
        const bool is_exact  = geometry.angle > 0. && gap < 1.;
        if (is_exact)
          reference = exact_energy(gap, geometry.angle, m);
        else if (gap >= .1)
          {
            parameters.tolerance = 1e-5;
            const FullQuadrature fine =
              evaluate(scene(geometry, gap, m, "disk-cylinder", 16), parameters)
                .full;
            reference = fine.value.energy;
          }
        const double energy = full.value.energy;
        const double best   = std::isfinite(reference) ? reference : energy;

        table.add_value("m", m);
        table.add_value("fibers", geometry.name);
        table.add_value("g/R", gap);
        table.add_value("energy", energy);
        table.add_value("points", full.n_points);
        table.add_value("estimate", full.error);
        table.add_value("true error", std::abs(energy / reference - 1.));
        table.add_value("against",
                        is_exact                 ? "exact" :
                        std::isfinite(reference) ? "1e-5" :
                                                   "-");
        table.add_value("cells", full.n_cells);
        table.add_value("pairs", full.n_pairs);
        table.add_value("CPU time [s]", full.cpu_time);
        table.add_value("SBIP error", beam.without_cutoff.energy / best - 1.);
        table.add_value("SSIP error",
                        sections.without_cutoff.energy / best - 1.);

        // As inaccurate as SBIP.
        parameters.tolerance =
          std::max(1e-3, std::abs(beam.without_cutoff.energy / best - 1.));
        const double ratio =
          evaluate(scene(geometry, gap, m, "disk-cylinder", 16), parameters)
            .full.cpu_time /
          beam.cpu_time_without_cutoff;
        smallest_ratio = std::min(smallest_ratio, ratio);
        largest_ratio  = std::max(largest_ratio, ratio);
        table.add_value("time over SBIP", ratio);
        std::ofstream csv("cost_and_error.csv",
                          is_first ? std::ios::trunc : std::ios::app);
        if (is_first)
          csv << "m,fibers,gap,estimate,error,cells,pairs,seconds,sbip_error,"
                 "sbip_seconds,ssip_error,ssip_seconds\n";
        is_first = false;
        csv << m << ",\"" << geometry.name << "\"," << gap << ',' << full.error
            << ',' << std::abs(energy / reference - 1.) << ',' << full.n_cells
            << ',' << full.n_pairs << ',' << full.cpu_time << ','
            << beam.without_cutoff.energy / best - 1. << ','
            << beam.cpu_time_without_cutoff << ','
            << sections.without_cutoff.energy / best - 1. << ','
            << sections.cpu_time_without_cutoff << '\n';

        if (gap == .1)
          {
            slowest = std::max(slowest, full.cpu_time);
            is_good = is_good && full.error < 1e-3 &&
                      !(std::abs(energy / reference - 1.) > 1e-3);
          }
      }

      dealii::TableHandler table;
      bool                 is_first = true;
      bool                 is_good  = true;
      double               slowest  = 0.;
      double smallest_ratio         = std::numeric_limits<double>::infinity();
      double largest_ratio          = 0.;
    };
  } // namespace
} // namespace Setae



int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  try
    {
      return Setae::CostAndError().run() ? 0 : 1;
    }
  catch (const std::exception &error)
    {
      std::cerr << error.what() << std::endl;
      return 1;
    }
}
