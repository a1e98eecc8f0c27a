// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

// Cylinders and disks beside cylinders: one way against the other, the limits
// of theory and of the papers, ends.

#include <setae/laws/disk_cylinder.h>
#include <setae/verification/cylinders.h>
#include <setae/verification/disk_cylinder.h>

#include <cmath>
#include <limits>

#include "agreement.h"

using namespace Setae;
using namespace Setae::References;
using dealii::Tensor;

namespace
{
  constexpr double pi       = M_PI;
  constexpr double infinity = std::numeric_limits<double>::infinity();

  SectionPair
  sections(const double ratio)
  {
    return {1., ratio, 1.5, .8};
  }

  /**
   * The disk of a straight source at the arc length s from the point of
   * crossing, seen from an infinite target.
   */
  DiskPose
  crossing_disk(const SectionPair &pair,
                const double       gap,
                const double       angle,
                const double       s)
  {
    const double contact = pair.radius_1 + pair.radius_2, X = contact + gap;
    const double Y = s * std::sin(angle), d = std::hypot(X, Y);
    return {(gap * (contact + X) + Y * Y) / (d + contact),
            std::cos(angle),
            std::sin(angle) * Y / d};
  }

  Estimate
  disks_along_source(const InversePower &power,
                     const SectionPair  &pair,
                     const double        gap,
                     const double        angle,
                     const double        begin,
                     const double        end)
  {
    const double contact = pair.radius_1 + pair.radius_2;
    return integrate_peak(
      [&](const double s) {
        return energy_of_disk_and_cylinder(power,
                                           pair,
                                           crossing_disk(pair, gap, angle, s))
          .value;
      },
      begin,
      end,
      0.,
      std::sqrt(2. * gap * contact) / std::sin(angle),
      1e-8,
      100. * (contact + gap) / std::sin(angle));
  }
} // namespace



TEST(ReferenceCylinders, ParallelAgreesWithADiskBesideACylinder)
{
  for (const unsigned int m : {2, 3, 6, 7, 12})
    for (const double ratio : {.1, 1., 10.})
      for (const double gap : {1e-6, 1e-3, .1, 10.})
        expect_agreement(parallel_cylinders({m, -2.}, sections(ratio), gap),
                         disk_and_cylinder({m, -2.}, sections(ratio), {gap}),
                         1e-11);
}



TEST(ReferenceCylinders, CrossingAgreesWithDisksAlongTheSource)
{
  for (const double ratio : {.1, 10.})
    for (const double gap : {1e-6, 1.})
      for (const double angle : {.1, .5 * pi})
        {
          const InversePower power = {6, -2.};
          expect_agreement(
            disks_along_source(
              power, sections(ratio), gap, angle, -infinity, infinity),
            crossing_cylinders(power, sections(ratio), gap, angle).energy);
        }
  for (const unsigned int m : {3, 5})
    expect_agreement(
      disks_along_source({m, 1.}, sections(2.), .01, .8, -infinity, infinity),
      crossing_cylinders({m, 1.}, sections(2.), .01, .8).energy);
}



// Theory, section 7, with A = pi^2 rho1 rho2 C and C = -k6.
TEST(ReferenceCylinders, HaveTheAsymptotesOfThePapers)
{
  const SectionPair  pair  = sections(2.);
  const InversePower power = {6, -3.};
  const double       A     = pi * pi * 1.5 * .8 * 3.;

  double g = 1e-6;
  EXPECT_NEAR(parallel_cylinders(power, pair, g).energy.value /
                (-A / 24. * std::sqrt(4. / 3.) * std::pow(g, -1.5)),
              1.,
              5e-6);
  for (const double angle : {.2, .5 * pi})
    EXPECT_NEAR(crossing_cylinders(power, pair, g, angle).energy.value /
                  (-A / 6. * std::sqrt(2.) / (g * std::sin(angle))),
                1.,
                5e-5);
  EXPECT_NEAR(parallel_cylinders({12, 1.}, pair, g).energy.value /
                (DiskCylinder::coefficient(12, 1.) * 1.2 * std::sqrt(4. / 3.) *
                 std::pow(g, -7.5)),
              1.,
              5e-6);

  const double d = 1e4;
  g              = d - 3.;
  EXPECT_NEAR(parallel_cylinders(power, pair, g).energy.value /
                (-3. * pi / 8. * A * 4. * std::pow(d, -5.)),
              1.,
              1e-6);
  EXPECT_NEAR(crossing_cylinders(power, pair, g, .5 * pi).energy.value /
                (-pi / 2. * A * 4. * std::pow(d, -4.)),
              1.,
              1e-6);
}



