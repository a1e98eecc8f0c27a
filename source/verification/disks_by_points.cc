// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <setae/base/exceptions.h>
#include <setae/verification/disk_integral.h>
#include <setae/verification/disks.h>

#include <algorithm>
#include <cmath>

namespace Setae
{
  namespace References
  {
    using dealii::Tensor;

    namespace
    {
      /** A disk as a point sees it: gap in its plane and height above it. */
      struct DiskView
      {
        double       gap;
        double       height;
        Tensor<1, 3> outward; ///< unit vector in the plane

        double
        distance() const
        {
          return std::hypot(height, std::max(gap, 0.));
        }
      };



      DiskView
      view_of_disk(const Tensor<1, 3> &point, const Disk &disk, const double R)
      {
        const Tensor<1, 3> x = point - disk.center;
        DiskView           view;
        view.height    = x * disk.normal;
        view.outward   = x - view.height * disk.normal;
        const double t = view.outward.norm();
        view.gap       = t - R;
        if (t > 0.)
          view.outward /= t;
        return view;
      }



      /** The view from a point next to one whose view is known. */
      DiskView
      view_from_neighbor(const DiskView     &view,
                         const Tensor<1, 3> &step,
                         const Disk         &disk,
                         const double        R)
      {
        const double       t  = R + view.gap;
        const double       up = step * disk.normal;
        const Tensor<1, 3> a  = step - up * disk.normal;

        DiskView result;
        result.height      = view.height + up;
        result.outward     = t * view.outward + a;
        const double t_new = result.outward.norm();
        result.gap         = (view.gap * (2. * R + view.gap) +
                      2. * t * (view.outward * a) + a * a) /
                     (t_new + R);
        if (t_new > 0.)
          result.outward /= t_new;
        return result;
      }



      /** Minus the derivative of the potential of a point along a direction. */
      double
      force_on_point(const InversePower &power,
                     const double        R,
                     const DiskView     &view,
                     const Disk         &disk,
                     const Tensor<1, 3> &direction,
                     const double        tolerance)
      {
        const double       h2 = view.height * view.height;
        const unsigned int m  = power.exponent;
        // The two parts may cancel: each has its own tolerance.
        const double in_plane   = view.outward * direction;
        const double along_axis = view.height * (disk.normal * direction);
        double       sum        = 0.;
        if (in_plane != 0. && view.gap > -R)
          sum += in_plane * slope_over_disk(
                              [&](const double p) {
                                return p * inverse_power(p * p + h2, m + 2);
                              },
                              R,
                              view.gap,
                              tolerance)
                              .value;
        if (along_axis != 0.)
          sum += along_axis * integrate_over_disk(
                                [&](const double p) {
                                  return inverse_power(p * p + h2, m + 2);
                                },
                                R,
                                view.gap,
                                tolerance,
                                std::abs(view.height))
                                .value;
        return power.prefactor * m * sum;
      }



      /** The disk that is integrated over, and its point next to the other. */
      class OuterDisk
      {
      public:
        OuterDisk(const Disk  &disk,
                  const double radius,
                  const Disk  &other,
                  const double other_radius)
          : R(radius)
          , other(other)
          , other_radius(other_radius)
        {
          // The x-axis points to the center of the other disk.
          const Tensor<1, 3> &n = disk.normal;
          e                     = other.center - disk.center;
          e -= (e * n) * n;
          if (e.norm() < 1e-8 * R)
            {
              unsigned int smallest = 0;
              for (unsigned int c = 1; c < 3; ++c)
                if (std::abs(n[c]) < std::abs(n[smallest]))
                  smallest = c;
              e           = 0.;
              e[smallest] = 1.;
              e -= (e * n) * n;
            }
          e /= e.norm();
          f = dealii::cross_product_3d(n, e);

          const auto view = [&](const double x, const double y) {
            return view_of_disk(disk.center + x * e + y * f,
                                other,
                                other_radius);
          };
          nearest = nearest_point_of_disk(
            [&](const double x, const double y) {
              return view(x, y).distance();
            },
            R);
          AssertThrow(nearest.distance > 0., ExcRun("The disks touch."));
          from_nearest = view(nearest.radius * std::cos(nearest.angle),
                              nearest.radius * std::sin(nearest.angle));
        }

        /** Whether the other disk is next to the edge, a sharper peak. */
        bool
        is_met_at_edge() const
        {
          return nearest.radius == R;
        }

        /** The integral of what points feel of the other disk. */
        Estimate
        integrate(const std::function<double(const DiskView &)> &felt,
                  const double tolerance) const
        {
          return integrate_over_disk(
            [&](const double dx, const double dy) {
              return felt(view_from_neighbor(
                from_nearest, dx * e + dy * f, other, other_radius));
            },
            R,
            nearest,
            tolerance);
        }

      private:
        double       R;
        Disk         other;
        double       other_radius;
        Tensor<1, 3> e, f;
        DiskPoint    nearest;
        DiskView     from_nearest;
      };



      /**
       * The integral over whichever disk is met at its edge, the first one if
       * both are.
       *
       * @param felt What a point of one disk, given by its view, feels of the
       * other one, which is given with its radius, and whether it is the first.
       */
      Estimate
      over_one_disk(
        const std::function<
          double(const DiskView &, const Disk &, double, bool)> &felt,
        const SectionPair                                       &sections,
        const Disk                                              &disk_1,
        const Disk                                              &disk_2,
        const double                                             tolerance)
      {
        const double    R1 = sections.radius_1, R2 = sections.radius_2;
        const OuterDisk first(disk_1, R1, disk_2, R2);
        const double    densities = sections.density_1 * sections.density_2;
        if (!first.is_met_at_edge())
          {
            const OuterDisk second(disk_2, R2, disk_1, R1);
            if (second.is_met_at_edge())
              return densities * second.integrate(
                                   [&](const DiskView &view) {
                                     return felt(view, disk_1, R1, true);
                                   },
                                   tolerance);
          }
        return densities * first.integrate(
                             [&](const DiskView &view) {
                               return felt(view, disk_2, R2, false);
                             },
                             tolerance);
      }
    } // namespace



    Estimate
    energy_of_disks_by_points(const InversePower &power,
                              const SectionPair  &sections,
                              const Disk         &disk_1,
                              const Disk         &disk_2,
                              const double        tolerance)
    {
      return over_one_disk(
        [&](const DiskView &view, const Disk &, const double R, bool) {
          return point_and_disk(
                   power, R, view.gap, view.height, inner(inner(tolerance)))
            .value;
        },
        sections,
        disk_1,
        disk_2,
        tolerance);
    }



    EnergyAndForce
    disks_by_points(const InversePower &power,
                    const SectionPair  &sections,
                    const Disk         &disk_1,
                    const Disk         &disk_2,
                    const Tensor<1, 3> &direction,
                    const double        tolerance)
    {
      return {
        energy_of_disks_by_points(power, sections, disk_1, disk_2, tolerance),
        over_one_disk(
          [&](const DiskView &view,
              const Disk     &felt_disk,
              const double    R,
              const bool      is_first) {
            return force_on_point(power,
                                  R,
                                  view,
                                  felt_disk,
                                  is_first ? -1. * direction : direction,
                                  inner(inner(tolerance)));
          },
          sections,
          disk_1,
          disk_2,
          tolerance)};
    }
  } // namespace References
} // namespace Setae
