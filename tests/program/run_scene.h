// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_tests_program_run_scene_h
#define setae_tests_program_run_scene_h

#include <setae/fiber_problem.h>

#include <fstream>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

namespace Setae
{
  /**
   * A scene of prm/, run without writing anything.
   */
  struct SceneRun
  {
    explicit SceneRun(const std::string &             name,
                      const std::vector<std::string> &overrides = {})
    {
      const std::string  file_name = SETAE_SCENES "/" + name + ".prm";
      std::ifstream      file(file_name);
      std::ostringstream text;
      text << file.rdbuf();
      problem = std::make_unique<FiberProblem>(
        Scene::read(text.str(), file_name, overrides), MPI_COMM_SELF, screen);
    }

    void
    run()
    {
      summary = problem->run(
        [this](const StepRecord &record) { records.push_back(record); });
    }

    std::ostringstream            screen;
    std::unique_ptr<FiberProblem> problem;
    std::vector<StepRecord>       records;
    RunSummary                    summary;
  };
} // namespace Setae

#endif
