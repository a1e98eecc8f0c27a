// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

// The numbers that SBIP Sec. 8.1 prints on the peeling of two fibers, beside
// those of Setae, and how these change with finer cells and quadrature.
// Zero is returned if all that must be reached is reached.

#include <deal.II/base/mpi.h>

#include <iostream>

#include "../comparison.h"
#include "peeling_curve.h"

namespace Setae
{
  namespace Peeling
  {
    /** The printed results for one strength of adhesion. */
    struct Published
    {
      std::string force_minimum; ///< [force/length]
      double      peak, peak_opening, pull_off;
      double      swapped;       ///< largest difference, source and target swapped
      double      swapped_rigid; ///< the same if the left fiber is rigid

      /** The peak of fibers that cannot shear. */
      double shear_rigid_peak;
    };

    // The paper's Simo-Reissner beams shear a little at the strongest adhesion.
    const Published published[] = {
      {"-0.01", .32, 3.4e-4, .13, 4e-6, .0013, .32},
      {"-0.1", 1.8, 3.6e-4, .48, 5e-6, .0043, 1.8},
      {"-1", 9.9, 3.6e-4, .82, 3e-5, .0142, 10.2}};

    const Overrides swapped = {"interactions/adhesion/source=right",
                               "interactions/adhesion/target=left"};

    const Overrides left_is_rigid = {"supports/left/at=all",
                                     "supports/left/displacement=0; 0; free",
                                     "supports/left/tangent=0; 0; free",
                                     "supports/pin/fibers=right"};

    // The same times in all runs, as long as none fails to converge.
    const Overrides fixed_steps = {
      "load stepping/largest step="
      "if(t < 2.5e-4, 1e-5, if(t < 0.01, 1e-3, 5e-3))",
      "load stepping/growth=1000",
      "load stepping/target iterations=1000"};



    class Table
    {
    public:
      explicit Table(const std::string &folder)
        : prm(read_file(folder + "/../../prm/peeling.prm"))
        , scene(Scene::read(prm, "peeling.prm"))
      {
        compute_force_unit(folder);
      }

      /** @return Whether everything that must be reached is reached. */
      bool
      run()
      {
        for (const Published &p : published)
          {
            add_curve(p);
            add_swapped(p);
          }
        add_laws();

        std::cout << "Peeling of two fibers, SBIP Sec. 8.1. Forces in units of "
                  << force_unit << ".\n\n";
        comparison.print(std::cout);
        std::cout << '\n';
        costs.write_text(std::cout, TableHandler::org_mode_table);
        comparison.write_csv("table.csv");
        return comparison.succeeds();
      }

    private:
      using TableHandler = dealii::TableHandler;

      void
      compute_force_unit(const std::string &folder)
      {
        const FiberParameters &fiber = scene.fibers[0];
        std::ostringstream     log;
        FiberProblem problem(Scene::read(read_file(folder + "/force_unit.prm"),
                                         "force_unit.prm"),
                             MPI_COMM_WORLD,
                             log);
        problem.run([this](const StepRecord &record) {
          force_unit = record.supports.back().reaction[0];
        });

        const double linear =
          12. * fiber.youngs_modulus * M_PI / 4. * std::pow(fiber.radius, 4) /
          (fiber.length * fiber.length);
        comparison.add({"midpoint load for l/4, over 12 EI/l^2",
                        1.364,
                        force_unit / linear,
                        Requirement::within(1.364, .001)});
      }

      Curve
      measure(const std::string &name, const Overrides &overrides)
      {
        // Beyond the largest pull-off.
        const Curve curve =
          Peeling::run(prm, Overrides{"load stepping/end time=0.9"} + overrides);
        const RunSummary &summary = curve.summary;
        costs.add_value("run", name);
        costs.add_value("steps", summary.n_steps);
        costs.add_value("iterations", summary.n_iterations);
        costs.add_value("rejected iterations", summary.n_rejected_iterations);
        costs.add_value("rejected steps", summary.n_rejected_steps);
        costs.add_value("snaps", summary.n_snaps);
        costs.add_value("CPU time [s]", summary.cpu_time);
        costs.add_value("smallest gap", summary.smallest_gap);
        costs.set_precision("CPU time [s]", 2);
        costs.set_precision("smallest gap", 3);
        costs.set_scientific("smallest gap", true);
        return curve;
      }

