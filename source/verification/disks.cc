// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <boost/math/tools/minima.hpp>

#include <setae/base/exceptions.h>
#include <setae/verification/disks.h>
#include <setae/verification/segments.h>

#include <algorithm>
#include <cmath>

namespace Setae
{
  namespace References
  {
    using dealii::Tensor;

    namespace
    {
      constexpr double pi = M_PI;

      /** Where a function with one minimum has it, exactly if at an end. */
      double
      argument_of_minimum(const Function &f, const double a, const double b)
      {
        constexpr int half_of_the_digits = 26;

        const auto inside =
          boost::math::tools::brent_find_minima(f, a, b, half_of_the_digits);
        for (const double end : {a, b})
          if (f(end) <= inside.second)
            return end;
        return inside.first;
      }



      /**
       * The parallel chords of a disk of radius R: at the angle chi their half
       * length is R cos(chi), and they are R sin(chi) from the center. They are
       * seen from one of them, from which chi is counted as a turn, so that
       * small differences do not cancel.
       */
      class Chords
      {
      public:
        Chords(const double radius, const double angle)
          : R(radius)
          , angle(std::min(.5 * pi, std::max(-.5 * pi, angle)))
          , sine(std::sin(this->angle))
          , cosine(std::abs(this->angle) < .5 * pi ? std::cos(angle) : 0.)
        {}

        Chords
        seen_from(const double turn) const
        {
          return Chords(R, angle + turn);
        }

        double
        first_turn() const
        {
          return -.5 * pi - angle;
        }

        double
        last_turn() const
        {
          return .5 * pi - angle;
        }

        double
        radius() const
        {
          return R;
        }

        double
        half_length(const double turn) const
        {
          return R * (cosine * std::cos(turn) - sine * std::sin(turn));
        }

        double
        from_center(const double turn) const
        {
          return R * (sine * std::cos(turn) + cosine * std::sin(turn));
        }

        /** The difference of from_center(). */
        double
        step(const double turn) const
        {
          const double half = .5 * turn;
          return 2. * R * std::sin(half) *
                 (cosine * std::cos(half) - sine * std::sin(half));
        }

        /** Minus the difference of half_length(). */
        double
        retreat(const double turn) const
        {
          const double half = .5 * turn;
          return 2. * R * std::sin(half) *
                 (sine * std::cos(half) + cosine * std::sin(half));
        }

      private:
        double R, angle, sine, cosine;
      };



      /** The axes along which two disks are taken apart. */
      struct Axes
      {
        Axes(const Disk &disk_1, const Disk &disk_2)
        {
          constexpr double round_off = 1e-14;

          // Parallel disks have many common directions: the one that is normal
          // to the connection of their centers.
          const Tensor<1, 3> d = disk_1.center - disk_2.center;
          along = dealii::cross_product_3d(disk_1.normal, disk_2.normal);
          if (along.norm() < round_off)
            along = dealii::cross_product_3d(disk_1.normal, d);
          if (along.norm() < round_off * d.norm())
            {
              Tensor<1, 3> e;
              for (unsigned int c = 0; c < 3; ++c)
                e[c] = std::abs(disk_1.normal[c]) < .7;
              along = dealii::cross_product_3d(disk_1.normal, e);
            }
          // The difference of two almost equal normals has few digits.
          along -= (along * disk_1.normal) * disk_1.normal;
          along /= (along * d < 0. ? -1. : 1.) * along.norm();

          normal  = disk_2.normal;
          lateral = dealii::cross_product_3d(normal, along);
        }

        /** Common to both planes; from the second disk to the first. */
        Tensor<1, 3> along;
        Tensor<1, 3> lateral; ///< in the plane of the second disk
        Tensor<1, 3> normal;  ///< of the second disk
      };



      /** How a chord of the first disk lies to one of the second disk. */
      struct Separation
      {
        double height; ///< above the plane of the second disk
        double lateral;
        double gap; ///< between their ends; negative if they are side by side

        double
        between_lines() const
        {
          return std::hypot(height, lateral);
        }

        double
        distance() const
        {
          return std::hypot(between_lines(), std::max(0., gap));
        }
      };



      /** All pairs of a chord of the first disk and one of the second one. */
      class PairsOfChords
      {
      public:
        PairsOfChords(const SectionPair &sections,
                      const Disk        &disk_1,
                      const Disk        &disk_2,
                      const Axes        &axes)
          : first(sections.radius_1, 0.)
          , second(sections.radius_2, 0.)
        {
          const Tensor<1, 3> step =
            dealii::cross_product_3d(disk_1.normal, axes.along);
          rise = step * axes.normal;
          run  = step * axes.lateral;

          const Tensor<1, 3> d = disk_1.center - disk_2.center;
          origin               = {d * axes.normal,
                                  d * axes.lateral,
                                  d * axes.along - sections.radius_1 - sections.radius_2};
        }

        Separation
        separation(const double turn_1, const double turn_2) const
        {
          const double step = first.step(turn_1);
          return {origin.height + rise * step,
                  origin.lateral + run * step - second.step(turn_2),
                  origin.gap + first.retreat(turn_1) + second.retreat(turn_2)};
        }

        double
        smallest_distance() const
        {
          return origin.distance();
        }

