// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors
//
// Two disks in parallel planes under a Lennard-Jones potential, energy per
// length squared over the offset: ISSIP Fig. 4, with the numbers of that paper
// (lengths are not in units of the radius here).

#include <setae/verification/disks.h>

#include "laws.h"
#include "results.h"

namespace Setae
{
  namespace LawReport
  {
    namespace
    {
      const std::string configuration = "offset disks";
      const std::string reduction     = "2D reduction";

      const PointPotential potential      = {{6, -1e-7}, {12, 5e-25}};
      constexpr double     R              = .02;
      const SectionPair    small_sections = {R, R, 1., 1.};

      const std::vector<double> offsets =
        {0., 1e-4, 2e-4, 5e-4, 1e-3, 2e-3, 5e-3, .01, .02};

      std::vector<double>
      gaps()
      {
        std::vector<double> result;
        for (unsigned int i = 0; i <= 12; ++i)
          result.push_back(8e-4 + 1e-4 * i);
        return result;
      }

      Results
      evaluate()
      {
        const DiskDisk    ssip(potential, small_sections, {});
        const OffsetDisks issip(potential, small_sections, {});
        // SSIP takes the distance of the centers for that in the plane.
        const std::vector<Method> methods = {
          {DiskDisk::name,
           [&](const Place &place) {
             const double R = 2. * small_sections.radius_1;
             const double distance =
               std::hypot(place.gap + 2. * R, place.offset);
             const GapDerivatives f = ssip(distance - 2. * R);
             return Interaction{f.value,
                                -f.first * (place.gap + 2. * R) / distance};
           }},
          {OffsetDisks::name, [&](const Place &place) {
             const OffsetGapDerivatives f = issip(place.offset, place.gap);
             return Interaction{f.value, -f.g};
           }}};

        Results results;
        for (const double offset : offsets)
          for (const double gap : gaps())
            {
              const Place place = {
                configuration, lennard_jones().name, gap, 0., offset};
              const bool  with_time = gap == gaps().front();
              const Exact exact     = ExactPowers(
                [&](const InversePower &power) {
                  return References::offset_disks(power,
                                                  small_sections,
                                                  gap,
                                                  offset);
                },
                with_time)(potential);
              results.add_exact(place, exact, reduction);
              results.add(place, exact, methods, with_time);
            }
        return results;
      }

      /** The L2 norm over the gaps of a relative error, as in ISSIP Fig. 4b. */
      double
      norm_of_error(const Results     &results,
                    const std::string &method,
                    const double       offset)
      {
        const Curve exact =
          results.curve(configuration, lennard_jones().name, reduction);
        const Curve law =
          results.curve(configuration, lennard_jones().name, method);
        double difference = 0., norm = 0.;
        for (unsigned int i = 0; i < exact.size(); ++i)
          if (exact[i].place.offset == offset)
            {
              const double e = exact[i].value.energy;
              difference += std::pow(law.at(i).value.energy - e, 2);
              norm += e * e;
            }
        return std::sqrt(difference / norm);
      }

      Comparison
      compare(const Results &results)
      {
        Comparison comparison;
        for (const double offset : offsets)
          {
            const std::string at = ", offset " + short_text(offset);
            comparison.add(
              {"ISSIP: norm of the error" + at,
               offset == 0. ? .01 : Comparison::none,
               norm_of_error(results, OffsetDisks::name, offset),
               offset <= .1 * R ? Requirement::at_most(.1) : Requirement()});
            comparison.add({"SSIP: norm of the error" + at,
                            offset == 0. ? .01 : Comparison::none,
                            norm_of_error(results, DiskDisk::name, offset)});
          }
        return comparison;
      }

      std::string
      column(const Place &place)
      {
        return place.gap == gaps().front() ?
                 "offset " + short_text(place.offset) :
                 "";
      }
    } // namespace
  }   // namespace LawReport
} // namespace Setae



int
main()
{
  using namespace Setae::LawReport;
  return report("offset_disks", evaluate, compare, column);
}