TEST(ReferenceCylinders, DependOnTheAngleOnlyBySine)
{
  const double perpendicular =
    crossing_cylinders({12, 1.}, sections(2.), .1, .5 * pi).energy.value;
  EXPECT_NEAR(
    crossing_cylinders({12, 1.}, sections(2.), .1, pi / 6.).energy.value /
      perpendicular,
    2.,
    1e-14);
}



TEST(ReferenceCylinders, ForceDoesTheWork)
{
  const SectionPair pair = sections(1.5);
  for (const unsigned int m : {6, 12})
    {
      const InversePower power = {m, 1.};
      expect_work(
        [&](const double gap) { return parallel_cylinders(power, pair, gap); },
        .01,
        .02);
      expect_work(
        [&](const double gap) {
          return crossing_cylinders(power, pair, gap, .7);
        },
        .01,
        .02);
      expect_work(
        [&](const double gap) {
          return crossing_half_cylinder(power, pair, gap, .7, -.3);
        },
        .01,
        .02);
      expect_work(
        [&](const double gap) {
          return pointing_half_cylinder(power, pair, gap);
        },
        .01,
        .02);
      expect_work(
        [&](const double gap) {
          return disk_and_cylinder(power, pair, {gap, .6, .64});
        },
        .1,
        .2);
    }
}



TEST(ReferenceCylinders, TwoHalvesMakeAnInfiniteSource)
{
  for (const unsigned int m : {3, 6, 12})
    for (const double ratio : {.1, 1., 10.})
      for (const double gap : {1e-6, .1, 10.})
        for (const double angle : {.1, .5 * pi})
          for (const double overhang : {0., .3, 5.})
            expect_agreement(
              crossing_half_cylinder(
                {m, 1.}, sections(ratio), gap, angle, overhang) +
                crossing_half_cylinder(
                  {m, 1.}, sections(ratio), gap, angle, -overhang),
              crossing_cylinders({m, 1.}, sections(ratio), gap, angle));
}



TEST(ReferenceCylinders, CrossingHalfAgreesWithDisksAlongTheSource)
{
  for (const double overhang : {-.5, .2, 1.})
    for (const double angle : {.5, .5 * pi})
      expect_agreement(
        disks_along_source(
          {6, 1.}, sections(2.), .01, angle, -infinity, overhang),
        crossing_half_cylinder({6, 1.}, sections(2.), .01, angle, overhang)
          .energy);
}



// Disks that face the target: tilted by a right angle, the center is closer by
// its own radius.
TEST(ReferenceCylinders, PointingHalfAgreesWithDisksAlongTheSource)
{
  for (const double ratio : {.5, 2.})
    for (const unsigned int m : {6, 12})
      {
        const double   gap = .01;
        const Estimate sum = integrate_peak(
          [&](const double s) {
            return energy_of_disk_and_cylinder({m, 1.},
                                               sections(ratio),
                                               {gap + s - 1., 0., 1.},
                                               1e-9)
              .value;
          },
          0.,
          infinity,
          0.,
          gap,
          1e-8,
          100.);
        expect_agreement(
          sum, pointing_half_cylinder({m, 1.}, sections(ratio), gap).energy);
      }
}



TEST(ReferenceCylinders, TiltedDiskKnowsItsDistance)
{
  const SectionPair pair = sections(2.);
  EXPECT_DOUBLE_EQ(distance(pair, {.1, .3, 0.}), .1);
  EXPECT_NEAR(distance(pair, {-.9, 0., 1.}), .1, 1e-15);

  // A disk whose plane contains the axis' direction, turned about it.
  const double d = 3.2, angle = .3;
  EXPECT_NEAR(distance(pair, {d - 3., 0., std::sin(angle)}),
              std::hypot(d - std::cos(angle), std::sin(angle)) - 2.,
              1e-14);
  EXPECT_THROW(energy_of_disk_and_cylinder({6, 1.}, pair, {-1.1, 0., 1.}),
               dealii::ExceptionBase);
  EXPECT_THROW(energy_of_disk_and_cylinder({6, 1.}, pair, {.1, .9, .9}),
               dealii::ExceptionBase);
}



