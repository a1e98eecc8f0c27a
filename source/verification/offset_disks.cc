// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <setae/base/exceptions.h>
#include <setae/verification/disks.h>

#include <algorithm>
#include <cmath>

namespace Setae
{
  namespace References
  {
    namespace
    {
      constexpr double pi = M_PI;

      /**
       * The second disk of ISSIP eq. A6 as the center of the first one sees it:
       * over the angle beta of the edge of the second disk.
       */
      class SecondDisk
      {
      public:
        SecondDisk(const SectionPair &sections, const double gap)
          : R1(sections.radius_1)
          , R2(sections.radius_2)
          , gap(gap)
          , d(R1 + R2 + gap)
          , densities(sections.density_1 * sections.density_2)
        {
          AssertThrow(gap > 0.,
                      ExcRun("A reference needs a positive gap, not " +
                             std::to_string(gap) + "."));
        }

        /**
         * The integral over the second disk of a potential.
         *
         * @param potential A function of the gap between point and first disk.
         */
        Estimate
        integrate(const Function &potential, const double tolerance) const
        {
          return over_edge(
            [&](const double beta) {
              return 2. * half_angle(beta) * potential(point_gap(beta));
            },
            tolerance);
        }

        /**
         * Minus its derivative with respect to the gap.
         *
         * @param slope The derivative of the potential.
         */
        Estimate
        force(const Function &slope, const double tolerance) const
        {
          return over_edge(
            [&](const double beta) {
              const double s = point_gap(beta);
              return -2. * R2 * std::sin(beta) / (R1 + s) * slope(s);
            },
            tolerance);
        }

      private:
        Estimate
        over_edge(const Function &f, const double tolerance) const
        {
          return densities * d * R2 *
                 integrate_peak(
                   [&](const double beta) { return std::sin(beta) * f(beta); },
                   0.,
                   pi,
                   0.,
                   std::min(pi, std::sqrt(2. * gap * (R1 + gap) / (d * R2))),
                   tolerance);
        }

        double
        point_gap(const double beta) const
        {
          const double half = std::sin(.5 * beta);
          const double s    = 4. * d * R2 * half * half;
          const double near = R1 + gap;
          return gap + s / (near + std::sqrt(near * near + s));
        }

        double
        half_angle(const double beta) const
        {
          const double half = std::sin(.5 * beta);
          return std::atan2(R2 * std::sin(beta),
                            R1 + gap + 2. * R2 * half * half);
        }

        double R1, R2, gap, d, densities;
      };
    } // namespace



    EnergyAndForce
    coplanar_disks(const InversePower &power,
                   const SectionPair  &sections,
                   const double        gap,
                   const double        tolerance)
    {
      const PlanarDisk disk(power.exponent, sections.radius_1);
      const SecondDisk second(sections, gap);
      return power.prefactor *
             EnergyAndForce{
               second.integrate([&](const double s) { return disk.value(s); },
                                tolerance),
               second.force([&](const double s) { return disk.derivative(s); },
                            tolerance)};
    }



    Estimate
    integrate_over_disks(const Function    &f,
                         const SectionPair &sections,
                         const double       gap,
                         const double       tolerance)
    {
      return SecondDisk(sections, gap)
        .integrate(
          [&](const double s) {
            return integrate_over_disk(f,
                                       sections.radius_1,
                                       s,
                                       inner(tolerance))
              .value;
          },
          tolerance);
    }



    Estimate
    force_over_disks(const Function    &slope,
                     const SectionPair &sections,
                     const double       gap,
                     const double       tolerance)
    {
      return SecondDisk(sections, gap)
        .force(
          [&](const double s) {
            return slope_over_disk(slope,
                                   sections.radius_1,
                                   s,
                                   inner(tolerance))
              .value;
          },
          tolerance);
    }



    EnergyAndForce
    offset_disks(const InversePower &power,
                 const SectionPair  &sections,
                 const double        gap,
                 const double        offset,
                 const double        tolerance)
    {
      const unsigned int m = power.exponent;
      return power.prefactor *
             EnergyAndForce{integrate_over_disks(
                              [&](const double p) {
                                return inverse_power(p * p + offset * offset,
                                                     m);
                              },
                              sections,
                              gap,
                              tolerance),
                            force_over_disks(
                              [&](const double p) {
                                return -1. * m * p *
                                       inverse_power(p * p + offset * offset,
                                                     m + 2);
                              },
                              sections,
                              gap,
                              tolerance)};
    }
  } // namespace References
} // namespace Setae
