// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

// The functions of the gap that laws are made of, and their derivatives against
// automatic ones.

#include <gtest/gtest.h>

#include <setae/laws/short_range.h>

#include <cmath>
#include <random>
#include <vector>

#include "../nested_sacado.h"

using namespace Setae;

namespace
{
  const std::vector<InversePowers::Term> terms = {{-2., 1}, {3e-9, 7}};

  std::vector<InversePowers::Term>
  positive(std::vector<InversePowers::Term> terms)
  {
    for (InversePowers::Term &term : terms)
      term.coefficient = std::abs(term.coefficient);
    return terms;
  }

  /** Gaps over 13 decades, spread evenly on a logarithmic scale. */
  std::vector<double>
  many_gaps(const double smallest = 1e-12)
  {
    std::mt19937                           random(1);
    std::uniform_real_distribution<double> exponent(std::log10(smallest), 1.);
    std::vector<double>                    gaps;
    for (unsigned int i = 0; i < 1000; ++i)
      gaps.push_back(std::pow(10., exponent(random)));
    return gaps;
  }

  /**
   * The errors of f.derivatives() relative to the derivatives of @p scale, in
   * which no terms cancel.
   */
  template <typename Function>
  void
  expect_derivatives(const Function      &f,
                     const InversePowers &scale,
                     const double         gap)
  {
    const LocalSystem<1> expected =
      local_system<1>(f.value(variable<1>(0, gap)));
    const GapDerivatives actual = f.derivatives(gap);
    const GapDerivatives size   = scale.derivatives(gap);
    constexpr double     e      = 1e-14;
    EXPECT_NEAR(actual.value, f.value(gap), e * size.value);
    EXPECT_NEAR(actual.value, expected.energy, e * size.value);
    EXPECT_NEAR(actual.first, expected.residual[0], -e * size.first);
    EXPECT_NEAR(actual.second, expected.tangent[0][0], e * size.second);
  }

  /** Derivatives at @p gap against their limits from below and above. */
  template <typename Function>
  void
  expect_continuous(const Function &f, const double gap)
  {
    const GapDerivatives at = f.derivatives(gap);
    const double         h  = 1e-9 * gap;
    for (const double side : {gap - h, gap + h})
      {
        // Anything but a jump is of the order h.
        const GapDerivatives next = f.derivatives(side);
        EXPECT_NEAR(next.value, at.value, 1e-7 * (1. + std::abs(at.value)));
        EXPECT_NEAR(next.first, at.first, 1e-6 * (1. + std::abs(at.first)));
        EXPECT_NEAR(next.second, at.second, 1e-5 * (1. + std::abs(at.second)));
      }
  }
} // namespace



TEST(InversePowers, IsTheSumOfItsPowers)
{
  const InversePowers f(terms);
  for (const double gap : many_gaps())
    EXPECT_NEAR(f.value(gap) /
                  (-2. * std::pow(gap, -1.5) + 3e-9 * std::pow(gap, -7.5)),
                1.,
                1e-11);
}



TEST(InversePowers, HasTheDerivativesOfItsValue)
{
  for (const double gap : many_gaps())
    expect_derivatives(InversePowers(terms),
                       InversePowers(positive(terms)),
                       gap);
}



TEST(Regularized, HasTheDerivativesOfItsValue)
{
  constexpr double                 gap_regularization = 1e-3;
  const Regularized<InversePowers> f(InversePowers(terms), gap_regularization);

  // Below, the terms of the expansion have the size of the function there.
  const InversePowers scale(positive(terms));
  for (const double gap : many_gaps())
    if (gap > gap_regularization)
      expect_derivatives(f, scale, gap);
    else
      {
        const LocalSystem<1> expected =
          local_system<1>(f.value(variable<1>(0, gap)));
        const GapDerivatives actual = f.derivatives(gap);
        EXPECT_DOUBLE_EQ(actual.value, expected.energy);
        EXPECT_DOUBLE_EQ(actual.first, expected.residual[0]);
        EXPECT_DOUBLE_EQ(actual.second, expected.tangent[0][0]);
      }
}