        PairsOfChords
        seen_from(const double turn_1, const double turn_2) const
        {
          PairsOfChords result = *this;
          result.first         = first.seen_from(turn_1);
          result.second        = second.seen_from(turn_2);
          result.origin        = separation(turn_1, turn_2);
          return result;
        }

        /** From a chord of the first disk and the one nearest to it. */
        PairsOfChords
        seen_from_chord(const double turn_1) const
        {
          return seen_from(turn_1,
                           argument_of_minimum(
                             [&](const double turn_2) {
                               return separation(turn_1, turn_2).distance();
                             },
                             second.first_turn(),
                             second.last_turn()));
        }

        PairsOfChords
        seen_from_nearest() const
        {
          return seen_from_chord(argument_of_minimum(
            [&](const double turn_1) {
              return seen_from_chord(turn_1).smallest_distance();
            },
            first.first_turn(),
            first.last_turn()));
        }

        PairMeasure
        points(const Separation &separation, const double turn_2) const
        {
          return PairMeasure(separation.gap,
                             first.half_length(0.),
                             second.half_length(turn_2));
        }

        Chords     first, second;
        Separation origin;
        double     rise, run; ///< of the steps of the first disk
      };



      /**
       * The integral over all pairs of chords, which are seen from the nearest
       * ones.
       *
       * @param f A function of the pairs of one chord of the first disk and of
       * the turn of the second chord.
       */
      Estimate
      integrate_over_chords(
        const PairsOfChords                                        &pairs,
        const std::function<double(const PairsOfChords &, double)> &f,
        const double                                                tolerance,
        const double negligible = 0.)
      {
        const auto scale = [](const PairsOfChords &pairs,
                              const Chords        &chords) {
          return std::min(1., pairs.smallest_distance() / chords.radius());
        };
        const double R1 = pairs.first.radius();
        return integrate_peak(
          [&](const double turn_1) {
            const PairsOfChords row = pairs.seen_from_chord(turn_1);
            return pairs.first.half_length(turn_1) *
                   integrate_peak(
                     [&](const double turn_2) { return f(row, turn_2); },
                     row.second.first_turn(),
                     row.second.last_turn(),
                     0.,
                     scale(row, row.second),
                     inner(tolerance),
                     0.,
                     inner(negligible / R1))
                     .value;
          },
          pairs.first.first_turn(),
          pairs.first.last_turn(),
          0.,
          scale(pairs, pairs.first),
          tolerance,
          0.,
          negligible);
      }



      PairsOfChords
      nearest_chords(const SectionPair &sections,
                     const Disk        &disk_1,
                     const Disk        &disk_2,
                     const Axes        &axes)
      {
        const PairsOfChords pairs =
          PairsOfChords(sections, disk_1, disk_2, axes).seen_from_nearest();
        AssertThrow(pairs.smallest_distance() > 0., ExcRun("The disks touch."));
        return pairs;
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
      const Axes                  axes(disk_1, disk_2);
      return power.prefactor * sections.density_1 * sections.density_2 *
             integrate_over_chords(
               nearest_chords(sections, disk_1, disk_2, axes),
               [&](const PairsOfChords &row, const double turn) {
                 const Separation s = row.separation(0., turn);
                 return row.second.half_length(turn) *
                        segments(s.between_lines(), row.points(s, turn));
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
      const Axes                  axes(disk_1, disk_2);
      const PairsOfChords         pairs =
        nearest_chords(sections, disk_1, disk_2, axes);
      const Estimate energy =
        energy_of_disks(power, sections, disk_1, disk_2, tolerance);
      const double factor =
        power.prefactor * sections.density_1 * sections.density_2;

      const double size = sections.radius_1 + sections.radius_2 +
                          (disk_1.center - disk_2.center).norm();
      const double negligible =
        tolerance * std::abs(energy.value / factor) / size;

      const auto normal = [&](const PairsOfChords &row, const double turn) {
        const Separation s = row.separation(0., turn);
        return m * s.height * row.second.half_length(turn) *
               segments_of_slope(s.between_lines(), row.points(s, turn));
      };
      const auto along = [&](const PairsOfChords &row, const double turn) {
        const Separation  s      = row.separation(0., turn);
        const PairMeasure points = row.points(s, turn);
        const double      p      = s.between_lines();
        return row.second.half_length(turn) *
               (segment(p, points.rise) - segment(p, points.fall));
      };
      const auto lateral = [&](const PairsOfChords &row, const double turn) {
        const Separation  s      = row.separation(0., turn);
        const PairMeasure points = row.points(s, turn);
        const double      p      = s.between_lines();
        const double      length = 2. * row.first.half_length(0.);
        const double      begin = points.rise.begin, end = points.fall.end;
        return row.second.from_center(turn) *
               (segment(p, {begin, begin + length}) +
                segment(p, {end - length, end}));
      };

      Estimate   force;
      const auto add = [&](const double component, const auto &f) {
        if (component != 0.)
          force = force +
                  component *
                    integrate_over_chords(
                      pairs,
                      f,
                      tolerance,
                      std::max(negligible / std::abs(component),
                               tolerance * std::abs(force.value / component)));
      };
      add(direction * axes.normal, normal);
      add(direction * axes.lateral, lateral);
      add(direction * axes.along, along);
      return {energy, factor * force};
    }
  } // namespace References
} // namespace Setae
