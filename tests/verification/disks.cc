// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

// Two disks: the same energy from integrals of one, two and three dimensions,
// and the limits of small and large gaps.

#include <setae/laws/disk_disk.h>
#include <setae/verification/disk_cylinder.h>

#include <cmath>
#include <limits>

#include "agreement.h"

using namespace Setae;
using namespace Setae::References;
using dealii::Tensor;

namespace
{
  constexpr double pi = M_PI;

  SectionPair
  sections(const double ratio)
  {
    return {1., ratio, 1.5, .8};
  }

  /** A second disk at a gap in the direction of x. */
  Disk
  disk_at(const SectionPair &pair, const double gap, const Tensor<1, 3> &normal)
  {
    return {Tensor<1, 3>({pair.radius_1 + pair.radius_2 + gap, 0., 0.}),
            normal};
  }

  const Disk         first     = {Tensor<1, 3>(), Tensor<1, 3>({0., 0., 1.})};
  const Tensor<1, 3> towards_x = Tensor<1, 3>({-1., 0., 0.});

  /**
   * Coplanar disks once more, without any of the coordinates of ISSIP eq. A6:
   * the pairs with the same difference of positions d-v fill the overlap of two
   * disks at the distance |v|, and the mean of r^-m over a circle around the
   * center of the other disk is d^-m F(m/2,m/2;1;|v|^2/d^2).
   */
  double
  energy_by_overlap(const unsigned int m,
                    const SectionPair &pair,
                    const double       gap)
  {
    const double R1 = pair.radius_1, R2 = pair.radius_2, d = R1 + R2 + gap;
    const Hypergeometric mean(.5 - .5 * (m - 1.), .5 - .5 * (m - 1.), m - 1);

    const auto overlap = [&](const double v) {
      if (v <= std::abs(R1 - R2))
        return pi * std::pow(std::min(R1, R2), 2);
      const double a1 = std::acos((v * v + R1 * R1 - R2 * R2) / (2. * v * R1));
      const double a2 = std::acos((v * v + R2 * R2 - R1 * R1) / (2. * v * R2));
      return R1 * R1 * (a1 - .5 * std::sin(2. * a1)) +
             R2 * R2 * (a2 - .5 * std::sin(2. * a2));
    };
    const auto ring = [&](const double v) {
      const double z          = v * v / (d * d),
                   complement = (d - v) * (d + v) / (d * d);
      return 2. * pi * v * overlap(v) * std::pow(d, -1. * m) *
             std::pow(complement, 1. - m) * mean(z, complement);
    };
    double sum =
      integrate_peak(ring, std::abs(R1 - R2), R1 + R2, d, gap, 1e-10).value;
    if (R1 != R2)
      sum += integrate_peak(ring, 0., std::abs(R1 - R2), d, gap, 1e-10).value;
    return sum * pair.density_1 * pair.density_2;
  }
} // namespace



TEST(ReferenceDisks, OneAndTwoDimensionsAgree)
{
  for (const unsigned int m : {1, 2, 3, 6, 12})
    for (const double ratio : {.1, 1., 10.})
      for (const double gap : {1e-6, 1e-3, .1, 10.})
        expect_agreement(coplanar_disks({m, -2.}, sections(ratio), gap),
                         offset_disks({m, -2.}, sections(ratio), gap, 0.),
                         1e-11);
}



TEST(ReferenceDisks, AgreeWithTheOverlapOfDisplacedDisks)
{
  for (const unsigned int m : {1, 3, 6, 12})
    for (const double ratio : {.1, 1., 10.})
      for (const double gap : {1e-3, .1, 10.})
        EXPECT_NEAR(
          energy_by_overlap(m, sections(ratio), gap) /
            coplanar_disks({m, 1.}, sections(ratio), gap).energy.value,
          1.,
          1e-9);
}



TEST(ReferenceDisks, HaveTheAsymptotesOfThePapers)
{
  const SectionPair pair = sections(2.);
  for (const unsigned int m : {6, 12})
    {
      const double gap = 1e-6;
      EXPECT_NEAR(coplanar_disks({m, 1.}, pair, gap).energy.value /
                    (DiskDisk::coefficient(m, 1., pair) *
                     std::pow(gap, 3.5 - m)),
                  1.,
                  1e-6);
    }
  for (const unsigned int m : {1, 6})
    {
      const double d = 1e4, monopole = 1.5 * pi * .8 * pi * 4.;
      EXPECT_NEAR(coplanar_disks({m, 1.}, pair, d - 3.).energy.value *
                    std::pow(d, m) / monopole,
                  1.,
                  1e-6);
    }
}



