// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

// Offset and gap, and gradient and Hessian in the four vectors against
// automatic derivatives.

#include <deal.II/base/point.h>

#include <deal.II/physics/transformations.h>

#include <gtest/gtest.h>

#include <setae/kinematics/offset_frame.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "../nested_sacado.h"
#include "../random_vectors.h"

using namespace Setae;

namespace
{
  constexpr OffsetAxis axes[] = {OffsetAxis::averaged, OffsetAxis::source};

  OffsetGapDerivatives
  random_law(std::mt19937 &random)
  {
    std::normal_distribution<double> n;
    return {n(random), n(random), n(random), n(random), n(random), n(random)};
  }

  /**
   * The quadratic function of offset and gap that has the derivatives @p law at
   * the pair, on the twelve coordinates as variables.
   */
  LocalSystem<12>
  by_sacado(const PointPair            &pair,
            const OffsetAxis            axis,
            const OffsetGapDerivatives &law)
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

    Tensor<1, 3, Number> b = a1 / Number(sqrt(Number(a1 * a1)));
    if (axis == OffsetAxis::averaged)
      b += Number((pair.a1 * pair.a2 < 0. ? -1. : 1.) /
                  Number(sqrt(Number(a2 * a2)))) *
           a2;
    const Tensor<1, 3, Number> tau    = b / Number(sqrt(Number(b * b)));
    const Tensor<1, 3, Number> d      = r1 - r2;
    const Number               offset = d * tau;
    const Tensor<1, 3, Number> normal = d - offset * tau;
    const Number               height = sqrt(Number(normal * normal));
    const Number               o      = offset - offset.val().val(),
                 g                    = height - height.val().val();
    return local_system<12>(Number(law.value + law.o * o + law.g * g +
                                   .5 * law.oo * o * o + law.og * o * g +
                                   .5 * law.gg * g * g));
  }

  void
  expect_derivatives(const PointPair            &pair,
                     const OffsetAxis            axis,
                     const OffsetGapDerivatives &law,
                     const double                e = 1e-13)
  {
    using namespace PointPairIndex;
    const OffsetFrame     frame(pair, .1, axis);
    const PointPairEnergy actual   = frame.energy(law, true);
    const LocalSystem<12> expected = by_sacado(pair, axis, law);
    const LocalSystem<12> forces =
      by_sacado(pair, axis, {0., law.o, law.g, 0., 0., 0.});

    EXPECT_EQ(actual.value, law.value);
    for (unsigned int i = 0; i < 4; ++i)
      for (unsigned int j = 0; j < 4; ++j)
        {
          // The largest entries of the blocks on the diagonal.
          double g_size = 0., sizes[2] = {};
          for (unsigned int c = 0; c < 3; ++c)
            {
              g_size = std::max(g_size, std::abs(expected.residual[3 * i + c]));
              for (unsigned int f = 0; f < 3; ++f)
                for (const unsigned int s : {0, 1})
                  {
                    const unsigned int k = 3 * (s == 0 ? i : j);
                    sizes[s] =
                      std::max({sizes[s],
                                std::abs(expected.tangent[k + c][k + f]),
                                std::abs(forces.tangent[k + c][k + f])});
                  }
            }
          const double size = std::sqrt(sizes[0] * sizes[1]);
          for (unsigned int c = 0; c < 3; ++c)
            {
              EXPECT_NEAR(actual.gradient[i][c],
                          expected.residual[3 * i + c],
                          e * g_size);
              for (unsigned int f = 0; f < 3; ++f)
                {
                  EXPECT_NEAR(actual.hessian[i][j][c][f],
                              expected.tangent[3 * i + c][3 * j + f],
                              e * size)
                    << "vectors " << i << ' ' << j;
                  EXPECT_NEAR(actual.hessian[i][j][c][f],
                              actual.hessian[j][i][f][c],
                              e * size);
                }
            }
        }
  }
} // namespace



