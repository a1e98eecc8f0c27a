// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors
//
// Two infinite parallel cylinders, energy per length over the gap: SSIP Fig. 9,
// SBIP Fig. 4a. What the laws give when they are integrated along the fibers,
// against the exact energy at every gap.

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
      const std::string configuration = "parallel cylinders";
      const std::string reduction     = "2D reduction";

      std::vector<Method>
      methods(const PointPotential &potential)
      {
        const PeakRule      rule = PeakRule::fine();
        std::vector<Method> result;
        for_each_law(potential,
                     equal_sections(),
                     [&](const std::string &name, const auto &law) {
                       result.push_back({name, [=](const Place &place) {
                                           return parallel_fibers(law,
                                                                  place.gap,
                                                                  sum_of_radii,
                                                                  rule);
                                         }});
                     });
        return result;
      }

      Results
      evaluate()
      {
        Results results;
        for (const NamedPotential &potential : short_range_potentials())
          {
            const std::vector<Method> methods =
              LawReport::methods(potential.powers);
            for (const double gap : decades(-4, 2, 3))
              {
                const Place place = {configuration, potential.name, gap};
                const Exact exact = ExactPowers(
                  [&](const InversePower &power) {
                    return References::parallel_cylinders(power,
                                                          equal_sections(),
                                                          gap);
                  },
                  place.is_decade())(potential.powers);
                results.add_exact(place, exact, reduction);
                results.add(place, exact, methods, place.is_decade());
              }
          }
        return results;
      }

      Comparison
      compare(const Results &results)
      {
        const auto vdw = [&](const std::string &method) {
          return results.curve(configuration, van_der_waals().name, method);
        };
        Comparison comparison;
        comparison.add({"exact: exponent of the gap, g/R = 1e-4",
                        -1.5,
                        slope(vdw(reduction), 1e-4, 2e-4),
                        Requirement::within(-1.5, .01)});
        comparison.add({"exact: exponent of the distance, g/R = 100",
                        -5.,
                        slope(vdw(reduction), 50., 100., sum_of_radii),
                        Requirement::within(-5., .01)});

        // SSIP: too strong, and ever more so as the gap closes
        comparison.add({"SSIP: exponent of the gap, g/R = 1e-4",
                        -2.,
                        slope(vdw(DiskDisk::name), 1e-4, 2e-4),
                        Requirement::within(-2., .01)});
        for (const double gap : {1e-1, 1e-2, 1e-3, 1e-4})
          comparison.add(
            {"SSIP: energy over the exact one, g/R = " + short_text(gap),
             Comparison::none,
             1. + nearest(vdw(DiskDisk::name), gap).energy_error});
        comparison.add(
          {"monopole: error, g/R = 100",
           Comparison::none,
           std::abs(nearest(vdw(Multipole<1>::name), 100.).energy_error),
           Requirement::at_most(1e-3)});

        // ISSIP and SBIP: the same, and right as the gap closes
        comparison.add({"SBIP: exponent of the gap, g/R = 1e-4",
                        -1.5,
                        slope(vdw(DiskCylinder::name), 1e-4, 2e-4),
                        Requirement::within(-1.5, 1e-6)});
        comparison.add(
          {"ISSIP over SBIP - 1, g/R = 1e-4 to 100, largest",
           0.,
           largest_difference(vdw(OffsetDisks::name), vdw(DiskCylinder::name)),
           Requirement::at_most(1e-6)});
        for (const double gap : {1e-1, 1e-2, 1e-3, 1e-4})
          comparison.add(
            {"SBIP: error, g/R = " + short_text(gap),
             Comparison::none,
             nearest(vdw(DiskCylinder::name), gap).energy_error,
             gap > 5e-4 ? Requirement() : Requirement::at_most(1e-3)});

        for (const NamedPotential &potential : short_range_potentials())
          {
            const Curve table = results.curve(configuration,
                                              potential.name,
                                              TabulatedDiskCylinder::name);
            comparison.add(
              {"tabulated: error, g/R = 1e-4 to 100, " + potential.name,
               Comparison::none,
               largest_error(table, 0., 200.),
               Requirement::at_most(LawAccuracy().tolerance)});
            comparison.add(
              {"tabulated: error of the force",
               Comparison::none,
               largest_error(table, 0., 200., &Row::force_error),
               Requirement::at_most(2. * LawAccuracy().tolerance)});
          }
        return comparison;
      }
    } // namespace
  }   // namespace LawReport
} // namespace Setae



int
main()
{
  using namespace Setae::LawReport;
  return report("parallel_cylinders", evaluate, compare, gap_column);
}
