// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <setae/solvers/newton.h>

#include <cmath>

namespace Setae
{
  Newton::Newton(const NewtonParameters &parameters, const Log &log)
    : parameters(parameters)
    , log(log)
  {}



  SolverResult
  Newton::solve(NonlinearSystem &system,
                Vector          &solution,
                const double     time) const
  {
    // An increment that helps only when it is much shorter than it should be
    // belongs to a load step that is too long: giving up soon is cheaper.
    constexpr unsigned int max_n_halvings = 3;

    SolverResult result;
    Vector       current(solution), increment(solution), trial(solution);
    Evaluation   state =
      system.evaluate(current, time, SupportIncrement::to_prescribed);

    while (result.n_iterations < parameters.max_n_iterations)
      {
        const bool is_predictor = result.n_iterations == 0;
        ++result.n_iterations;
        if (!system.solve(increment))
          {
            result.reason = "the tangent matrix is singular";
            return result;
          }

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
              next.residual_norm <=
                (1. - 1e-4 * factor) * state.residual_norm ||
              next.residual_norm < parameters.residual_tolerance;
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

        const double increment_norm = factor * increment.l2_norm();
        log({result.n_iterations,
             state.residual_norm,
             increment_norm,
             factor,
             state.gaps.smallest});
        if (state.residual_norm < parameters.residual_tolerance &&
            increment_norm < parameters.increment_tolerance)
          {
            result.evaluation = state;
            result.converged  = state.is_admissible;
            result.reason     = state.reason;
            if (result.converged)
              solution = current;
            return result;
          }
      }
    result.evaluation = state;
    result.reason     = "no convergence in " +
                    std::to_string(parameters.max_n_iterations) + " iterations";
    return result;
  }
} // namespace Setae
