// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <deal.II/base/utilities.h>

#include <setae/base/exceptions.h>
#include <setae/dynamic_run.h>
#include <setae/solvers/generalized_alpha.h>
#include <setae/solvers/ida.h>
#include <setae/solvers/time_stepping.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

namespace Setae
{
  DynamicRun::DynamicRun(const Scene   &scene,
                         DynamicSystem &system,
                         Progress      &progress)
    : scene(scene)
    , dynamics(scene.dynamics)
    , system(system)
    , progress(progress)
    , guard(dynamics,
            std::all_of(scene.interactions.begin(),
                        scene.interactions.end(),
                        [](const InteractionParameters &interaction) {
                          return interaction.has_potential();
                        }))
  {}



  Evaluation
  DynamicRun::evaluate(const Motion &motion, const double time)
  {
    Vector rate(motion.acceleration);
    rate.add(dynamics.damping, motion.velocity);
    return system.evaluate_motion(
      motion.displacement, rate, 0., time, Request::residual);
  }



  MotionReport
  DynamicRun::report(const Motion     &motion,
                     const Evaluation &evaluation,
                     const Work       &work)
  {
    MotionReport result;
    result.momenta       = system.momenta(motion);
    result.total_energy  = evaluation.energy + result.momenta.kinetic_energy;
    result.support_work  = work.supports;
    result.external_work = work.external;
    result.dissipation   = work.damping;
    return result;
  }



  void
  DynamicRun::run(const StepVisitor &visit)
  {
    const Motion initial = system.initial_motion();

    SolverResult at_start;
    at_start.evaluation = evaluate(initial, 0.);
    AssertThrow(at_start.evaluation.is_admissible,
                ExcRun("The motion cannot begin: " +
                       at_start.evaluation.reason + "."));
    last = report(initial, at_start.evaluation, work);
    last_state.emplace(system, initial, 0.);
    guard.start(last, at_start.evaluation);
    StepRecord record;
    record.motion = last;
    visit(record, at_start, initial.displacement);

    if (dynamics.integrator == "IDA")
      run_ida(initial, visit);
    else
      run_generalized_alpha(initial, visit);
  }



  void
  DynamicRun::run_generalized_alpha(const Motion      &initial,
                                    const StepVisitor &visit)
  {
    GeneralizedAlpha method(
      dynamics,
      scene.newton,
      [this](const IterationReport &report) {
        progress.print_iteration(report);
      },
      initial);
    TimeStepping steps(dynamics);
    while (!steps.is_finished())
      {
        StepRecord         record;
        const SolverResult result = solve_step(method, steps, record);
        record.motion             = last;
        visit(record, result, method.motion().displacement);
      }
  }



  SolverResult
  DynamicRun::solve_step(GeneralizedAlpha &method,
                         TimeStepping     &steps,
                         StepRecord       &record)
  {
    for (;;)
      {
        record.time      = steps.next_time();
        record.step_size = steps.step_size();
        SolverResult result =
          method.try_step(system, record.time, record.step_size);
        if (result.converged)
          {
            result.reason    = system.passage(method.motion().displacement,
                                           method.trial().displacement);
            result.converged = result.reason.empty();
          }

        StepMeasure quality;
        std::string reason = result.reason;
        if (result.converged)
          {
            BalancedState state(system, method.trial(), record.time);
            const Work    step =
              work_between(system,
                           dynamics.damping,
                           *last_state,
                           state,
                           steps.time() > 0. ?
                             0. :
                             dynamics.damping * record.step_size);
            Work sum = work;
            sum += step;
            MotionReport next = report(method.trial(), result.evaluation, sum);

            // Inertia does as much as the kinetic energy changes by, but for
            // numerical damping and the force that conserves the energy.
            next.numerical_dissipation =
              last.numerical_dissipation + step.inertia -
              method.energy_correction() -
              (next.momenta.kinetic_energy - last.momenta.kinetic_energy);
            quality =
              measure(method, steps, next, result.evaluation, step.path);
            if (quality.is_acceptable())
              {
                guard.accept(next, result.evaluation);
                last       = next;
                last_state = std::move(state);
                work       = sum;
                method.accept();
                steps.accept(quality);
                return result;
              }
            reason = this->reason(quality, next, result.evaluation);
          }
        record.n_iterations_rejected += result.n_iterations;
        ++record.n_rejected;
        progress.print_rejection(reason);

        const double begin = steps.time();
        if (result.converged ? steps.reject(quality) : steps.reject())
          continue;
        std::ostringstream message;
        message << "The time step from " << begin << " to " << record.time
                << (result.converged ?
                      " is the smallest one and not accurate: " :
                      " has no solution: ")
                << reason << ". 'dynamics/smallest step', "
                << dynamics.shortest_step()
                << ", allows no shorter one. The states before it are on disk.";
        AssertThrow(false, ExcRun(message.str()));
      }
  }



