// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

// Fibers of a twentieth of the length of the scene, with as many points per
// length.

#include <gtest/gtest.h>

#include <cmath>

#include "run_scene.h"

using namespace Setae;

namespace
{
  std::vector<std::string>
  operator+(std::vector<std::string>        first,
            const std::vector<std::string> &second)
  {
    first.insert(first.end(), second.begin(), second.end());
    return first;
  }

  const std::string              path         = "interactions/adhesion/";
  const std::vector<std::string> short_fibers = {
    "constants=l=0.25, R=0.02, g_0=8e-4",
    "fibers/left/length=0.25",
    "fibers/right/length=0.25",
    "fibers/left/cells=4",
    "fibers/right/cells=4",
    path + "integration segments=200"};
} // namespace



TEST(PeelingIssip, ConvergesQuadraticallyInEveryVariant)
{
  for (const std::string frame : {"averaged", "source"})
    for (const std::string moments : {"true", "false"})
      {
        SceneRun scene(
          "peeling_issip",
          short_fibers +
            std::vector<std::string>{"load stepping/end time=2e-4",
                                     "load stepping/largest step=2e-4",
                                     "load stepping/first step=2e-4",
                                     "newton/log iterations=true",
                                     "newton/relative increment tolerance=1e-9",
                                     path + "frame=" + frame,
                                     path + "interaction moments=" + moments});
        scene.run();
        EXPECT_EQ(scene.summary.n_rejected_steps, 0u);
        SCOPED_TRACE(frame + ' ' + moments);
        expect_quadratic_convergence(scene.increments_of_last_step(), 1e-14);
      }
}



// The law has the equilibrium of two parallel cylinders, and a midpoint rule as
// fine as this one keeps it.
TEST(PeelingIssip, StartsAtTheEquilibriumOfParallelCylinders)
{
  SceneRun scene("peeling_issip",
                 short_fibers + std::vector<std::string>{
                                  "supports/left/at=start",
                                  "supports/left/displacement=free; free; free",
                                  "supports/left/tangent=0; 0; free",
                                  "load stepping/end time=1e-9"});
  scene.run();
  const State        state  = scene.problem->state();
  const FiberSystem &fibers = scene.problem->fiber_system();
  Tensor<1, 3>       r[2];
  for (const unsigned int f : {0, 1})
    {
      const auto [cell, x] = fibers.locate(f, .125);
      r[f]                 = state.current[cell].position(x);
    }
  const double expected = .64170 * std::pow(5e-25 / 1e-7, 1. / 6.);
  EXPECT_NEAR((r[1] - r[0]).norm() - .04, expected, 2e-3 * expected);
}
