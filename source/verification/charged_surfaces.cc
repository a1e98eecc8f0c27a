// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <setae/base/exceptions.h>
#include <setae/verification/charged_surfaces.h>
#include <setae/verification/disk_integral.h>

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

      /**
       * The integral along a ring of a function of the squared distance from a
       * point.
       *
       * @param gap In the plane of the ring, from the projection of the point.
       * @param height Distance from that plane.
       */
      Estimate
      over_ring(const Function &f,
                const double    R,
                const double    gap,
                const double    height,
                const double    tolerance)
      {
        const double t       = R + gap;
        const double nearest = gap * gap + height * height;
        const double scale =
          t > 0. ? std::min(pi, std::sqrt(nearest / (t * R))) : pi;
        return 2. * R *
               integrate_peak(
                 [&](const double gamma) {
                   const double half = std::sin(.5 * gamma);
                   return f(nearest + 4. * t * R * half * half);
                 },
                 0.,
                 pi,
                 0.,
                 scale,
                 tolerance);
      }



      double
      densities(const SectionPair &sections)
      {
        return sections.density_1 * sections.density_2;
      }
    } // namespace



    Estimate
    energy_of_rings(const InversePower &power,
                    const SectionPair  &sections,
                    const Disk         &ring_1,
                    const Disk         &ring_2,
                    const double        tolerance)
    {
      const double R1 = sections.radius_1, R2 = sections.radius_2;

      // The first ring starts where it is closest to the other center, or
      // anywhere.
      const Tensor<1, 3> &n = ring_1.normal;
      Tensor<1, 3>        e = ring_2.center - ring_1.center;
      e -= (e * n) * n;
      if (e.norm() < 1e-8 * R1)
        {
          e = dealii::cross_product_3d(n, ring_2.normal);
          if (e.norm() < 1e-8)
            e = std::abs(n[0]) < .5 ? Tensor<1, 3>({1., 0., 0.}) :
                                      Tensor<1, 3>({0., 1., 0.});
          e -= (e * n) * n;
        }
      e /= e.norm();
      const Tensor<1, 3> f = dealii::cross_product_3d(n, e);

      const auto cylindrical = [&](const double beta) {
        const Tensor<1, 3> x = ring_1.center - ring_2.center +
                               R1 * (std::cos(beta) * e + std::sin(beta) * f);
        const double height = x * ring_2.normal;
        return std::make_pair((x - height * ring_2.normal).norm() - R2, height);
      };
      const auto distance = [&](const double beta) {
        const auto [gap, height] = cylindrical(beta);
        return std::hypot(gap, height);
      };
      const double nearest  = angle_of_minimum(distance);
      const double smallest = distance(nearest);
      AssertThrow(smallest > 0., ExcRun("The rings touch."));

      const double exponent   = -.5 * power.exponent;
      const auto   from_point = [&](const double beta) {
        const auto [gap, height] = cylindrical(beta);
        return over_ring([&](
                           const double r2) { return std::pow(r2, exponent); },
                         R2,
                         gap,
                         height,
                         inner(tolerance))
          .value;
      };
      const double scale = std::min(1., std::sqrt(smallest / R1));
      return power.prefactor * densities(sections) * R1 *
             (integrate_peak(
                from_point, nearest, nearest + pi, nearest, scale, tolerance) +
              integrate_peak(
                from_point, nearest - pi, nearest, nearest, scale, tolerance));
    }



    Estimate
    energy_of_parallel_surfaces(const InversePower &power,
                                const SectionPair  &sections,
                                const double        gap,
                                const Overlap      &overlap,
                                const double        tolerance)
    {
      AssertThrow(gap > 0., ExcRun("A reference needs a positive gap."));
      const double R1 = sections.radius_1, R2 = sections.radius_2;
      const double d = R1 + R2 + gap;

      const PairMeasure           pairs(overlap);
      const DoubleSegmentIntegral segments(power.exponent);
      const auto                  along_axes = [&](const double r2) {
        return segments(std::sqrt(r2), pairs);
      };
      const auto from_point = [&](const double beta) {
        const double half      = std::sin(.5 * beta);
        const double s         = 4. * d * R2 * half * half;
        const double near      = R1 + gap;
        const double point_gap = gap + s / (near + std::sqrt(near * near + s));
        return over_ring(along_axes, R1, point_gap, 0., inner(tolerance)).value;
      };
      return power.prefactor * densities(sections) * 2. * R2 *
             integrate_peak(
               from_point,
               0.,
               pi,
               0.,
               std::min(pi, std::sqrt(2. * gap * (R1 + gap) / (d * R2))),
               tolerance);
    }



    Estimate
    energy_of_crossing_surfaces(const InversePower &power,
                                const SectionPair  &sections,
                                const double        gap,
                                const double        angle,
                                const double        length_1,
                                const double        length_2,
                                const double        tolerance)
    {
      AssertThrow(gap > 0., ExcRun("A reference needs a positive gap."));
      const double R1 = sections.radius_1, R2 = sections.radius_2;
      const double sine = std::sin(angle), cosine = std::cos(angle);

      const SegmentIntegral segment(power.exponent);

      // X along the gap, Z along the target. A line of the source at its angle
      // beta, which is zero next to the target, and its point at s.
      const auto from_line = [&](const double beta) {
        const double half       = std::sin(.5 * beta);
        const double height     = gap + 2. * R1 * half * half; // X-R2
        const double side       = R1 * std::sin(beta);
        const double X          = R2 + height;
        const auto   from_point = [&](const double s) {
          const double Y = s * sine + side * cosine;
          const double Z = s * cosine - side * sine;
          const double point_gap =
            (height * (X + R2) + Y * Y) / (std::hypot(X, Y) + R2);
          return over_ring(
                   [&](const double r2) {
                     return segment(std::sqrt(r2),
                                    {-.5 * length_2 - Z, .5 * length_2 - Z});
                   },
                   R2,
                   point_gap,
                   0.,
                   inner(inner(tolerance)))
            .value;
        };
        return integrate_peak(from_point,
                              -.5 * length_1,
                              .5 * length_1,
                              sine > 0. ? -side * cosine / sine : 0.,
                              std::sqrt(2. * height * X),
                              inner(tolerance))
          .value;
      };
      return power.prefactor * densities(sections) * 2. * R1 *
             integrate_peak(from_line,
                            0.,
                            pi,
                            0.,
                            std::min(pi, std::sqrt(2. * gap / R1)),
                            tolerance);
    }



    Estimate
    energy_of_crossing_monopoles(const InversePower &power,
                                 const SectionPair  &sections,
                                 const double        gap,
                                 const double        angle,
                                 const double        length_1,
                                 const double        length_2,
                                 const double        tolerance)
    {
      const double          R1 = sections.radius_1, R2 = sections.radius_2;
      const double          d    = R1 + R2 + gap;
      const double          sine = std::sin(angle), cosine = std::cos(angle);
      const SegmentIntegral segment(power.exponent);
      return power.prefactor * densities(sections) * 4. * pi * pi * R1 * R2 *
             integrate_peak(
               [&](const double s) {
                 const double z = s * cosine;
                 return segment(std::hypot(d, s * sine),
                                {-.5 * length_2 - z, .5 * length_2 - z});
               },
               -.5 * length_1,
               .5 * length_1,
               0.,
               d,
               tolerance);
    }
  } // namespace References
} // namespace Setae
