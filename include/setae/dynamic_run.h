// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_dynamic_run_h
#define setae_dynamic_run_h

#include <setae/energy_guard.h>
#include <setae/output/progress.h>
#include <setae/solvers/work_between.h>

#include <optional>

namespace Setae
{
  class GeneralizedAlpha;
  class TimeStepping;
  struct StepMeasure;

  /**
   * The run of a scene with inertia, by the integrator that it names.
   */
  class DynamicRun
  {
  public:
    using Vector = NonlinearSystem::Vector;

    DynamicRun(const Scene &scene, DynamicSystem &system, Progress &progress);

    /**
     * Integrate from time 0 to the end; @p visit sees time 0 and the end of each
     * step.
     *
     * @throws ExcRun if a step has no solution, with what happened where.
     */
    void
    run(const StepVisitor &visit);

  private:
    void
    run_generalized_alpha(const Motion &initial, const StepVisitor &visit);

    void
    run_ida(const Motion &initial, const StepVisitor &visit);

    SolverResult
    solve_step(GeneralizedAlpha &method,
               TimeStepping     &steps,
               StepRecord       &record);

    /** What the step that has been solved is judged by. */
    StepMeasure
    measure(const GeneralizedAlpha &method,
            const TimeStepping     &steps,
            const MotionReport     &motion,
            const Evaluation       &evaluation,
            const double            path);

    /** What is wrong with a step that has been solved, in words. */
    std::string
    reason(const StepMeasure  &measure,
           const MotionReport &motion,
           const Evaluation   &evaluation) const;

    /** Residual and energies of a motion. */
    Evaluation
    evaluate(const Motion &motion, const double time);

    /**
     * Energies and momenta of a motion, the one evaluated last, after the
     * @p work since time 0.
     */
    MotionReport
    report(const Motion     &motion,
           const Evaluation &evaluation,
           const Work       &work);

    const Scene              &scene;
    const DynamicsParameters &dynamics;
    DynamicSystem            &system;
    Progress                 &progress;
    EnergyGuard               guard;

    // Of the last accepted step.
    MotionReport                 last;
    std::optional<BalancedState> last_state;
    Work                         work; ///< since time 0
  };
} // namespace Setae

#endif
