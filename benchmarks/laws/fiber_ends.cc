// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors
//
// The ends of fibers: cylinders that slide along each other, a half cylinder
// that crosses a cylinder, one that points at it. What the laws give as the
// program evaluates them, against exact energies and forces. The end of a
// source costs a law nothing, since the integral along the source ends there
// too; the end of a target is for the law to know. So both roles are tried.
//
// Coulomb's potential is that of charges on the surface, against the full
// quadrature.

#include <deal.II/base/mpi.h>

#include <setae/verification/cylinders.h>
#include <setae/verification/disk_cylinder.h>

#include "two_fibers.h"

namespace Setae
{
  namespace LawReport
  {
    namespace
    {
      const std::string reduction = "reduction", integral = "4D hierarchical";

      /**
       * What fibers so long miss of those that are infinite is less than 1e-4
       * of energy and force.
       */
      constexpr double half_length = 20., cell_length = 5.;

      /** Of fibers that slide along each other. */
      constexpr double sliding_length = 10.;

      const std::vector<double> gaps = {1., .1};

      const Tensor<1, 3> x_axis({1., 0., 0.}), z_axis({0., 0., 1.});

      using ExactFunction =
        std::function<References::EnergyAndForce(const InversePower &)>;

      /** Two fibers, and a component of the force on the source. */
      struct Case
      {
        Place            place; ///< without the potential
        const TwoFibers *bodies, *surfaces;
        FiberCurve       source, target;
        Tensor<1, 3>     direction;
        ExactFunction    exact;

        bool
        is_axial() const
        {
          return place.configuration.find("axial") != std::string::npos;
        }
      };

      /**
       * Far inside, what draws a fiber along its axis is exponentially small:
       * its error is relative to no less than this part of the energy over the
       * radius.
       */
      constexpr double smallest_axial_force = .1;

      constexpr double
      radians(const double degrees)
      {
        return degrees * M_PI / 180.;
      }

      Place
      place(const std::string &configuration,
            const double       gap,
            const double       angle,
            const double       offset)
      {
        return {configuration, "", gap, angle, offset};
      }

      /** The source of the pair is always the first body. */
      struct Pair
      {
        Pair(const double source_length, const double target_length)
          : bodies(source_length, target_length, cell_length)
          , surfaces(source_length,
                     target_length,
                     cell_length,
                     Distribution::surface)
        {}

        TwoFibers bodies, surfaces;
      };



      /** Of the same length, the target begins by a shift farther along. */
      void
      add_sliding(const Pair &pair, std::vector<Case> &cases)
      {
        for (const bool is_axial : {false, true})
          for (const double gap : gaps)
            for (const double shift : {3., 8., 9.5, 10., 10.5, 12.})
              {
                Case c;
                c.place = place(is_axial ? "sliding: axial force" : "sliding",
                                gap,
                                0.,
                                shift);
                c.bodies   = &pair.bodies;
                c.surfaces = &pair.surfaces;
                c.source = straight((sum_of_radii + gap) * z_axis, x_axis, 0.);
                c.target = straight(shift * x_axis, x_axis, 0.);
                c.direction = is_axial ? -x_axis : z_axis;
                c.exact     = [=](const InversePower &power) {
                  const auto e = References::finite_parallel_cylinders(
                    power,
                    equal_sections(),
                    gap,
                    {sliding_length, sliding_length, shift});
                  return References::EnergyAndForce{e.energy,
                                                    is_axial ? e.thrust :
                                                                   e.force};
                };
                cases.push_back(c);
              }
      }



      /** The disk at the end of a half cylinder that crosses a cylinder. */
      References::DiskPose
      end_disk(const double gap, const double angle, const double overhang)
      {
        const double X = sum_of_radii + gap, Y = overhang * std::sin(angle);
        const double d = std::hypot(X, Y);
        return {(gap * (sum_of_radii + X) + Y * Y) / (d + sum_of_radii),
                std::cos(angle),
                std::sin(angle) * Y / d};
      }

