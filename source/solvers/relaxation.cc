// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <setae/solvers/relaxation.h>

#include <cmath>

namespace Setae
{
  Relaxation::Relaxation(const NewtonParameters &parameters,
                         const Newton::Log &     log)
    : parameters(parameters)
    , log(log)
  {}



  SolverResult
  Relaxation::solve(NonlinearSystem &system,
                    Vector &         solution,
                    const double     time) const
  {
    constexpr double       first_damping = 1e-3, largest_damping = 1e3;
    constexpr unsigned int max_n_steps = 300;

    SolverResult result;
    Vector       current(solution), increment(solution), trial(solution);
    Evaluation   state =
      system.evaluate(current, time, SupportIncrement::to_prescribed);
    bool   moves_supports = true;
    double damping        = first_damping;

    while (result.n_iterations < max_n_steps)
      {
        ++result.n_iterations;
        const bool is_solved = system.solve(increment, damping);
        trial                = current;
        trial.add(1., increment);
        const Evaluation next =
          is_solved ?
            system.evaluate(trial, time, SupportIncrement::at_rest) :
            Evaluation();

        // Moving the supports costs energy; from then on it has to fall, up to
        // what round-off leaves of a difference of energies.
        const double round_off = 1e-13 * (std::abs(state.energy) + 1e-300);
        const bool   is_lower  = moves_supports ||
                              next.energy <= state.energy + round_off;
        if (!(is_solved && next.is_admissible && is_lower))
          {
            damping *= 8.;
            if (damping > largest_damping)
              {
                result.reason = "the overdamped motion finds no state of lower "
                                "energy";
                return result;
              }
            // The matrix of the state that the motion goes on from.
            state = system.evaluate(current,
                                    time,
                                    moves_supports ?
                                      SupportIncrement::to_prescribed :
                                      SupportIncrement::at_rest);
            continue;
          }

        moves_supports = false;
        current        = trial;
        state          = next;
        damping /= 4.;

        const double increment_norm = increment.l2_norm();
        log({result.n_iterations,
             state.residual_norm,
             increment_norm,
             1.,
             state.gaps.smallest});
        if (state.residual_norm < parameters.residual_tolerance &&
            increment_norm < parameters.increment_tolerance)
          {
            result.evaluation = state;
            result.converged  = true;
            solution          = current;
            return result;
          }
      }
    result.reason = "the overdamped motion does not come to rest in " +
                    std::to_string(max_n_steps) + " steps";
    return result;
  }
} // namespace Setae
