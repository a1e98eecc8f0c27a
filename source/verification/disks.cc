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
        const double h2       = view.height * view.height;
        const double m        = power.exponent;
        const double exponent = -.5 * m - 1.;
        // The two parts may cancel: each has its own tolerance.
        const double in_plane   = view.outward * direction;
        const double along_axis = view.height * (disk.normal * direction);
        double       sum        = 0.;
        if (in_plane != 0. && view.gap > -R)
          sum += in_plane * slope_over_disk(
                              [&](const double p) {
                                return p * std::pow(p * p + h2, exponent);
                              },
                              R,
                              view.gap,
                              tolerance)
                              .value;
        if (along_axis != 0.)
          sum += along_axis * integrate_over_disk(
                                [&](const double p) {
                                  return std::pow(p * p + h2, exponent);
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
      const double m = power.exponent;
      return power.prefactor *
             EnergyAndForce{integrate_over_disks(
                              [&](const double p) {
                                return std::pow(p * p + offset * offset,
                                                -.5 * m);
                              },
                              sections,
                              gap,
                              tolerance),
                            force_over_disks(
                              [&](const double p) {
                                return -m * p *
                                       std::pow(p * p + offset * offset,
                                                -.5 * m - 1.);
                              },
                              sections,
                              gap,
                              tolerance)};
    }



    Estimate
    energy_of_disks(const InversePower &power,
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
    disks(const InversePower &power,
          const SectionPair  &sections,
          const Disk         &disk_1,
          const Disk         &disk_2,
          const Tensor<1, 3> &direction,
          const double        tolerance)
    {
      return {energy_of_disks(power, sections, disk_1, disk_2, tolerance),
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
