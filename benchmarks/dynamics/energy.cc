// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors
//
// The energy of the two fibers that snap into contact (SSIP paper, Sec. 7.4),
// from the end of the ramp of the charge on: the paper keeps it within 2% with
// rho infinity = 0.9 and time steps of 1e-5; here by energy-conserving steps,
// also without numerical damping and with steps ten times longer, and by plain
// generalized-alpha for comparison, of which nothing is required.

#include <deal.II/base/convergence_table.h>

#include <iostream>
#include <limits>

#include "snap.h"

namespace Setae
{
  namespace Snap
  {
    namespace
    {
      /** @return Whether the energy is kept as required. */
      bool
      study(const std::string &prm)
      {
        struct Case
        {
          const char *integrator, *rho_infinity, *time_step;
          double      required; ///< largest deviation of the energy, or none
        };
        constexpr double ramp = 1e-3, R = .02,
                         none = std::numeric_limits<double>::infinity();
        bool                     is_kept = true;
        dealii::ConvergenceTable table;
        for (const Case &c : {Case{"energy-conserving", "0.9", "1e-5", .02},
                              Case{"energy-conserving", "1", "1e-5", .005},
                              Case{"energy-conserving", "0.9", "1e-4", .05},
                              Case{"energy-conserving", "1", "1e-4", .005},
                              Case{"generalized-alpha", "0.9", "1e-5", none},
                              Case{"generalized-alpha", "1", "1e-5", none}})
          {
            const Result result =
              run(prm,
                  {std::string("dynamics/integrator=") + c.integrator,
                   std::string("dynamics/rho infinity=") + c.rho_infinity,
                   std::string("dynamics/time step=") + c.time_step});
            const auto deviation = result.energy_deviation(ramp);
            table.add_value("integrator", std::string(c.integrator));
            table.add_value("rho infinity", std::string(c.rho_infinity));
            table.add_value("time step", std::string(c.time_step));
            table.add_value("steps", result.summary.n_steps);
            table.add_value("rejected", result.summary.n_rejected_steps);
            table.add_value("iterations", result.summary.n_iterations);
            table.add_value("largest deviation", deviation[0]);
            table.add_value("at the end", deviation[1]);
            table.add_value("required", c.required);
            table.add_value("smallest gap/R", result.summary.smallest_gap / R);
            table.add_value("CPU time [s]", result.summary.cpu_time);
            // Axes that pass each other have a gap of -2 R on the way.
            is_kept = is_kept && deviation[0] <= c.required &&
                      result.summary.smallest_gap > -R;
          }
        for (const char *column : {"largest deviation", "at the end"})
          {
            table.set_precision(column, 2);
            table.set_scientific(column, true);
          }
        table.write_text(std::cout);
        std::cout << "The energy is kept as required, and no fiber passes the "
                     "other: "
                  << (is_kept ? "reached" : "MISSED") << std::endl;
        return is_kept;
      }
    } // namespace
  }   // namespace Snap
} // namespace Setae



int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  try
    {
      const std::string folder = argv[1];
      return Setae::Snap::study(
               Setae::read_file(folder + "/../../prm/snap.prm")) ?
               0 :
               1;
    }
  catch (const std::exception &error)
    {
      std::cerr << error.what() << std::endl;
      return 1;
    }
}
