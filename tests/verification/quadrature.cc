// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

// The parts that all references are made of: quadrature, hypergeometric
// function, potentials of a point.

#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/ellint_2.hpp>

#include <setae/base/exceptions.h>
#include <setae/verification/disk_integral.h>
#include <setae/verification/point_potentials.h>

#include <cmath>
#include <limits>

#include "agreement.h"

using namespace Setae;
using namespace Setae::References;

namespace
{
  constexpr double pi       = M_PI;
  constexpr double infinity = std::numeric_limits<double>::infinity();
} // namespace



TEST(ReferenceQuadrature, TakesPeaksOfAnyWidth)
{
  for (const double width : {1e-9, 1e-3, 1.})
    {
      const auto peak = [&](const double x) {
        return 1. / (width * width + x * x);
      };
      const auto expected = [&](const double a, const double b) {
        return std::atan2(width * (b - a), width * width + a * b) / width;
      };
      for (const double begin : {-1., 0., .5})
        EXPECT_NEAR(integrate_peak(peak, begin, 2., 0., width, 1e-10).value /
                      expected(begin, 2.),
                    1.,
                    1e-11);
      EXPECT_NEAR(
        integrate_peak(peak, -infinity, infinity, 0., width, 1e-10, 100.)
            .value *
          width / pi,
        1.,
        1e-11);
    }
}



TEST(ReferenceQuadrature, ThrowsIfTheToleranceIsMissed)
{
  // An infinite integral, more digits than a double has, not a number.
  EXPECT_THROW(integrate([](const double x) { return 1. / x; }, 0., 1., 1e-10),
               ExcRun);
  EXPECT_THROW(
    integrate([](const double x) { return std::exp(x); }, 0., 1., 1e-15),
    ExcRun);
  EXPECT_THROW(
    integrate([](const double x) { return std::log(-1. - x); }, 0., 1., 1e-10),
    ExcRun);
}



// A part of something larger need not be known to its last digit.
TEST(ReferenceQuadrature, IsContentWithANegligibleError)
{
  unsigned int n    = 0;
  const auto   root = [&n](const double x) {
    ++n;
    return std::sqrt(x);
  };
  integrate(root, 0., 1., 1e-12);
  const unsigned int n_exact = n;
  n                          = 0;
  EXPECT_NEAR(integrate(root, 0., 1., 1e-12, 1e-3).value, 2. / 3., 1e-3);
  EXPECT_LT(n, n_exact);
}



TEST(ReferenceQuadrature, PassesExceptionsOfTheIntegrandOn)
{
  EXPECT_THROW(
    integrate([](const double) -> double { throw std::runtime_error(""); },
              0.,
              1.,
              1e-10),
    std::runtime_error);
}



TEST(ReferenceQuadrature, DiskIntegralIsExactForPolynomialsAroundAnyPoint)
{
  const double R = 1.3;
  for (const DiskPoint &peak :
       {DiskPoint{R, .4, 1e-6}, DiskPoint{R, 2., .1}, DiskPoint{.5, 1., 1e-3}})
    {
      const double x = peak.radius * std::cos(peak.angle);
      const double y = peak.radius * std::sin(peak.angle);
      EXPECT_NEAR(integrate_over_disk(
                    [&](const double dx, const double dy) {
                      return (x + dx) * (x + dx) + 3. * (y + dy) * (y + dy);
                    },
                    R,
                    peak,
                    1e-10)
                      .value /
                    (pi * std::pow(R, 4)),
                  1.,
                  1e-10);
    }
}



TEST(ReferenceQuadrature, FindsTheNearestPointOfADisk)
{
  const DiskPoint edge = nearest_point_of_disk(
    [](const double x, const double y) { return std::hypot(x - 3., y - 4.); },
    1.);
  EXPECT_EQ(edge.radius, 1.);
  EXPECT_NEAR(edge.angle, std::atan2(4., 3.), 1e-7);
  EXPECT_NEAR(edge.distance, 4., 1e-14);

  const DiskPoint inside = nearest_point_of_disk(
    [](const double x, const double y) {
      return std::hypot(.2, std::hypot(x - .3, y + .4));
    },
    1.);
  EXPECT_NEAR(inside.radius, .5, 1e-6);
  EXPECT_NEAR(inside.angle, std::atan2(-.4, .3), 1e-6);
  EXPECT_NEAR(inside.distance, .2, 1e-12);
}



TEST(ReferenceHypergeometric, HasTheValuesOfEllipticIntegrals)
{
  for (const double complement : {1e-12, 1e-6, .1, .49, .51, .9})
    {
      const double z = 1. - complement, k = std::sqrt(z);
      EXPECT_NEAR(Hypergeometric(.5, .5, 0)(z, complement) /
                    (2. / pi * boost::math::ellint_1(k)),
                  1.,
                  complement < 1e-10 ? 1e-5 : 1e-10);
      EXPECT_NEAR(Hypergeometric(-.5, .5, 1)(z, complement) /
                    (2. / pi * boost::math::ellint_2(k)),
                  1.,
                  1e-14);
    }
}



// With mpmath at 30 digits.
TEST(ReferenceHypergeometric, HasTheValuesOfArbitraryPrecision)
{
  struct Value
  {
    double       a, b;
    unsigned int difference;
    double       complement, value;
  };
  for (const Value &v : {Value{-0.5, -0.5, 3, 1e-6, 1.13176834273799066},
                         Value{-3.5, -3.5, 9, 0.001, 14.6940585014059807},
                         Value{-3.5, -3.5, 9, 0.4, 7.23222145051762993},
                         Value{-4.5, -3.5, 10, 0.05, 22.0316381443832906},
                         Value{-1.5, -0.5, 4, 0.3, 1.25445234504827826},
                         Value{0.5, 1.5, 0, 1e-6, 9.28707909003983077},
                         Value{1., 1., 0, 0.01, 4.65168705655362764},
                         Value{-7.5, -7.5, 17, 0.45, 216.951552321228721},
                         Value{-2., -1.5, 6, 0.2, 2.01485714285714286},
                         Value{-3.5, -3.5, 9, 0.8, 2.48980261192800823}})
    EXPECT_NEAR(Hypergeometric(v.a, v.b, v.difference)(1. - v.complement,
                                                       v.complement) /
                  v.value,
                1.,
                5e-15);
}



