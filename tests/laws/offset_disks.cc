// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

// The law of two disks at an offset against hypergeometric functions, integrals
// and automatic derivatives.

#include <boost/math/quadrature/exp_sinh.hpp>
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <boost/math/special_functions/gamma.hpp>
#include <boost/math/special_functions/hypergeometric_pFq.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>

#include <gtest/gtest.h>

#include <setae/laws/disk_cylinder.h>
#include <setae/laws/lennard_jones.h>
#include <setae/laws/offset_disks.h>

#include <cmath>
#include <random>
#include <vector>

#include "../nested_sacado.h"

using namespace Setae;

namespace
{
  using Real = boost::multiprecision::cpp_bin_float_50;

  constexpr SectionPair  sections    = {.02, .05, 3., .7};
  constexpr unsigned int exponents[] = {4, 5, 6, 7, 8, 9, 10, 12, 13, 20};

  /** Gauss' series, for |x| not close to one. */
  Real
  series(const Real &a, const Real &b, const Real &c, const Real &x)
  {
    Real term = 1., sum = 0.;
    for (unsigned int j = 0; abs(term) > 1e-45 * abs(sum); ++j)
      {
        sum += term;
        term *= (a + j) * (b + j) / ((c + j) * (j + 1)) * x;
      }
    return sum;
  }

  /**
   * 2F1(a,b;c;-y) for y >= 0 in 50 digits: by Pfaff's transformation, and for
   * large y by the connection to infinity, where b - a must be no integer.
   */
  Real
  hypergeometric(const Real &a, const Real &b, const Real &c, const Real &y)
  {
    using boost::math::tgamma;
    if (y < 2)
      return pow(Real(1 + y), Real(-a)) * series(a, c - b, c, y / (1 + y));
    const auto branch = [&](const Real &a, const Real &b) {
      return Real(tgamma(c) * tgamma(Real(b - a)) /
                  (tgamma(b) * tgamma(Real(c - a))) * pow(y, Real(-a)) *
                  series(a, a - c + 1, a - b + 1, -1 / y));
    };
    return branch(a, b) + branch(b, a);
  }

  /** OffsetPower in 50 digits. */
  struct Reference
  {
    Real value, o, g, oo, og, gg;

    Reference(const unsigned int m,
              const unsigned int k,
              const Real        &q1,
              const Real        &q2)
    {
      // The powers q2^h f(y), y = (q1/q2)^2, and derivatives by y.
      const Real h = Real(7) / 2 - m - k, a = -h / 2, b = a + Real(1) / 2,
                 c = Real(m) / 2, y = (q1 / q2) * (q1 / q2);
      const Real f0 = hypergeometric(a, b, c, y),
                 f1 = -a * b / c * hypergeometric(a + 1, b + 1, c + 1, y),
                 f2 = a * (a + 1) * b * (b + 1) / (c * (c + 1)) *
                      hypergeometric(a + 2, b + 2, c + 2, y);
      const Real y_o = 2 * q1 / (q2 * q2), y_g = -2 * y / q2;
      const Real power = pow(q2, h);
      value            = power * f0;
      o                = power * f1 * y_o;
      g                = power * (h / q2 * f0 + f1 * y_g);
      oo               = power * (f2 * y_o * y_o + f1 * 2 / (q2 * q2));
      og = power * (f2 * y_o * y_g + f1 * (h / q2 * y_o - 2 * y_o / q2));
      gg = power * (h * (h - 1) / (q2 * q2) * f0 + 2 * h / q2 * f1 * y_g +
                    f2 * y_g * y_g + f1 * 6 * y / (q2 * q2));
    }
  };

  /** 0 and ratios of offset and gap from 1e-8 to 1e8. */
  std::vector<double>
  ratios()
  {
    std::vector<double> result = {0.};
    for (double e = -8.; e <= 8.; e += .25)
      result.push_back(std::pow(10., e));
    return result;
  }

  void
  expect_relative(const double actual, const Real &expected, const double e)
  {
    EXPECT_NEAR(actual, double(expected), e * std::abs(double(expected)));
  }

  OffsetDisks
  lennard_jones(const GapRange &range)
  {
    return {lennard_jones_of_cylinders(1e-3, -1., sections), sections, range};
  }

  /** Both parts positive, for sizes in which nothing cancels. */
  OffsetDisks
  sizes(const GapRange &range)
  {
    PointPotential potential = lennard_jones_of_cylinders(1e-3, -1., sections);
    for (InversePower &power : potential)
      power.prefactor = std::abs(power.prefactor);
    return {potential, sections, range};
  }
} // namespace



