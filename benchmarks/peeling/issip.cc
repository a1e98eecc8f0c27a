// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

// The numbers of ISSIP Sec. 6 on the peeling of two fibers by section-section
// interaction with offset, beside those of Setae: errors of quadrature and
// cutoff, pull-off, the same curve by section-beam interaction, and the
// variants of the kernel. Zero is returned if all that must be reached is
// reached.

#include <deal.II/base/mpi.h>

#include <boost/math/quadrature/gauss_kronrod.hpp>

#include <setae/laws/disk_cylinder.h>
#include <setae/laws/offset_disks.h>

#include <iostream>

#include "../comparison.h"
#include "peeling_curve.h"

namespace Setae
{
  namespace Peeling
  {
    class Issip
    {
    public:
      explicit Issip(const std::string &folder)
        : prm(read_file(folder + "/../../prm/peeling_issip.prm"))
        , scene(Scene::read(prm, "peeling_issip.prm"))
      {}

      /** @return Whether everything that must be reached is reached. */
      bool
      run()
      {
        add_integrals();
        add_cutoffs();
        add_variants();
        add_curve();

        std::cout << "Peeling of two fibers, ISSIP Sec. 6.\n\n";
        comparison.print(std::cout);
        std::cout << '\n';
        costs.write_text(std::cout, TableHandler::org_mode_table);
        comparison.write_csv("issip.csv");
        return comparison.succeeds();
      }

    private:
      using TableHandler = dealii::TableHandler;

      /** What a straight fiber does to a section, Sec. 6.5 and 6.7. */
      void
      add_integrals()
      {
        const FiberParameters &fiber = scene.fibers[0];
        const SectionPair      sections{fiber.radius, fiber.radius, 1., 1.};
        const PointPotential potential{{6, scene.interactions[0].prefactors[0]},
                                       {12,
                                        scene.interactions[0].prefactors[1]}};
        const OffsetDisks    law(potential, sections, {});
        const DiskCylinder   cylinder(potential, sections, {});
        const double         gap   = 9e-4;
        const auto           force = [&](const double offset) {
          return law(offset, gap).g;
        };
        const auto integral = [&](const double end) {
          return 2. *
                 boost::math::quadrature::gauss_kronrod<double, 31>::integrate(
                   force, 0., end, 15, 1e-12);
        };

        const double begin = -.03, points_per_length = 3200.;
        const auto   midpoint_error = [&](const double points_per_length) {
          const unsigned int n = std::lround(-2. * begin * points_per_length);
          double             sum = 0.;
          for (unsigned int i = 0; i < n; ++i)
            sum += force(begin - 2. * begin * (i + .5) / n);
          return std::abs(sum * -2. * begin / n / integral(-begin) - 1.);
        };
        comparison.add(
          {"midpoint rule, 3200 points per length, gap 9e-4: error",
           3.4e-5,
           midpoint_error(points_per_length),
           Requirement::within(3.4e-5, 2e-6)});
        comparison.add({"the same with 6400 points per length",
                        Comparison::none,
                        midpoint_error(2. * points_per_length),
                        Requirement::at_most(1e-8)});

        // The cutoff radius of 0.05, less what the height takes of it.
        const double height = 2. * fiber.radius + gap;
        comparison.add(
          {"cutoff radius 0.05, gap 9e-4: error of the force",
           4e-4,
           std::abs(integral(std::sqrt(.05 * .05 - height * height)) /
                      cylinder(gap, 1.).g -
                    1.),
           Requirement::at_most(1e-3)});
      }

      Curve
      measure(const std::string &name,
              const Overrides   &overrides,
              const Ending       ending = Ending::is_an_error)
      {
        const Curve       curve   = Peeling::run(prm, overrides, ending);
        const RunSummary &summary = curve.summary;
        costs.add_value("run", name);
        costs.add_value("steps", summary.n_steps);
        costs.add_value("iterations", summary.n_iterations);
        costs.add_value("rejected iterations", summary.n_rejected_iterations);
        costs.add_value("interaction [s]",
                        curve.sections.at("interaction").cpu_time);
        costs.add_value("per evaluation [s]",
                        curve.sections.at("interaction").per_call());
        costs.add_value("smallest gap", summary.smallest_gap);
        costs.set_precision("interaction [s]", 1);
        costs.set_precision("per evaluation [s]", 3);
        costs.set_precision("smallest gap", 3);
        costs.set_scientific("smallest gap", true);
        std::cerr << name << ": pull-off at " << last_bonded(curve).opening
                  << " with " << last_bonded(curve).force << ", peak "
                  << curve.peak().force << std::endl;
        return curve;
      }

