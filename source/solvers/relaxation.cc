// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <setae/solvers/convergence.h>
#include <setae/solvers/relaxation.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace Setae
{
  Relaxation::Relaxation(const NewtonParameters &parameters,
                         const Newton::Log      &log)
    : parameters(parameters)
    , log(log)
  {}



  SolverResult
  Relaxation::solve(NonlinearSystem &system,
                    Vector          &solution,
                    const double     time) const
  {
    constexpr double       first_step = 1e3, smallest_step = 1e-6;
    constexpr double       growth = 4., reduction = .125;
    constexpr unsigned int max_n_iterations = 500;

    Convergence  convergence(parameters, system);
    SolverResult result;
    Vector       current(solution), coefficients(solution);
    Evaluation   state =
      system.evaluate(current, time, SupportIncrement::to_prescribed);
    const Vector diagonal  = system.diagonal();
    double       step_size = first_step;

    // Moving the supports may cost energy; from then on it has to fall, up to
    // what round-off leaves of a difference of energies.
    double upper_bound = std::numeric_limits<double>::infinity();

    while (result.n_iterations < max_n_iterations)
      {
        Vector next(current);
        coefficients.equ(1. / step_size, diagonal);
        Step step =
          advance(system, next, coefficients, time, upper_bound, result);
        if (step.succeeded)
          {
            step.reason    = system.passage(current, next);
            step.succeeded = step.reason.empty();
          }
        if (!step.succeeded)
          {
            step_size *= reduction;
            if (step_size < smallest_step)
              {
                result.reason = "the overdamped motion finds no state of lower "
                                "energy, in its smallest step because " +
                                step.reason;
                return result;
              }
            continue;
          }

        current     = next;
        state       = step.evaluation;
        upper_bound = state.energy + 1e-12 * std::abs(state.energy);
        step_size *= growth;
        if (convergence.is_reached(state, step.increment_norm, false))
          {
            result.evaluation = state;
            result.converged  = state.is_admissible;
            result.reason     = state.reason;
            if (result.converged)
              solution = current;
            return result;
          }
      }
    result.reason = "the overdamped motion does not come to rest in " +
                    std::to_string(max_n_iterations) + " iterations";
    return result;
  }



  Relaxation::Step
  Relaxation::advance(NonlinearSystem &system,
                      Vector          &current,
                      const Vector    &coefficients,
                      const double     time,
                      const double     upper_bound,
                      SolverResult    &result) const
  {
    // Fibers that turn stretch at first; a second iteration takes that back.
    constexpr unsigned int max_n_iterations = 3;

    Step   step;
    Vector motion(current), increment(current);
    motion = 0.;
    system.evaluate(current, time, SupportIncrement::to_prescribed);
    system.add_damping(coefficients, motion);

    for (unsigned int i = 0; i < max_n_iterations && !step.succeeded; ++i)
      {
        ++result.n_iterations;
        if (!system.solve(increment))
          {
            step.reason = "the tangent matrix is singular";
            return step;
          }
        current += increment;
        motion += increment;
        step.increment_norm = system.increment_norm(increment);
        step.evaluation =
          system.evaluate(current, time, SupportIncrement::at_rest);
        // Where fibers swing, one may press on the other for a while, more than
        // any equilibrium would: only its end has to be admissible.
        if (!step.evaluation.is_valid || step.evaluation.gaps.smallest <= 0.)
          {
            std::ostringstream text;
            text << "fibers overlap, with the gap "
                 << step.evaluation.gaps.smallest;
            step.reason =
              step.evaluation.is_valid ? text.str() : step.evaluation.reason;
            return step;
          }
        step.reason    = "the energy grows";
        step.succeeded = step.evaluation.energy <= upper_bound;
        log({result.n_iterations,
             step.evaluation.residual_norm,
             step.increment_norm,
             1.,
             step.evaluation.gaps.smallest});
        if (!step.succeeded)
          system.add_damping(coefficients, motion);
      }
    return step;
  }
} // namespace Setae