  StepMeasure
  DynamicRun::measure(const GeneralizedAlpha &method,
                      const TimeStepping     &steps,
                      const MotionReport     &motion,
                      const Evaluation       &evaluation,
                      const double            path)
  {
    StepMeasure result;
    if (dynamics.largest_displacement > 0.)
      result.displacement =
        method.largest_displacement(system) / dynamics.largest_displacement;
    if (dynamics.energy_tolerance > 0.)
      result.energy =
        std::abs(motion.balance() - last.balance()) / dynamics.energy_tolerance;
    if (steps.is_adaptive())
      result.error = method.error(system) / dynamics.tolerance;
    result.gain = guard.measure(motion, evaluation, path);
    return result;
  }



  std::string
  DynamicRun::reason(const StepMeasure  &measure,
                     const MotionReport &motion,
                     const Evaluation   &evaluation) const
  {
    std::ostringstream text;
    const auto         add = [&text](const double       part,
                             const std::string &what,
                             const std::string &parameter) {
      if (part > 1.)
        text << (text.tellp() > 0 ? ", " : "") << what << " is " << part
             << " times 'dynamics/" << parameter << "'";
    };
    add(measure.error, "the error", "tolerance");
    add(measure.displacement,
        "the displacement of a node",
        "largest displacement");
    add(measure.energy, "the error of the energy balance", "energy tolerance");
    if (!(measure.gain <= 1.))
      text << (text.tellp() > 0 ? ", " : "")
           << guard.reason(motion, evaluation);
    return text.str();
  }



  void
  DynamicRun::run_ida(const Motion &initial, const StepVisitor &visit)
  {
    double last_time         = 0.;
    Vector last_displacement = initial.displacement;
    Ida(dynamics).run(
      system,
      initial,
      [&](const double       time,
          const Motion      &motion,
          const WorkMeter   &meter,
          const unsigned int n_solved) {
        const std::string passage =
          system.passage(last_displacement, motion.displacement);
        AssertThrow(passage.empty(),
                    ExcRun("From time " +
                           dealii::Utilities::to_string(last_time) + " to " +
                           dealii::Utilities::to_string(time) + " " + passage +
                           ": 'dynamics/time step' "
                           "or 'dynamics/tolerance' is too "
                           "large. The states before it are "
                           "on disk."));
        last_displacement = motion.displacement;

        SolverResult result;
        result.converged    = true;
        result.n_iterations = n_solved;
        result.evaluation   = evaluate(motion, time);
        AssertThrow(result.evaluation.is_admissible,
                    ExcRun("At time " + dealii::Utilities::to_string(time) +
                           ", " + result.evaluation.reason +
                           ". The states before it are on disk."));

        last = report(motion,
                      result.evaluation,
                      meter.until({system, motion, time}));
        AssertThrow(!guard.is_exceeded(last, result.evaluation),
                    ExcRun("At time " + dealii::Utilities::to_string(time) +
                           ", " + guard.reason(last, result.evaluation) +
                           "; a smaller 'dynamics/tolerance' may help. The "
                           "states before it are on disk."));
        guard.accept(last, result.evaluation);

        StepRecord record;
        record.time      = time;
        record.step_size = time - last_time;
        record.motion    = last;
        last_time        = time;
        visit(record, result, motion.displacement);
      });
  }
} // namespace Setae