      /** What the end of the half cylinder feels is the disk that it lacks. */
      References::EnergyAndForce
      crossing(const InversePower &power,
               const double        gap,
               const double        angle,
               const double        overhang,
               const bool          is_axial)
      {
        References::EnergyAndForce result = References::crossing_half_cylinder(
          power, equal_sections(), gap, angle, overhang);
        if (is_axial)
          result.force =
            -1. * References::energy_of_disk_and_cylinder(
                    power, equal_sections(), end_disk(gap, angle, overhang));
        return result;
      }

      /** The end is by an overhang beyond the point of crossing. */
      void
      add_crossing(const Pair        &pair,
                   const bool         source_ends,
                   std::vector<Case> &cases)
      {
        for (const double degrees : {90., 45.})
          for (const bool is_axial : {false, true})
            for (const double gap : gaps)
              for (const double overhang : {-1., 0., .5, 1., 2.})
                {
                  const double       angle = radians(degrees);
                  const Tensor<1, 3> t({std::cos(angle), std::sin(angle), 0.});
                  const Tensor<1, 3> height = (sum_of_radii + gap) * z_axis;

                  Case c;
                  c.place    = place("crossing at " + short_text(degrees) +
                                    " degrees: the " +
                                    (source_ends ? "source" : "target") +
                                    " ends" + (is_axial ? ": axial force" : ""),
                                  gap,
                                  degrees,
                                  overhang);
                  c.bodies   = &pair.bodies;
                  c.surfaces = &pair.surfaces;
                  // Its end is at s = half_length.
                  const double s = half_length - overhang;
                  c.source       = source_ends ?
                                     straight(height, t, s) :
                                     straight(height, x_axis, half_length);
                  c.target = source_ends ? straight({}, x_axis, half_length) :
                                           straight({}, t, s);
                  c.direction =
                    is_axial ? (source_ends ? 1. : -1.) * t : z_axis;
                  c.exact = [=](const InversePower &power) {
                    return crossing(power, gap, angle, overhang, is_axial);
                  };
                  cases.push_back(c);
                }
      }



      /** The force is along both the gap and the axis of what points. */
      void
      add_pointing(const Pair        &pair,
                   const bool         source_ends,
                   std::vector<Case> &cases)
      {
        for (const double gap : {3., 1., .3, .1})
          {
            const FiberCurve pointing =
              straight((1. + gap) * z_axis, z_axis, 0.);
            const FiberCurve other = straight({}, x_axis, half_length);

            Case c;
            c.place =
              place(source_ends ? "the source points" : "the target points",
                    gap,
                    90.,
                    0.);
            c.bodies    = &pair.bodies;
            c.surfaces  = &pair.surfaces;
            c.source    = source_ends ? pointing : other;
            c.target    = source_ends ? other : pointing;
            c.direction = (source_ends ? 1. : -1.) * z_axis;
            c.exact     = [=](const InversePower &power) {
              return References::pointing_half_cylinder(power,
                                                        equal_sections(),
                                                        gap);
            };
            cases.push_back(c);
          }
      }



      std::vector<Method>
      methods(const TwoFibers      &fibers,
              const State          &state,
              const Case           &c,
              const PointPotential &potential)
      {
        std::vector<Method> result;
        for (const SceneLaw &law : scene_laws(potential))
          {
            // Points a third of the smallest gap apart for two integrals
            const bool is_double =
              law.law == DiskDisk::name || law.law == OffsetDisks::name;
            const auto by_law =
              fibers.by_law(law, potential, state, is_double ? 30 : 20);
            result.push_back(
              {law.name, [by_law, direction = c.direction](const Place &) {
                 const Resultant r = by_law();
                 return Interaction{r.energy, r.force * direction};
               }});
          }
        return result;
      }

      Exact
      with_scale(Exact exact, const Case &c)
      {
        if (c.is_axial())
          exact.scale.force =
            std::copysign(std::max(std::abs(exact.scale.force),
                                   smallest_axial_force *
                                     std::abs(exact.scale.energy)),
                          exact.scale.force);
        return exact;
      }