TEST(OffsetFrame, IsOffsetAndGap)
{
  const Tensor<1, 3> e({1., 0., 0.}), f({0., 1., 0.}), g({0., 0., 1.});
  const PointPair    pair = {2. * e + 5. * g, 2. * e, 2. * g - f, 3. * f};

  const OffsetFrame source(pair, .7, OffsetAxis::source);
  EXPECT_DOUBLE_EQ(source.offset, 2.);
  EXPECT_DOUBLE_EQ(source.gap, std::sqrt(10.) - .7);

  // At a right angle, the sum is taken, not the difference.
  const OffsetFrame averaged(pair, .7, OffsetAxis::averaged);
  EXPECT_DOUBLE_EQ(averaged.offset, 3. * std::sqrt(.5));
  EXPECT_DOUBLE_EQ(averaged.gap, std::sqrt(9.5) - .7);
}



TEST(OffsetFrame, HasTheDerivativesOfTheEnergy)
{
  std::mt19937                           random(1);
  std::uniform_real_distribution<double> exponent(-3., 3.);
  for (unsigned int i = 0; i < 300; ++i)
    for (const OffsetAxis axis : axes)
      {
        // Distances and parameters of the curves over six decades.
        const auto scale = [&]() { return std::pow(10., exponent(random)); };
        const PointPair   pair = {scale() * random_vector(random),
                                  scale() * random_vector(random),
                                  scale() * random_vector(random),
                                  scale() * random_vector(random)};
        const OffsetFrame frame(pair, .1, axis);
        const double      e =
          1e-13 * (1. + std::pow(frame.offset / frame.height, 2)) *
          (1. + (pair.r1.norm() + pair.r2.norm()) / frame.d.norm());
        expect_derivatives(pair, axis, random_law(random), e);
      }
}



TEST(OffsetFrame, HasThemForParallelAndNearlyPerpendicularTangents)
{
  std::mt19937 random(2);
  for (unsigned int i = 0; i < 100; ++i)
    for (const OffsetAxis axis : axes)
      {
        const Tensor<1, 3> a1     = random_vector(random);
        const Tensor<1, 3> across = cross_product_3d(a1, random_vector(random));
        const Tensor<1, 3> d      = cross_product_3d(a1, random_vector(random));
        for (const Tensor<1, 3> &a2 : {Tensor<1, 3>(2. * a1),
                                       Tensor<1, 3>(-3. * a1),
                                       Tensor<1, 3>(a1 + 1e-9 * across),
                                       Tensor<1, 3>(across + 1e-9 * a1),
                                       Tensor<1, 3>(across - 1e-9 * a1)})
          for (const double offset : {0., 1e-9, .3, -2.})
            expect_derivatives({d + offset * a1, a1, Tensor<1, 3>(), a2},
                               axis,
                               random_law(random),
                               1e-12 *
                                 (1. + offset * offset * a1.norm_square() /
                                         d.norm_square()));
      }
}



TEST(OffsetFrame, HasSmallGapsToRoundingErrorsOfTheDistance)
{
  std::mt19937 random(3);
  for (const double gap : {1e-9, 0., -1e-2})
    for (unsigned int i = 0; i < 100; ++i)
      {
        const Tensor<1, 3> t = random_vector(random);
        Tensor<1, 3>       n = cross_product_3d(t, random_vector(random));
        n /= n.norm();
        const Tensor<1, 3> r2   = random_vector(random);
        const PointPair    pair = {r2 + (1.001 + gap) * n + .02 * t / t.norm(),
                                   t,
                                   r2,
                                   -2. * t};
        for (const OffsetAxis axis : axes)
          {
            EXPECT_NEAR(OffsetFrame(pair, 1.001, axis).gap, gap, 3e-15);
            EXPECT_NEAR(std::abs(OffsetFrame(pair, 1.001, axis).offset),
                        .02,
                        3e-15);
          }
      }
}



