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
                  integrate(
                    [&](const double phi) { return area(distance(v, phi)); },
                    begin,
                    end,
                    tolerance,
                    negligible)
                    .value;
              begin = std::max(begin, end);
            }
          return 2. * sum;
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
          const auto segment = [s](const double R, const double other) {
            const double cosine =
              (s * s + R * R - other * other) / (2. * s * R);
            const double a = std::acos(std::min(1., std::max(-1., cosine)));
            return R * R * (a - .5 * std::sin(2. * a));
          };
          return segment(R1, R2) + segment(R2, R1);
        }

        double R1, R2, d;
      };
    } // namespace



    EnergyAndForce
    facing_disks(const InversePower &power,
                 const SectionPair  &sections,
                 const double        distance,
                 const double        displacement,
                 const double        tolerance)
    {
      AssertThrow(distance > 0. && displacement >= 0. &&
                    displacement < sections.radius_1 + sections.radius_2,
                  ExcRun("The disks do not face each other."));
      const Overlapping         overlapping(sections, displacement);
      const std::vector<double> v                 = overlapping.breakpoints();
      const double              h2                = distance * distance;
      const auto                power_of_distance = [&](const double exponent) {
        Estimate sum;
        for (unsigned int i = 0; i + 1 < v.size(); ++i)
          if (v[i + 1] > v[i])
            sum = sum + integrate_peak(
                          [&](const double v) {
                            return v * std::pow(v * v + h2, exponent) *
                                   overlapping.integral(v, inner(tolerance));
                          },
                          v[i],
                          v[i + 1],
                          0.,
                          distance,
                          tolerance,
                          0.,
                          tolerance * std::abs(sum.value));
        return sum;
      };
      const double m = power.exponent;
      return power.prefactor * sections.density_1 * sections.density_2 *
             EnergyAndForce{power_of_distance(-.5 * m),
                            m * distance * power_of_distance(-.5 * m - 1.)};
    }
  } // namespace References
} // namespace Setae
