// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

// Gradient and Hessian in the four vectors against automatic derivatives.

#include <gtest/gtest.h>

#include <setae/kinematics/gap_angle.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "../nested_sacado.h"
#include "../random_vectors.h"

using namespace Setae;

namespace
{
  GapAngleDerivatives
  random_law(std::mt19937 &random)
  {
    std::normal_distribution<double> n;
    return {n(random), n(random), n(random), n(random), n(random), n(random)};
  }

  /**
   * The quadratic function of gap and cosine that has the derivatives @p law at
   * the pair, on the twelve coordinates as variables.
   */
  LocalSystem<12>
  by_sacado(const PointPair           &pair,
            const double               sum_of_radii,
            const GapAngleDerivatives &law)
  {
    using Number = NestedFad<12>;
    std::array<Tensor<1, 3, Number>, 4> v;
    unsigned int                        i = 0;
    for (const Tensor<1, 3> &vector : {pair.r1, pair.a1, pair.r2, pair.a2})
      {
        for (unsigned int c = 0; c < 3; ++c)
          v[i][c] = variable<12>(3 * i + c, vector[c]);
        ++i;
      }
    const auto &[r1, a1, r2, a2] = v;

    const Tensor<1, 3, Number> d   = r1 - r2;
    const Number               gap = sqrt(Number(d * d)) - sum_of_radii;
    const Number cosine = (a1 * a2) / sqrt(Number((a1 * a1) * (a2 * a2)));
    const Number g = gap - gap.val().val(), c = cosine - cosine.val().val();
    return local_system<12>(Number(law.value + law.g * g + law.c * c +
                                   .5 * law.gg * g * g + law.gc * g * c +
                                   .5 * law.cc * c * c));
  }

  /** What the entries of the derivatives with respect to a vector scale with.
   */
  double
  size_of(const unsigned int vector, const GapAngle &geometry)
  {
    using namespace PointPairIndex;
    return vector == a1 ? 1. / geometry.length_1 :
           vector == a2 ? 1. / geometry.length_2 :
                          1.;
  }

  void
  expect_derivatives(const PointPair           &pair,
                     const double               sum_of_radii,
                     const GapAngleDerivatives &law)
  {
    using namespace PointPairIndex;
    const GapAngle        geometry(pair, sum_of_radii);
    const PointPairEnergy actual   = geometry.energy(law, true);
    const LocalSystem<12> expected = by_sacado(pair, sum_of_radii, law);
    constexpr double      e        = 2e-14;

    EXPECT_EQ(actual.value, law.value);
    for (unsigned int i = 0; i < 4; ++i)
      {
        const bool   is_angle_i = i == a1 || i == a2;
        const double size_1     = std::abs(is_angle_i ? law.c : law.g);
        for (unsigned int c = 0; c < 3; ++c)
          EXPECT_NEAR(actual.gradient[i][c],
                      expected.residual[3 * i + c],
                      e * size_1 * size_of(i, geometry));

        for (unsigned int j = 0; j < 4; ++j)
          {
            const bool   is_angle_j = j == a1 || j == a2;
            const double size_2 =
              is_angle_i && is_angle_j ?
                std::abs(law.c) + std::abs(law.cc) :
              is_angle_i || is_angle_j ?
                std::abs(law.gc) :
                std::abs(law.gg) + std::abs(law.g) / geometry.distance;
            for (unsigned int c = 0; c < 3; ++c)
              for (unsigned int f = 0; f < 3; ++f)
                {
                  EXPECT_NEAR(actual.hessian[i][j][c][f],
                              expected.tangent[3 * i + c][3 * j + f],
                              e * size_2 * size_of(i, geometry) *
                                size_of(j, geometry))
                    << "vectors " << i << ' ' << j;
                  EXPECT_NEAR(actual.hessian[i][j][c][f],
                              actual.hessian[j][i][f][c],
                              e * size_2 * size_of(i, geometry) *
                                size_of(j, geometry));
                }
          }
      }
  }
} // namespace



TEST(GapAngle, IsGapAndCosine)
{
  const Tensor<1, 3> e({1., 0., 0.}), f({0., 1., 0.}), g({0., 0., 1.});
  const GapAngle     geometry({5. * g, 2. * e, 2. * g, 3. * e + 3. * f}, .7);
  EXPECT_DOUBLE_EQ(geometry.gap, 2.3);
  EXPECT_DOUBLE_EQ(geometry.cosine, std::sqrt(.5));
  EXPECT_DOUBLE_EQ((geometry.n - g).norm(), 0.);
}



TEST(GapAngle, HasTheDerivativesOfTheEnergy)
{
  std::mt19937                           random(1);
  std::uniform_real_distribution<double> exponent(-3., 3.);
  for (unsigned int i = 0; i < 300; ++i)
    {
      // Distances and parameters of the curves over six decades.
      const auto      scale = [&]() { return std::pow(10., exponent(random)); };
      const PointPair pair  = {scale() * random_vector(random),
                               scale() * random_vector(random),
                               scale() * random_vector(random),
                               scale() * random_vector(random)};
      expect_derivatives(pair, .1, random_law(random));
    }
}



TEST(GapAngle, HasThemForParallelAndPerpendicularTangents)
{
  std::mt19937 random(2);
  for (unsigned int i = 0; i < 100; ++i)
    {
      const Tensor<1, 3> a1 = random_vector(random);
      const Tensor<1, 3> perpendicular =
        cross_product_3d(a1, random_vector(random));
      const Tensor<1, 3> r1 = random_vector(random), r2 = random_vector(random);
      const Tensor<1, 3> nearly = a1 + 1e-9 * perpendicular;
      for (const Tensor<1, 3> &a2 : {Tensor<1, 3>(2. * a1),
                                     Tensor<1, 3>(-3. * a1),
                                     nearly,
                                     perpendicular})
        expect_derivatives({r1, a1, r2, a2}, .1, random_law(random));
    }
}



TEST(GapAngle, HasThemWhereSurfacesNearlyTouchOrOverlap)
{
  std::mt19937 random(3);
  for (const double gap : {1e-9, 0., -1e-2})
    for (const double radius : {1., 1e-3})
      for (unsigned int i = 0; i < 100; ++i)
        {
          const double       sum_of_radii = 1. + radius;
          const Tensor<1, 3> r2           = random_vector(random);
          const PointPair    pair         = {r2 + (sum_of_radii + gap) *
                                                    random_direction(random),
                                             random_vector(random),
                                             r2,
                                             random_vector(random)};
          EXPECT_NEAR(GapAngle(pair, sum_of_radii).gap, gap, 2e-15);
          expect_derivatives(pair, sum_of_radii, random_law(random));
        }
}



TEST(GapAngle, HasTheSameGradientWithoutTheHessian)
{
  std::mt19937    random(4);
  const PointPair pair = {random_vector(random),
                          random_vector(random),
                          random_vector(random),
                          random_vector(random)};
  const GapAngle  geometry(pair, .1);
  const auto      law     = random_law(random);
  const auto      with    = geometry.energy(law, true);
  const auto      without = geometry.energy(law, false);
  for (unsigned int i = 0; i < 4; ++i)
    EXPECT_EQ((with.gradient[i] - without.gradient[i]).norm(), 0.);
}