TEST(ReferencePotentials, CylinderIsADiskOfLines)
{
  const double R = .7;
  for (const unsigned int m : {2, 3, 4, 5, 6, 9, 12, 20})
    for (const double gap : {1e-6, 1e-2, .3, 20.})
      {
        const PointCylinder cylinder({m, -2.}, R);
        const double        factor = -2. * line_factor(m);
        EXPECT_NEAR(cylinder.value(gap) /
                      (factor *
                       integrate_over_disk(
                         [&](const double p) { return std::pow(p, 1. - m); },
                         R,
                         gap,
                         1e-11)
                         .value),
                    1.,
                    1e-12);
        EXPECT_NEAR(cylinder.derivative(gap) /
                      (factor * slope_over_disk(
                                  [&](const double p) {
                                    return (1. - m) * std::pow(p, -1. * m);
                                  },
                                  R,
                                  gap,
                                  1e-11)
                                  .value),
                    1.,
                    1e-12);
      }
}



TEST(ReferencePotentials, PlaneAndCylinderIsElementary)
{
  const double R = .7;
  for (const unsigned int m : {3, 4, 5, 6, 7, 12})
    for (const double gap : {1e-6, 1e-2, .3, 20.})
      {
        const PointCylinder cylinder({m, 1.}, R);
        const double        X     = R + gap;
        const Estimate      plane = integrate_peak(
          [&](const double Y) {
            return cylinder.value((gap * (X + R) + Y * Y) /
                                  (std::hypot(X, Y) + R));
          },
          -infinity,
          infinity,
          0.,
          std::sqrt(2. * gap * X),
          1e-10,
          1e3 * X);
        EXPECT_NEAR(2. * pi / (m - 2.) * chord_integral(m - 2, R, gap) /
                      plane.value,
                    1.,
                    1e-10);
      }
}



TEST(ReferencePotentials, SegmentsAddUpAndMatchQuadrature)
{
  for (const unsigned int m : {1, 2, 3, 6, 12, 20})
    {
      const SegmentIntegral segment(m);
      for (const double p : {1e-6, .3, 5.})
        for (const Interval z : {Interval{-2., 1.},
                                 Interval{.1, .4},
                                 Interval{-.3, -.1},
                                 Interval{0., 10.},
                                 Interval{8., 9.},
                                 Interval{8., 8.000001}})
          {
            const Estimate quadrature = integrate_peak(
              [&](const double z) { return std::pow(p * p + z * z, -.5 * m); },
              z.begin,
              z.end,
              0.,
              p,
              1e-11);
            EXPECT_NEAR(segment(p, z) / quadrature.value, 1., 1e-12);
          }
      EXPECT_NEAR(segment(0., {1., 2.}),
                  m == 1 ? std::log(2.) :
                           (1. - std::pow(2., 1. - m)) / (m - 1.),
                  1e-15);
      if (m >= 2)
        {
          const double halves =
            segment(.3, {-infinity, .2}) + segment(.3, {.2, infinity});
          EXPECT_NEAR(halves / (line_factor(m) * std::pow(.3, 1. - m)),
                      1.,
                      1e-14);
        }
    }
}



TEST(ReferencePotentials, PairsOfSegmentsMatchQuadrature)
{
  for (const unsigned int m : {1, 2, 3, 6, 12})
    for (const Overlap overlap : {Overlap{2., 3., -.5},
                                  Overlap{2., 2., 0.},
                                  Overlap{3., 1., .7},
                                  Overlap{1., 2., 4.},
                                  Overlap{1e-6, 2e-6, 1.}})
      for (const double p : {1e-3, .3})
        {
          const SegmentIntegral segment(m);
          const auto            pairs = [&](const double z) {
            return segment(p,
                           {overlap.shift - z,
                            overlap.shift + overlap.length_2 - z});
          };
          // From end to end of the target, where the integrand varies on the
          // scale p.
          const double middle =
            std::min(overlap.length_1,
                     std::max(0., overlap.shift + .5 * overlap.length_2));
          const double expected =
            integrate_peak(pairs, 0., middle, overlap.shift, p, 1e-10).value +
            integrate_peak(pairs,
                           middle,
                           overlap.length_1,
                           overlap.shift + overlap.length_2,
                           p,
                           1e-10)
              .value;
          EXPECT_NEAR(DoubleSegmentIntegral(m)(p, PairMeasure(overlap)) /
                        expected,
                      1.,
                      1e-10);
        }
}



// A point beside, above and beyond the edge of the end.
TEST(ReferencePotentials, CylinderIsAStackOfDisks)
{
  const double R = .7;
  for (const unsigned int m : {1, 3, 6, 12})
    for (const double gap : {.1, -.1, -.7})
      {
        const Interval z     = {.05, 2.};
        const Estimate stack = integrate_peak(
          [&](const double height) {
            return point_and_disk({m, 1.}, R, gap, height, 1e-10).value;
          },
          z.begin,
          z.end,
          0.,
          .05,
          1e-9);
        expect_agreement(point_and_cylinder({m, 1.}, R, gap, z), stack);
      }
}
