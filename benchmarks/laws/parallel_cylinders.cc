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

      std::string
      name_with(const double radius_2)
      {
        return configuration + ": R2/R1 = " + short_text(radius_2);
      }

      std::vector<Method>
      methods(const PointPotential &potential, const double radius_2)
      {
        const PeakRule      rule = PeakRule::fine();
        std::vector<Method> result;
        for_each_law(potential,
                     sections_with(radius_2),
                     [&](const std::string &name, const auto &law) {
                       result.push_back({name, [=](const Place &place) {
                                           return parallel_fibers(law,
                                                                  place.gap,
                                                                  1. + radius_2,
                                                                  rule);
                                         }});
                     });
        return result;
      }

      void
      add(const NamedPotential      &potential,
          const std::string         &name,
          const double               radius_2,
          const std::vector<double> &gaps,
          Results                   &results)
      {
        const std::vector<Method> methods =
          LawReport::methods(potential.powers, radius_2);
        for (const double gap : gaps)
          {
            Place place;
            place.configuration = name;
            place.potential     = potential.name;
            place.gap           = gap;
            place.radius_2      = radius_2;

            const bool  with_time = radius_2 == 1. && place.is_decade();
            const Exact exact     = ExactPowers(
              [&](const InversePower &power) {
                return References::parallel_cylinders(power,
                                                      sections_with(radius_2),
                                                      gap);
              },
              with_time)(potential.powers);
            results.add_exact(place, exact, reduction);
            results.add(place, exact, methods, with_time);
          }
      }

      Results
      evaluate()
      {
        Results results;
        for (const NamedPotential &potential : short_range_potentials())
          {
            add(potential, configuration, 1., decades(-4, 2, 3), results);
            for (const double radius_2 : unequal_radii)
              add(potential,
                  name_with(radius_2),
                  radius_2,
                  decades(-4, 2, 1),
                  results);
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
            Curve table;
            for (const Row &row : results.all())
              if (row.method == TabulatedDiskCylinder::name &&
                  row.place.potential == potential.name)
                table.push_back(row);
            comparison.add({"tabulated: error, g/R = 1e-4 to 100, all radii, " +
                              potential.name,
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
