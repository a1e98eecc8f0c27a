// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

// A fiber that turns on a rigid arc is kept off it by repulsion alone (after
// SSIP paper, Sec. 7.2).

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "run_scene.h"

using namespace Setae;

namespace
{
  void
  expect_contact_at_all_angles(const std::vector<std::string> &overrides)
  {
    SceneRun scene("beam_on_arc", overrides);
    scene.run();
    ASSERT_EQ(scene.records.back().time, 3.);
    EXPECT_EQ(scene.summary.n_rejected_steps, 0u);
    EXPECT_EQ(scene.summary.n_snaps, 0u);
    EXPECT_GT(scene.summary.smallest_gap, 2e-3);

    double largest = 0., at = 0.;
    for (const StepRecord &record : scene.records)
      {
        Tensor<1, 3> sum;
        for (const SupportReport &support : record.supports)
          sum += support.reaction;
        EXPECT_LT(sum.norm(), 1e-10);

        const double force = record.supports[2].reaction[2];
        EXPECT_GE(force, 0.);
        if (force > largest)
          {
            largest = force;
            at      = record.time;
          }
      }
    EXPECT_GT(largest, .5);
    EXPECT_NEAR(at, 2., .051);
  }
} // namespace



TEST(BeamOnArc, IsHeldBySectionAndBeamAtAllAngles)
{
  expect_contact_at_all_angles({});
}

TEST(BeamOnArc, IsHeldBySectionsAtAllAngles)
{
  expect_contact_at_all_angles({"interactions/steric/law=disk-disk",
                                "interactions/steric/integration segments=20",
                                "load stepping/largest step=0.1"});
}

TEST(RigidFiber, HasNoStrainEnergyAndStaysWhereItIs)
{
  SceneRun scene("beam_on_arc", {"load stepping/end time=1"});
  scene.run();
  const State state = scene.problem->state();
  for (const auto &coefficient : state.displacement.back().coefficients)
    EXPECT_EQ(coefficient.norm(), 0.);
}
