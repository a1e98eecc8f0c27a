// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "run_scene.h"

using namespace Setae;

namespace
{
  // The load at midspan that deflects a simply supported fiber, one end
  // sliding, by a quarter of its length: 1.364 times the 12 EI/l^2 of linear
  // theory.
  const double force_unit  = 1.364 * 12. * (1e5 * M_PI / 4. * 1.6e-7) / 25.;
  const double initial_gap = 1e-3, length = 5.;

  /** Force of the right support, the last one but one. */
  double
  force(const StepRecord &record)
  {
    return record.supports[1].reaction[0];
  }
} // namespace



TEST(Peeling, ReproducesForcePeakAndPullOff)
{
  SceneRun scene("peeling");
  scene.run();

  const auto peak =
    std::max_element(scene.records.begin(),
                     scene.records.end(),
                     [](const StepRecord &a, const StepRecord &b) {
                       return force(a) < force(b);
                     });
  EXPECT_NEAR(force(*peak) / force_unit, 1.82, .01);
  EXPECT_NEAR(peak->time + initial_gap / length, 3.5e-4, 2e-5);

  const auto snap = std::find_if(scene.records.begin(),
                                 scene.records.end(),
                                 [](const StepRecord &r) { return r.is_snap; });
  ASSERT_NE(snap, scene.records.end());
  EXPECT_NEAR(snap->time + initial_gap / length, .4775, .002);

  EXPECT_EQ(scene.summary.n_snaps, 1u);
  EXPECT_LE(scene.summary.n_iterations, 400u);
  EXPECT_GE(scene.summary.smallest_gap, 8e-4);

  // Separated: straight again, without force or energy, at the end of the load.
  EXPECT_EQ(scene.records.back().time, .6);
  EXPECT_LT(std::abs(force(scene.records.back())), 1e-9 * force_unit);
  EXPECT_LT(scene.records.back().evaluation.energies[0], 1e-12);
}



// When the last bond lets go, the right fiber swings about its lower end, which
// is pressed against the left one while it does.
TEST(Peeling, FromOneEndOnlyGoesOnToTheEndOfTheLoad)
{
  SceneRun scene("peeling", {"supports/right/at=end"});
  scene.run();
  EXPECT_EQ(scene.summary.n_snaps, 1u);
  EXPECT_GE(scene.summary.smallest_gap, 8e-4);
  EXPECT_EQ(scene.records.back().time, .6);

  // Straight again, turned about the end that still touches.
  EXPECT_LT(scene.records.back().evaluation.energies[0], 1e-8);
}



TEST(Peeling, DoesNotDependOnTheSourceSide)
{
  const std::string end = "load stepping/end time=0.02";
  SceneRun          scene("peeling", {end});
  SceneRun          swapped("peeling",
                   {end,
                             "interactions/adhesion/source=right",
                             "interactions/adhesion/target=left"});
  scene.run();
  swapped.run();
  ASSERT_EQ(scene.records.size(), swapped.records.size());
  for (unsigned int i = 0; i < scene.records.size(); ++i)
    EXPECT_NEAR(force(scene.records[i]) / force_unit,
                force(swapped.records[i]) / force_unit,
                1e-7);
}



TEST(Peeling, ReactionsAreInEquilibrium)
{
  SceneRun scene("peeling", {"load stepping/end time=0.01"});
  scene.run();
  for (const StepRecord &record : scene.records)
    EXPECT_NEAR((record.supports[0].reaction[0] + force(record)) / force_unit,
                0.,
                1e-9);
}



TEST(Peeling, ConvergesQuadratically)
{
  SceneRun scene("peeling",
                 {"load stepping/end time=0.002",
                  "newton/log iterations=true"});
  scene.run();

  expect_quadratic_convergence(scene.increments_of_last_step());
}
