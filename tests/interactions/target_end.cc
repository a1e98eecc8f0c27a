// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

// A section around the end of a target: sign, growth, continuity, and the exact
// energy of a disk in front of a half-infinite cylinder.

#include <gtest/gtest.h>

#include <setae/interactions/target_end.h>
#include <setae/laws/oriented_disk_cylinder.h>
#include <setae/verification/disk_cylinder.h>

#include <cmath>
#include <random>

using namespace Setae;

namespace
{
  using Law = OrientedDiskCylinder;

  constexpr SectionPair sections = {1., 1.2, 1., 1.};

  TargetEnd<Law>
  end_of(const unsigned int m, const GapRange &range = {})
  {
    const InversePower power = {m, 1.};
    return TargetEnd<Law>({{Law({power}, sections, range),
                            EndFraction(m, sections, range),
                            FlatEnd(power, sections, range)}});
  }

  constexpr double length = 1000.;

  double
  energy(const TargetEnd<Law> &end, const FlatEnd::Pose<double> &pose)
  {
    return end.value({true, false},
                     pose.square,
                     pose.along,
                     pose.cosine,
                     pose.z / length,
                     length,
                     [](const Law   &law,
                        const double g,
                        const double c,
                        const double t) { return law.energy(g, c, t); });
  }

  /** A section with its center at (d, z) beside the axis. */
  FlatEnd::Pose<double>
  pose_at(const double d, const double z, const Tensor<1, 3> &normal)
  {
    return {d * d, d * normal[0], normal[2], z};
  }

  /** The one at the distance @p gap from the plane of the end. */
  FlatEnd::Pose<double>
  in_front(const double d, const double gap, const Tensor<1, 3> &normal)
  {
    const double sine = std::hypot(normal[0], normal[1]);
    return pose_at(d, -sections.radius_1 * sine - gap, normal);
  }
} // namespace



TEST(TargetEnd, RepelsMoreAndMoreAsTheCapIsTouched)
{
  std::mt19937                     random(1);
  std::uniform_real_distribution<> uniform(-1., 1.);
  for (const unsigned int m : {6, 7, 12})
    {
      const TargetEnd<Law> end = end_of(m);
      for (unsigned int i = 0; i < 100; ++i)
        {
          Tensor<1, 3> normal(
            {uniform(random), uniform(random), uniform(random)});
          normal /= normal.norm();
          const double d       = i % 10 == 0 ? 0. : .1 * uniform(random);
          double       further = 0.;
          for (double gap = .3; gap > 1e-12; gap *= .3)
            {
              const double e = energy(end, in_front(d, gap, normal));
              ASSERT_TRUE(std::isfinite(e));
              ASSERT_GT(e, further) << "gap " << gap;
              further = e;
            }
        }
    }
}



// Normal parallel to the axis and crosswise, on a way around the end.
TEST(TargetEnd, HasNoJumpAroundTheEnd)
{
  for (const unsigned int m : {6, 12})
    for (const double crosswise : {0., .3, 1.})
      {
        const TargetEnd<Law> end = end_of(m);
        const Tensor<1, 3>   normal(
          {0., crosswise, std::sqrt(1. - crosswise * crosswise)});
        const double reach =
          sections.radius_1 * std::sqrt(1. - normal[2] * normal[2]) + .3;
        const double beside = sections.radius_1 + sections.radius_2 + .3;

        constexpr double step  = 1e-4;
        double           f_old = 0.;
        unsigned int     n     = 0;
        for (double angle = 0.; angle < .5 * M_PI; angle += step, ++n)
          {
            const double f = std::log(energy(end,
                                             pose_at(beside * std::sin(angle),
                                                     -reach * std::cos(angle),
                                                     normal)));
            if (n > 0)
              {
                EXPECT_LT(std::abs(f - f_old), .05);
              }
            f_old = f;
          }
      }
}



TEST(TargetEnd, HasTheEnergyOfADiskInFrontOfACylinder)
{
  for (const unsigned int m : {6, 12})
    {
      const TargetEnd<Law> end = end_of(m);
      for (const Tensor<1, 3> &normal : {Tensor<1, 3>({0., 0., 1.}),
                                         Tensor<1, 3>({1., 0., 0.}),
                                         Tensor<1, 3>({.6, 0., .8})})
        {
          const auto           pose = in_front(.2, .01, normal);
          References::Disk     disk = {Tensor<1, 3>({.2, 0., pose.z}), normal};
          References::Interval cylinder;
          cylinder.begin     = 0.;
          const double exact = References::energy_of_disk_and_cylinder(
                                 {m, 1.}, sections, disk, cylinder, 1e-3)
                                 .value;
          EXPECT_NEAR(energy(end, pose) / exact, 1., .02);
        }
    }
}
