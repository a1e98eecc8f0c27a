// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_static_run_h
#define setae_static_run_h

#include <setae/fiber_equations.h>
#include <setae/output/progress.h>
#include <setae/solvers/load_stepping.h>

namespace Setae
{
  /**
   * The run of a static scene: an equilibrium for each load step, and the
   * overdamped motion to the next one where a branch ends.
   */
  class StaticRun
  {
  public:
    using Vector = NonlinearSystem::Vector;

    /** @throws ExcParameter if the formula of the load steps is wrong. */
    StaticRun(const Scene    &scene,
              FiberEquations &equations,
              Progress       &progress);

    /**
     * Go through all load steps from the unknowns in @p solution.
     *
     * @throws ExcRun if a step has no solution, with what happened where.
     */
    void
    run(Vector &solution, const StepVisitor &visit);

  private:
    /** The overdamped motion to the next stable state, if the scene wants it.
     */
    SolverResult
    relax(Vector &solution, const double time);

    SolverResult
    solve_step(Vector &solution, StepRecord &record);

    void
    reject_passage(const Vector &begin,
                   Vector       &solution,
                   SolverResult &result) const;

    const Scene      &scene;
    FiberEquations   &equations;
    Progress         &progress;
    const Newton::Log log;
    const Newton      newton;
    LoadStepping      steps;
  };
} // namespace Setae

#endif