TEST(Regularized, IsAParabolaBelowTheRegularizationGapAndNegative)
{
  constexpr double                 g0 = 1e-3;
  const InversePowers              f(terms);
  const Regularized<InversePowers> r(f, g0);
  const GapDerivatives             at = f.derivatives(g0);
  for (const double gap : {.9 * g0, .1 * g0, 0., -g0, -50. * g0})
    {
      const double x = gap - g0;
      EXPECT_TRUE(r.admits(gap));
      EXPECT_DOUBLE_EQ(r.derivatives(gap).value,
                       at.value + at.first * x + .5 * at.second * x * x);
      EXPECT_DOUBLE_EQ(r.derivatives(gap).first, at.first + at.second * x);
      EXPECT_DOUBLE_EQ(r.derivatives(gap).second, at.second);
      EXPECT_DOUBLE_EQ(r.value(gap), r.derivatives(gap).value);
    }
}



TEST(Regularized, HasTwoContinuousDerivatives)
{
  const Regularized<InversePowers> r(InversePowers(terms), .01);
  const GapDerivatives             at = InversePowers(terms).derivatives(.01);
  const GapDerivatives below          = r.derivatives(std::nextafter(.01, 0.));
  EXPECT_NEAR(below.value / at.value, 1., 1e-13);
  EXPECT_NEAR(below.first / at.first, 1., 1e-13);
  EXPECT_NEAR(below.second / at.second, 1., 1e-13);
}



TEST(Regularized, WithoutRegularizationAdmitsPositiveGapsOnly)
{
  const Regularized<InversePowers> r(InversePowers(terms), 0.);
  EXPECT_TRUE(r.admits(1e-300));
  EXPECT_FALSE(r.admits(0.));
  EXPECT_FALSE(r.admits(-1e-300));
  EXPECT_DOUBLE_EQ(r.derivatives(1e-9).first,
                   InversePowers(terms).derivatives(1e-9).first);
}



TEST(SmoothCutoff, HasTheDerivativesOfItsValue)
{
  const SmoothCutoff<InversePowers> f(InversePowers(terms), .5, .8);
  const InversePowers               scale(positive(terms));
  for (const double gap : many_gaps())
    if (gap < .5)
      expect_derivatives(f, scale, gap);
  for (unsigned int i = 0; i <= 1000; ++i)
    {
      // The derivatives of the switch are up to 60 times those of the power.
      const double         gap = .5 + .3 * i / 1000.;
      const LocalSystem<1> expected =
        local_system<1>(f.value(variable<1>(0, gap)));
      const GapDerivatives actual = f.derivatives(gap);
      const double         size   = scale.value(gap);
      EXPECT_NEAR(actual.value, expected.energy, 1e-14 * size);
      EXPECT_NEAR(actual.first, expected.residual[0], 1e-13 * size);
      EXPECT_NEAR(actual.second, expected.tangent[0][0], 1e-12 * size);
    }
}



TEST(SmoothCutoff, HasTwoContinuousDerivatives)
{
  const SmoothCutoff<InversePowers> f(InversePowers(terms), .5, .8);
  expect_continuous(f, .5);
  expect_continuous(f, .8);
}



TEST(SmoothCutoff, LeavesTheFunctionBelowAndNothingAbove)
{
  const InversePowers               g(terms);
  const SmoothCutoff<InversePowers> f(g, .5, .8);
  EXPECT_DOUBLE_EQ(f.value(.3), g.value(.3));
  EXPECT_NEAR(f.value(.65), .5 * g.value(.65), 1e-14);
  for (const double gap : {.8, .9, 1e9})
    {
      EXPECT_EQ(f.value(gap), 0.);
      EXPECT_EQ(f.derivatives(gap).value, 0.);
      EXPECT_EQ(f.derivatives(gap).first, 0.);
      EXPECT_EQ(f.derivatives(gap).second, 0.);
    }
}



TEST(SmoothCutoff, CanBeHardOrAbsent)
{
  const double                      infinity = GapRange().cutoff;
  const InversePowers               g(terms);
  const SmoothCutoff<InversePowers> hard(g, .8, .8), late(g, infinity, .8),
    absent(g, infinity, infinity);
  for (const auto &f : {hard, late})
    {
      EXPECT_EQ(f.value(.8), 0.);
      EXPECT_EQ(f.derivatives(.8).value, 0.);
      EXPECT_EQ(f.value(.7), g.value(.7));
      EXPECT_EQ(f.derivatives(.7).second, g.derivatives(.7).second);
    }
  EXPECT_EQ(absent.value(1e9), g.value(1e9));
  EXPECT_EQ(absent.derivatives(1e9).first, g.derivatives(1e9).first);
}