TEST(ReferenceCylinders, DiskInSpaceAgreesWithDiskPose)
{
  const SectionPair pair = sections(.7);
  for (const double gap : {1e-3, 1.})
    for (const unsigned int m : {3, 6})
      {
        const Disk disk = {Tensor<1, 3>({1.7 + gap, 0., 3.}),
                           Tensor<1, 3>({.48, .64, .6})};
        expect_agreement(energy_of_disk_and_cylinder(
                           {m, 1.}, pair, disk, {-infinity, infinity}),
                         energy_of_disk_and_cylinder({m, 1.},
                                                     pair,
                                                     {gap, .6, .48}));
      }
}



TEST(ReferenceCylinders, EndOfATargetTakesHalf)
{
  const SectionPair pair   = sections(.7);
  const Disk        at_end = {Tensor<1, 3>({1.71, 0., 0.}),
                              Tensor<1, 3>({0., 0., 1.})};
  const double      half =
    energy_of_disk_and_cylinder({6, 1.}, pair, at_end, {-infinity, 0.}).value;
  EXPECT_NEAR(half / parallel_cylinders({6, 1.}, pair, .01).energy.value,
              .5,
              1e-10);
}



TEST(ReferenceCylinders, DisksBesideTwoHalvesAddUp)
{
  const SectionPair pair = sections(.7);
  const Disk disk = {Tensor<1, 3>({1.8, 0., .2}), Tensor<1, 3>({.48, .64, .6})};
  const auto energy = [&](const double begin, const double end) {
    return energy_of_disk_and_cylinder({6, 1.}, pair, disk, {begin, end});
  };
  expect_agreement(energy(-infinity, 0.) + energy(0., infinity),
                   energy(-infinity, infinity));
  expect_agreement(energy(-1., 0.) + energy(0., 2.), energy(-1., 2.));
}



TEST(ReferenceCylinders, FiniteParallelAgreesWithDisksAlongTheSource)
{
  const SectionPair pair  = sections(.7);
  const double      shift = 1.5;
  for (const unsigned int m : {1, 6})
    {
      const Estimate sum = integrate(
        [&](const double s) {
          return energy_of_disk_and_cylinder({m, 1.},
                                             pair,
                                             Disk{Tensor<1, 3>({2., 0., s}),
                                                  Tensor<1, 3>({0., 0., 1.})},
                                             {shift, shift + 3.},
                                             1e-8)
            .value;
        },
        0.,
        2.,
        1e-7);
      expect_agreement(
        sum,
        finite_parallel_cylinders({m, 1.}, pair, .3, {2., 3., shift}).energy,
        1e-8);
    }
}



// Away from the ends, sliding by a length changes the energy by that of the
// length: the thrust at a gap that is small beside the overlap.
TEST(ReferenceCylinders, FiniteParallelPullThemselvesIntoOverlap)
{
  const SectionPair pair = sections(.7);
  const double      per_length =
    parallel_cylinders({6, -1.}, pair, 1e-3).energy.value;
  const SlidingCylinders sliding =
    finite_parallel_cylinders({6, -1.}, pair, 1e-3, {50., 50., 20.});
  EXPECT_NEAR(sliding.thrust.value / per_length, 1., 1e-6);
  EXPECT_NEAR(sliding.energy.value / (30. * per_length), 1., 1e-3);

  const auto at_shift = [&](const double shift) {
    const SlidingCylinders s =
      finite_parallel_cylinders({6, -1.}, pair, .1, {5., 3., shift});
    return EnergyAndForce{s.energy, s.thrust};
  };
  expect_work(at_shift, 3., 6.);
  expect_work(
    [&](const double gap) {
      const SlidingCylinders s =
        finite_parallel_cylinders({6, -1.}, pair, gap, {5., 3., 4.});
      return EnergyAndForce{s.energy, s.force};
    },
    .1,
    .2);
}



TEST(ReferenceCylinders, InfiniteEnergiesAndContactAreRefused)
{
  const SectionPair pair = sections(1.);
  EXPECT_THROW(parallel_cylinders({1, 1.}, pair, 1.), dealii::ExceptionBase);
  EXPECT_THROW(crossing_cylinders({2, 1.}, pair, 1., 1.),
               dealii::ExceptionBase);
  EXPECT_THROW(pointing_half_cylinder({3, 1.}, pair, 1.),
               dealii::ExceptionBase);
  EXPECT_THROW(crossing_cylinders({6, 1.}, pair, 0., 1.),
               dealii::ExceptionBase);
}
