// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <deal.II/lac/sparsity_tools.h>

#include <setae/assembly/interaction.h>
#include <setae/assembly/load.h>
#include <setae/base/exceptions.h>
#include <setae/fiber_problem.h>
#include <setae/solvers/newton.h>
#include <setae/solvers/relaxation.h>
#include <setae/verification/verification.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace Setae
{
  using namespace dealii;

  namespace
  {
    std::vector<std::string>
    term_names(const Scene &scene)
    {
      std::vector<std::string> names = {"strain"};
      for (const LoadParameters &load : scene.loads)
        names.push_back(scene.loads.size() > 1 ? "load (" + load.name + ")" :
                                                 "load");
      for (const InteractionParameters &interaction : scene.interactions)
        names.push_back(scene.interactions.size() > 1 ?
                          "interaction (" + interaction.name + ")" :
                          "interaction");
      return names;
    }
    /** The largest distance of a node from the first one [length]. */
    double
    extent(const State &state)
    {
      double             largest = 0.;
      const Tensor<1, 3> origin  = state.current.front().coefficients[0];
      for (const HermiteCell<> &cell : state.current)
        for (const unsigned int a : {0, 2})
          largest = std::max(largest, (cell.coefficients[a] - origin).norm());
      return largest;
    }
  } // namespace



  FiberProblem::FiberProblem(const Scene  &scene,
                             MPI_Comm      communicator,
                             std::ostream &out)
    : scene(scene)
    , communicator(communicator)
    , pcout(out, Utilities::MPI::this_mpi_process(communicator) == 0)
    , progress(pcout, this->scene, term_names(scene))
    // Without the communicator, which would make it print a notice on the way
    // out of a run that failed.
    , timer(pcout, TimerOutput::never, TimerOutput::wall_times)
    , fibers(this->scene, communicator)
    , supports(fibers)
    , system(fibers)
    , all_dofs(complete_index_set(fibers.dof_handler.n_dofs()))
    , solution(fibers.owned_dofs, communicator)
    , everywhere(fibers.owned_dofs, all_dofs, communicator)
  {
    setup_terms();
    check_initial_gaps();

    // Its formula is not looked at again before the run.
    LoadStepping(this->scene.load_stepping, this->scene.constants);
  }



  void
  FiberProblem::setup_terms()
  {
    auto strain_energy = std::make_unique<StrainEnergy>(fibers);
    strain             = strain_energy.get();
    terms.push_back(std::move(strain_energy));
    for (const LoadParameters &load : scene.loads)
      {
        auto term = std::make_unique<Load>(fibers, load);
        loads.push_back(term.get());
        terms.push_back(std::move(term));
      }
    for (const InteractionParameters &interaction : scene.interactions)
      terms.push_back(make_interaction(fibers, interaction));
  }



  /**
   * Let the terms look for partners, and give the matrix its pattern if that is
   * new on any rank.
   */
  void
  FiberProblem::find_pairs(const State &state)
  {
    bool changed = system.tangent_matrix.m() == 0;
    for (const auto &term : terms)
      if (term->has_search())
        {
          TimerOutput::Scope section(timer, "search");
          changed = term->update_couplings(state) || changed;
        }
    if (Utilities::MPI::max(changed ? 1 : 0, communicator) == 1)
      setup_matrix();
  }



  void
  FiberProblem::setup_matrix()
  {
    TimerOutput::Scope section(timer, "setup");

    std::vector<std::pair<unsigned int, unsigned int>> pairs;
    for (const unsigned int cell : fibers.owned_cells)
      pairs.emplace_back(cell, cell);
    for (const auto &term : terms)
      term->add_couplings(pairs);

    DynamicSparsityPattern               pattern(all_dofs);
    std::vector<types::global_dof_index> dofs;
    for (const auto &[first, second] : pairs)
      {
        dofs.clear();
        for (const unsigned int cell : {first, second})
          for (const auto dof : fibers.cell_dofs[cell])
            if (dof != numbers::invalid_dof_index)
              dofs.push_back(dof);
        supports.at_rest().add_entries_local_to_global(dofs, pattern, false);
      }
    SparsityTools::distribute_sparsity_pattern(pattern,
                                               fibers.owned_dofs,
                                               communicator,
                                               all_dofs);
    system.reinit_matrix(pattern);
  }



  Evaluation
  FiberProblem::evaluate(const Vector          &solution,
                         const double           time,
                         const SupportIncrement support_increment)
  {
    everywhere        = solution;
    const State state = fibers.state(everywhere, time);
    find_pairs(state);

    increment_at_rest = support_increment == SupportIncrement::at_rest;
    if (!increment_at_rest)
      increment_constraints = supports.increment_to(time, everywhere);

    Evaluation evaluation;
    assemble_system(state,
                    increment_at_rest ? supports.at_rest() :
                                        increment_constraints,
                    evaluation);
    judge(evaluation);
    return evaluation;
  }



  void
  FiberProblem::assemble_system(const State                     &state,
                                const AffineConstraints<double> &constraints,
                                Evaluation                      &evaluation)
  {
    system.start(Request::tangent, constraints);
    bool is_complete = true;
    evaluation.energies.assign(terms.size(), 0.);
    for (unsigned int i = 0; i < terms.size(); ++i)
      {
        TimerOutput::Scope section(timer, terms[i]->name());
        try
          {
            evaluation.energies[i] =
              terms[i]->assemble(state, Request::tangent, system);
          }
        catch (const TorsionFreeKirchhoff::ExcCollapsedCell &)
          {
            is_complete = false;
          }
      }
    system.finish();

    evaluation.is_valid =
      Utilities::MPI::min(is_complete ? 1 : 0, communicator) == 1;
    if (!evaluation.is_valid)
      evaluation.reason = "a cell has collapsed to a point";

    Utilities::MPI::sum(evaluation.energies, communicator, evaluation.energies);
    for (const double energy : evaluation.energies)
      evaluation.energy += energy;

    Vector free_residual(system.residual);
    supports.at_rest().set_zero(free_residual);
    evaluation.residual_norm = free_residual.l2_norm();

    // Stiffness times the round-off of a coordinate.
    evaluation.round_off = std::numeric_limits<double>::epsilon() *
                           system.tangent_matrix.linfty_norm() * extent(state);
  }



  /** Collect the gaps of all terms and ranks, and find what is wrong. */
  void
  FiberProblem::judge(Evaluation &evaluation) const
  {
    if (!std::isfinite(evaluation.residual_norm) ||
        !std::isfinite(evaluation.energy))
      {
        evaluation.is_valid = false;
        evaluation.reason   = "the residual is not finite";
      }
    evaluation.is_admissible = evaluation.is_valid;
    for (const auto &term : terms)
      {
        GapReport gaps;
        for (const GapReport &report :
             Utilities::MPI::all_gather(communicator, term->gaps()))
          gaps.see(report);
        evaluation.gaps.see(gaps);

        const double limit = term->smallest_admissible_gap();
        if (gaps.smallest <= term->singular_gap())
          evaluation.is_valid = false;
        if (gaps.smallest < limit || !evaluation.is_valid)
          {
            evaluation.is_admissible = false;
            std::ostringstream text;
            text << "the gap is " << gaps.smallest << " " << where(gaps)
                 << ", below " << limit;
            evaluation.reason = text.str();
          }
      }
  }



  bool
  FiberProblem::solve(Vector &increment)
  {
    TimerOutput::Scope section(timer, "solve");
    bool               is_solved = true;
    try
      {
        SolverControl                  control;
        TrilinosWrappers::SolverDirect solver(
          control,
          TrilinosWrappers::SolverDirect::AdditionalData(
            false, scene.newton.linear_solver));
        solver.solve(system.tangent_matrix, increment, system.right_hand_side);
      }
    catch (const std::exception &)
      {
        is_solved = false;
      }
    is_solved = is_solved && std::isfinite(increment.l2_norm());
    if (Utilities::MPI::min(is_solved ? 1 : 0, communicator) == 0)
      return false;
    (increment_at_rest ? supports.at_rest() : increment_constraints)
      .distribute(increment);
    return true;
  }



  double
  FiberProblem::add_damping(const Vector &coefficients, const Vector &motion)
  {
    auto  &matrix = system.tangent_matrix;
    Vector force(motion);
    force.scale(coefficients);
    for (const auto i : fibers.owned_dofs)
      matrix.set(i, i, matrix.diag_element(i) + coefficients(i));
    matrix.compress(VectorOperation::insert);

    Vector free_force(force);
    supports.at_rest().set_zero(free_force);
    system.right_hand_side -= free_force;

    free_force += system.residual;
    supports.at_rest().set_zero(free_force);
    return free_force.l2_norm();
  }



  FiberProblem::Vector
  FiberProblem::diagonal() const
  {
    Vector result(fibers.owned_dofs, communicator);
    for (const auto i : fibers.owned_dofs)
      result(i) = std::abs(system.tangent_matrix.diag_element(i));
    result.compress(VectorOperation::insert);
    return result;
  }



  double
  FiberProblem::largest_displacement(const Vector &increment) const
  {
    double largest = 0.;
    for (const unsigned int cell : fibers.owned_cells)
      for (const unsigned int shape : {0u, 2u})
        for (unsigned int c = 0; c < 3; ++c)
          {
            const auto dof = fibers.cell_dofs[cell][3 * shape + c];
            if (fibers.owned_dofs.is_element(dof))
              largest = std::max(largest, std::abs(increment(dof)));
          }
    return Utilities::MPI::max(largest, communicator);
  }



  void
  FiberProblem::check_initial_gaps()
  {
    if (scene.interactions.empty())
      return;
    const Evaluation initial =
      evaluate(solution, 0., SupportIncrement::at_rest);
    AssertThrow(initial.gaps.smallest > 0.,
                ExcInput("Fibers overlap initially: the gap " +
                         where(initial.gaps) + " is " +
                         std::to_string(initial.gaps.smallest) +
                         ", but must be positive."));
  }



  std::string
  FiberProblem::where(const GapReport &gaps) const
  {
    const auto place = [this](const unsigned int cell) {
      const Fiber &f = fibers.fibers[fibers.fiber_of_cell[cell]];
      return "'" + f.name + "'";
    };
    const Fiber       &f = fibers.fibers[fibers.fiber_of_cell[gaps.source]];
    const auto         i = gaps.source - f.first_cell;
    std::ostringstream text;
    text << "between " << place(gaps.source) << " (at s = "
         << f.arc_length[i] + gaps.x * (f.arc_length[i + 1] - f.arc_length[i])
         << ") and " << place(gaps.target);
    return text.str();
  }



  State
  FiberProblem::state() const
  {
    everywhere = solution;
    return fibers.state(everywhere, time);
  }



  SolverResult
  FiberProblem::solve_step(LoadStepping &steps, StepRecord &record)
  {
    const Newton::Log log = [this](const IterationReport &report) {
      progress.print_iteration(report);
    };
    const Newton newton(scene.newton, log);
    for (;;)
      {
        record.time               = steps.next_time();
        record.step_size          = steps.step_size();
        const SolverResult result = newton.solve(*this, solution, record.time);
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

        SolverResult relaxed = result;
        if (scene.load_stepping.pass_instabilities && has_potential())
          relaxed =
            Relaxation(scene.newton, log).solve(*this, solution, record.time);
        std::ostringstream message;
        message << "The load step from time " << steps.time() << " to "
                << record.time << " has no solution: " << relaxed.reason
                << ". The states before it are on disk.";
        AssertThrow(relaxed.converged, ExcRun(message.str()));
        record.is_snap = true;
        steps.restart();
        return relaxed;
      }
  }



  bool
  FiberProblem::has_potential() const
  {
    return std::all_of(terms.begin(), terms.end(), [](const auto &term) {
      return term->has_potential();
    });
  }



  /** Fill in what is known of every step once it is solved. */
  void
  FiberProblem::complete(StepRecord &record, const SolverResult &result)
  {
    time                    = record.time;
    record.step             = summary.n_steps;
    record.evaluation       = result.evaluation;
    record.n_iterations     = result.n_iterations;
    record.has_interactions = !scene.interactions.empty();
    record.supports         = supports.report(record.time, system.residual);
    record.wall_time        = wall_clock.wall_time();

    const State state = this->state();
    for (unsigned int i = 0; i < loads.size(); ++i)
      if (loads[i]->has_point())
        record.loads.push_back(
          {scene.loads[i].name, loads[i]->displacement(state)});
  }



  RunSummary
  FiberProblem::run(const std::function<void(const StepRecord &)> &visit)
  {
    Timer cpu_clock;
    summary = {};
    wall_clock.restart();

    const auto finish_step = [&](StepRecord          record,
                                 const SolverResult &result) {
      complete(record, result);
      summary.add(record);
      visit(record);
    };

    // The fibers as they are given need not be in equilibrium.
    const SolverResult initial =
      Newton(scene.newton, [](const IterationReport &) {
      }).solve(*this, solution, 0.);
    AssertThrow(initial.converged,
                ExcRun("There is no equilibrium at time 0: " + initial.reason +
                       "."));
    finish_step(StepRecord{}, initial);

    LoadStepping steps(scene.load_stepping, scene.constants);
    while (!steps.is_finished())
      {
        StepRecord         record;
        const SolverResult result = solve_step(steps, record);
        finish_step(record, result);
      }
    summary.cpu_time = cpu_clock.cpu_time();
    return summary;
  }



  RunSummary
  FiberProblem::run()
  {
    ResultFiles files(fibers, term_names(scene));
    files.prepare();
    progress.print_header(fibers);
    run([&](const StepRecord &record) {
      output_results(record, files);
      progress.print_step(record);
    });
    progress.print_summary(summary);
    if (scene.verification != "none")
      {
        TimerOutput::Scope section(timer, "verification");
        const auto         verifications = verify(fibers, state());
        if (pcout.is_active())
          print(verifications, pcout.get_stream());
      }
    timer.print_summary();
    return summary;
  }



  void
  FiberProblem::output_results(const StepRecord &record, ResultFiles &files)
  {
    TimerOutput::Scope section(timer, "output");
    files.add(record, state(), *strain, terms);
  }
} // namespace Setae
