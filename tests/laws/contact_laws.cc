// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

// The laws of a disk and a cylinder at any angle: their limits and errors, and
// their derivatives.

#include <gtest/gtest.h>

#include <setae/laws/disk_cylinder.h>
#include <setae/laws/section_quadrature.h>
#include <setae/laws/tabulated_disk_cylinder.h>

#include <cmath>
#include <random>

#include "../../benchmarks/section_beam/cylinders.h"
#include "../nested_sacado.h"

using namespace Setae;
using namespace Setae::Cylinders;

namespace
{
  constexpr double degree = M_PI / 180.;

  template <typename Law>
  Law
  law_of(const PointPotential &potential,
         const SectionPair    &sections,
         const GapRange       &range = {})
  {
    if constexpr (std::is_same_v<Law, OrientedDiskCylinder>)
      return Law(potential, sections, range);
    else
      return Law(potential, sections, range, {4, 9, .01});
  }

  template <typename Law>
  class ContactLaws : public testing::Test
  {};

  using AllOfThem = testing::
    Types<OrientedDiskCylinder, SectionQuadrature, TabulatedDiskCylinder>;
  TYPED_TEST_SUITE(ContactLaws, AllOfThem);

  struct Placement
  {
    double gap, cosine, tilt;
  };

  Placement
  random_placement(std::mt19937 &random)
  {
    std::uniform_real_distribution<double> any(0., 1.);
    const double c = any(random), angle = 2. * M_PI * any(random);
    return {std::pow(10., -5. + 6. * any(random)),
            any(random) < .5 ? c : -c,
            std::sqrt(1. - c * c) * std::cos(angle)};
  }
} // namespace



TYPED_TEST(ContactLaws, HaveTheDerivativesOfTheirEnergy)
{
  std::mt19937         random(1);
  const PointPotential potential = {{6, -1.}, {12, 1e-6}};
  for (const double R2 : {1., .1, 10.})
    for (const GapRange &range : {GapRange(), GapRange{.01, .5, .8}})
      {
        const auto law = law_of<TypeParam>(potential, {1., R2, 1., 1.}, range);
        for (unsigned int i = 0; i < 40; ++i)
          {
            Placement p = random_placement(random);
            if (i % 5 == 0)
              p.tilt = 0.;
            if (i % 5 == 1)
              p.cosine = 1., p.tilt = 0.;
            if (i % 5 == 2)
              p.cosine = 0.;
            if (i % 10 == 3)
              p.cosine = 1e-3, p.tilt = 1. - 1e-4;
            const GapAngleTiltDerivatives a = law(p.gap, p.cosine, p.tilt);
            const LocalSystem<3>          b =
              local_system<3>(law.energy(variable<3>(0, p.gap),
                                         variable<3>(1, p.cosine),
                                         variable<3>(2, p.tilt)));
            // The smallest length on which the energy changes, and the same
            // for angles, where the disk leans over.
            const double     l = std::min(p.gap, std::min(1., R2));
            const double     E = std::abs(a.value) + l * std::abs(a.g);
            const double     s = std::abs(p.tilt) > .99 ? 1. / l : 1.;
            constexpr double e = 1e-8;
            EXPECT_NEAR(a.value, b.energy, 1e-12 * E);
            EXPECT_NEAR(a.g, b.residual[0], e * E / l);
            EXPECT_NEAR(a.c, b.residual[1], e * E * s);
            EXPECT_NEAR(a.t, b.residual[2], e * E * s);
            EXPECT_NEAR(a.gg, b.tangent[0][0], e * E / (l * l));
            EXPECT_NEAR(a.gc, b.tangent[0][1], e * E * s / l);
            EXPECT_NEAR(a.gt, b.tangent[0][2], e * E * s / l);
            EXPECT_NEAR(a.cc, b.tangent[1][1], e * E * s * s);
            EXPECT_NEAR(a.ct, b.tangent[1][2], e * E * s * s);
            EXPECT_NEAR(a.tt, b.tangent[2][2], e * E * s / l);
          }
      }
}



TYPED_TEST(ContactLaws, DoNotDependOnTheSenseOfTheFibers)
{
  std::mt19937 random(2);
  const auto   law = law_of<TypeParam>({{6, -1.}}, {1., 2., 1., 1.});
  for (unsigned int i = 0; i < 20; ++i)
    {
      const Placement p = random_placement(random);
      const double    E = law(p.gap, p.cosine, p.tilt).value;
      EXPECT_DOUBLE_EQ(law(p.gap, -p.cosine, p.tilt).value, E);
      EXPECT_DOUBLE_EQ(law(p.gap, p.cosine, -p.tilt).value, E);
    }
}



// As the gap closes they are SBIP eq. 17 for parallel fibers.
TYPED_TEST(ContactLaws, AreDiskCylinderBetweenParallelFibersAtASmallGap)
{
  for (const unsigned int m : {6, 12})
    {
      const SectionPair sections = {1., .5, 2., 3.};
      const double      ratio =
        law_of<TypeParam>({{m, 1.}}, sections)(1e-6, 1., 0.).value /
        DiskCylinder({{m, 1.}}, sections, {})(1e-6, 1.).value;
      EXPECT_NEAR(ratio, 1., 5e-3);
    }
}



TEST(OrientedDiskCylinder, HasTheAsymptoticEnergyOfCrossingCylinders)
{
  constexpr double g = 1e-6;
  for (const double R2 : {1., 2.})
    for (const double angle : {5., 15., 30., 60., 80., 90.})
      {
        const double               a = angle * degree;
        const OrientedDiskCylinder law({{6, 1.}}, {1., R2, 1., 1.}, {});
        const double               exact =
          M_PI * M_PI / 6. * std::sqrt(R2) / (g * std::sin(a));
        EXPECT_NEAR(crossing_by_law(law, 1. + R2, g, a).energy / exact,
                    1.,
                    1e-4)
          << angle;
      }
}



TEST(SectionQuadrature, ConvergesToTheExactEnergyOfCrossingCylinders)
{
  for (const unsigned int m : {6, 12})
    for (const double g : {1e-3, .1, 3.})
      {
        const double a = 40. * degree, exact = crossing(m, 1., 2., g, a).energy;
        double       last = .05;
        for (const unsigned int n : {3, 6, 12})
          {
            const SectionQuadrature law({{m, 1.}},
                                        {1., 2., 1., 1.},
                                        {},
                                        {n, 2 * n, 0.});
            const double            error =
              std::abs(crossing_by_law(law, 3., g, a).energy / exact - 1.);
            EXPECT_LT(error, last);
            last = std::max(.5 * error, 3e-4);
          }
      }
}



TEST(TabulatedDiskCylinder, IsRightToOneInAThousand)
{
  for (const unsigned int m : {6, 12})
    for (const double R2 : {.1, 1., 10.})
      {
        const TabulatedDiskCylinder law({{m, 1.}}, {1., R2, 1., 1.}, {}, {});
        for (const double g : {1e-6, 1e-3, .01, .1, 1., 10.})
          for (const double angle : {.1, 10., 45., 89., 90.})
            {
              const double a     = angle * degree;
              const auto   f     = crossing_by_law(law, 1. + R2, g, a);
              const auto   exact = crossing(m, 1., R2, g, a);
              EXPECT_NEAR(f.energy / exact.energy, 1., 1e-3)
                << m << ' ' << R2 << ' ' << g << ' ' << angle;
              EXPECT_NEAR(f.force / exact.force, 1., 1e-3)
                << m << ' ' << R2 << ' ' << g << ' ' << angle;
            }
      }
}
