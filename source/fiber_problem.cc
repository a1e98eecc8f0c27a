// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <setae/base/exceptions.h>
#include <setae/dynamic_run.h>
#include <setae/fiber_problem.h>
#include <setae/static_run.h>
#include <setae/verification/verification.h>

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
    , equations(fibers, timer)
    , solution(fibers.owned_dofs, communicator)
  {
    check_initial_gaps();

    // Its formula is not looked at again before the run.
    if (!this->scene.dynamics.is_on())
      StaticRun(this->scene, equations, progress);
  }



  void
  FiberProblem::check_initial_gaps()
  {
    if (scene.interactions.empty())
      return;
    const Evaluation initial =
      equations.evaluate(solution, 0., SupportIncrement::at_rest);
    std::ostringstream gap;
    gap << initial.gaps.smallest;
    AssertThrow(initial.gaps.smallest > 0.,
                ExcInput("Fibers overlap initially: the gap " +
                         equations.where(initial.gaps) + " is " + gap.str() +
                         ", but must be positive."));
  }



  State
  FiberProblem::state() const
  {
    return equations.state(solution, time);
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
    record.supports         = equations.support_reports(record.time);
    record.wall_time        = wall_clock.wall_time();

    const State state = this->state();
    for (unsigned int i = 0; i < equations.loads.size(); ++i)
      if (equations.loads[i]->has_point())
        record.loads.push_back(
          {scene.loads[i].name, equations.loads[i]->displacement(state)});
  }



  RunSummary
  FiberProblem::run(const std::function<void(const StepRecord &)> &visit)
  {
    Timer cpu_clock;
    summary = {};
    wall_clock.restart();

    const StepVisitor finish_step = [&](StepRecord          record,
                                        const SolverResult &result,
                                        const Vector       &unknowns) {
      solution = unknowns;
      complete(record, result);
      if (record.evaluation.gaps.smallest < summary.smallest_gap)
        summary.smallest_gap_place = equations.where(record.evaluation.gaps) +
                                     " in step " + std::to_string(record.step);
      summary.add(record);
      visit(record);
    };
    if (scene.dynamics.is_on())
      DynamicRun(scene, equations, progress).run(finish_step);
    else
      {
        Vector equilibrium(solution);
        StaticRun(scene, equations, progress).run(equilibrium, finish_step);
      }
    summary.cpu_time = cpu_clock.cpu_time();
    return summary;
  }



  /** Once for each interaction, on the screen. */
  void
  FiberProblem::warn_of_points()
  {
    const State state = this->state();
    for (const auto &term : equations.terms)
      if (warned_terms.count(term.get()) == 0)
        for (const std::string &warning :
             Utilities::MPI::all_gather(communicator,
                                        term->unresolved_points(state)))
          if (!warning.empty() && warned_terms.insert(term.get()).second)
            progress.print_warning(warning);
  }



  RunSummary
  FiberProblem::run(const RunOrigin &origin)
  {
    ResultFiles files(fibers, term_names(scene));
    files.prepare(origin);
    progress.print_header(fibers);
    for (const std::string &notice : fibers.notices)
      pcout << notice << std::endl;
    run([&](const StepRecord &record) {
      output_results(record, files);
      progress.print_step(record);
      warn_of_points();
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
    files.add(record, state(), *equations.strain, equations.terms);
  }
} // namespace Setae
