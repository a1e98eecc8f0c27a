// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "run_scene.h"

using namespace Setae;

namespace
{
  std::set<std::string>
  timer_sections(const FiberProblem &problem)
  {
    std::set<std::string> names;
    for (const auto &[name, time] : problem.timer_output().get_summary_data(
           dealii::TimerOutput::total_wall_time))
      names.insert(name);
    return names;
  }
} // namespace



// Elliptic integrals for P l^2/(EI) = 10, Mattiasson 1981: 0.55500 and 0.81061
// of the inextensible rod; slenderness 100 changes the fourth digit.
TEST(Elastica, BendsAsTheEllipticIntegralsSay)
{
  SceneRun scene("elastica");
  scene.run();
  const Tensor<1, 3> u = scene.records.back().loads[0].displacement;
  EXPECT_NEAR(u[0], -.55500, 2e-4);
  EXPECT_NEAR(u[1], -.81061, 3e-4);
  EXPECT_EQ(u[2], 0.);
  EXPECT_NEAR(scene.records.back().supports[0].reaction[1], 10., 1e-7);
}



TEST(Elastica, IsSolvedInOneLoadStepFromTheStraightRod)
{
  SceneRun scene("elastica",
                 {"load stepping/first step=1",
                  "load stepping/largest step=1"});
  scene.run();
  EXPECT_EQ(scene.records.size(), 2u);
  EXPECT_LE(scene.records.back().n_iterations, 10u);
  EXPECT_NEAR(scene.records.back().loads[0].displacement[1], -.8108, 1e-3);
}



// EI as before, EA 1e4 times larger: round-off leaves more in the residual than
// its tolerance.
TEST(Elastica, OfSlendernessTenThousandIsSolvedToRoundOff)
{
  SceneRun scene("elastica",
                 {"fibers/rod/radius=1e-4",
                  "fibers/rod/youngs modulus=1.2732395447351628e16"});
  scene.run();
  const Tensor<1, 3> u = scene.records.back().loads[0].displacement;
  EXPECT_NEAR(u[0], -.55500, 1e-4);
  EXPECT_NEAR(u[1], -.81061, 1e-4);
}



TEST(Cantilever, IsRolledUpToACircleByAMoment)
{
  SceneRun scene("cantilever_moment", {"fibers/rod/cells=32"});
  scene.run();
  const Tensor<1, 3> u = scene.records.back().loads[0].displacement;
  EXPECT_NEAR(u[0], -1., 2e-5);
  EXPECT_NEAR(u[1], 0., 2e-5);
  EXPECT_NEAR(scene.records.back().evaluation.energies[0],
              2. * M_PI * M_PI,
              1e-3);
}



TEST(Scenes, HaveOnlyWhatTheyNeed)
{
  SceneRun space("elastica", {"load stepping/end time=0.1"});
  SceneRun plane("elastica",
                 {"coordinates=x, y", "load stepping/end time=0.1"});
  SceneRun peeling("peeling", {"load stepping/end time=1e-5"});
  space.run();
  plane.run();
  peeling.run();

  // 17 nodes with position and tangent, in three coordinates and in two.
  EXPECT_EQ(space.problem->n_dofs(), 17u * 2u * 3u);
  EXPECT_EQ(plane.problem->n_dofs(), 17u * 2u * 2u);
  EXPECT_EQ(peeling.problem->n_dofs(), 2u * 65u * 2u * 2u);

  // Without partners, a row couples to its node and the two next to it: 3
  // blocks, less what the clamp takes away; its five rows keep their diagonal.
  const auto chain = [](const unsigned int n_nodes, const unsigned int block) {
    return (3 * n_nodes - 2) * block * block;
  };
  EXPECT_EQ(space.problem->n_nonzero_elements(),
            chain(16, 6) + 2 * 6 * 1 + 1 + 5);
  EXPECT_EQ(plane.problem->n_nonzero_elements(),
            chain(16, 4) + 2 * 4 * 1 + 1 + 3);

  const std::set<std::string> without = {"setup", "strain", "load", "solve"};
  EXPECT_EQ(timer_sections(*space.problem), without);
  EXPECT_EQ(timer_sections(*plane.problem), without);
  EXPECT_EQ(timer_sections(*peeling.problem),
            (std::set<std::string>{
              "setup", "strain", "search", "interaction", "solve"}));
}