TEST(ReferenceDisks, AnyPoseContainsCoplanarAndOffsetDisks)
{
  const SectionPair pair = sections(1.5);
  for (const unsigned int m : {1, 6, 12})
    for (const double gap : {1e-3, 1.})
      {
        Disk second = disk_at(pair, gap, first.normal);
        expect_agreement(disks({m, 1.}, pair, first, second, towards_x),
                         coplanar_disks({m, 1.}, pair, gap));
        second.center[2] = .4;
        expect_agreement(disks({m, 1.}, pair, first, second, towards_x),
                         offset_disks({m, 1.}, pair, gap, .4));
      }
}



// Here the round-off of the positions is 1e-10 of the gap.
TEST(ReferenceDisks, AnyPoseIsGoodToEightDigitsAtAMillionthOfTheRadius)
{
  const SectionPair pair = sections(1.5);
  const double      gap  = 1e-6;
  for (const unsigned int m : {6, 12})
    expect_agreement(
      energy_of_disks({m, 1.}, pair, first, disk_at(pair, gap, first.normal)),
      coplanar_disks({m, 1.}, pair, gap).energy,
      1e-8);
}



TEST(ReferenceDisks, AnyPoseIsSymmetric)
{
  const SectionPair pair = sections(1.5), swapped = {1.5, 1., .8, 1.5};
  for (const unsigned int m : {1, 6})
    for (const double gap : {1e-2, .5})
      for (const Tensor<1, 3> normal : {Tensor<1, 3>({.8, 0., .6}),
                                        Tensor<1, 3>({0., 1., 0.}),
                                        Tensor<1, 3>({.48, .64, .6})})
        {
          const Disk second = disk_at(pair, gap, normal);
          expect_agreement(
            disks({m, 1.}, pair, first, second, towards_x, 1e-9),
            disks({m, 1.}, swapped, second, first, -1. * towards_x, 1e-9));
        }
}



TEST(ReferenceDisks, ForceDoesTheWork)
{
  const SectionPair pair = sections(1.5);
  for (const unsigned int m : {1, 6, 12})
    {
      expect_work(
        [&](const double gap) {
          return coplanar_disks({m, 1.}, pair, gap);
        },
        .01,
        .02);
      expect_work(
        [&](const double gap) {
          return offset_disks({m, 1.}, pair, gap, .1);
        },
        .1,
        .3);
    }
  expect_work(
    [&](const double gap) {
      return disks({6, 1.},
                   pair,
                   first,
                   disk_at(pair, gap, Tensor<1, 3>({.48, .64, .6})),
                   towards_x,
                   1e-9);
    },
    .1,
    .3);
}



// Chords do not know that the disks are parallel, and need no third dimension.
TEST(ReferenceDisks, FacingDisksAgreeWithAnyPose)
{
  const Tensor<1, 3> x({1., 0., 0.}), z({0., 0., 1.});
  for (const unsigned int m : {1, 6, 12})
    for (const double ratio : {1., .3})
      for (const double displacement : {0., .5, 1.1})
        for (const double gap : {.1, 1e-4})
          {
            const SectionPair  pair  = sections(ratio);
            const InversePower power = {m, 1.};
            const Disk second = {Tensor<1, 3>({-displacement, 0., -gap}), z};
            expect_agreement(disks(power, pair, first, second, z),
                             facing_disks(power, pair, gap, displacement),
                             1e-10);
            // Where edges are far from edges it is next to nothing.
            if (displacement > .8)
              expect_agreement(
                disks(power, pair, first, second, x).force,
                sideways_force_of_facing_disks(power, pair, gap, displacement),
                1e-10);
          }
}



// What cancels is zero to the tolerance of what it is made of.
TEST(ReferenceDisks, NoForceBreaksTheSymmetry)
{
  const SectionPair  pair = sections(1.5);
  const Tensor<1, 3> x({1., 0., 0.}), y({0., 1., 0.}), z({0., 0., 1.});
  for (const double gap : {1e-4, .5})
    {
      const Disk     rolled  = disk_at(pair, gap, Tensor<1, 3>({0., .6, .8}));
      const Disk     opposed = {Tensor<1, 3>({0., 0., gap}), z};
      const Estimate energy  = energy_of_disks({6, 1.}, pair, first, opposed);
      for (const Tensor<1, 3> &sideways : {x, y})
        EXPECT_NEAR(disks({6, 1.}, pair, first, opposed, sideways).force.value /
                      energy.value,
                    0.,
                    1e-10);
      const double force = disks({6, 1.}, pair, first, rolled, x).force.value;
      for (const Tensor<1, 3> &sideways : {y, z})
        EXPECT_NEAR(disks({6, 1.}, pair, first, rolled, sideways).force.value /
                      force,
                    0.,
                    1e-10);
    }
}



