// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

// The numbers of ISSIP Sec. 6 on the peeling of two fibers by section-section
// interaction with offset, beside those of Setae: errors of quadrature, cutoff
// and mesh, variants, the curve by section-beam interaction. Zero is returned
// if all that must be reached is reached.

#include <deal.II/base/convergence_table.h>
#include <deal.II/base/mpi.h>

#include <boost/math/quadrature/gauss_kronrod.hpp>

#include <setae/laws/disk_cylinder.h>
#include <setae/laws/offset_disks.h>

#include <iostream>

#include "../comparison.h"
#include "opened_fibers.h"
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
        add_cutoff_integrals();
        add_cutoffs();
        add_cells();
        add_moments();
        add_curve();

        std::cout << "Peeling of two fibers, ISSIP Sec. 6.\n\n";
        comparison.print(std::cout);
        std::cout << '\n';
        convergence.write_text(std::cout, TableHandler::org_mode_table);
        std::cout << '\n';
        costs.write_text(std::cout, TableHandler::org_mode_table);
        comparison.write_csv("issip.csv");
        return comparison.succeeds();
      }

    private:
      using TableHandler = dealii::TableHandler;

      /** The force of a straight fiber on a section, Sec. 6.5 and 6.7. */
      void
      add_integrals()
      {
        const OffsetDisks law   = this->law({});
        const double      end   = .03;
        const double      exact = force_of_fiber(law, end);
        for (const auto &[points_per_length, published, requirement] :
             {std::make_tuple(1600u, Comparison::none, Requirement()),
              {3200u, 3.4e-5, Requirement::within(3.4e-5, 2e-6)},
              {6400u, Comparison::none, Requirement::at_most(1e-8)}})
          {
            const unsigned int n   = std::lround(2. * end * points_per_length);
            double             sum = 0.;
            for (unsigned int i = 0; i < n; ++i)
              sum += law(end * ((2. * i + 1.) / n - 1.), gap).g;
            comparison.add({"midpoint rule, " +
                              std::to_string(points_per_length) +
                              " points per length: error",
                            published,
                            std::abs(sum * 2. * end / n / exact - 1.),
                            requirement});
          }
      }

      /**
       * What a cutoff does to this force: where forces are left out, and where
       * the energy is switched off, whose slope attracts.
       */
      void
      add_cutoff_integrals()
      {
        const double diameter   = 2. * scene.fibers[0].radius;
        const auto   half_chord = [&](const double radius) {
          return std::sqrt(radius * radius - std::pow(diameter + gap, 2));
        };
        const double exact =
          DiskCylinder(potential(), sections(), {})(gap, 1.).g;
        for (const auto &[radius, published, requirement] :
             {std::make_tuple(.045, Comparison::none, Requirement()),
              {.05, 4e-4, Requirement::at_most(1e-3)},
              {.06, Comparison::none, Requirement()}})
          {
            std::ostringstream name;
            name << "straight fiber, cutoff radius " << radius << ": ";
            comparison.add(
              {name.str() + "force left out",
               published,
               1. - force_of_fiber(law({}), half_chord(radius)) / exact,
               requirement});
            const OffsetDisks switched = law(switched_off_at(radius));
            comparison.add(
              {name.str() + "force added with the energy switched off",
               Comparison::none,
               force_of_fiber(switched,
                              half_chord(switched.cutoff() + diameter)) /
                   exact -
                 1.});
          }
      }

      SectionPair
      sections() const
      {
        return {scene.fibers[0].radius, scene.fibers[1].radius, 1., 1.};
      }

      PointPotential
      potential() const
      {
        const std::vector<double> &k = scene.interactions[0].prefactors;
        return {{6, k[0]}, {12, k[1]}};
      }

      OffsetDisks
      law(const GapRange &range) const
      {
        return {potential(), sections(), range};
      }

      /** Of the part of a fiber with offsets of at most @p end. */
      static double
      force_of_fiber(const OffsetDisks &law, const double end)
      {
        return 2. *
               boost::math::quadrature::gauss_kronrod<double, 31>::integrate(
                 [&law](const double offset) { return law(offset, gap).g; },
                 0.,
                 end,
                 15,
                 1e-12);
      }

      /** The radius about a section is in the middle of the switch. */
      GapRange
      switched_off_at(const double radius) const
      {
        const double middle = radius - 2. * scene.fibers[0].radius;
        GapRange     range;
        range.cutoff       = middle / (1. - .5 * switch_width);
        range.cutoff_begin = (1. - switch_width) * range.cutoff;
        return range;
      }

      Curve
      measure(const std::string &name,
              const Overrides   &overrides,
              const Ending       ending = Ending::is_an_error)
      {
        const Curve curve = Peeling::run(prm, overrides, ending);
        report(name, curve);
        return curve;
      }

      void
      report(const std::string &name, const Curve &curve)
      {
        const RunSummary &summary = curve.summary;
        costs.add_value("run", name);
        costs.add_value("steps", summary.n_steps);
        costs.add_value("iterations", summary.n_iterations);
        costs.add_value("rejected iterations", summary.n_rejected_iterations);
        costs.add_value("interaction [s]",
                        curve.sections.at("interaction").cpu_time);
        costs.add_value("smallest gap", summary.smallest_gap);
        costs.set_precision("interaction [s]", 1);
        costs.set_scientific("smallest gap", true);
        std::cerr << name << ": last bonded at " << last_bonded(curve).opening
                  << " with " << last_bonded(curve).force << ", after "
                  << curve.sections.at("interaction").cpu_time << " s"
                  << std::endl;
      }

      static Point
      last_bonded(const Curve &curve)
      {
        return curve.points[curve.n_bonded() - 1];
      }

      /** From the steep descent after the peak to close to pull-off. */
      static bool
      is_compared(const Point &p)
      {
        return p.opening > 1e-3 && p.opening < .57;
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
            if (is_compared(p) && !std::isnan(f))
              largest = std::max(largest, std::abs(p.force / f - 1.));
          }
        return largest;
      }

      /** The same before, where forces change sign, over the largest force. */
      static double
      initial_difference(const Curve &curve, const Curve &reference)
      {
        double largest = 0.;
        for (unsigned int i = 0; !is_compared(curve.points[i]); ++i)
          largest =
            std::max(largest,
                     std::abs(curve.points[i].force -
                              reference.force(curve.points[i].opening)));
        return largest / reference.peak().force;
      }

      /**
       * Errors at pull-off, Sec. 6.5 and Fig. 15. The paper leaves out the
       * forces of all pairs beyond a radius, so its fibers attract each other
       * less; here the energy is switched off, which attracts more.
       */
      void
      add_cutoffs()
      {
        const Curve reference = pull_apart("cutoff radius 0.07", .07);
        for (const auto &[radius, published] :
             {std::make_pair(.045, 8.2e-3), {.05, 2.1e-3}, {.06, 4e-4}})
          {
            std::ostringstream name;
            name << "cutoff radius " << radius;
            const Curve curve = pull_apart(name.str(), radius);
            name << ": error of ";
            comparison.add(
              {name.str() + "t at pull-off",
               published,
               std::abs(curve.pull_off() / reference.pull_off() - 1.),
               Requirement::at_most(published)});
            comparison.add(
              {name.str() + "the force at pull-off",
               Comparison::none,
               std::abs(
                 last_bonded(curve).force / last_bonded(reference).force - 1.),
               Requirement::at_most(published)});
            comparison.add(
              {name.str() + "the force at t = 0.57",
               Comparison::none,
               std::abs(
                 curve.nearest(.57).force / reference.nearest(.57).force - 1.),
               Requirement::at_most(1e-4)});
            if (radius == .05)
              add_axis(curve);
          }
      }

      /** From u_x/l = 0.5 to pull-off. */
      Curve
      pull_apart(const std::string &name,
                 const double       cutoff_radius,
                 const Overrides   &variant = {})
      {
        std::ostringstream cutoff, width;
        cutoff << path << "cutoff=" << switched_off_at(cutoff_radius).cutoff;
        width << path << "switch width=" << switch_width;
        const Curve curve = Opened::released(
          Peeling::run(Opened::scene(prm),
                       Opened::until(.58) +
                         Overrides{cutoff.str(), width.str()} + variant));
        report(name, curve);
        return curve;
      }

      /** The offset along the axis of the source: the bias of Sec. 5.5. */
      void
      add_axis(const Curve &averaged)
      {
        const Curve source =
          pull_apart("axis of the source", .05, {path + "frame=source"});
        comparison.add({"axis of the source: t at pull-off, relative",
                        1.,
                        source.pull_off() / averaged.pull_off(),
                        Requirement::within(1., .005)});
        comparison.add(
          {"axis of the source: error of the force at t = 0.57",
           Comparison::none,
           std::abs(source.nearest(.57).force / averaged.nearest(.57).force -
                    1.),
           Requirement::at_most(.01)});
      }

      /** Spatial convergence at t = 0.57, Sec. 6.6. */
      void
      add_cells()
      {
        const std::string opened = Opened::scene(prm);
        const auto        shape  = [&](const unsigned int n_cells) {
          Opened::Shape result;
          const Curve   curve =
            Peeling::run(opened,
                         Opened::until(.57, n_cells),
                         Ending::is_an_error,
                         [&result](const FiberProblem &problem) {
                           result = Opened::Shape(problem);
                         });
          report(std::to_string(n_cells) + " cells, t = 0.57",
                 Opened::released(curve));
          return std::make_pair(result, curve.points.back().force);
        };
        const auto [reference, reference_force] = shape(128);
        for (const unsigned int n_cells : {8, 16, 32, 64})
          {
            const auto [result, force] = shape(n_cells);
            convergence.add_value("cells", n_cells);
            convergence.add_value("position", result.position_error(reference));
            convergence.add_value("curvature",
                                  result.curvature_error(reference));
            convergence.add_value("force",
                                  std::abs(force / reference_force - 1.));
          }
        for (const std::string quantity : {"position", "curvature", "force"})
          {
            convergence.set_precision(quantity, 2);
            convergence.set_scientific(quantity, true);
            convergence.evaluate_convergence_rates(
              quantity, dealii::ConvergenceTable::reduction_rate_log2);
          }
      }

      /** Without moments, Sec. 6.4 and Fig. 13. */
      void
      add_moments()
      {
        const Curve with = measure("moments", coarse);
        const Curve without =
          measure("no moments",
                  coarse + Overrides{path + "interaction moments=false"},
                  Ending::is_the_end_of_the_curve);
        comparison.add({"without moments: t at pull-off, relative",
                        1.,
                        last_bonded(without).opening / with.pull_off(),
                        Requirement::within(1., .002)});
        comparison.add(
          {"without moments: force from t = 1e-3 on, largest difference",
           Comparison::none,
           difference(without, with),
           Requirement::at_most(.01)});
        comparison.add(
          {"without moments: force before, largest difference over the peak",
           Comparison::none,
           initial_difference(without, with),
           Requirement::at_most(.01)});
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

      static constexpr double gap          = 9e-4; // of the straight fiber
      static constexpr double switch_width = .1;

      const std::string path = "interactions/adhesion/";

      const Overrides to_pull_off = {"load stepping/end time=0.6",
                                     "load stepping/smallest step=2e-5"};

      // To compare the moments: 2432 points per length, and steps that do not
      // depend on the number of iterations, so that the curves have points in
      // common.
      const Overrides coarse =
        to_pull_off +
        Overrides{"load stepping/largest step=min(0.03, max(2e-4, 0.4*t))",
                  "load stepping/target iterations=30",
                  path + "integration segments=190"};

      const std::string prm;
      const Scene       scene;
      Comparison        comparison;
      TableHandler      costs;

      dealii::ConvergenceTable convergence;
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