      static Point
      last_bonded(const Curve &curve)
      {
        return curve.points[curve.n_bonded() - 1];
      }

      /** The largest difference of forces at the openings of @p curve. */
      static double
      difference(const Curve &curve, const Curve &reference)
      {
        double largest = 0.;
        for (unsigned int i = 1; i + 1 < curve.n_bonded(); ++i)
          {
            const Point &p = curve.points[i];
            const double f = reference.force(p.opening);
            if (p.opening > 1e-3 && p.opening < .57 && !std::isnan(f))
              largest = std::max(largest, std::abs(p.force / f - 1.));
          }
        return largest;
      }

      /** Errors of the force at pull-off, Sec. 6.5 and Fig. 15. */
      void
      add_cutoffs()
      {
        const auto cutoff = [this](const double radius) {
          std::ostringstream text;
          text << path << "cutoff=" << radius - 2. * scene.fibers[0].radius;
          return coarse + Overrides{text.str()};
        };
        const Curve reference = measure("cutoff 0.07", cutoff(.07));
        for (const auto &[radius, published] :
             {std::make_pair(.045, 8.2e-3), {.05, 2.1e-3}, {.06, 4e-4}})
          {
            std::ostringstream name;
            name << "cutoff " << radius;
            const Curve curve = measure(name.str(), cutoff(radius));
            comparison.add(
              {name.str() + ": error of the force at pull-off",
               published,
               std::abs(
                 last_bonded(curve).force / last_bonded(reference).force - 1.),
               Requirement::at_most(1.5 * published)});
            comparison.add(
              {name.str() + ": error of t at pull-off",
               Comparison::none,
               std::abs(curve.pull_off() / reference.pull_off() - 1.)});
          }
      }

      /** Without moments (Sec. 6.4, Fig. 13), and the axis of the source. */
      void
      add_variants()
      {
        const Curve curve = measure("averaged axis, moments", coarse);
        const auto  add   = [&](const std::string &name, const Curve &variant) {
          comparison.add({name + ": t at pull-off, relative",
                          1.,
                          last_bonded(variant).opening / curve.pull_off(),
                          Requirement::within(1., .002)});
          comparison.add({name + ": force, largest difference",
                          Comparison::none,
                          largest_difference(variant, curve).largest,
                          Requirement::at_most(.01)});
        };
        add("without moments",
            measure("averaged axis, no moments",
                    coarse + Overrides{path + "interaction moments=false"},
                    Ending::is_the_end_of_the_curve));
        add("axis of the source",
            measure("axis of the source",
                    coarse + Overrides{path + "frame=source"}));
      }

      /** The whole curve, Fig. 12. */
      void
      add_curve()
      {
        const Overrides sbip = {
          path + "law=disk-cylinder",
          path + "cutoff=0.1",
          path + "integration rule=gauss",
          path + "integration segments=2",
          path + "gauss points=10",
          "load stepping/end time=0.6",
          "load stepping/largest step="
          "if(t < 2.5e-4, 5e-6, if(t < 0.02, 2e-4, 2e-3))"};
        const Curve beam  = measure("SBIP", sbip);
        const Curve curve = measure("ISSIP", to_pull_off);

        const auto add = [&](const std::string &quantity,
                             const double       number,
                             const double       measured,
                             const double       tolerance) {
          comparison.add({quantity,
                          number,
                          measured,
                          Requirement::within(number, tolerance)});
        };
        const Peak peak = curve.peak(), beam_peak = beam.peak();
        add("u_x/l at pull-off", .575, curve.pull_off(), .002);
        add("u_x/l at pull-off by SBIP", .575, beam.pull_off(), .006);
        add("peak force over SBIP", 1., peak.force / beam_peak.force, .03);
        add("u_x/l at the peak over SBIP",
            1.,
            peak.opening / beam_peak.opening,
            .05);
        comparison.add(
          {"force from peak to pull-off, largest difference to SBIP",
           Comparison::none,
           difference(curve, beam),
           Requirement::at_most(.03)});
      }

      const std::string path = "interactions/adhesion/";

      const Overrides to_pull_off = {"load stepping/end time=0.6",
                                     "load stepping/smallest step=2e-5"};

      // Where only pull-off is compared: no steps for the peak, and 2432 points
      // per length.
      const Overrides coarse =
        to_pull_off + Overrides{"load stepping/largest step=0.1",
                                path + "integration segments=190"};

      const std::string prm;
      const Scene       scene;
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
      return Setae::Peeling::Issip(argv[1]).run() ? 0 : 1;
    }
  catch (const std::exception &error)
    {
      std::cerr << error.what() << std::endl;
      return 1;
    }
}
