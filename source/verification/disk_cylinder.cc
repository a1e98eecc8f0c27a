// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <boost/math/tools/minima.hpp>

#include <setae/base/exceptions.h>
#include <setae/verification/disk_cylinder.h>
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
       * The disk seen along the axis of the cylinder: an ellipse. Its chords
       * normal to the axis keep their length, R1 cos(chi) to both sides of the
       * longer half axis, those along it are shortened by cos(alpha). A point
       * of the ellipse is (V,Y), V along the chords.
       */
      class ProjectedDisk
      {
      public:
        ProjectedDisk(const SectionPair &sections, const DiskPose &pose)
          : R1(sections.radius_1)
          , R2(sections.radius_2)
          , gap(pose.gap)
          , cos_alpha(std::abs(pose.cosine))
        {
          const double sin2_alpha = 1. - cos_alpha * cos_alpha;
          AssertThrow(cos_alpha <= 1. &&
                        pose.tilt * pose.tilt <= sin2_alpha + 1e-14,
                      ExcRun("A disk cannot have this cosine and this tilt."));
          sin_omega =
            sin2_alpha > 0. ?
              std::min(1., std::abs(pose.tilt) / std::sqrt(sin2_alpha)) :
              0.;
          cos_omega = std::sqrt((1. - sin_omega) * (1. + sin_omega));
        }

        /** One chord. */
        struct Chord
        {
          double length;
          double begin; ///< V at the end that is nearer to the axis
          double Y;
          double surplus; ///< begin^2 + Y^2 - R2^2
        };

        Chord
        chord(const double chi) const
        {
          const double d    = R1 + R2 + gap;
          const double half = std::sin(.5 * chi);

          Chord chord;
          chord.length = 2. * R1 * std::cos(chi);
          chord.begin  = d * cos_omega - R1 * std::cos(chi);
          chord.Y      = d * sin_omega - R1 * std::sin(chi) * cos_alpha;

          // The difference to R2 of the larger coordinate, where all that is of
          // the order of the radius but cancels comes from small angles.
          if (cos_omega >= sin_omega)
            {
              const double excess =
                gap + 2. * R1 * half * half -
                d * sin_omega * sin_omega / (1. + cos_omega);
              chord.surplus = excess * (2. * R2 + excess) + chord.Y * chord.Y;
            }
          else
            {
              const double excess =
                (R1 + gap) - d * cos_omega * cos_omega / (1. + sin_omega) -
                R1 * std::sin(chi) * cos_alpha;
              chord.surplus =
                excess * (2. * R2 + excess) + chord.begin * chord.begin;
            }
          return chord;
        }

        /** Distance from the surface of a point of a chord. */
        double
        distance(const Chord &chord, const double tau) const
        {
          const double V       = chord.begin + tau;
          const double surplus = chord.surplus + tau * (chord.begin + V);
          return surplus / (std::hypot(V, chord.Y) + R2);
        }

        /** The smallest one of a chord. */
        double
        distance(const Chord &chord) const
        {
          return distance(chord,
                          std::min(chord.length, std::max(0., -chord.begin)));
        }

        /** Of all chords the one with the nearest point. */
        double
        nearest_chord() const
        {
          if (sin_omega == 0. || cos_alpha == 0.)
            return 0.;
          return boost::math::tools::brent_find_minima(
                   [&](const double chi) { return distance(chord(chi)); },
                   -.5 * pi,
                   .5 * pi,
                   26)
            .first;
        }

        double
        smallest_distance() const
        {
          return distance(chord(nearest_chord()));
        }

        /**
         * The integral over the disk of a function of the distance from the
         * surface and of the direction of the point, (V cos(omega) + Y
         * sin(omega)) / |(V,Y)|, i.e. its cosine with n.
         */
        Estimate
        integrate(const std::function<double(double, double)> &f,
                  const double                                 tolerance) const
        {
          const double chi      = nearest_chord();
          const double smallest = distance(chord(chi));
          AssertThrow(smallest > 0.,
                      ExcRun("The disk reaches into the cylinder."));
          return integrate_peak(
            [&](const double chi) {
              const Chord c = chord(chi);
              return R1 * std::cos(chi) *
                     along_chord(f, c, inner(tolerance)).value;
            },
            -.5 * pi,
            .5 * pi,
            chi,
            std::min(1., std::sqrt(smallest / R1)),
            tolerance);
        }

      private:
        Estimate
        along_chord(const std::function<double(double, double)> &f,
                    const Chord                                 &c,
                    const double tolerance) const
        {
          const double peak     = std::max(0., -c.begin);
          const double smallest = distance(c, peak);
          const double x        = R2 + smallest;
          const double curved   = std::sqrt(2. * smallest * x);
          const double scale =
            c.begin > 0. ? std::min(curved, smallest * x / c.begin) : curved;
          return integrate_peak(
            [&](const double tau) {
              const double V = c.begin + tau;
              return f(distance(c, tau),
                       (V * cos_omega + c.Y * sin_omega) / std::hypot(V, c.Y));
            },
            0.,
            c.length,
            peak,
            scale,
            tolerance);
        }

        double R1, R2, gap, cos_alpha, sin_omega, cos_omega;
      };
    } // namespace



    double
    distance(const SectionPair &sections, const DiskPose &pose)
    {
      return ProjectedDisk(sections, pose).smallest_distance();
    }



    Estimate
    energy_of_disk_and_cylinder(const InversePower &power,
                                const SectionPair  &sections,
                                const DiskPose     &pose,
                                const double        tolerance)
    {
      const PointCylinder cylinder(power, sections.radius_2);
      return sections.density_1 * sections.density_2 *
             ProjectedDisk(sections, pose)
               .integrate([&](const double distance,
                              double) { return cylinder.value(distance); },
                          tolerance);
    }



    EnergyAndForce
    disk_and_cylinder(const InversePower &power,
                      const SectionPair  &sections,
                      const DiskPose     &pose,
                      const double        tolerance)
    {
      const PointCylinder cylinder(power, sections.radius_2);
      return {energy_of_disk_and_cylinder(power, sections, pose, tolerance),
              sections.density_1 * sections.density_2 *
                ProjectedDisk(sections, pose)
                  .integrate(
                    [&](const double distance, const double cosine) {
                      return -cylinder.derivative(distance) * cosine;
                    },
                    tolerance)};
    }



    Estimate
    energy_of_disk_and_cylinder(const InversePower &power,
                                const SectionPair  &sections,
                                const Disk         &disk,
                                const Interval     &cylinder,
                                const double        tolerance)
    {
      const double        R1 = sections.radius_1, R2 = sections.radius_2;
      const Tensor<1, 3> &n = disk.normal;

      // Face to face with the end: a stack of facing disks.
      const double before       = std::max(cylinder.begin - disk.center[2],
                                     disk.center[2] - cylinder.end);
      const double displacement = std::hypot(disk.center[0], disk.center[1]);
      if (std::hypot(n[0], n[1]) < 1e-14 && before > 0. &&
          displacement < R1 + R2)
        {
          const SegmentIntegral stack(power.exponent);
          const Interval z = {before, before + (cylinder.end - cylinder.begin)};
          return power.prefactor *
                 integrate_over_facing_disks(
                   [&](const double v) { return stack(v, z); },
                   sections,
                   before,
                   displacement,
                   tolerance);
        }

      // In the plane of the disk: one axis normal to z, the other one rising.
      Tensor<1, 3> e({-n[1], n[0], 0.});
      if (e.norm() < 1e-12)
        e = Tensor<1, 3>({1., 0., 0.});
      e /= e.norm();
      const Tensor<1, 3> f = dealii::cross_product_3d(n, e);

      const auto distance = [&](const double x, const double y) {
        const Tensor<1, 3> r   = disk.center + x * e + y * f;
        const double       gap = std::hypot(r[0], r[1]) - R2;
        const double       beyond =
          std::max({0., cylinder.begin - r[2], r[2] - cylinder.end});
        return beyond > 0. ? std::hypot(beyond, std::max(0., gap)) : gap;
      };
      const DiskPoint nearest = nearest_point_of_disk(distance, R1);
      AssertThrow(nearest.distance > 0.,
                  ExcRun("The disk reaches into the cylinder."));

      const Tensor<1, 3> peak =
        disk.center + nearest.radius * (std::cos(nearest.angle) * e +
                                        std::sin(nearest.angle) * f);
      const double t   = std::hypot(peak[0], peak[1]);
      const double gap = t - R2;
      return sections.density_1 * sections.density_2 *
             integrate_over_disk(
               [&](const double dx, const double dy) {
                 const Tensor<1, 3> step = dx * e + dy * f;
                 const double       t_new =
                   std::hypot(peak[0] + step[0], peak[1] + step[1]);
                 const double gap_new =
                   (gap * (2. * R2 + gap) +
                    2. * (peak[0] * step[0] + peak[1] * step[1]) +
                    step[0] * step[0] + step[1] * step[1]) /
                   (t_new + R2);
                 const double z = peak[2] + step[2];
                 return point_and_cylinder(power,
                                           R2,
                                           gap_new,
                                           {cylinder.begin - z,
                                            cylinder.end - z},
                                           inner(inner(tolerance)))
                   .value;
               },
               R1,
               nearest,
               tolerance);
    }
  } // namespace References
} // namespace Setae
