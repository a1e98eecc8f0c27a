// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors
//
// Error against run time of the integrators: the two fibers that snap into
// contact, before and through the first contact and up to the first hard one,
// by generalized-alpha with equal and with adapted steps, by energy-conserving
// steps and by IDA, against equal steps far smaller than all others. From the
// hard contact on, smaller steps do not give the same motion any more: when two
// runs part is printed.

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
          study("snap", "1.2e-2", 4);
          predictability();
          std::cout << "\nOrder of generalized-alpha before the contact: "
                    << order << " (required: 2 +- 0.1) "
                    << (std::abs(order - 2.) <= .1 ? "reached" : "MISSED")
                    << std::endl;
          return std::abs(order - 2.) <= .1;
        }

      private:
        /**
         * The settings of all runs: fewer points than in the scene, as time is
         * what is studied.
         */
        static Overrides
        scene(const std::string &end)
        {
          return {"dynamics/end time=" + end,
                  "interactions/coulomb/gauss points=4",
                  "interactions/contact/gauss points=2",
                  "dynamics/integrator=generalized-alpha",
                  "dynamics/rho infinity=0.9",
                  "dynamics/largest displacement=0",
                  "newton/residual tolerance=1e-12",
                  "newton/increment tolerance=1e-7"};
        }

        /** Print when runs with successive time steps part from each other. */
        void
        predictability() const
        {
          constexpr double          R = .02;
          dealii::ConvergenceTable  table;
          std::vector<Result>       results;
          const std::vector<double> steps = {2e-5, 1e-5, 5e-6};
          for (const double step : steps)
            {
              Overrides overrides = scene("2e-2");
              overrides.push_back("dynamics/time step=" + number(step));
              results.push_back(Snap::run(prm, overrides));
            }
          for (unsigned int i = 0; i + 1 < results.size(); ++i)
            {
              table.add_value("step", number(steps[i]));
              table.add_value("half of it", number(steps[i + 1]));
              for (const double part : {.01, .1, 1.})
                table.add_value("beyond " + number(part) + " R at",
                                number(results[i].time_of_separation(
                                  results[i + 1], part * R)));
            }
          std::cout
            << "\nTime at which a node of two runs is farther apart, up "
               "to time 0.02\n";
          table.write_text(std::cout);
        }

        /** @return The last rate of convergence of equal steps. */
        double
        study(const std::string &phase,
              const std::string &end,
              const unsigned int n_refinements)
        {
          const Overrides base    = scene(end);
          const auto      step_of = [](const unsigned int refinement) {
            return 1e-4 / (1u << refinement);
          };
          const auto with = [&base](Overrides more) {
            more.insert(more.begin(), base.begin(), base.end());
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
          for (unsigned int i = 0; i < n_refinements; ++i)
            add("conserving",
                step_of(i),
                with({"dynamics/integrator=energy-conserving",
                      "dynamics/time step=" + number(step_of(i))}));
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