      /** Peak and pull-off, with finer cells and quadrature as well. */
      void
      add_curve(const Published &p)
      {
        const std::string name = "f_min = " + p.force_minimum;
        const Overrides   strength = {"interactions/adhesion/force minimum=" +
                                    p.force_minimum};
        const Curve       curve    = measure(name, strength);
        const Curve       fine     = measure(name + ", 128 cells",
                                   strength + cells(128) + integration(1, 10));
        const Curve finely_integrated =
          measure(name + ", 40 Gauss points", strength + integration(4, 10));

        const auto add = [&](const std::string &quantity,
                             const double       number,
                             const Requirement &requirement,
                             const auto &       evaluate) {
          comparison.add({name + ": " + quantity,
                          number,
                          evaluate(curve),
                          requirement,
                          evaluate(fine),
                          evaluate(finely_integrated)});
        };
        add("peak force",
            p.peak,
            Requirement::within(p.shear_rigid_peak, .03 * p.shear_rigid_peak),
            [this](const Curve &c) { return c.peak().force / force_unit; });
        add("u_x/l at the peak",
            p.peak_opening,
            Requirement::within(p.peak_opening, 2e-5),
            [](const Curve &c) { return c.peak().opening; });
        add("u_x/l at pull-off",
            p.pull_off,
            Requirement::within(p.pull_off, .01),
            [](const Curve &c) { return c.pull_off(); });

        const double equilibrium = scene.interactions[0].equilibrium_gap;
        // Later, the bonded part is so short that its ends press on the middle.
        add("gap in the middle over g_eq, u_x/l = 0.005",
            1.,
            Requirement::within(1., 1e-3),
            [&](const Curve &c) {
              return c.nearest(.005).middle_gap / equilibrium;
            });
        add("smallest gap over g_reg",
            Comparison::none,
            Requirement::at_least(1.),
            [&](const Curve &c) {
              return c.summary.smallest_gap /
                     scene.interactions[0].regularization;
            });
      }

      /** What the choice of source and target changes. */
      void
      add_swapped(const Published &p)
      {
        const std::string name = "f_min = " + p.force_minimum;
        const Overrides   strength =
          fixed_steps +
          Overrides{"interactions/adhesion/force minimum=" + p.force_minimum};
        const auto add = [&](const std::string &what,
                             const Overrides   &setup,
                             const double       number,
                             const double       bound) {
          const Curve curve = measure(name + what, strength + setup);
          const Curve other =
            measure(name + what + ", swapped", strength + setup + swapped);
          const Difference difference = largest_difference(other, curve);

          // A run that takes other steps would be compared in few points only.
          const bool is_complete = difference.n > .8 * curve.n_bonded();
          comparison.add({name + what + ": sides swapped, relative change",
                          number,
                          is_complete ? difference.largest : Comparison::none,
                          Requirement::at_most(bound)});
        };
        add(", same steps", {}, p.swapped, 1e-7);
        add(", left rigid", left_is_rigid, p.swapped_rigid, p.swapped_rigid);
      }

      /** The section-section law beside the section-beam law, SBIP Fig. 11. */
      void
      add_laws()
      {
        const double    k6 = -1e-7, k12 = 5e-25;
        const Overrides ssip = point_potential("disk-disk", k6, k12);
        const Overrides sbip = point_potential("disk-cylinder", k6, k12);

        const Curve beam   = measure("SBIP", sbip);
        const Curve paper  = measure("SSIP, 20 Gauss points", ssip);
        const Curve curve  = measure("SSIP, 40 Gauss points",
                                    ssip + integration(4, 10));
        const Curve fine   = measure("SSIP, 128 cells, 40 Gauss points",
                                   ssip + cells(128) + integration(4, 10));
        const Curve finely_integrated =
          measure("SSIP, 80 Gauss points", ssip + integration(8, 10));
        const Curve calibrated =
          measure("SBIP, 4 times as strong",
                  point_potential("disk-cylinder", 4. * k6, 4. * k12));

        const auto peak     = [](const Curve &c) { return c.peak().force; };
        const auto place    = [](const Curve &c) { return c.peak().opening; };
        const auto pull_off = [](const Curve &c) { return c.pull_off(); };
        const auto add      = [&](const std::string &quantity,
                             const double       number,
                             const double       tolerance,
                             const auto        &evaluate,
                             const Curve       &reference) {
          comparison.add({quantity,
                          number,
                          evaluate(curve) / evaluate(reference),
                          Requirement::within(number, tolerance),
                          evaluate(fine) / evaluate(reference),
                          evaluate(finely_integrated) / evaluate(reference)});
        };
        add("SSIP over SBIP, peak force", 2.6, .1, peak, beam);
        comparison.add({"SSIP over SBIP, peak force, 20 Gauss points",
                        2.6,
                        peak(paper) / peak(beam),
                        Requirement::within(2.6, .05)});
        add("SSIP over SBIP, u_x/l at pull-off", 1.3, .05, pull_off, beam);
        comparison.add({"SBIP, u_x/l at the peak",
                        3e-4,
                        place(beam),
                        Requirement::within(3e-4, 2e-5)});
        comparison.add({"SSIP, u_x/l at the peak",
                        3e-4,
                        place(curve),
                        Requirement::within(3e-4, 2e-5),
                        place(fine),
                        place(finely_integrated)});
        add("SSIP over SBIP of 4 times the strength, peak force",
            1.,
            .1,
            peak,
            calibrated);
        add("SSIP over SBIP of 4 times the strength, u_x/l at pull-off",
            1.,
            .1,
            pull_off,
            calibrated);
      }

      const std::string prm;
      const Scene       scene;
      double            force_unit = 0.; ///< [force]
      Comparison        comparison;
      TableHandler      costs;
    };
  } // namespace Peeling
} // namespace Setae



int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  try
    {
      return Setae::Peeling::Table(argv[1]).run() ? 0 : 1;
    }
  catch (const std::exception &error)
    {
      std::cerr << error.what() << std::endl;
      return 1;
    }
}