TEST(ReferenceDisks, ChordsAgreeWithPoints)
{
  const SectionPair pair = sections(1.5);
  for (const unsigned int m : {1, 6})
    for (const double gap : {1e-2, .5})
      for (const Tensor<1, 3> normal : {Tensor<1, 3>({.8, 0., .6}),
                                        Tensor<1, 3>({0., 1., 0.}),
                                        Tensor<1, 3>({.48, .64, .6})})
        {
          const Disk second = disk_at(pair, gap, normal);
          expect_agreement(
            disks({m, 1.}, pair, first, second, towards_x, 1e-9),
            disks_by_points({m, 1.}, pair, first, second, towards_x, 1e-9));
        }
}



// In front of the larger disk, where points have no edge to find, and partly
// beside it.
TEST(ReferenceDisks, ChordsAgreeWithPointsOfAlmostParallelDisks)
{
  struct Position
  {
    double ratio, displacement, gap;
  };
  const Tensor<1, 3> direction({.6, 0., .8});
  const double       azimuth = .7;
  for (const Position &position :
       {Position{.3, .4, 1e-4}, Position{.3, 1.1, 1e-2}, Position{1., .5, .1}})
    for (const double turn : {.03, 1e-6})
      {
        const SectionPair pair   = sections(position.ratio);
        const Disk        second = {Tensor<1, 3>({position.displacement,
                                                  0.,
                                                  position.gap +
                                                    position.ratio * std::sin(turn)}),
                                    Tensor<1, 3>({std::sin(turn) * std::cos(azimuth),
                                                  std::sin(turn) * std::sin(azimuth),
                                                  std::cos(turn)})};
        expect_agreement(
          disks({6, 1.}, pair, first, second, direction, 1e-8),
          disks_by_points({6, 1.}, pair, first, second, direction, 1e-8),
          1e-8);
      }
}



TEST(ReferenceDisks, ForceOfAlmostParallelDisksDoesTheWork)
{
  const double       turn = 1e-3;
  const Tensor<1, 3> direction({.28, 0., -.96});
  expect_work(
    [&](const double way) {
      return disks({6, 1.},
                   sections(.3),
                   first,
                   {Tensor<1, 3>({1., .2, 1e-3}) - way * direction,
                    Tensor<1, 3>({0., std::sin(turn), std::cos(turn)})},
                   direction,
                   1e-9);
    },
    0.,
    1e-3);
}



TEST(ReferenceDisks, SidewaysForceDoesTheWork)
{
  const unsigned int m = 6;
  for (const double ratio : {1., .5})
    expect_work(
      [&](const double displacement) {
        return EnergyAndForce{
          facing_disks({m, 1.}, sections(ratio), .1, displacement).energy,
          sideways_force_of_facing_disks(
            {m, 1.}, sections(ratio), .1, displacement)};
      },
      .8,
      1.2);
}



// Face to face with the end of a cylinder: disk by disk, also of equal radii.
TEST(ReferenceDisks, ADiskBeforeAnEndIsAStackOfFacingDisks)
{
  const double       infinity = std::numeric_limits<double>::infinity();
  const unsigned int m        = 6;
  for (const double displacement : {0., .9})
    {
      const Disk disk = {Tensor<1, 3>({displacement, 0., .1}),
                         Tensor<1, 3>({0., 0., 1.})};
      expect_agreement(energy_of_disk_and_cylinder(
                         {m, 1.}, sections(1.), disk, Interval{-infinity, 0.}),
                       integrate_peak(
                         [&](const double h) {
                           return facing_disks({m, 1.},
                                               sections(1.),
                                               h,
                                               displacement)
                             .energy.value;
                         },
                         .1,
                         infinity,
                         .1,
                         .1,
                         1e-9,
                         100.),
                       1e-8);
    }
}



// Two planes of points: as many as fit on the smaller disk.
TEST(ReferenceDisks, FacingDisksArePlanesAsTheGapCloses)
{
  const double h = 1e-6;
  for (const unsigned int m : {6, 12})
    EXPECT_NEAR(facing_disks({m, 1.}, sections(.5), h, .2).energy.value /
                  (1.2 * .25 * pi * 2. * pi / (m - 2.) * std::pow(h, 2. - m)),
                1.,
                1e-9);
}



// An edge on a face: stacked, the faces are a cylinder that ends below the
// edge.
TEST(ReferenceDisks, EdgeOnFaceAgreesWithTheEndOfACylinder)
{
  const SectionPair  pair = {.7, 1., 1., 1.};
  const Tensor<1, 3> z({0., 0., 1.}), x({1., 0., 0.});
  const Disk         upright = {Tensor<1, 3>({.2, 0., .8}), x};
  const Estimate     stack   = integrate(
    [&](const double depth) {
      return energy_of_disks({6, 1.},
                             pair,
                             upright,
                             {Tensor<1, 3>({0., 0., -depth}), z},
                             1e-9)
        .value;
    },
    0.,
    .5,
    1e-8);
  expect_agreement(stack,
                   energy_of_disk_and_cylinder(
                     {6, 1.}, pair, upright, Interval{-.5, 0.}, 1e-9),
                   1e-8);
}
