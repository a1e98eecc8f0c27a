// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <gtest/gtest.h>

#include <setae/laws/point_law.h>

#include <complex>

using namespace Setae;

namespace
{
  const PointPotential lennard_jones = {{6, -2.}, {12, 3.}};
  const PointPotential odd           = {{1, 1.5}, {7, -.5}};

  double
  by_definition(const PointPotential &potential, const double r)
  {
    double sum = 0.;
    for (const InversePower &power : potential)
      sum += power.prefactor * std::pow(r, -double(power.exponent));
    return sum;
  }
} // namespace

TEST(PointLaw, IsTheSumOfInversePowers)
{
  for (const PointPotential &potential : {lennard_jones, odd})
    for (const double r : {1e-3, .7, 1., 40.})
      {
        const PointLaw law(potential);
        const double   expected = by_definition(potential, r);
        const double   accuracy = 1e-13 * std::abs(expected);
        EXPECT_NEAR(law(r * r).value, expected, accuracy) << r;
        EXPECT_NEAR(law.energy(r * r), expected, accuracy) << r;
      }
}

TEST(PointLaw, DerivativeIsThatOfTheEnergy)
{
  constexpr double step = 1e-30;
  for (const double r : {.3, 1., 2.5})
    {
      const std::complex<double> z(r, step);
      const double               derivative =
        PointLaw(lennard_jones).energy(z * z).imag() / step;
      EXPECT_NEAR(PointLaw(lennard_jones)(r * r).first_over_r * r,
                  derivative,
                  1e-13 * std::abs(derivative));
    }
}

TEST(PointLaw, LanesAreSingleNumbers)
{
  for (const PointPotential &potential : {lennard_jones, odd})
    {
      const PointLaw law(potential);
      Lanes          squares;
      for (unsigned int i = 0; i < n_lanes; ++i)
        squares[i] = .5 + i;
      const PointLaw::Derivatives<Lanes> lanes = law(squares);
      for (unsigned int i = 0; i < n_lanes; ++i)
        {
          const double square = squares[i];
          EXPECT_DOUBLE_EQ(lanes.value[i], law(square).value);
          EXPECT_DOUBLE_EQ(lanes.first_over_r[i], law(square).first_over_r);
        }
    }
}
