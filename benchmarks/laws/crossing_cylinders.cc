// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors
//
// Two infinite cylinders that cross, energy over the gap at some angles and
// over the angle at a small gap: SSIP Fig. 10b, SBIP Fig. 4b and 5. What the
// laws give when they are integrated along the fibers, against the exact
// energy.

#include <setae/verification/cylinders.h>

#include "laws.h"
#include "results.h"
#include "straight_fibers.h"

namespace Setae
{
  namespace LawReport
  {
    namespace
    {
      const std::string reduction  = "1D reduction";
      const std::string all_angles = "all angles";

      /** At which the gap is varied [degrees]. */
      const std::vector<double> angles = {90., 45., 10.};

      /** The gap at which the angle is varied, as in SBIP Fig. 5. */
      constexpr double fixed_gap = 1e-3;

      std::string
      crossing_at(const double angle)
      {
        return "crossing at " + short_text(angle) + " degrees";
      }

      double
      radians(const double angle)
      {
        return angle * M_PI / 180.;
      }

      std::string
      unequal_at(const double angle, const double radius_2)
      {
        return crossing_at(angle) + ": R2/R1 = " + short_text(radius_2);
      }

      std::vector<Method>
      methods(const PointPotential &potential, const double radius_2)
      {
        // Where fibers cross at a right angle, the thinner one makes the gap
        // grow: peak_width() takes both.
        const double   thinner = std::min(1., radius_2);
        const PeakRule rule    = PeakRule::fine(
          radius_2 == 1. ? 1. : std::sqrt(.5 * (1. + radius_2) / thinner));
        std::vector<Method> result;
        for_each_law(potential,
                     sections_with(radius_2),
                     [&](const std::string &name, const auto &law) {
                       result.push_back(
                         {name, [=](const Place &place) {
                            return CrossingFibers(place.gap,
                                                  radians(place.angle),
                                                  1. + radius_2)(law, rule);
                          }});
                     });
        return result;
      }

      void
      add_place(const Place               &place,
                const PointPotential      &potential,
                const std::vector<Method> &methods,
                Results                   &results)
      {
        const bool  with_time = place.gap == .1 && place.radius_2 == 1.;
        const Exact exact     = ExactPowers(
          [&](const InversePower &power) {
            return References::crossing_cylinders(power,
                                                  sections_with(place.radius_2),
                                                  place.gap,
                                                  radians(place.angle));
          },
          with_time)(potential);
        results.add_exact(place, exact, reduction);
        results.add(place, exact, methods, with_time);
      }

      Results
      evaluate()
      {
        Results results;
        for (const NamedPotential &potential : short_range_potentials())
          {
            const std::vector<Method> methods =
              LawReport::methods(potential.powers, 1.);
            for (const double angle : angles)
              for (const double gap : decades(-4, 2, 2))
                add_place({crossing_at(angle), potential.name, gap, angle},
                          potential.powers,
                          methods,
                          results);
            for (const double angle :
                 {90., 60., 45., 30., 20., 10., 5., 2., 1.})
              add_place({all_angles, potential.name, fixed_gap, angle},
                        potential.powers,
                        methods,
                        results);
            for (const double radius_2 : unequal_radii)
              {
                const std::vector<Method> methods =
                  LawReport::methods(potential.powers, radius_2);
                for (const double angle : {90., 45.})
                  for (const double gap : decades(-4, 2, 1))
                    add_place({unequal_at(angle, radius_2),
                               potential.name,
                               gap,
                               angle,
                               0.,
                               0.,
                               radius_2},
                              potential.powers,
                              methods,
                              results);
              }
          }
        return results;
      }

      void
      compare_exponents(const Results &results, Comparison &comparison)
      {
        const auto vdw = [&](const std::string &method) {
          return results.curve(crossing_at(90.), van_der_waals().name, method);
        };
        comparison.add({"exact, 90 degrees: exponent of the gap, g/R = 1e-4",
                        -1.,
                        slope(vdw(reduction), 1e-4, 3e-4),
                        Requirement::within(-1., .01)});
        comparison.add(
          {"exact, 90 degrees: exponent of the distance, g/R = 100",
           -4.,
           slope(vdw(reduction), 30., 100., sum_of_radii),
           Requirement::within(-4., .01)});
        comparison.add({"SSIP: exponent of the gap, g/R = 1e-4",
                        -1.5,
                        slope(vdw(DiskDisk::name), 1e-4, 3e-4),
                        Requirement::within(-1.5, .05)});
        comparison.add({"SBIP: exponent of the gap, g/R = 1e-4",
                        -1.,
                        slope(vdw(DiskCylinder::name), 1e-4, 3e-4),
                        Requirement::within(-1., .03)});
        comparison.add({"monopole: error, g/R = 100",
                        Comparison::none,
                        nearest(vdw(Multipole<1>::name), 100.).energy_error,
                        Requirement::within(0., 1e-3)});
      }

      /** Energy of a method over the exact one at the smallest gap. */
      void
      compare_closing_gaps(const Results &results, Comparison &comparison)
      {
        for (const double angle : angles)
          {
            const double c     = std::cos(radians(angle));
            const auto   ratio = [&](const std::string &method) {
              return 1. + nearest(results.curve(crossing_at(angle),
                                                van_der_waals().name,
                                                method),
                                  1e-4)
                            .energy_error;
            };
            const std::string at =
              ", " + short_text(angle) + " degrees, g/R = 1e-4";
            comparison.add({"SSIP over exact" + at,
                            Comparison::none,
                            ratio(DiskDisk::name)});
            comparison.add({"ISSIP over exact" + at,
                            Comparison::none,
                            ratio(OffsetDisks::name),
                            Requirement::within(1., .01)});
            const double expected = std::sqrt(2. / (c * c + 1.));
            comparison.add({"SBIP over exact" + at + " (published: verified)",
                            1.,
                            ratio(DiskCylinder::name)});
            comparison.add({"the same over the known factor",
                            Comparison::none,
                            ratio(DiskCylinder::name) / expected,
                            Requirement::within(1., .01)});
            comparison.add({"closed form over exact" + at,
                            Comparison::none,
                            ratio(OrientedDiskCylinder::name),
                            Requirement::within(1., .01)});
          }
      }

      void
      compare_table(const Results &results, Comparison &comparison)
      {
        for (const NamedPotential &potential : short_range_potentials())
          {
            Curve curve;
            for (const Row &row : results.all())
              if (row.method == TabulatedDiskCylinder::name &&
                  row.place.potential == potential.name)
                curve.push_back(row);
            const double energy = largest_error(curve, 0., 200.),
                         force =
                           largest_error(curve, 0., 200., &Row::force_error);
            comparison.add({"tabulated: error, all gaps, angles and radii, " +
                              potential.name,
                            Comparison::none,
                            energy,
                            Requirement::at_most(LawAccuracy().tolerance)});
            comparison.add(
              {"tabulated: error of the force",
               Comparison::none,
               force,
               Requirement::at_most(2. * LawAccuracy().tolerance)});
          }
      }

      Comparison
      compare(const Results &results)
      {
        Comparison comparison;
        compare_exponents(results, comparison);
        compare_closing_gaps(results, comparison);
        compare_table(results, comparison);
        return comparison;
      }

      std::string
      column(const Place &place)
      {
        return place.configuration == all_angles ?
                 short_text(place.angle) + " degrees" :
                 gap_column(place);
      }
    } // namespace
  }   // namespace LawReport
} // namespace Setae



int
main()
{
  using namespace Setae::LawReport;
  return report("crossing_cylinders", evaluate, compare, column);
}
