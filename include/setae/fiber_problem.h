// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_fiber_problem_h
#define setae_fiber_problem_h

#include <deal.II/base/conditional_ostream.h>
#include <deal.II/base/timer.h>

#include <deal.II/lac/solver_control.h>
#include <deal.II/lac/trilinos_solver.h>

#include <setae/assembly/load.h>
#include <setae/assembly/strain_energy.h>
#include <setae/assembly/supports.h>
#include <setae/fibers/fiber_system.h>
#include <setae/output/progress.h>
#include <setae/output/result_files.h>
#include <setae/scene.h>
#include <setae/solvers/load_stepping.h>
#include <setae/solvers/nonlinear_system.h>

#include <memory>
#include <ostream>

namespace Setae
{
  /**
   * The driver: a scene is a list of fibers and a list of energy terms, whose
   * sum is made stationary for each load step.
   *
   * @code
   * FiberProblem problem(Scene::read(text, file_name), MPI_COMM_WORLD,
   * std::cout); problem.run();
   * @endcode
   */
  class FiberProblem : private NonlinearSystem
  {
  public:
    /**
     * Build everything that the scene needs and check it; nothing is written.
     *
     * @throws ExcInput, ExcParameter
     */
    FiberProblem(const Scene &scene, MPI_Comm communicator, std::ostream &out);

    /**
     * Go through all load steps, and write the output directory of the scene.
     * The results of every step are on disk before the next one starts.
     *
     * @throws ExcRun if a step has no solution, with what happened where.
     */
    RunSummary
    run();

    /**
     * All load steps without writing anything; @p visit sees each one. For
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
      return system.tangent_matrix.n_nonzero_elements();
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
    void
    setup_terms();

    void
    find_pairs(const State &state);

    void
    setup_matrix();

    Evaluation
    evaluate(const Vector          &solution,
             const double           time,
             const SupportIncrement supports) override;

    void
    assemble_system(const State                             &state,
                    const dealii::AffineConstraints<double> &constraints,
                    Evaluation                              &evaluation);

    void
    judge(Evaluation &evaluation) const;

    bool
    solve(Vector &increment) override;

    double
    add_damping(const Vector &coefficients, const Vector &motion) override;

    Vector
    diagonal() const override;

    double
    largest_displacement(const Vector &increment) const override;

    void
    check_initial_gaps();

    SolverResult
    solve_step(LoadStepping &steps, StepRecord &record);

    bool
    has_potential() const;

    void
    complete(StepRecord &record, const SolverResult &result);

    void
    output_results(const StepRecord &record, ResultFiles &files);

    std::string
    where(const GapReport &gaps) const;

    const Scene                 scene;
    const MPI_Comm              communicator;
    dealii::ConditionalOStream  pcout;
    Progress                    progress;
    mutable dealii::TimerOutput timer;
    dealii::Timer               wall_clock;

    FiberSystem                              fibers;
    std::vector<std::unique_ptr<EnergyTerm>> terms;
    const StrainEnergy                      *strain; ///< the first of the terms
    std::vector<const Load *>                loads;
    Supports                                 supports;
    GlobalSystem                             system;

    dealii::IndexSet                  all_dofs;
    Vector                            solution;
    double                            time = 0.;  ///< of the solution
    mutable Vector                    everywhere; ///< solution, on all ranks
    dealii::AffineConstraints<double> increment_constraints;
    bool                              increment_at_rest = true;

    RunSummary summary;
  };
} // namespace Setae

#endif
