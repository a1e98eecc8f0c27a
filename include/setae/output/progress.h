// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_output_progress_h
#define setae_output_progress_h

#include <deal.II/base/conditional_ostream.h>

#include <setae/fibers/fiber_system.h>
#include <setae/output/step_record.h>
#include <setae/solvers/newton.h>

#include <string>
#include <vector>

namespace Setae
{
  /**
   * What a run tells the screen: a banner, a line for each load step, and what
   * it took in the end.
   */
  class Progress
  {
  public:
    Progress(const dealii::ConditionalOStream &out,
             const Scene                      &scene,
             const std::vector<std::string>   &term_names);

    void
    print_header(const FiberSystem &fibers);

    /** Only if the scene asks for it. */
    void
    print_iteration(const IterationReport &report);

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
    dealii::ConditionalOStream     out;
    const Scene                   &scene;
    const std::vector<std::string> term_names;
  };
} // namespace Setae

#endif
