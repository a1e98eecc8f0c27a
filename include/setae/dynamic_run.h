// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_dynamic_run_h
#define setae_dynamic_run_h

#include <setae/output/progress.h>
#include <setae/solvers/dynamic_system.h>

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
            const MotionReport     &motion);

    /** Residual and energies of a motion. */
    Evaluation
    evaluate(const Motion &motion, const double time);

    /** A report of a motion, and what the next one starts from. */
    struct Balance
    {
      MotionReport              report;
      double                    support_power = 0.; ///< [energy/time]
      std::vector<ExternalWork> external_work;      ///< of this rank
    };

    /**
     * Energies, momenta and, by the trapezoidal rule from the last accepted
     * step on, work. The motion is the one evaluated last.
     */
    Balance
    balance(const Motion     &motion,
            const double      time,
            const double      step_size,
            const Evaluation &evaluation);

    const Scene              &scene;
    const DynamicsParameters &dynamics;
    DynamicSystem            &system;
    Progress                 &progress;

    Balance last; ///< of the last accepted step
  };
} // namespace Setae

#endif
