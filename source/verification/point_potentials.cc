// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <setae/base/exceptions.h>
#include <setae/verification/point_potentials.h>

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
       * Where a point sees a disk: over the angle gamma of the edge, from the
       * nearest point of the edge to the farthest one.
       */
      struct EdgeView
      {
        EdgeView(const double radius, const double gap)
          : R(radius)
          , gap(gap)
          , t(radius + gap)
        {}

        /** The distance p of a point of the edge. */
        double
        distance(const double gamma) const
        {
          const double half = std::sin(.5 * gamma);
          return std::sqrt(gap * gap + 4. * t * R * half * half);
        }

        /** p dp / dgamma */
        double
        jacobian(const double gamma) const
        {
          return t * R * std::sin(gamma);
        }

        /** The angle between the lines to the center and to the edge. */
        double
        half_angle(const double gamma) const
        {
          const double half = std::sin(.5 * gamma);
          return std::atan2(R * std::sin(gamma), gap + 2. * R * half * half);
        }

        /** Of the dependence on gamma near zero. */
        double
        scale() const
        {
          const double g = std::max(std::abs(gap), 1e-13 * R);
          return t > 0. ? std::min(pi, g / std::sqrt(t * R)) : pi;
        }

        double R, gap, t;
      };

    } // namespace



    PlanarDisk::PlanarDisk(const unsigned int exponent, const double radius)
      : p(exponent)
      , R(radius)
      , value_function(
          exponent > 2 ?
            Hypergeometric(2. - p / 2., 2. - p / 2., exponent - 2) :
            Hypergeometric(p / 2., p / 2., 2 - exponent))
      , derivative_function(1. - p / 2., 2. - p / 2., exponent - 1)
    {}



    double
    PlanarDisk::value(const double gap) const
    {
      const double t          = R + gap;
      const double z          = R / t * (R / t);
      const double complement = gap * (t + R) / (t * t);
      const double singular   = p > 2. ? std::pow(complement, 2. - p) : 1.;
      return pi * R * R * std::pow(t, -p) * singular *
             value_function(z, complement);
    }



    double
    PlanarDisk::derivative(const double gap) const
    {
      const double t          = R + gap;
      const double z          = R / t * (R / t);
      const double complement = gap * (t + R) / (t * t);
      return -p * pi * R * R * std::pow(t, -p - 1.) *
             std::pow(complement, 1. - p) * derivative_function(z, complement);
    }



    PointCylinder::PointCylinder(const InversePower &power, const double radius)
      : factor(power.prefactor * line_factor(power.exponent))
      , disk(power.exponent - 1, radius)
    {}



    double
    PointCylinder::value(const double gap) const
    {
      return factor * disk.value(gap);
    }



    double
    PointCylinder::derivative(const double gap) const
    {
      return factor * disk.derivative(gap);
    }



    double
    chord_integral(const unsigned int q, const double R, const double gap)
    {
      const double x          = R + gap;
      const double z          = R / x * (R / x);
      const double complement = gap * (x + R) / (x * x);
      if (q <= 2)
        return pi * R * R * std::pow(x, -1. * q) * 2. /
               ((1. + std::sqrt(complement)) *
                (q == 2 ? std::sqrt(complement) : 1.));

      // By Euler's transformation a polynomial in z.
      const double a = 2. - .5 * q, b = 1.5 - .5 * q;
      double       polynomial = 0., term = 1.;
      for (unsigned int n = 0; term != 0.; ++n)
        {
          polynomial += term;
          term *= (a + n) * (b + n) / ((2. + n) * (1. + n)) * z;
        }
      return pi * R * R * std::pow(x, -1. * q) * std::pow(complement, 1.5 - q) *
             polynomial;
    }



    Estimate
    integrate_over_disk(const Function &f,
                        const double    radius,
                        const double    gap,
                        const double    tolerance,
                        const double    scale)
    {
      // Around a point inside whole circles, which matter most.
      Estimate result;
      if (gap < 0.)
        result =
          integrate_peak([&](const double p) { return 2. * pi * p * f(p); },
                         0.,
                         -gap,
                         0.,
                         std::min(scale, -gap),
                         tolerance);

      const EdgeView view(radius, gap);
      if (view.t > 0.)
        result = result + integrate_peak(
                            [&](const double gamma) {
                              return 2. * view.half_angle(gamma) *
                                     f(view.distance(gamma)) *
                                     view.jacobian(gamma);
                            },
                            0.,
                            pi,
                            0.,
                            view.scale(),
                            tolerance,
                            0.,
                            tolerance * std::abs(result.value));
      return result;
    }



    Estimate
    slope_over_disk(const Function &slope,
                    const double    radius,
                    const double    gap,
                    const double    tolerance)
    {
      const EdgeView view(radius, gap);
      return integrate_peak(
        [&](const double gamma) {
          const double p = view.distance(gamma);
          return 2. * radius * std::sin(gamma) / p * slope(p) *
                 view.jacobian(gamma);
        },
        0.,
        pi,
        0.,
        view.scale(),
        tolerance);
    }



    Estimate
    point_and_cylinder(const InversePower &power,
                       const double        radius,
                       const double        gap,
                       const Interval     &z,
                       const double        tolerance)
    {
      const SegmentIntegral segment(power.exponent);
      return power.prefactor *
             integrate_over_disk([&](const double p) { return segment(p, z); },
                                 radius,
                                 gap,
                                 tolerance,
                                 std::max(z.begin, -z.end));
    }



    Estimate
    point_and_disk(const InversePower &power,
                   const double        radius,
                   const double        gap,
                   const double        height,
                   const double        tolerance)
    {
      return power.prefactor *
             integrate_over_disk(
               [&](const double p) {
                 return inverse_power(p * p + height * height, power.exponent);
               },
               radius,
               gap,
               tolerance,
               std::abs(height));
    }
  } // namespace References
} // namespace Setae
