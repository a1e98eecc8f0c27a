// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <gtest/gtest.h>

#include <setae/far_field/taylor_expansion.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace Setae;

namespace
{
  struct Charge
  {
    double       q;
    Tensor<1, 3> offset;
  };

  /** Charges of either sign within a ball around a center. */
  struct Cluster
  {
    Cluster(const unsigned int seed, const double radius)
    {
      std::mt19937                           random(seed);
      std::uniform_real_distribution<double> uniform(-1., 1.);
      while (charges.size() < 7)
        {
          Charge charge;
          charge.q = uniform(random);
          for (unsigned int c = 0; c < 3; ++c)
            charge.offset[c] = radius * uniform(random);
          if (charge.offset.norm() < radius)
            charges.push_back(charge);
        }
    }

    std::vector<double>
    moments(const TaylorExpansion &expansion) const
    {
      std::vector<double> result(expansion.size(), 0.);
      for (const Charge &c : charges)
        expansion.add_charge(c.q, c.offset, result.data());
      return result;
    }

    std::vector<double>
    powers(const unsigned int order) const
    {
      std::vector<double> result(order + 1, 0.);
      for (const Charge &c : charges)
        for (unsigned int n = 0; n <= order; ++n)
          result[n] += std::abs(c.q) * std::pow(c.offset.norm(), n);
      return result;
    }

    std::vector<Charge> charges;
  };

  const PointPotential coulomb = {{1, 1.}};
  const PointPotential several = {{1, -.3}, {2, .5}, {3, 1.}, {6, .1}};
  const Tensor<1, 3>   R({1.2, -.9, 2.});
  const double         radius = .4;

  std::vector<double>
  local_of(const TaylorExpansion &expansion, const std::vector<double> &moments)
  {
    TaylorExpansion::Kernel kernel;
    expansion.evaluate_kernel(R, kernel);
    std::vector<double> local(expansion.size(), 0.);
    expansion.interact(kernel, moments.data(), local.data());
    return local;
  }
} // namespace



TEST(TaylorExpansion, StaysBelowItsBoundOfTheError)
{
  for (const PointPotential &potential : {coulomb, PointPotential{{3, 2.}}})
    for (const unsigned int order : {1, 2, 4, 8, 12})
      for (const double size : {.1, .4, .7})
        {
          const TaylorExpansion expansion(potential, order);
          const Cluster         A(1, size), B(2, size);
          const auto local = local_of(expansion, B.moments(expansion));

          double error = 0., magnitude = 0.;
          for (const Charge &a : A.charges)
            {
              Tensor<1, 3> force;
              for (const Charge &b : B.charges)
                {
                  const Tensor<1, 3> d = R + a.offset - b.offset;
                  for (const auto &[m, k] : potential)
                    {
                      const double f = m * k * std::pow(d.norm(), -(m + 2.));
                      force -= b.q * f * d;
                      magnitude += std::abs(a.q * b.q) * f * d.norm();
                    }
                }
              error +=
                (a.q * (expansion.derivatives(local.data(), a.offset).gradient -
                        force))
                  .norm();
            }
          const double bound = expansion.relative_error(A.powers(order),
                                                        B.powers(order),
                                                        2. * size,
                                                        R.norm());
          EXPECT_LT(error, bound * magnitude) << order << ' ' << size;
          EXPECT_GT(error, 0.);
        }
}

TEST(TaylorExpansion, GainsDigitsWithTheOrder)
{
  const Cluster A(3, radius), B(4, radius);
  double        exact = 0.;
  for (const Charge &a : A.charges)
    for (const Charge &b : B.charges)
      for (const auto &[m, k] : several)
        exact +=
          a.q * b.q * k * std::pow((R + a.offset - b.offset).norm(), -1. * m);

  double last_error = 1e300;
  for (const unsigned int order : {2, 5, 8, 11, 14})
    {
      const TaylorExpansion expansion(several, order);
      const auto            local  = local_of(expansion, B.moments(expansion));
      double                energy = 0.;
      for (const Charge &a : A.charges)
        energy += a.q * expansion.value(local.data(), a.offset);
      const double error = std::abs(energy - exact);
      EXPECT_LT(error, .2 * last_error);
      last_error = error;
    }
  EXPECT_LT(last_error, 1e-7);
}

