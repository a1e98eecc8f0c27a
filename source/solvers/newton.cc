// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <setae/solvers/convergence.h>
#include <setae/solvers/newton.h>

#include <algorithm>
#include <deque>
#include <limits>

namespace Setae
{
  Newton::Newton(const NewtonParameters &parameters, const Log &log)
    : parameters(parameters)
    , log(log)
  {}



  SolverResult
  Newton::solve(NonlinearSystem       &system,
                Vector                &solution,
                const double           time,
                const SupportIncrement supports) const
  {
    // An increment that helps only when it is much shorter than it should be
    // belongs to a load step that is too long: giving up soon is cheaper.
    constexpr unsigned int max_n_halvings = 3;

    // In slender fibers, a good increment may well raise the residual once:
    // what bends is stretched at first. So the decrease is measured against the
    // largest of the last few norms (Grippo, Lampariello, Lucidi 1986). Where
    // there is no equilibrium, the iterations wander about the smallest
    // residual: it has to be halved within a few of them.
    constexpr unsigned int memory = 3, patience = 6;
    std::deque<double>     last_norms;
    double       reference_norm      = std::numeric_limits<double>::infinity();
    unsigned int reference_iteration = 0;

    Convergence  convergence(parameters, system);
    SolverResult result;
    Vector       current(solution), increment(solution), trial(solution);
    Evaluation   state = system.evaluate(current, time, supports);
    if (supports == SupportIncrement::at_rest)
      {
        if (!state.is_valid)
          {
            result.reason = state.reason;
            return result;
          }
        last_norms.push_back(state.residual_norm);
      }

    while (result.n_iterations < parameters.max_n_iterations)
      {
        const bool is_predictor = result.n_iterations == 0 &&
                                  supports == SupportIncrement::to_prescribed;
        ++result.n_iterations;
        if (!system.solve(increment))
          {
            result.reason = "the tangent matrix is singular";
            return result;
          }

        const double largest_norm =
          last_norms.empty() ?
            std::numeric_limits<double>::infinity() :
            *std::max_element(last_norms.begin(), last_norms.end());

        double factor = 1.;
        if (!is_predictor && parameters.largest_increment > 0.)
          factor = std::min(1.,
                            parameters.largest_increment /
                              system.largest_displacement(increment));

        Evaluation next;
        for (unsigned int halvings = 0;; ++halvings, factor *= .5)
          {
            trial = current;
            trial.add(factor, increment);
            next = system.evaluate(trial, time, SupportIncrement::at_rest);
            const bool decreases =
              next.residual_norm <= (1. - 1e-4 * factor) * largest_norm ||
              convergence.has_small_residual(next);
            if (next.is_valid && (is_predictor || decreases))
              break;
            if (is_predictor || halvings == max_n_halvings)
              {
                result.reason = next.is_valid ?
                                  "the residual does not decrease" :
                                  next.reason;
                return result;
              }
          }
        current = trial;
        state   = next;
        last_norms.push_back(state.residual_norm);
        if (last_norms.size() > memory)
          last_norms.pop_front();
        if (state.residual_norm <= .5 * reference_norm)
          {
            reference_norm      = state.residual_norm;
            reference_iteration = result.n_iterations;
          }
        const bool is_stalled =
          result.n_iterations - reference_iteration >= patience &&
          !convergence.has_small_residual(state);

        const double increment_norm = factor * system.increment_norm(increment);
        log({result.n_iterations,
             state.residual_norm,
             increment_norm,
             factor,
             state.gaps.smallest});
        if (convergence.is_reached(state, increment_norm, factor < 1.))
          {
            result.evaluation = state;
            result.converged  = state.is_admissible;
            result.reason     = state.reason;
            if (result.converged)
              solution = current;
            return result;
          }
        if (is_stalled)
          {
            result.reason = "the residual does not decrease (" +
                            convergence.distance(state) + ")";
            return result;
          }
      }
    result.evaluation = state;
    result.reason     = "no convergence in " +
                    std::to_string(parameters.max_n_iterations) +
                    " iterations (" + convergence.distance(state) + ")";
    return result;
  }
} // namespace Setae
