// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

// Whole scenes with the tabulated law of a disk and a cylinder.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "run_scene.h"

using namespace Setae;

TEST(TabulatedLaw, LowersTheForcePeakOfPeelingByFourPercent)
{
  const auto run = [](const std::vector<std::string> &overrides) {
    SceneRun scene("peeling", overrides);
    scene.run();
    EXPECT_EQ(scene.records.back().time, 6e-4);
    EXPECT_EQ(scene.summary.n_rejected_steps, 0u);
    EXPECT_GT(scene.summary.smallest_gap, 8e-4);
    double peak = 0.;
    for (const StepRecord &record : scene.records)
      {
        const double force = record.supports[1].reaction[0];
        EXPECT_NEAR(record.supports[0].reaction[0] + force, 0., 1e-9);
        peak = std::max(peak, force);
      }
    expect_quadratic_convergence(scene.increments_of_last_step());
    return peak;
  };
  const std::string end = "load stepping/end time=6e-4",
                    log = "newton/log iterations=true";
  const double paper    = run({end, log});
  const double exact =
    run({end,
         log,
         "interactions/adhesion/law=tabulated-disk-cylinder",
         "interactions/adhesion/target ends=finite",
         // Those of the scene by the law of the paper.
         "interactions/adhesion/equilibrium gap=0",
         "interactions/adhesion/force minimum=0",
         "interactions/adhesion/prefactors=-8.551109416687777e-08, "
         "1.224662383592767e-24"});
  EXPECT_NEAR(exact / paper, .9563, .001);
}



TEST(TabulatedLaw, HoldsABeamOnAnArcAtAllAngles)
{
  SceneRun scene("beam_on_arc",
                 {"interactions/steric/law=tabulated-disk-cylinder",
                  "interactions/steric/target ends=finite",
                  "newton/log iterations=true"});
  scene.run();
  ASSERT_EQ(scene.records.back().time, 3.);
  EXPECT_EQ(scene.summary.n_rejected_steps, 0u);
  EXPECT_EQ(scene.summary.n_snaps, 0u);
  EXPECT_GT(scene.summary.smallest_gap, 2e-3);
  for (const StepRecord &record : scene.records)
    {
      Tensor<1, 3> sum;
      for (const SupportReport &support : record.supports)
        sum += support.reaction;
      EXPECT_LT(sum.norm(), 1e-10);
    }
  expect_quadratic_convergence(scene.increments_of_last_step());
}