// Both sides see the same energy, and moments and potential may be moved.
TEST(TaylorExpansion, IsTheSameFromBothSidesAndAboutAnyCenter)
{
  const TaylorExpansion expansion(several, 6);
  const Cluster         A(5, radius), B(6, radius);
  const auto            M_A = A.moments(expansion), M_B = B.moments(expansion);
  const auto            local_A = local_of(expansion, M_B);

  TaylorExpansion::Kernel kernel;
  expansion.evaluate_kernel(R, kernel);
  std::vector<double> local_B(expansion.size(), 0.);
  expansion.interact_reversed(kernel, M_A.data(), local_B.data());
  double from_A = 0., from_B = 0.;
  for (unsigned int k = 0; k < expansion.size(); ++k)
    {
      from_A += M_A[k] * local_A[k];
      from_B += M_B[k] * local_B[k];
    }
  EXPECT_NEAR(from_A, from_B, 1e-13 * std::abs(from_A));

  const Tensor<1, 3>  shift({.3, -.2, .5});
  std::vector<double> moved(expansion.size(), 0.), direct(moved);
  expansion.shift_moments(shift, M_B.data(), moved.data());
  for (const Charge &c : B.charges)
    expansion.add_charge(c.q, c.offset + shift, direct.data());
  for (unsigned int k = 0; k < expansion.size(); ++k)
    EXPECT_NEAR(moved[k], direct[k], 1e-14);

  std::vector<double> about(expansion.size(), 0.);
  expansion.shift_local(shift, local_A.data(), about.data());
  for (const Charge &c : A.charges)
    EXPECT_NEAR(expansion.value(about.data(), c.offset - shift),
                expansion.value(local_A.data(), c.offset),
                1e-12 * std::abs(local_A[0]));
}

TEST(TaylorExpansion, HasTheDerivativesOfItsPotential)
{
  const TaylorExpansion expansion(several, 5);
  const auto local = local_of(expansion, Cluster(7, radius).moments(expansion));
  const Tensor<1, 3> a({.1, -.25, .2});
  const auto         V = expansion.derivatives(local.data(), a);
  EXPECT_DOUBLE_EQ(V.value, expansion.value(local.data(), a));
  constexpr double h = 1e-4;
  for (unsigned int c = 0; c < 3; ++c)
    {
      Tensor<1, 3> e;
      e[c]                = h;
      const auto forward  = expansion.derivatives(local.data(), a + e),
                 backward = expansion.derivatives(local.data(), a - e);
      EXPECT_NEAR((forward.value - backward.value) / (2. * h),
                  V.gradient[c],
                  1e-7);
      for (unsigned int d = 0; d < 3; ++d)
        EXPECT_NEAR((forward.gradient[d] - backward.gradient[d]) / (2. * h),
                    V.hessian[d][c],
                    1e-7);
    }
}

TEST(TaylorExpansion, KnowsHowMomentsChangeWithMotion)
{
  const TaylorExpansion expansion(coulomb, 7);
  const Tensor<1, 3>    a({.3, -.2, .4}), v({-1., .7, .5});
  constexpr double      h = 1e-5;
  std::vector<double>   change(expansion.size(), 0.), difference(change);
  expansion.add_moving_charge(1.7, a, v, change.data());
  expansion.add_charge(1.7 / (2. * h), a + h * v, difference.data());
  expansion.add_charge(-1.7 / (2. * h), a - h * v, difference.data());
  for (unsigned int k = 0; k < expansion.size(); ++k)
    EXPECT_NEAR(change[k], difference[k], 1e-9);
}

TEST(TaylorExpansion, ForbidsClustersThatAreTooClose)
{
  const TaylorExpansion expansion(coulomb, 4);
  const auto            powers = Cluster(8, 1.).powers(4);
  EXPECT_TRUE(std::isinf(expansion.relative_error(powers, powers, 2., 2.)));
  EXPECT_TRUE(std::isinf(expansion.relative_error(powers, powers, 2., 0.)));
  EXPECT_LT(expansion.relative_error(powers, powers, 2., 1e3), 1e-8);
}