TEST(OffsetPower, IsTheHypergeometricFunctionForAllRatios)
{
  for (const unsigned int m : exponents)
    for (const unsigned int k : {0, 1, 2})
      {
        const OffsetPower power(m, k);
        for (const double gap : {1e-6, 300.})
          for (const double ratio : ratios())
            {
              const double    offset = ratio * gap;
              const Reference reference(m, k, offset, gap);
              SCOPED_TRACE(testing::Message() << m << ' ' << k << ' ' << ratio);
              expect_relative(power.value(offset, gap), reference.value, 2e-14);
              const OffsetGapDerivatives p = power.derivatives(offset, gap);
              expect_relative(p.value, reference.value, 2e-14);
              expect_relative(p.o, reference.o, 1e-13);
              expect_relative(p.g, reference.g, 2e-13);
              expect_relative(p.og, reference.og, 2e-13);

              expect_relative(p.gg, reference.gg, k == 2 ? 1e-12 : 1e-13);

              // This one has a zero near the ratio of one half.
              const double oo = double(reference.oo);
              EXPECT_NEAR(p.oo,
                          oo,
                          2e-13 * std::max(std::abs(oo),
                                           ratio < 1. ? std::abs(p.gg) : 0.));
            }
      }
}



// A library in place of our own series, where it has the function.
TEST(OffsetPower, IsBoostsHypergeometricFunctionForSmallRatios)
{
  for (const unsigned int m : exponents)
    for (double ratio = 0.; ratio < .9; ratio += .01)
      expect_relative(OffsetPower(m, 0).value(ratio, 1.),
                      boost::math::hypergeometric_pFq({(2. * m - 7.) / 4.,
                                                       (2. * m - 5.) / 4.},
                                                      {m / 2.},
                                                      -ratio * ratio),
                      1e-13);
}



TEST(OffsetPower, HasItsDerivativesInTheGapAsNextPowers)
{
  std::mt19937                           random(1);
  std::uniform_real_distribution<double> exponent(-3., 3.);
  for (const unsigned int m : exponents)
    for (unsigned int i = 0; i < 100; ++i)
      {
        const double offset = std::pow(10., exponent(random));
        const double gap    = std::pow(10., exponent(random));
        const auto   at     = [&](const unsigned int k) {
          return OffsetPower(m, k).derivatives(offset, gap);
        };
        const double first = 3.5 - m, second = first * (2.5 - m);
        expect_relative(at(0).g, first * at(1).value, 1e-13);
        expect_relative(at(0).og, first * at(1).o, 1e-13);
        expect_relative(at(0).gg, second * at(2).value, 1e-13);
      }
}



TEST(OffsetDisks, AreDiskDiskWithoutOffset)
{
  for (const GapRange &range : {GapRange(), GapRange{1e-3, .05, .1}})
    {
      const OffsetDisks law = lennard_jones(range);
      const DiskDisk    disks(lennard_jones_of_cylinders(1e-3, -1., sections),
                           sections,
                           range);
      for (const double gap : {1e-5, 1e-3, 2e-3, .01, .06, .09, .2})
        {
          const OffsetGapDerivatives a = law(0., gap);
          const GapDerivatives       b = disks(gap);
          EXPECT_NEAR(a.value, b.value, 1e-13 * std::abs(b.value));
          EXPECT_NEAR(a.g, b.first, 1e-12 * std::abs(b.first));
          EXPECT_NEAR(a.gg, b.second, 1e-11 * std::abs(b.second));
          EXPECT_EQ(a.o, 0.);
          EXPECT_EQ(a.og, 0.);
        }
    }
}



// ISSIP eq. 32, which SSIP does not fulfill.
TEST(OffsetDisks, AreTwoParallelCylindersWhenIntegrated)
{
  boost::math::quadrature::exp_sinh<double> half_line;
  for (const unsigned int m : {6, 7, 8, 12, 13})
    {
      const PointPotential potential = {{m, -2.}};
      const OffsetDisks    law(potential, sections, {});
      const DiskCylinder   cylinders(potential, sections, {});
      for (const double gap : {1e-5, 1e-3, .1, 2.})
        {
          const double integral =
            2. * gap * half_line.integrate([&](const double x) {
              return law(x * gap, gap).value;
            });
          const double expected = cylinders(gap, 1.).value;
          EXPECT_NEAR(integral, expected, 1e-10 * std::abs(expected)) << m;
        }
    }
}



