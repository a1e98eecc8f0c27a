// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_output_progress_h
#define setae_output_progress_h

#include <deal.II/base/conditional_ostream.h>

#include <setae/fibers/fiber_system.h>
#include <setae/output/step_record.h>
#include <setae/solvers/newton.h>

#include <chrono>
#include <deque>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace Setae
{
  /**
   * What a run tells the screen: a banner, a line for each step, and what it
   * took in the end.
   */
  class Progress
  {
  public:
    /** @p silence: how long the screen stays as it is during iterations [s]. */
    Progress(const dealii::ConditionalOStream &out,
             const Scene                      &scene,
             const std::vector<std::string>   &term_names,
             const double                      silence = 5.);

    void
    print_header(const FiberSystem &fibers);

    /**
     * Each one if the scene asks for it, otherwise one now and then, so that a
     * long search is seen to go on.
     */
    void
    print_iteration(const IterationReport &report);

    /** The same for the overdamped motion to the next stable state. */
    void
    print_relaxation(const IterationReport &report);

    /** Only if the scene asks for it. */
    void
    print_rejection(const std::string &reason);

    /** Something that may be wrong although the run goes on. */
    void
    print_warning(const std::string &warning);

    void
    print_step(const StepRecord &record);

    void
    print_summary(const RunSummary &summary);

  private:
    void
    print_iteration(const std::string &what, const IterationReport &report);

    /**
     * How long the whole run will have taken [s], if the last steps went on at
     * an even pace: not at the beginning, and not while they grow or shrink by
     * orders of magnitude.
     */
    std::optional<double>
    expected_time(const StepRecord &record);

    void
    print_line(const std::string &line);

    dealii::ConditionalOStream     out;
    const Scene                   &scene;
    const std::vector<std::string> term_names;

    const double                          silence;
    std::chrono::steady_clock::time_point last_line;

    /** Time of the scene and wall time of the last steps. */
    std::deque<std::pair<double, double>> last_steps;
  };
} // namespace Setae

#endif
