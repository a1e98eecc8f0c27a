// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors
//
// Error against run time of the integrators: the two fibers that snap into
// contact, before and through the first contact, by generalized-alpha with
// equal and with adapted steps and by IDA, against equal steps far smaller than
// all others.

#include <deal.II/base/convergence_table.h>

#include <fstream>
#include <iostream>

#include "snap.h"

namespace Setae
{
  namespace Snap
  {
    namespace
    {
      class WorkPrecision
      {
      public:
        explicit WorkPrecision(const std::string &prm)
          : prm(prm)
        {}

        /** @return Whether generalized-alpha has order two. */
        bool
        run()
        {
          csv.open("time_integration.csv");
          csv << "phase,integrator,parameter,steps,linear systems,error,CPU "
                 "time\n";
          const double order = study("flight", "1.4e-3", 5);
          study("contact", "3e-3", 5);
          std::cout << "\nOrder of generalized-alpha before the contact: "
                    << order << " (required: 2 +- 0.1) "
                    << (std::abs(order - 2.) <= .1 ? "reached" : "MISSED")
                    << std::endl;
          return std::abs(order - 2.) <= .1;
        }

      private:
        /** @return The last rate of convergence of equal steps. */
        double
        study(const std::string &phase,
              const std::string &end,
              const unsigned int n_refinements)
        {
          // Fewer points than in the scene: time is what is studied.
          const Overrides scene   = {"dynamics/end time=" + end,
                                     "interactions/coulomb/gauss points=4",
                                     "interactions/contact/gauss points=2",
                                     "dynamics/rho infinity=0.9",
                                     "dynamics/largest displacement=0",
                                     "newton/residual tolerance=1e-12",
                                     "newton/increment tolerance=1e-7"};
          const auto      step_of = [](const unsigned int refinement) {
            return 1e-4 / (1u << refinement);
          };
          const auto with = [&scene](Overrides more) {
            more.insert(more.begin(), scene.begin(), scene.end());
            return more;
          };
          const auto with_step = [&](const double step) {
            return with({"dynamics/time step=" + number(step)});
          };
          const Result reference =
            Snap::run(prm, with_step(step_of(n_refinements + 2)));

          dealii::ConvergenceTable table;
          std::vector<double>      errors;
          const auto               add = [&](const std::string &integrator,
                               const double       parameter,
                               const Overrides   &overrides) {
            const Result result = Snap::run(prm, overrides);
            errors.push_back(result.distance(reference.state));
            const RunSummary &summary = result.summary;
            table.add_value("integrator", integrator);
            table.add_value("parameter", number(parameter));
            table.add_value("steps", summary.n_steps - 1);
            table.add_value("linear systems", summary.n_iterations);
            table.add_value("error", errors.back());
            table.add_value("CPU time [s]", summary.cpu_time);
            csv << phase << ',' << integrator << ',' << parameter << ','
                << summary.n_steps - 1 << ',' << summary.n_iterations << ','
                << errors.back() << ',' << summary.cpu_time << std::endl;
          };
          for (unsigned int i = 0; i < n_refinements; ++i)
            add("equal steps", step_of(i), with_step(step_of(i)));
          const double order =
            std::log2(errors[n_refinements - 2] / errors[n_refinements - 1]);
          for (const double tolerance : {1e-3, 1e-4, 1e-5, 1e-6})
            add("adapted steps",
                tolerance,
                with({"dynamics/time step=1e-5",
                      "dynamics/tolerance=" + number(tolerance)}));
          for (const double tolerance : {1e-4, 1e-5, 1e-6, 1e-7})
            add("IDA",
                tolerance,
                with({"dynamics/integrator=IDA",
                      "dynamics/time step=1e-4",
                      "dynamics/tolerance=" + number(tolerance)}));

          table.set_precision("error", 2);
          table.set_scientific("error", true);
          std::cout << "\nUp to time " << end << " (" << phase
                    << "), error of the nodes [length], reference "
                    << reference.summary.n_steps - 1 << " equal steps in "
                    << reference.summary.cpu_time << " s\n";
          table.write_text(std::cout);
          return order;
        }

        static std::string
        number(const double value)
        {
          std::ostringstream text;
          text << value;
          return text.str();
        }

        const std::string prm;
        std::ofstream     csv;
      };
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
      const std::string prm = Setae::read_file(folder + "/../../prm/snap.prm");
      return Setae::Snap::WorkPrecision(prm).run() ? 0 : 1;
    }
  catch (const std::exception &error)
    {
      std::cerr << error.what() << std::endl;
      return 1;
    }
}
