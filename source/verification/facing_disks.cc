// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <setae/base/exceptions.h>
#include <setae/verification/disks.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace Setae
{
  namespace References
  {
    namespace
    {
      constexpr double pi = M_PI;

      /** The overlap of two disks, displaced by d and by a vector v. */
      class Overlapping
      {
      public:
        Overlapping(const SectionPair &sections, const double displacement)
          : R1(sections.radius_1)
          , R2(sections.radius_2)
          , d(displacement)
        {}

        /** Its area, integrated over the direction of v. */
        double
        integral(const double v, const double tolerance) const
        {
          if (d == 0. || v == 0.)
            return 2. * pi * area(std::max(d, v));

          // The distance of the centers is smallest at the angle zero. Where
          // one disk leaves the other one, the area has no further derivatives.
          // What matters is the overlap at v = 0.
          const double negligible = tolerance * area(d);
          double       sum        = 0.;
          double       begin      = 0.;
          const double full       = angle(v, std::abs(R1 - R2));
          const double none       = angle(v, R1 + R2);
          for (const double end : {full, none})
            {
              if (end > begin)
                sum +=
                  integrate_peak(
                    [&](const double phi) { return area(distance(v, phi)); },
                    begin,
                    end,
                    0.,
                    turn(v),
                    tolerance,
                    0.,
                    negligible)
                    .value;
              begin = std::max(begin, end);
            }
          return 2. * sum;
        }

        /** The derivative of the integral with respect to d. */
        double
        slope(const double v, const double tolerance) const
        {
          if (v == 0.)
            return -2. * pi * chord(d);
          // The chord grows as a square root where the edges begin to cross,
          // which the sine makes smooth.
          const double begin  = angle(v, std::abs(R1 - R2));
          const double end    = angle(v, R1 + R2);
          const double middle = .5 * (begin + end), half = .5 * (end - begin);
          if (half <= 0.)
            return 0.;
          return -2. * integrate_peak(
                         [&](const double theta) {
                           const double phi = middle + half * std::sin(theta);
                           const double s   = distance(v, phi);
                           return half * std::cos(theta) * chord(s) *
                                  (d - v * std::cos(phi)) / s;
                         },
                         -.5 * pi,
                         .5 * pi,
                         -.5 * pi,
                         std::min(1., std::sqrt(2. * turn(v) / half)),
                         tolerance,
                         0.,
                         tolerance * std::min(R1, R2))
                         .value;
        }

        /** Where the integral over v has to be split. */
        std::vector<double>
        breakpoints() const
        {
          const double        difference = std::abs(R1 - R2);
          std::vector<double> result     = {0.,
                                            std::abs(d - difference),
                                            d + difference,
                                            R1 + R2 - d,
                                            R1 + R2 + d};
          std::sort(result.begin(), result.end());
          return result;
        }

      private:
        double
        distance(const double v, const double phi) const
        {
          const double half = std::sin(.5 * phi);
          return std::sqrt((v - d) * (v - d) + 4. * v * d * half * half);
        }

        /** The angle by which v turns the connection of the centers, if it is
         * about as long as d. */
        double
        turn(const double v) const
        {
          return std::min(pi,
                          std::max(1e-9, std::abs(v - d) / std::sqrt(v * d)));
        }

        /** Where the distance of the centers is s. */
        double
        angle(const double v, const double s) const
        {
          const double cosine = (v * v + d * d - s * s) / (2. * v * d);
          return std::acos(std::min(1., std::max(-1., cosine)));
        }

        double
        area(const double s) const
        {
          if (s >= R1 + R2)
            return 0.;
          if (s <= std::abs(R1 - R2))
            return pi * std::pow(std::min(R1, R2), 2);
          // The angle by both its sides: its cosine alone is known to half of
          // the digits where the circles touch.
          const double half    = .5 * chord(s);
          const auto   segment = [=](const double R, const double other) {
            const double apothem =
              (s * s + (R - other) * (R + other)) / (2. * s);
            return R * R * std::atan2(half, apothem) - half * apothem;
          };
          return segment(R1, R2) + segment(R2, R1);
        }

        /** The common chord at the distance s: minus the slope of the area. */
        double
        chord(const double s) const
        {
          const double square = ((R1 + R2) - s) * (s + (R1 - R2)) *
                                (s - (R1 - R2)) * (s + (R1 + R2));
          return square > 0. ? std::sqrt(square) / s : 0.;
        }

        double R1, R2, d;
      };



      /**
       * The integral over all pairs of points of f(v), where v is the part of
       * their distance in the planes.
       *
       * @param weight The measure of the pairs by v, over v.
       * @param scale Where f begins to decay.
       */
      template <typename Weight>
      Estimate
      over_pairs(const Function    &f,
                 const Weight      &weight,
                 const Overlapping &overlapping,
                 const double       scale,
                 const double       tolerance)
      {
        const std::vector<double> breakpoints = overlapping.breakpoints();
        Estimate                  sum;
        for (unsigned int i = 0; i + 1 < breakpoints.size(); ++i)
          if (breakpoints[i + 1] > breakpoints[i])
            sum = sum + integrate_peak(
                          [&](const double v) {
                            return v * f(v) * weight(v, inner(tolerance));
                          },
                          breakpoints[i],
                          breakpoints[i + 1],
                          0.,
                          scale,
                          tolerance,
                          0.,
                          tolerance * std::abs(sum.value));
        return sum;
      }



      Overlapping
      overlapping_disks(const SectionPair &sections,
                        const double       distance,
                        const double       displacement)
      {
        AssertThrow(distance > 0. && displacement >= 0. &&
                      displacement < sections.radius_1 + sections.radius_2,
                    ExcRun("The disks do not face each other."));
        return Overlapping(sections, displacement);
      }
    } // namespace



    Estimate
    integrate_over_facing_disks(const Function    &f,
                                const SectionPair &sections,
                                const double       distance,
                                const double       displacement,
                                const double       tolerance)
    {
      const Overlapping disks =
        overlapping_disks(sections, distance, displacement);
      return sections.density_1 * sections.density_2 *
             over_pairs(
               f,
               [&](const double v, const double tolerance) {
                 return disks.integral(v, tolerance);
               },
               disks,
               distance,
               tolerance);
    }



    EnergyAndForce
    facing_disks(const InversePower &power,
                 const SectionPair  &sections,
                 const double        distance,
                 const double        displacement,
                 const double        tolerance)
    {
      const double h2                = distance * distance;
      const auto   power_of_distance = [&](const unsigned int exponent) {
        return integrate_over_facing_disks(
          [&](const double v) { return inverse_power(v * v + h2, exponent); },
          sections,
          distance,
          displacement,
          tolerance);
      };
      const unsigned int m = power.exponent;
      return power.prefactor *
             EnergyAndForce{power_of_distance(m),
                            m * distance * power_of_distance(m + 2)};
    }



    Estimate
    sideways_force_of_facing_disks(const InversePower &power,
                                   const SectionPair  &sections,
                                   const double        distance,
                                   const double        displacement,
                                   const double        tolerance)
    {
      const Overlapping disks =
        overlapping_disks(sections, distance, displacement);
      if (displacement == 0.)
        return {};
      return -power.prefactor * sections.density_1 * sections.density_2 *
             over_pairs(
               [&](const double v) {
                 return inverse_power(v * v + distance * distance,
                                      power.exponent);
               },
               [&](const double v, const double tolerance) {
                 return disks.slope(v, tolerance);
               },
               disks,
               distance,
               tolerance);
    }
  } // namespace References
} // namespace Setae
