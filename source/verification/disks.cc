// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <setae/verification/chords.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace Setae
{
  namespace References
  {
    using dealii::Tensor;

    namespace
    {
      using ChordFunction = std::function<double(const PairOfChords &)>;

      /** For the size of an integral that tells what is negligible. */
      constexpr double rough = .1;

      ChordFunction
      magnitude(const ChordFunction &f)
      {
        return [&f](const PairOfChords &pair) { return std::abs(f(pair)); };
      }



      /** The turn within which anything changes next to a pair. */
      double
      scale(const PairsOfChords &pairs, const Chords &chords)
      {
        return std::min(1.,
                        pairs.pair(0., 0.).smallest_distance() /
                          chords.radius());
      }



      /** The integral over the second angle, from the nearest chord on. */
      double
      integrate_row(const PairsOfChords &row,
                    const ChordFunction &f,
                    const double         tolerance,
                    const double         negligible)
      {
        return integrate_peak(
                 [&](const double turn) { return f(row.pair(0., turn)); },
                 row.second.first_turn(),
                 row.second.last_turn(),
                 0.,
                 scale(row, row.second),
                 tolerance,
                 0.,
                 negligible)
          .value;
      }



      /** Where the integral over the first angle has peaks or edges; tips of
       * the first disk that are close to the second one are both. */
      std::vector<double>
      peaks(const PairsOfChords &pairs)
      {
        const double        same   = .1 * scale(pairs, pairs.first);
        std::vector<double> result = pairs.crossing_edges();
        result.push_back(0.);
        for (const double tip :
             {pairs.first.first_turn(), pairs.first.last_turn()})
          if (scale(pairs.row(tip), pairs.first) < .1)
            result.push_back(tip);
        std::sort(result.begin(), result.end());
        const auto last = std::unique(result.begin(),
                                      result.end(),
                                      [&](const double a, const double b) {
                                        return b - a < same;
                                      });
        result.erase(last, result.end());
        return result;
      }



      /** The integral over both angles of f R1 cos(chi1). */
      Estimate
      integrate_rows(const PairsOfChords &pairs,
                     const ChordFunction &f,
                     const double         tolerance,
                     const double         negligible)
      {
        const double of_a_row  = inner(negligible / pairs.first.radius());
        const auto   along_row = [&](const double turn) {
          const PairsOfChords row = pairs.row(turn);
          const double size = integrate_row(row, magnitude(f), rough, of_a_row);
          return pairs.first.half_length(turn) *
                 integrate_row(row,
                               f,
                               inner(tolerance),
                               std::max(inner(tolerance) * size, of_a_row));
        };
        const std::vector<double> turns = peaks(pairs);
        Estimate                  sum;
        double                    begin = pairs.first.first_turn();
        for (unsigned int i = 0; i < turns.size(); ++i)
          {
            const double end = i + 1 < turns.size() ?
                                 .5 * (turns[i] + turns[i + 1]) :
                                 pairs.first.last_turn();
            if (begin < end)
              sum =
                sum + integrate_peak(along_row,
                                     begin,
                                     end,
                                     turns[i],
                                     scale(pairs.row(turns[i]), pairs.first),
                                     tolerance,
                                     0.,
                                     negligible);
            begin = end;
          }
        return sum;
      }



      /**
       * The same to a tolerance that is relative to the integral of the
       * magnitude of f, whose signs may cancel.
       */
      Estimate
      integrate(const PairsOfChords &pairs,
                const ChordFunction &f,
                const double         tolerance)
      {
        const double size =
          integrate_rows(pairs, magnitude(f), rough, 0.).value;
        return integrate_rows(pairs, f, tolerance, tolerance * size);
      }
    } // namespace



    Estimate
    energy_of_disks(const InversePower &power,
                    const SectionPair  &sections,
                    const Disk         &disk_1,
                    const Disk         &disk_2,
                    const double        tolerance)
    {
      const DoubleSegmentIntegral segments(power.exponent);
      return power.prefactor * sections.density_1 * sections.density_2 *
             integrate(
               PairsOfChords(sections, disk_1, disk_2),
               [&](const PairOfChords &pair) {
                 return pair.half_2 * segments(pair.distance, pair.points);
               },
               tolerance);
    }



    EnergyAndForce
    disks(const InversePower &power,
          const SectionPair  &sections,
          const Disk         &disk_1,
          const Disk         &disk_2,
          const Tensor<1, 3> &direction,
          const double        tolerance)
    {
      const unsigned int          m = power.exponent;
      const SegmentIntegral       segment(m);
      const DoubleSegmentIntegral segments_of_slope(m + 2);
      const PairsOfChords         pairs(sections, disk_1, disk_2);

      const auto normal = [&](const PairOfChords &pair) {
        return m * pair.height * pair.half_2 *
               segments_of_slope(pair.distance, pair.points);
      };
      // In its plane the second disk is moved by moving its edge, where it
      // meets the potential of the first one: one chord at both its ends.
      const auto at_begin = [&](const PairOfChords &pair) {
        const double begin = pair.points.rise.begin;
        return segment(pair.distance, {begin, begin + 2. * pair.half_1});
      };
      const auto at_end = [&](const PairOfChords &pair) {
        const double end = pair.points.fall.end;
        return segment(pair.distance, {end - 2. * pair.half_1, end});
      };

      Estimate   force;
      const auto add = [&](const double component, const ChordFunction &f) {
        if (component != 0.)
          force = force + component * integrate(pairs, f, tolerance);
      };
      const double along = direction * pairs.along;
      add(direction * pairs.normal, normal);
      add(along, [&](const PairOfChords &pair) {
        return pair.half_2 * at_begin(pair);
      });
      add(-along,
          [&](const PairOfChords &pair) { return pair.half_2 * at_end(pair); });
      add(direction * pairs.lateral, [&](const PairOfChords &pair) {
        return pair.from_center_2 * (at_begin(pair) + at_end(pair));
      });
      return {energy_of_disks(power, sections, disk_1, disk_2, tolerance),
              power.prefactor * sections.density_1 * sections.density_2 *
                force};
    }
  } // namespace References
} // namespace Setae