      void
      add(const Case &c, Results &results)
      {
        Place      place     = c.place;
        const bool with_time = place.gap == .1;

        const State body_state = c.bodies->state(c.source, c.target);
        ExactPowers powers(c.exact, with_time);
        for (const NamedPotential &potential : short_range_potentials())
          {
            place.potential   = potential.name;
            const Exact exact = with_scale(powers(potential.powers), c);
            results.add_exact(place, exact, reduction);
            results.add(place,
                        exact,
                        methods(*c.bodies, body_state, c, potential.powers),
                        with_time);
          }

        const State surface_state = c.surfaces->state(c.source, c.target);
        ExactPowers charges(
          [&](const InversePower &power) {
            FullQuadratureParameters parameters;
            parameters.tolerance = 1e-4;
            const FullQuadrature f =
              c.surfaces->full(power, surface_state, parameters);
            return References::EnergyAndForce{
              {f.value.energy, f.error * std::abs(f.value.energy)},
              {f.value.force * c.direction,
               f.force_error * f.value.force.norm()}};
          },
          with_time);
        place.potential   = coulomb().name;
        const Exact exact = with_scale(charges(coulomb().powers), c);
        results.add_exact(place, exact, integral);
        results.add(place,
                    exact,
                    methods(*c.surfaces, surface_state, c, coulomb().powers),
                    with_time);
      }

      Results
      evaluate()
      {
        const Pair        finite(sliding_length, sliding_length);
        const Pair        source_ends(half_length, 2. * half_length);
        const Pair        target_ends(2. * half_length, half_length);
        std::vector<Case> cases;
        add_sliding(finite, cases);
        add_crossing(source_ends, true, cases);
        add_crossing(target_ends, false, cases);
        add_pointing(source_ends, true, cases);
        add_pointing(target_ends, false, cases);
        Results results;
        for (const Case &c : cases)
          add(c, results);
        return results;
      }

      /** The largest error of the tabulated law at the places accepted. */
      template <typename Accepts>
      double
      largest(const Results &results,
              const Accepts &accepts,
              double Row::*error)
      {
        Curve curve;
        for (const Row &row : results.all())
          if (row.method == TabulatedDiskCylinder::name && accepts(row.place))
            curve.push_back(row);
        return largest_error(curve, 0., 10., error);
      }

      /** What laws make of ends, and must not make worse. */
      Comparison
      compare(const Results &results)
      {
        const auto is = [](const std::string &words) {
          return [=](const Place &place) {
            return place.configuration.find(words) != std::string::npos;
          };
        };
        const auto inside = [](const auto &accepts, const double end) {
          return [=](const Place &place) {
            return accepts(place) &&
                   (end > 0. ? place.offset <= end : place.offset >= end);
          };
        };
        const auto beyond = [](const auto &accepts, const double end) {
          return [=](const Place &place) {
            return accepts(place) &&
                   (end > 0. ? place.offset > end : place.offset < end);
          };
        };

        Comparison comparison;
        const auto add = [&](const std::string &what,
                             const auto        &accepts,
                             const Requirement &requirement) {
          comparison.add({"tabulated: error of the energy, " + what,
                          Comparison::none,
                          largest(results, accepts, &Row::energy_error),
                          requirement});
          comparison.add({"tabulated: error of the force, " + what,
                          Comparison::none,
                          largest(results, accepts, &Row::force_error),
                          requirement});
        };
        add("a source that ends",
            is("the source ends"),
            Requirement::at_most(1e-3));
        add("a source that points",
            is("the source points"),
            Requirement::at_most(.1));
        add("sliding while side by side",
            inside(is("sliding"), sliding_length),
            Requirement::at_most(.08));
        add("sliding beyond the ends",
            beyond(is("sliding"), sliding_length),
            {});
        add("a target that ends beyond the crossing",
            inside(is("the target ends"), 0.),
            Requirement::at_most(.1));
        add("a target that ends before the crossing",
            beyond(is("the target ends"), 0.),
            Requirement::at_most(.1));
        add("a target that points",
            is("the target points"),
            Requirement::at_most(.1));
        return comparison;
      }

      std::string
      column(const Place &place)
      {
        return "g/R = " + short_text(place.gap) +
               (place.configuration.find("points") == std::string::npos ?
                  ", s/R = " + short_text(place.offset) :
                  "");
      }
    } // namespace
  }   // namespace LawReport
} // namespace Setae



int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  using namespace Setae::LawReport;
  return report("fiber_ends", evaluate, compare, column);
}
