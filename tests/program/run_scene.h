// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_tests_program_run_scene_h
#define setae_tests_program_run_scene_h

#include <gtest/gtest.h>

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
    explicit SceneRun(const std::string              &name,
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

    /** The norms of the increments of the last load step, from the log. */
    std::vector<double>
    increments_of_last_step() const
    {
      std::vector<double> increments;
      std::istringstream  log(screen.str());
      for (std::string word; log >> word;)
        if (word == "iteration")
          {
            unsigned int i;
            log >> i;
            if (i == 1)
              increments.clear();
          }
        else if (word == "increment")
          {
            increments.emplace_back();
            log >> increments.back();
          }
      return increments;
    }

    std::ostringstream            screen;
    std::unique_ptr<FiberProblem> problem;
    std::vector<StepRecord>       records;
    RunSummary                    summary;
  };



  /**
   * The norms of the increments of a Newton iteration fall as their squares, up
   * to their @p round_off [length].
   */
  inline void
  expect_quadratic_convergence(std::vector<double> increments,
                               const double        round_off = 1e-12)
  {
    while (increments.size() > 3 && increments.back() < round_off)
      increments.pop_back();
    ASSERT_GE(increments.size(), 4u);
    const unsigned int n = increments.size();
    const double       a = increments[n - 3], b = increments[n - 2],
                 c = increments[n - 1];
    EXPECT_LT(b, .2 * a);
    EXPECT_LT(c, 10. * (b / (a * a)) * b * b);
  }
} // namespace Setae

#endif
