// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_benchmarks_charged_scene_run_h
#define setae_benchmarks_charged_scene_run_h

#include <setae/fiber_problem.h>

#include <sstream>
#include <string>
#include <vector>

#include "../program_sections.h"

namespace Setae
{
  using Overrides = std::vector<std::string>;

  /** A scene that has been run to its end without writing anything. */
  struct SceneRun
  {
    /**
     * @param prm The text of the scene.
     * @throws ExcRun where a load step has no solution.
     */
    SceneRun(const std::string &prm,
             const std::string &file_name,
             const Overrides   &overrides)
      : scene(Scene::read(prm, file_name, overrides))
      , problem(scene, MPI_COMM_WORLD, screen)
      , summary(problem.run(
          [this](const StepRecord &record) { records.push_back(record); }))
    {}

    const StepRecord &
    last() const
    {
      return records.back();
    }

    const Scene             scene;
    std::ostringstream      screen;
    FiberProblem            problem;
    std::vector<StepRecord> records;
    const RunSummary        summary;
  };
} // namespace Setae

#endif
