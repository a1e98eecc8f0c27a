// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <setae/output/step_record.h>

#include <algorithm>

namespace Setae
{
  void
  RunSummary::add(const StepRecord &record)
  {
    ++n_steps;
    n_iterations += record.n_iterations + record.n_iterations_rejected;
    n_rejected_steps += record.n_rejected;
    n_rejected_iterations += record.n_iterations_rejected;
    n_snaps += record.is_snap ? 1 : 0;
    smallest_gap = std::min(smallest_gap, record.evaluation.gaps.smallest);
    wall_time    = record.wall_time;
  }
} // namespace Setae
