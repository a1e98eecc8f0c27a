// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors
//
// Error against run time: the force peak of the peeling scene over cells x Gauss
// points for the section-beam law (SBIP) and the section-section law (SSIP), each
// against a fine reference of its own; and what an iteration costs where both
// reach the same accuracy of the force.

#include "peeling_curve.h"

#include <deal.II/base/convergence_table.h>

#include <fstream>
#include <iostream>

namespace Setae
{
  namespace Peeling
  {
    namespace
    {
      /** A mesh and a quadrature: ten Gauss points in each segment. */
      struct Resolution
      {
        unsigned int n_cells, n_segments;
      };

      struct Result
      {
        double peak, energy, cpu_time, time_per_iteration;
      };

      class WorkPrecision
      {
      public:
        explicit WorkPrecision(const std::string &prm)
          : prm(prm)
        {}

        bool
        run()
        {
          std::ofstream csv("work_precision.csv");
          csv << "law,cells,points per cell,peak error,energy error,CPU time,"
                 "CPU time per iteration\n";
          const double beam =
            study("disk-cylinder",
                  {{16, 1}, {16, 2}, {32, 1}, {32, 2}, {64, 1}, {64, 2}, {128, 1}},
                  {256, 2},
                  csv);
          const double section =
            study("disk-disk",
                  {{16, 8}, {32, 2}, {32, 4}, {32, 8}, {64, 1}, {64, 2}, {64, 4},
                   {128, 1}, {128, 2}},
                  {128, 8},
                  csv);

          const double ratio = section / beam;
          std::cout << "\nCPU time of one iteration with a peak force right to "
                    << accuracy << ": SSIP over SBIP = " << ratio
                    << " (required: at least " << smallest_ratio << ") "
                    << (ratio >= smallest_ratio ? "reached" : "MISSED")
                    << std::endl;
          return ratio >= smallest_ratio;
        }

      private:
        static constexpr double accuracy = 1e-3, smallest_ratio = 5.;

        Result
        solve(const std::string &law, const Resolution &resolution) const
        {
          // The same load steps in all runs, past the peak.
          const Overrides steps = {"load stepping/first step=1e-5",
                                   "load stepping/largest step=1e-5",
                                   "load stepping/end time=2e-4"};
          const Curve     curve =
            Peeling::run(prm,
                         steps + point_potential(law, -1e-7, 5e-25) +
                           cells(resolution.n_cells) +
                           integration(resolution.n_segments, 10));
          return {curve.peak().force,
                  curve.points.back().energy,
                  curve.summary.cpu_time,
                  curve.summary.cpu_time / curve.summary.n_iterations};
        }

        /**
         * @return The smallest time of an iteration among the resolutions that
         * are accurate enough [s].
         */
        double
        study(const std::string &            law,
              const std::vector<Resolution> &resolutions,
              const Resolution &             finest,
              std::ofstream &                csv) const
        {
          const Result             reference = solve(law, finest);
          dealii::ConvergenceTable table;
          double                   best = std::numeric_limits<double>::infinity();
          for (const Resolution &resolution : resolutions)
            {
              const Result result = solve(law, resolution);
              const double peak_error =
                std::abs(result.peak / reference.peak - 1.);
              const double energy_error =
                std::abs(result.energy / reference.energy - 1.);
              const unsigned int n_points = 10 * resolution.n_segments;
              table.add_value("cells", resolution.n_cells);
              table.add_value("points per cell", n_points);
              table.add_value("peak error", peak_error);
              table.add_value("energy error", energy_error);
              table.add_value("CPU time [s]", result.cpu_time);
              table.add_value("ms per iteration",
                              1e3 * result.time_per_iteration);
              csv << law << ',' << resolution.n_cells << ',' << n_points << ','
                  << peak_error << ',' << energy_error << ','
                  << result.cpu_time << ',' << result.time_per_iteration
                  << '\n';
              if (peak_error <= accuracy)
                best = std::min(best, result.time_per_iteration);
            }
          for (const char *column : {"peak error", "energy error"})
            {
              table.set_scientific(column, true);
              table.set_precision(column, 2);
            }
          std::cout << '\n'
                    << law << ", reference: " << finest.n_cells << " cells x "
                    << 10 * finest.n_segments << " points, "
                    << reference.cpu_time << " s\n";
          table.write_text(std::cout);
          return best;
        }

        const std::string prm;
      };
    } // namespace
  }   // namespace Peeling
} // namespace Setae



int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  try
    {
      const std::string folder = argv[1];
      const std::string prm =
        Setae::read_file(folder + "/../../prm/peeling.prm");
      return Setae::Peeling::WorkPrecision(prm).run() ? 0 : 1;
    }
  catch (const std::exception &error)
    {
      std::cerr << error.what() << std::endl;
      return 1;
    }
}
