// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <boost/math/tools/minima.hpp>

#include <setae/verification/disk_integral.h>

#include <algorithm>
#include <cmath>

namespace Setae
{
  namespace References
  {
    namespace
    {
      constexpr double pi = M_PI;

      /** An abscissa of a minimum is known to half of the digits. */
      constexpr int minimum_bits = 26;

      std::pair<double, double>
      minimum(const Function &f, const double a, const double b)
      {
        return boost::math::tools::brent_find_minima(f, a, b, minimum_bits);
      }
    } // namespace



    double
    angle_of_minimum(const Function &f)
    {
      constexpr unsigned int n      = 72;
      constexpr double       step   = 2. * pi / n;
      double                 angle  = 0.;
      double                 lowest = f(0.);
      for (unsigned int i = 1; i < n; ++i)
        if (const double value = f(i * step); value < lowest)
          {
            lowest = value;
            angle  = i * step;
          }
      const auto refined = minimum(f, angle - step, angle + step);

      // By symmetry the minimum often is one of the first angles: exactly.
      return refined.second < lowest ? refined.first : angle;
    }



    DiskPoint
    nearest_point_of_disk(const PlaneFunction &distance, const double radius)
    {
      const auto on_edge = [&](const double angle) {
        return distance(radius * std::cos(angle), radius * std::sin(angle));
      };
      const double angle = angle_of_minimum(on_edge);
      DiskPoint    nearest{radius, angle, on_edge(angle)};

      // Convex: inside it is closer only if a step inwards is.
      const double inside = (1. - 1e-6) * radius;
      if (distance(inside * std::cos(angle), inside * std::sin(angle)) >=
          nearest.distance)
        return nearest;

      double     y_of_minimum = 0.;
      const auto along_y      = [&](const double x) {
        const double y = std::sqrt(std::max(0., radius * radius - x * x));
        const auto   result =
          minimum([&](const double y) { return distance(x, y); }, -y, y);
        y_of_minimum = result.first;
        return result.second;
      };
      const double x = minimum(along_y, -radius, radius).first;
      const double d = along_y(x);
      return {std::hypot(x, y_of_minimum), std::atan2(y_of_minimum, x), d};
    }



    Estimate
    integrate_over_disk(const PlaneFunction &f,
                        const double         R,
                        const DiskPoint     &peak,
                        const double         tolerance)
    {
      // Along a ray from the peak; the angle is the one to the line through the
      // center, zero inwards.
      const auto along_ray = [&](const double angle) {
        const double direction = peak.angle + pi + angle;
        const double c = std::cos(direction), s = std::sin(direction);
        const double half_chord = std::sqrt(
          std::max(0., R * R - std::pow(peak.radius * std::sin(angle), 2.)));
        const double length = peak.radius * std::cos(angle) + half_chord;
        if (length <= 0.)
          return 0.;
        return integrate_peak([&](
                                const double p) { return p * f(p * c, p * s); },
                              0.,
                              length,
                              0.,
                              std::min(peak.distance, length),
                              inner(tolerance))
          .value;
      };

      if (peak.radius < R)
        return integrate(along_ray, 0., pi, tolerance) +
               integrate(along_ray, pi, 2. * pi, tolerance);

      // Seen from the edge, only rays within a small angle from the edge differ
      // from those across the disk.
      const double scale = std::min(1., std::sqrt(peak.distance / R));
      return integrate_peak(
               along_ray, -.5 * pi, 0., -.5 * pi, scale, tolerance) +
             integrate_peak(along_ray, 0., .5 * pi, .5 * pi, scale, tolerance);
    }
  } // namespace References
} // namespace Setae
