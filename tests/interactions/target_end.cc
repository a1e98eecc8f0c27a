// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

// A section around the end of a target: sign, growth, continuity, and the exact
// energy of a disk in front of a half-infinite cylinder.

#include <gtest/gtest.h>

#include <setae/interactions/target_end.h>
#include <setae/laws/oriented_disk_cylinder.h>
#include <setae/laws/tabulated_disk_cylinder.h>
#include <setae/verification/disk_cylinder.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace Setae;

namespace
{
  using Law = OrientedDiskCylinder;

  constexpr SectionPair sections = {1., 1.2, 1., 1.};

  TargetEnd<Law>
  end_of(const unsigned int m,
         const SectionPair &sections = ::sections,
         const GapRange    &range    = {})
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
    return end.value(
      {{true, false}, 0., CellPlace::infinity, length, 2. * length},
      SectionPose<double>{
        pose.square, pose.along, pose.cosine, pose.z / length, length});
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



// Straight ways across the end, tangential and at every angle around it. If the
// logarithm of the energy has a continuous slope with a bounded derivative
// between kinks, the largest change of the slope over a step halves with the
// step; at a kink it stays, at a jump of the energy it doubles.
TEST(TargetEnd, HasAContinuousSlopeAroundTheEnd)
{
  for (const unsigned int m : {6, 12})
    for (const double R2 : {.3, 1., 3.})
      for (Tensor<1, 3> normal : {Tensor<1, 3>({0., 0., 1.}),
                                  Tensor<1, 3>({0., 1., 0.}),
                                  Tensor<1, 3>({1., 0., 0.}),
                                  Tensor<1, 3>({.5, .6, .62}),
                                  Tensor<1, 3>({.1, 0., 1.}),
                                  Tensor<1, 3>({-.7, 0., .7})})
        {
          normal /= normal.norm();
          const SectionPair    pair = {1., R2, 1., 1.};
          const TargetEnd<Law> end  = end_of(m, pair);
          const Law            law({{m, 1.}}, pair, {});
          const FlatEnd        flat_end({m, 1.}, pair, {});
          const auto           clearance = [&](const double d, const double z) {
            const auto   pose   = pose_at(d, z, normal);
            const double of_end = flat_end.clearance(pose);
            if (!flat_end.has_side(pose.square))
              return of_end;
            const auto contact =
              law.contact(flat_end.gap(d), pose.cosine, normal[0]);
            return std::max(of_end, contact.clearance());
          };
          for (double angle = .05; angle < 1.55; angle += .1)
            {
              // The place at the distance gap, from the edge in this direction
              constexpr double gap  = .02;
              double           near = 0., far = 5.;
              for (unsigned int i = 0; i < 60; ++i)
                {
                  const double s = .5 * (near + far);
                  (clearance(R2 + s * std::sin(angle), -s * std::cos(angle)) <
                       gap ?
                     near :
                     far)        = s;
                }
              const double d      = R2 + far * std::sin(angle);
              const double z      = -far * std::cos(angle);
              const auto   change = [&](const unsigned int n) {
                constexpr double half   = .4 * gap;
                const double     step   = 2. * half / n;
                double           result = 0., f[3] = {};
                for (unsigned int i = 0; i <= n; ++i)
                  {
                    const double s = i * step - half;
                    f[0]           = f[1];
                    f[1]           = f[2];
                    f[2]           = std::log(energy(end,
                                           pose_at(d + s * std::cos(angle),
                                                   z + s * std::sin(angle),
                                                   normal)));
                    if (i > 1)
                      result =
                        std::max(result,
                                 std::abs(f[2] - 2. * f[1] + f[0]) / step);
                  }
                return result;
              };
              const double coarse = change(2000), fine = change(4000);
              ASSERT_TRUE(std::isfinite(coarse));
              EXPECT_LT(fine, .6 * coarse + 1e-5)
                << "m = " << m << ", R2/R1 = " << R2 << ", normal " << normal
                << ", angle " << angle;
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



// Beyond the end, beside the extended target and at all distances in front.
TEST(TargetEnd, HasTheEnergyOfAParallelDiskBeyondTheEnd)
{
  const double sum_of_radii = sections.radius_1 + sections.radius_2;
  for (const unsigned int m : {6, 12})
    {
      const InversePower          power = {m, 1.};
      const TabulatedDiskCylinder law({power}, sections, {}, {});
      const FlatEnd               flat_end(power, sections, {});
      const EndFraction           fraction(m, sections, {});
      const Tensor<1, 3>          axis({0., 0., 1.});

      const auto expect =
        [&](const double d, const double z, const double tolerance) {
          const auto   pose = pose_at(d, z, axis);
          const double gap  = flat_end.gap(d);
          const auto   front =
            flat_end.front(pose, gap > 0. ? flat_end.softened(gap) : 0.);
          double energy = front.energy;
          if (front.side_share > 0.)
            energy += front.side_share * law(gap, 1., 0.).value *
                      fraction.value(gap, gap, 1., 0., z);
          References::Interval cylinder;
          cylinder.begin = 0.;
          const double exact =
            References::energy_of_disk_and_cylinder(
              power, sections, {Tensor<1, 3>({d, 0., z}), axis}, cylinder, 1e-4)
              .value;
          EXPECT_NEAR(energy / exact, 1., tolerance)
            << "m = " << m << ", d = " << d << ", z = " << z;
        };
      for (const double gap : {.01, .1, .3, 1.})
        for (const double part : {.3, 1., 3.})
          expect(sum_of_radii + gap, -part * gap, .02);
      for (const double z : {-.01, -.1, -1., -3., -10.})
        expect(0., z, .06);
      for (const double d : {1., 2., 3.})
        expect(d, -10., .02);
    }
}
