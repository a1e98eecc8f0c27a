// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

// Charged rings and cylinders, and what SSIP says of the monopole law: wrong
// for two sections, right for two fibers.

#include <setae/verification/charged_surfaces.h>

#include <cmath>

#include "agreement.h"

using namespace Setae;
using namespace Setae::References;
using dealii::Tensor;

namespace
{
  constexpr double       pi      = M_PI;
  constexpr InversePower coulomb = {1, 1.};
  constexpr double       length  = 50.; // of fibers of radius one

  constexpr SectionPair sections = {1., 1., .7, 2.};

  const Tensor<1, 3> z({0., 0., 1.});

  /** The error of the monopole law. */
  double
  error_of_monopoles(const double gap, const double angle)
  {
    return energy_of_crossing_monopoles(
             coulomb, sections, gap, angle, length, length)
               .value /
             energy_of_crossing_surfaces(
               coulomb, sections, gap, angle, length, length)
               .value -
           1.;
  }
} // namespace



TEST(ReferenceSurfaces, ParallelIsTheLimitOfCrossing)
{
  for (const double gap : {1e-3, 1.})
    expect_agreement(
      energy_of_parallel_surfaces(coulomb, sections, gap, {4., 4., 0.}),
      energy_of_crossing_surfaces(coulomb, sections, gap, 0., 4., 4.));
}



TEST(ReferenceSurfaces, CylindersAreRingsAlongTheSource)
{
  const SectionPair pair = {1., .7, 1., 1.};
  for (const double shift : {.3, 3.})
    {
      const Estimate sum = integrate(
        [&](const double s) {
          return integrate(
                   [&](const double t) {
                     return energy_of_rings(coulomb,
                                            pair,
                                            {Tensor<1, 3>({0., 0., s}), z},
                                            {Tensor<1, 3>({1.8, 0., shift + t}),
                                             z},
                                            1e-9)
                       .value;
                   },
                   0.,
                   1.,
                   1e-8)
            .value;
        },
        0.,
        2.,
        1e-7);
      expect_agreement(
        sum,
        energy_of_parallel_surfaces(coulomb, pair, .1, {2., 1., shift}),
        1e-8);
    }
}



TEST(ReferenceSurfaces, RingsOfAllOrientationsAreMonopolesFarAway)
{
  const double d        = 1e3;
  const double monopole = 4. * pi * pi * 1.4 / d;
  for (const Tensor<1, 3> normal : {z, Tensor<1, 3>({.48, .64, .6})})
    EXPECT_NEAR(energy_of_rings(coulomb,
                                sections,
                                {Tensor<1, 3>(), z},
                                {Tensor<1, 3>({d, 0., 0.}), normal})
                    .value /
                  monopole,
                1.,
                2e-6);
}



TEST(ReferenceSurfaces, RingsAreSymmetric)
{
  const SectionPair pair = {1., .7, 1., 1.}, swapped = {.7, 1., 1., 1.};
  const Disk        one   = {Tensor<1, 3>(), z};
  const Disk        other = {Tensor<1, 3>({1.701, 0., .1}),
                             Tensor<1, 3>({.48, .64, .6})};
  expect_agreement(energy_of_rings(coulomb, pair, one, other),
                   energy_of_rings(coulomb, swapped, other, one));
  const Disk coaxial = {Tensor<1, 3>({0., 0., .1}), z};
  expect_agreement(energy_of_rings(coulomb, pair, one, coaxial),
                   energy_of_rings(coulomb, swapped, coaxial, one));
}



// SSIP Sec. 7.1.2: 'below 7% already for g/R = 1' for two sections, 'below
// 0.3%' and '0.03%' for two fibers of slenderness 50 at g/R = 1e-3.
TEST(ReferenceSurfaces, MonopoleLawIsAsGoodAsThePaperSays)
{
  const Disk   ring     = {Tensor<1, 3>(), z};
  const double monopole = 4. * pi * pi * 1.4 / 3.;
  for (const Tensor<1, 3> normal : {z, Tensor<1, 3>({0., 1., 0.})})
    {
      const double exact = energy_of_rings(coulomb,
                                           sections,
                                           ring,
                                           {Tensor<1, 3>({3., 0., 0.}), normal})
                             .value;
      EXPECT_LT(std::abs(monopole / exact - 1.), .07);
      EXPECT_GT(std::abs(monopole / exact - 1.), .05);
    }

  const double parallel      = error_of_monopoles(1e-3, 0.);
  const double perpendicular = error_of_monopoles(1e-3, .5 * pi);
  EXPECT_LT(std::abs(parallel), 3e-3);
  EXPECT_NEAR(parallel, -1.7303e-3, 1e-7);
  EXPECT_LT(std::abs(perpendicular), 3.5e-4);
  EXPECT_NEAR(perpendicular, -3.417e-4, 1e-7);
}
