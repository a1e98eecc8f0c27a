// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <setae/base/exceptions.h>
#include <setae/verification/cylinders.h>
#include <setae/verification/disks.h>

#include <algorithm>
#include <cmath>

namespace Setae
{
  namespace References
  {
    namespace
    {
      constexpr double pi       = M_PI;
      constexpr double infinity = std::numeric_limits<double>::infinity();

      void
      check(const InversePower &power,
            const unsigned int  smallest_exponent,
            const double        gap)
      {
        AssertThrow(power.exponent >= smallest_exponent,
                    ExcRun("The energy of these cylinders is infinite for the "
                           "exponent " +
                           std::to_string(power.exponent) + "."));
        AssertThrow(gap > 0.,
                    ExcRun("A reference needs a positive gap, not " +
                           std::to_string(gap) + "."));
      }



      double
      densities(const SectionPair &sections)
      {
        return sections.density_1 * sections.density_2;
      }



      /**
       * The integral over the section of the source with its chord lengths
       * normal to the direction of the gap: of a function of the distance
       * between the chord and the surface of the target.
       *
       * @param f A function of this distance and of half of the chord length.
       */
      Estimate
      over_chords(const std::function<double(double, double)> &f,
                  const double                                 R,
                  const double                                 gap,
                  const double                                 tolerance)
      {
        return integrate_peak(
          [&](const double theta) {
            const double half = std::sin(.5 * theta);
            const double c    = R * std::sin(theta);
            return c * f(gap + 2. * R * half * half, c);
          },
          0.,
          pi,
          0.,
          std::min(pi, std::sqrt(2. * gap / R)),
          tolerance);
      }



    } // namespace



    EnergyAndForce
    parallel_cylinders(const InversePower &power,
                       const SectionPair  &sections,
                       const double        gap,
                       const double        tolerance)
    {
      check(power, 2, gap);
      return coplanar_disks({power.exponent - 1,
                             power.prefactor * line_factor(power.exponent)},
                            sections,
                            gap,
                            tolerance);
    }



    EnergyAndForce
    crossing_cylinders(const InversePower &power,
                       const SectionPair  &sections,
                       const double        gap,
                       const double        angle,
                       const double        tolerance)
    {
      check(power, 3, gap);
      const unsigned int q = power.exponent - 2;
      const double       factor =
        densities(sections) * power.prefactor * 2. * pi / std::sin(angle);
      const auto with_exponent = [&](const unsigned int q) {
        return over_chords(
          [&](const double s, const double c) {
            return 2. * c * chord_integral(q, sections.radius_2, s);
          },
          sections.radius_1,
          gap,
          tolerance);
      };
      return factor *
             EnergyAndForce{1. / q * with_exponent(q), with_exponent(q + 1)};
    }



    EnergyAndForce
    crossing_half_cylinder(const InversePower &power,
                           const SectionPair  &sections,
                           const double        gap,
                           const double        angle,
                           const double        overhang,
                           const double        tolerance)
    {
      check(power, 3, gap);
      const double        R1 = sections.radius_1, R2 = sections.radius_2;
      const double        sine   = std::sin(angle);
      const double        cosine = std::abs(std::cos(angle));
      const PointCylinder cylinder(power, R2);

      // Y is the coordinate normal to the gap and to the target. A slice of the
      // source with the width 2c in its own plane has the full measure 2c/sine
      // up to its end, which is oblique in these coordinates.
      const auto across = [&](const auto &f, const double s, const double c) {
        const double X      = R2 + s;
        const double scale  = std::sqrt(2. * s * X);
        const double far    = 100. * (X + R1);
        const double middle = overhang * sine;
        const double slope  = c * cosine;
        Estimate     sum =
          2. * c / sine *
          integrate_peak(
            f, -infinity, middle - slope, 0., scale, inner(tolerance), far);
        if (slope > 0.)
          sum = sum + c * slope / sine *
                        integrate_peak(
                          [&](const double x) {
                            return (1. - x) * f(middle + slope * x);
                          },
                          -1.,
                          1.,
                          -middle / slope,
                          scale / slope,
                          inner(tolerance));
        return sum.value;
      };
      const auto distance = [&](const double s, const double Y) {
        const double X = R2 + s;
        return (s * (X + R2) + Y * Y) / (std::hypot(X, Y) + R2);
      };
      const auto potential = [&](const double s, const double c) {
        return across(
          [&](const double Y) { return cylinder.value(distance(s, Y)); }, s, c);
      };
      const auto force = [&](const double s, const double c) {
        return across(
          [&](const double Y) {
            return -cylinder.derivative(distance(s, Y)) * (R2 + s) /
                   std::hypot(R2 + s, Y);
          },
          s,
          c);
      };
      return densities(sections) *
             EnergyAndForce{over_chords(potential, R1, gap, tolerance),
                            over_chords(force, R1, gap, tolerance)};
    }



