// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <setae/base/exceptions.h>
#include <setae/solvers/relaxation.h>
#include <setae/static_run.h>

#include <sstream>

namespace Setae
{
  StaticRun::StaticRun(const Scene    &scene,
                       FiberEquations &equations,
                       Progress       &progress)
    : scene(scene)
    , equations(equations)
    , progress(progress)
    , log([&progress](const IterationReport &report) {
      progress.print_iteration(report);
    })
    , newton(scene.newton, log)
    , steps(scene.load_stepping, scene.constants)
  {}



  void
  StaticRun::run(Vector &solution, const StepVisitor &visit)
  {
    // The fibers as they are given need not be in equilibrium.
    const Vector as_given(solution);
    SolverResult initial = Newton(scene.newton, [](const IterationReport &) {
                           }).solve(equations, solution, 0.);
    reject_passage(as_given, solution, initial);
    AssertThrow(initial.converged,
                ExcRun("There is no equilibrium at time 0 near the fibers as "
                       "they are given (loads and interactions may grow from "
                       "zero with t): " +
                       initial.reason + "."));
    equations.check_free_fibers();
    visit(StepRecord{}, initial, solution);

    while (!steps.is_finished())
      {
        StepRecord         record;
        const SolverResult result = solve_step(solution, record);
        visit(record, result, solution);
      }
  }



  /**
   * A state that fibers reach only through each other is no solution, although
   * the equations do not see it.
   */
  void
  StaticRun::reject_passage(const Vector &begin,
                            Vector       &solution,
                            SolverResult &result) const
  {
    if (!result.converged)
      return;
    const std::string passage = equations.passage(begin, solution);
    if (passage.empty())
      return;
    result.converged = false;
    result.reason    = passage + "; a stiffer contact may keep them apart";
    solution         = begin;
  }



  SolverResult
  StaticRun::relax(Vector &solution, const double time)
  {
    SolverResult result;
    if (!scene.load_stepping.pass_instabilities)
      result.reason =
        "'load stepping/pass instabilities' is false, so no other "
        "stable state is searched";
    else if (!equations.has_potential())
      result.reason =
        "no other stable state is searched, because an interaction "
        "has no potential";
    else
      result = Relaxation(scene.newton, [this](const IterationReport &report) {
                 progress.print_relaxation(report);
               }).solve(equations, solution, time);
    return result;
  }



  SolverResult
  StaticRun::solve_step(Vector &solution, StepRecord &record)
  {
    for (;;)
      {
        record.time      = steps.next_time();
        record.step_size = steps.step_size();
        const Vector begin(solution);
        SolverResult result = newton.solve(equations, solution, record.time);
        reject_passage(begin, solution, result);
        if (result.converged)
          {
            steps.accept(result.n_iterations);
            return result;
          }
        record.n_iterations_rejected += result.n_iterations;
        ++record.n_rejected;
        progress.print_rejection(result.reason);
        if (steps.reject())
          continue;

        const SolverResult relaxed = relax(solution, record.time);
        if (!relaxed.converged)
          {
            std::ostringstream message;
            message << "The load step from time " << steps.time() << " to "
                    << record.time << " has no solution: " << result.reason;
            if (relaxed.reason != result.reason)
              message << "; " << relaxed.reason;
            message << ". 'load stepping/instability resolution', "
                    << scene.load_stepping.instability_resolution
                    << ", allows no shorter one. The states before it are on "
                       "disk.";
            AssertThrow(false, ExcRun(message.str()));
          }
        equations.check_free_fibers();
        record.is_snap = true;
        steps.restart();
        return relaxed;
      }
  }
} // namespace Setae
