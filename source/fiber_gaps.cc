// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <setae/fiber_equations.h>

#include <cmath>
#include <limits>
#include <sstream>

// FiberEquations, continued: what is wrong with a state, and where.

namespace Setae
{
  using namespace dealii;

  /** Collect the gaps of all terms and ranks, and find what is wrong. */
  void
  FiberEquations::judge(Evaluation &evaluation) const
  {
    if (!std::isfinite(evaluation.residual_norm) ||
        !std::isfinite(evaluation.energy))
      {
        evaluation.is_valid = false;
        evaluation.reason   = "the residual is not finite";
        for (unsigned int i = 0; i < terms.size(); ++i)
          if (!std::isfinite(evaluation.energies[i]))
            evaluation.reason =
              "the energy of the " + terms[i]->name() + " is not finite";
      }
    evaluation.is_admissible = evaluation.is_valid;
    for (const auto &term : terms)
      {
        GapReport gaps;
        for (const GapReport &report :
             Utilities::MPI::all_gather(communicator, term->gaps()))
          gaps.see(report);
        evaluation.gaps.see(gaps);

        const double limit       = term->smallest_admissible_gap();
        const bool   is_singular = gaps.smallest <= term->singular_gap();
        if (gaps.smallest < limit || is_singular)
          {
            evaluation.is_valid      = evaluation.is_valid && !is_singular;
            evaluation.is_admissible = false;
            std::ostringstream text;
            text << "the gap is " << gaps.smallest << " " << where(gaps)
                 << ", below " << limit << term->small_gap_advice();
            evaluation.reason = text.str();
          }
      }
  }



  std::string
  FiberEquations::where(const GapReport &gaps) const
  {
    const auto place = [this](const unsigned int cell) {
      const Fiber &f = fibers.fibers[fibers.fiber_of_cell[cell]];
      return "'" + f.name + "'";
    };
    const Fiber       &f = fibers.fibers[fibers.fiber_of_cell[gaps.source]];
    const auto         i = gaps.source - f.first_cell;
    std::ostringstream text;
    text << "between " << place(gaps.source) << " (at s = "
         << f.arc_length[i] + gaps.x * (f.arc_length[i + 1] - f.arc_length[i])
         << ") and " << place(gaps.target);
    return text.str();
  }



  std::string
  FiberEquations::passage(const Vector &from, const Vector &to) const
  {
    const State begin = state(from, 0.), end = state(to, 0.);
    Passage     first;
    first.fraction = std::numeric_limits<double>::infinity();
    for (const auto &term : terms)
      for (const Passage &passage : Utilities::MPI::all_gather(
             communicator, term->find_passage(begin, end).value_or(first)))
        if (passage.is_before(first))
          first = passage;
    if (std::isinf(first.fraction))
      return {};
    GapReport place;
    place.source = first.source;
    place.target = first.target;
    place.x      = first.x;
    return "fibers would pass through each other " + where(place);
  }
} // namespace Setae
