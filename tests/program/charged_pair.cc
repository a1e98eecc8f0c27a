// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

// What the SSIP paper says of its two charged fibers, Sec. 7.3, and more: every
// strength of the attraction is solved in one step from the straight fibers.

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "run_scene.h"

using namespace Setae;

namespace
{
  /** The equilibrium at prefactor @p k in one load step. */
  SceneRun
  in_one_step(const double k, const std::string &n_gauss_points = "10")
  {
    SceneRun scene("charged_pair",
                   {"load stepping/end time=" + std::to_string(k),
                    "load stepping/first step=1",
                    "load stepping/largest step=1",
                    "interactions/coulomb/gauss points=" + n_gauss_points});
    scene.run();
    return scene;
  }

  double
  midpoint(const SceneRun &scene)
  {
    return scene.records.back().loads[0].displacement[0];
  }
} // namespace



TEST(ChargedPair, IsSolvedInOneStepForEveryStrength)
{
  double last = 0.;
  for (unsigned int i = 1; i <= 10; ++i)
    {
      const SceneRun scene = in_one_step(.1 * i);
      ASSERT_EQ(scene.records.size(), 2u) << i;
      EXPECT_EQ(scene.summary.n_rejected_steps, 0u);
      EXPECT_EQ(scene.summary.n_snaps, 0u);
      EXPECT_LT(scene.records.back().evaluation.residual_norm, 1e-10);
      EXPECT_GT(midpoint(scene), last);
      last = midpoint(scene);
    }
}



TEST(ChargedPair, DoesNotDependOnTheLoadSteps)
{
  SceneRun scene("charged_pair");
  scene.run();
  for (const StepRecord &record : scene.records)
    {
      const double displacement = record.loads[0].displacement[0];
      if (record.time > 0.)
        {
          EXPECT_NEAR(displacement, midpoint(in_one_step(record.time)), 1e-9);
        }
    }
}



TEST(ChargedPair, IsSymmetric)
{
  const SceneRun     scene = in_one_step(1.);
  const auto        &cells = scene.problem->state().current;
  const unsigned int n     = cells.size() / 2;
  for (unsigned int i = 0; i < n; ++i)
    for (const double x : {0., .3, .5, 1.})
      {
        const Tensor<1, 3> left        = cells[i].position(x),
                           right       = cells[n + i].position(x),
                           upside_down = cells[n - 1 - i].position(1. - x);
        EXPECT_NEAR(left[0] + right[0], 5., 1e-12);
        EXPECT_NEAR(left[1], right[1], 1e-12);
        EXPECT_NEAR(left[0], upside_down[0], 1e-12);
      }

  // The forces along the fibers cancel: no reaction where they are pinned.
  EXPECT_NEAR(scene.records.back().supports[1].reaction[1], 0., 1e-12);
}



TEST(ChargedPair, IsIntegratedWithTenPointsAsWithThirtyTwo)
{
  for (const double k : {.4, 1.})
    EXPECT_NEAR(midpoint(in_one_step(k)), midpoint(in_one_step(k, "32")), 1e-8);
}