    EnergyAndForce
    pointing_half_cylinder(const InversePower &power,
                           const SectionPair  &sections,
                           const double        gap,
                           const double        tolerance)
    {
      check(power, 4, gap);
      const double        R1 = sections.radius_1, R2 = sections.radius_2;
      const double        X0 = R2 + gap;
      const PointCylinder cylinder(power, R2);

      // At the distance Y from the plane of the axes, X along the source.
      const auto surplus = [&](const double Y) {
        return gap * (R2 + X0) + Y * Y;
      };
      const auto along_source = [&](const double Y) {
        const double x = std::hypot(X0, Y);
        const double s = surplus(Y) / (x + R2);
        return integrate_peak(
                 [&](const double tau) {
                   const double X = X0 + tau;
                   return cylinder.value((surplus(Y) + tau * (X0 + X)) /
                                         (std::hypot(X, Y) + R2));
                 },
                 0.,
                 infinity,
                 0.,
                 s * x / X0,
                 inner(tolerance),
                 100. * (X0 + R1))
          .value;
      };
      const auto at_end = [&](const double Y) {
        return cylinder.value(surplus(Y) / (std::hypot(X0, Y) + R2));
      };

      // Y = R1 sin(chi), with chords 2 R1 cos(chi) along the target.
      const auto over_section = [&](const Function &f) {
        return integrate_peak(
          [&](const double chi) {
            const double c = R1 * std::cos(chi);
            return 4. * c * c * f(R1 * std::sin(chi));
          },
          0.,
          .5 * pi,
          0.,
          std::min(1., std::sqrt(2. * gap * X0) / R1),
          tolerance);
      };
      return densities(sections) *
             EnergyAndForce{over_section(along_source), over_section(at_end)};
    }



    SlidingCylinders
    finite_parallel_cylinders(const InversePower &power,
                              const SectionPair  &sections,
                              const double        gap,
                              const Overlap      &overlap,
                              const double        tolerance)
    {
      check(power, 1, gap);
      // A shift takes from the fall of the double integral what the rise gets.
      const unsigned int          m = power.exponent;
      const PairMeasure           pairs(overlap);
      const DoubleSegmentIntegral segments(m), segments_of_slope(m + 2);
      const SegmentIntegral       segment(m);

      const auto along = [&](const Interval &z) {
        return integrate_over_disks([&](
                                      const double p) { return segment(p, z); },
                                    sections,
                                    gap,
                                    tolerance);
      };
      const double k = power.prefactor;
      return {k * integrate_over_disks(
                    [&](const double p) { return segments(p, pairs); },
                    sections,
                    gap,
                    tolerance),
              k * m *
                force_over_disks(
                  [&](const double p) {
                    return -p * segments_of_slope(p, pairs);
                  },
                  sections,
                  gap,
                  tolerance),
              k * (along(pairs.fall) + -1. * along(pairs.rise))};
    }
  } // namespace References
} // namespace Setae
