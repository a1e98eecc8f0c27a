// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

// A target that fades towards its ends, and the zone that makes up for it.

#include <gtest/gtest.h>

#include <setae/interactions/faded_target.h>
#include <setae/laws/oriented_disk_cylinder.h>

#include <cmath>
#include <random>

using namespace Setae;

namespace
{
  using Law = OrientedDiskCylinder;

  constexpr double sum_of_radii = 2.5, length = 100.;

  /** The first of two long cells of a fiber. */
  constexpr CellPlace place = {{true, false}, 0., length, length, 2. * length};

  FadedTarget<Law>
  faded_target(const unsigned int m, const GapRange &range = {})
  {
    const SectionPair  sections = {1., 1.5, 1., 1.};
    const InversePower power    = {m, 1.};
    return FadedTarget<Law>(sum_of_radii,
                            {{Law({power}, sections, range),
                              FadingFraction(m, sections)}});
  }

  /** A parallel section at @p gap, the length @p s inside the end. */
  SectionPose<double>
  parallel(const double gap, const double s)
  {
    const double d = sum_of_radii + gap;
    return {d * d, 0., 1., s / length, length};
  }

  /** The energy of a section over that before an infinite target. */
  double
  part_left(const FadedTarget<Law> &target, const double gap, const double s)
  {
    return target.value(place, parallel(gap, s)) /
           target.value({}, parallel(gap, s));
  }
} // namespace



TEST(EndZone, AndTheFadedTargetAreTheWholeFiber)
{
  for (const double fiber_length : {200., 20., 11., 3.})
    {
      const EndZone zone(sum_of_radii, fiber_length);
      double        zones = 0., last = 1.;
      for (unsigned int i = 0; i <= 1000; ++i)
        {
          const CellPlace whole = {
            {true, true}, 0., 0., fiber_length, fiber_length};
          const double share = zone.share(whole, i / 2000.);
          ASSERT_LE(share, last);
          ASSERT_GE(share, 0.);
          EXPECT_NEAR(share, zone.share(whole, 1. - i / 2000.), 1e-12);
          zones += share;
          last = share;
        }
      EXPECT_EQ(zone.share({{}, 0., 0., fiber_length, fiber_length}, 0.), 1.);
      EXPECT_EQ(zone.is_all(), fiber_length < 4. * sum_of_radii);
      EXPECT_EQ(last, zone.is_all() ? 1. : 0.);
      EXPECT_GT(zones, 0.);
    }
}

TEST(EndZone, IsNotThereOnAClosedFiber)
{
  const EndZone zone(sum_of_radii, CellPlace::infinity);
  EXPECT_EQ(zone.share(CellPlace(), .5), 0.);
  EXPECT_FALSE(zone.touches(CellPlace()));
}



// What is taken from a target by fading is what its zone adds, however wide the
// transition is that a section sees.
TEST(FadedTarget, LosesWhatTheZoneHas)
{
  for (const unsigned int m : {6, 12})
    for (const double gap : {1e-6, .01, .1, 1., 10.})
      {
        const auto    target = faded_target(m);
        const EndZone zone(sum_of_radii, place.fiber_length);

        constexpr double step = .05;
        double           lost = 0., zones = 0.;
        for (double s = -100. + .5 * step; s < 100.; s += step)
          {
            lost += step * ((s > 0.) - part_left(target, gap, s));
            if (s > 0.)
              zones += step * zone.share(place, s / length);
          }
        EXPECT_NEAR(lost / zones, 1., gap > 1. ? .05 : 1e-3)
          << "m = " << m << ", gap " << gap;
      }
}

TEST(FadedTarget, IsAllThereInsideAndNotAtTheEnd)
{
  const auto target = faded_target(6);
  for (const double gap : {1e-6, 1e-3, .1, 1.})
    {
      EXPECT_EQ(part_left(target, gap, 90.), 1.);
      EXPECT_LT(part_left(target, gap, 0.), 2e-3);
      for (double s = -20., last = 0.; s < 60.; s += .1)
        {
          const double part = part_left(target, gap, s);
          ASSERT_GE(part, last - 1e-4);
          last = part;
        }
    }
}



TEST(FadedTarget, IsFiniteAndHasTheRightSign)
{
  std::mt19937                     random(1);
  std::uniform_real_distribution<> uniform(0., 1.);
  const GapRange                   regularized = {.01, 20., 30.};
  const FadedTarget<Law>           targets[]   = {faded_target(6),
                                                  faded_target(12),
                                                  faded_target(6, regularized)};
  for (unsigned int i = 0; i < 30000; ++i)
    {
      const FadedTarget<Law> &target = targets[i % 3];

      // Beside the target or, in front of it, also on its axis
      const bool   in_front = i % 2 == 0;
      const double gap      = std::pow(10., 14. * uniform(random) - 12.);
      const double d =
        in_front ? gap * (i % 4 == 0 ? 0. : 1.) : sum_of_radii + 1. + gap;
      const double s =
        in_front ? -10. * uniform(random) : 60. * uniform(random) - 20.;
      const double cosine = i % 5 == 0 ? 1. : 2. * uniform(random) - 1.;
      const double sine   = std::sqrt(1. - cosine * cosine);
      const double along  = d * sine * (i % 7 == 0 ? 1. : uniform(random));

      const SectionPose<double> pose = {
        d * d, along, cosine, s / length, length};
      const double energy = target.value(place, pose);
      ASSERT_TRUE(std::isfinite(energy));
      ASSERT_GE(energy, 0.) << "d " << d << ", s " << s << ", cos " << cosine;

      const auto variables = target.value(
        place,
        SectionPose<PoseVariables>{PoseVariables::variable(0, pose.square),
                                   PoseVariables::variable(1, pose.along),
                                   PoseVariables::variable(2, pose.cosine),
                                   PoseVariables::variable(3, pose.x),
                                   PoseVariables::variable(4, pose.length)});
      EXPECT_NEAR(variables.val(), energy, 1e-6 * energy);
      for (unsigned int k = 0; k < 5; ++k)
        {
          ASSERT_TRUE(std::isfinite(variables.d(k)));
          for (unsigned int l = 0; l <= k; ++l)
            ASSERT_TRUE(std::isfinite(variables.dd(k, l)));
        }
    }
}