TEST(OffsetFrame, DoesNotChangeInARigidMotionOrWithTheSenseOfTheCurves)
{
  std::mt19937       random(4);
  const Tensor<2, 3> rotation =
    dealii::Physics::Transformations::Rotations::rotation_matrix_3d(
      dealii::Point<3>(2. / 7., 3. / 7., 6. / 7.), 2.5);
  const Tensor<1, 3> shift({-1., .5, 2.});
  for (unsigned int i = 0; i < 100; ++i)
    for (const OffsetAxis axis : axes)
      {
        const PointPair   pair = {random_vector(random),
                                  random_vector(random),
                                  random_vector(random),
                                  random_vector(random)};
        const OffsetFrame frame(pair, .1, axis);
        const OffsetFrame moved({rotation * pair.r1 + shift,
                                 rotation * pair.a1,
                                 rotation * pair.r2 + shift,
                                 rotation * pair.a2},
                                .1,
                                axis);
        EXPECT_NEAR(moved.offset, frame.offset, 1e-13);
        EXPECT_NEAR(moved.gap, frame.gap, 1e-13);
        const OffsetFrame reversed({pair.r1, -2. * pair.a1, pair.r2, pair.a2},
                                   .1,
                                   axis);
        EXPECT_NEAR(std::abs(reversed.offset), std::abs(frame.offset), 1e-13);
        EXPECT_NEAR(reversed.gap, frame.gap, 1e-13);
      }
}



TEST(OffsetFrame, KnowsNoSourceIfAveragedAndNoTargetIfNot)
{
  std::mt19937      random(5);
  const PointPair   pair = {random_vector(random),
                            random_vector(random),
                            random_vector(random),
                            random_vector(random)};
  const OffsetFrame averaged(pair, .1, OffsetAxis::averaged);
  const OffsetFrame swapped({pair.r2, pair.a2, pair.r1, pair.a1},
                            .1,
                            OffsetAxis::averaged);
  EXPECT_DOUBLE_EQ(std::abs(swapped.offset), std::abs(averaged.offset));
  EXPECT_DOUBLE_EQ(swapped.gap, averaged.gap);

  using namespace PointPairIndex;
  const PointPairEnergy e =
    OffsetFrame(pair, .1, OffsetAxis::source).energy(random_law(random), true);
  EXPECT_EQ(e.gradient[a2].norm(), 0.);
  for (unsigned int i = 0; i < 4; ++i)
    {
      EXPECT_EQ(e.hessian[i][a2].norm(), 0.);
      EXPECT_EQ(e.hessian[a2][i].norm(), 0.);
    }
}



// ISSIP eq. 54 with the weights one half: a couple on both tangents.
TEST(OffsetFrame, SharesTheMomentInThePlane)
{
  const OffsetGapDerivatives law   = {0., .3, -.7, 0., 0., 0.};
  const double               angle = .4;
  const Tensor<1, 3>         t1({1., 0., 0.}), n1({0., 1., 0.}),
    t2({std::cos(angle), std::sin(angle), 0.}),
    n2({-std::sin(angle), std::cos(angle), 0.});
  const PointPair pair = {.2 * t1 + .9 * n1, 2. * t1, Tensor<1, 3>(), 3. * t2};
  const OffsetFrame     frame(pair, .1, OffsetAxis::averaged);
  const PointPairEnergy e      = frame.energy(law, false);
  const double          couple = law.o * frame.height - law.g * frame.offset;

  using namespace PointPairIndex;
  EXPECT_NEAR((e.gradient[a1] - .5 * couple / 2. * n1).norm(), 0., 1e-15);
  EXPECT_NEAR((e.gradient[a2] - .5 * couple / 3. * n2).norm(), 0., 1e-15);
}



TEST(OffsetFrame, IsFiniteForSectionsOnOneAxis)
{
  const Tensor<1, 3> t({2. / 7., 3. / 7., 6. / 7.});
  std::mt19937       random(6);
  for (const OffsetAxis axis : axes)
    for (const double shift : {0., 1e-16, 1e-14, 1e-8})
      {
        const PointPair       pair = {3. * t + Tensor<1, 3>({shift, 0., 0.}),
                                      t,
                                      Tensor<1, 3>(),
                                      t};
        const PointPairEnergy e =
          OffsetFrame(pair, .1, axis).energy(random_law(random), true);
        for (unsigned int i = 0; i < 4; ++i)
          {
            EXPECT_TRUE(std::isfinite(e.gradient[i].norm()));
            for (unsigned int j = 0; j < 4; ++j)
              EXPECT_TRUE(std::isfinite(e.hessian[i][j].norm()));
          }
      }
}