// The four-fold integral of ISSIP eq. 21 with r^2 = p^2 + q1^2; what the law
// leaves out is of the order of the distance over the radius.
TEST(OffsetDisks, ApproachTheExactIntegral)
{
  const auto exact = [](const double m, const double q1, const double q2) {
    boost::math::quadrature::tanh_sinh<double> inner, outer;
    const double                               d = 2. + q2;
    const auto chord_angle                       = [](const double cosine) {
      return std::acos(std::min(1., std::max(-1., cosine)));
    };
    return 4. * outer.integrate(
                  [&](const double u) {
                    const double t = 1. + q2 + u;
                    const double psi =
                      chord_angle((t * t + d * d - 1.) / (2. * t * d));
                    return t * psi *
                           inner.integrate(
                             [&](const double l) {
                               const double p = std::exp(l);
                               return p * p *
                                      std::pow(p * p + q1 * q1, -.5 * m) *
                                      chord_angle((t * t + p * p - 1.) /
                                                  (2. * t * p));
                             },
                             std::log(t - 1.),
                             std::log(t + 1.),
                             1e-6);
                  },
                  0.,
                  2.,
                  1e-6);
  };
  const SectionPair equal;
  for (const unsigned int m : {6, 12})
    for (const double ratio : {0., .5, 2.})
      for (const double q2 : {1e-2, 1e-3})
        {
          const OffsetDisks law({{m, 1.}}, equal, {});
          EXPECT_NEAR(law(ratio * q2, q2).value / exact(m, ratio * q2, q2),
                      1.,
                      3. * (1. + ratio) * q2)
            << m << ' ' << ratio;
        }
}



// Above, below and at the regularization gap, and where the law is switched
// off.
TEST(OffsetDisks, HaveTheDerivativesOfTheEnergy)
{
  const GapRange    range = {1e-3, .05, .1};
  const OffsetDisks law = lennard_jones(range), size = sizes({1e-3});
  std::mt19937      random(2);
  std::uniform_real_distribution<double> exponent(-6., -1.);
  for (unsigned int i = 0; i < 2000; ++i)
    {
      const double offset =
        (i % 2 == 0 ? 1. : -1.) * std::pow(10., exponent(random));
      const double               gap = i % 10 == 0 ? 1e-3 :
                                       i % 10 < 4 ? 1e-3 - std::pow(10., exponent(random)) :
                                                    1e-3 + std::pow(10., exponent(random));
      const OffsetGapDerivatives a   = law(offset, gap);
      const OffsetGapDerivatives s   = size(offset, std::max(gap, 1e-3));
      const LocalSystem<2>       b   = local_system<2>(
        law.energy(variable<2>(0, offset), variable<2>(1, gap)));

      // Expansion below, switch above.
      const double width = .05, x = std::max(0., 1e-3 - gap);
      const double gg     = s.gg + 60. * s.value / (width * width),
                   g      = std::abs(s.g) + x * gg + 2. * s.value / width,
                   v      = s.value + x * g;
      const double     oo = gg * (1. + std::pow(10. * x / 1e-3, 2));
      constexpr double e  = 1e-12;
      EXPECT_NEAR(a.value, b.energy, e * v);
      EXPECT_NEAR(a.o, b.residual[0], e * g * std::sqrt(oo / gg));
      EXPECT_NEAR(a.g, b.residual[1], e * g);
      EXPECT_NEAR(a.oo, b.tangent[0][0], e * oo) << offset << ' ' << gap;
      EXPECT_NEAR(a.og, b.tangent[0][1], e * std::sqrt(oo * gg));
      EXPECT_NEAR(a.gg, b.tangent[1][1], e * gg);
    }
}



TEST(OffsetDisks, HaveTwoContinuousDerivativesWhereRegularized)
{
  const OffsetDisks law = lennard_jones({1e-3});
  for (const double offset : {0., 1e-4, 1e-3, .1})
    {
      const OffsetGapDerivatives above = law(offset, 1e-3),
                                 below = law(offset, 1e-3 * (1. - 1e-12));
      const double s                   = 1e-8 * std::abs(above.gg);
      EXPECT_NEAR(above.value, below.value, 1e-6 * s);
      EXPECT_NEAR(above.o, below.o, 1e-3 * s);
      EXPECT_NEAR(above.g, below.g, 1e-3 * s);
      EXPECT_NEAR(above.oo, below.oo, s);
      EXPECT_NEAR(above.og, below.og, s);
      EXPECT_NEAR(above.gg, below.gg, s);
    }
}



// The cutoff is a distance of centers, less the radii.
TEST(OffsetDisks, EndAtTheCutoff)
{
  const OffsetDisks law = lennard_jones({0., .05, .1});
  EXPECT_EQ(law.cutoff(), .1);
  const double height = .08, radii = .07;
  const double end = std::sqrt(.17 * .17 - height * height);
  EXPECT_NE(law(.999 * end, height - radii).gg, 0.);
  EXPECT_EQ(law(1.001 * end, height - radii).value, 0.);
  EXPECT_EQ(law(1.001 * end, height - radii).oo, 0.);
}
