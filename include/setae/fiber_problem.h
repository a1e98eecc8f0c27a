// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_fiber_problem_h
#define setae_fiber_problem_h

#include <deal.II/base/conditional_ostream.h>
#include <deal.II/base/timer.h>

#include <setae/fiber_equations.h>
#include <setae/fibers/fiber_system.h>
#include <setae/output/progress.h>
#include <setae/output/result_files.h>
#include <setae/scene.h>

#include <functional>
#include <ostream>
#include <set>

namespace Setae
{
  /**
   * The driver: a scene is a list of fibers and a list of energy terms, whose
   * sum is made stationary for each load step, or whose fibers are moved in
   * time.
   *
   * @code
   * FiberProblem problem(Scene::read(text, file_name), MPI_COMM_WORLD,
   * std::cout); problem.run();
   * @endcode
   */
  class FiberProblem
  {
  public:
    /**
     * Build everything that the scene needs and check it; nothing is written.
     *
     * @throws ExcInput, ExcParameter
     */
    FiberProblem(const Scene &scene, MPI_Comm communicator, std::ostream &out);

    /**
     * Go through all load or time steps, and write the output directory of the
     * scene. The results of every step are on disk before the next one starts.
     *
     * @throws ExcRun if a step has no solution, with what happened where;
     * ExcParameter if the output directory cannot be used.
     */
    RunSummary
    run(const RunOrigin &origin = {});

    /**
     * All steps without writing anything; @p visit sees each one. For
     * benchmarks and tests.
     */
    RunSummary
    run(const std::function<void(const StepRecord &)> &visit);

    /** What the scene has been given, for tests and for the screen. */
    dealii::types::global_dof_index
    n_dofs() const
    {
      return fibers.dof_handler.n_dofs();
    }

    std::size_t
    n_nonzero_elements() const
    {
      return equations.n_nonzero_elements();
    }

    const dealii::TimerOutput &
    timer_output() const
    {
      return timer;
    }

    const FiberSystem &
    fiber_system() const
    {
      return fibers;
    }

    /** The state of the last step. */
    State
    state() const;

  private:
    using Vector = NonlinearSystem::Vector;

    void
    check_initial_gaps();

    void
    complete(StepRecord &record, const SolverResult &result);

    void
    warn_of_points();

    void
    output_results(const StepRecord &record, ResultFiles &files);

    const Scene                 scene;
    const MPI_Comm              communicator;
    dealii::ConditionalOStream  pcout;
    Progress                    progress;
    mutable dealii::TimerOutput timer;
    dealii::Timer               wall_clock;

    FiberSystem    fibers;
    FiberEquations equations;
    Vector         solution;
    double         time = 0.; ///< of the solution

    RunSummary summary;

    std::set<const EnergyTerm *> warned_terms;
  };
} // namespace Setae

#endif
