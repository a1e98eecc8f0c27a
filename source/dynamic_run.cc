// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <setae/base/exceptions.h>
#include <setae/dynamic_run.h>
#include <setae/solvers/generalized_alpha.h>
#include <setae/solvers/ida.h>
#include <setae/solvers/time_stepping.h>

#include <sstream>

namespace Setae
{
  DynamicRun::DynamicRun(const Scene   &scene,
                         DynamicSystem &system,
                         Progress      &progress)
    : scene(scene)
    , dynamics(scene.dynamics)
    , system(system)
    , progress(progress)
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
                     const double      step_size,
                     const Evaluation &evaluation)
  {
    MotionReport result;
    result.momenta      = system.momenta(motion);
    result.total_energy = evaluation.energy + result.momenta.kinetic_energy;

    // Damping takes the power c V.MV, twice c times the kinetic energy.
    const double support_power = system.support_power(motion);
    result.support_work        = last_report.support_work +
                          .5 * step_size * (last_support_power + support_power);
    result.dissipation =
      last_report.dissipation +
      step_size * dynamics.damping *
        (last_report.momenta.kinetic_energy + result.momenta.kinetic_energy);
    last_report        = result;
    last_support_power = support_power;
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
    last_report        = {};
    last_support_power = 0.;
    StepRecord record;
    record.motion = report(initial, 0., at_start.evaluation);
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
        record.motion =
          report(method.motion(), record.step_size, result.evaluation);
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
        const SolverResult result =
          method.try_step(system, record.time, record.step_size);

        const StepMeasure quality =
          result.converged ? measure(method, steps) : StepMeasure();
        if (result.converged && quality.is_acceptable())
          {
            method.accept();
            steps.accept(quality);
            return result;
          }

        std::ostringstream reason;
        if (!result.converged)
          reason << result.reason;
        else
          reason << "the error is " << quality.error
                 << " of the tolerance, the largest displacement "
                 << quality.displacement << " of what is allowed";
        record.n_iterations_rejected += result.n_iterations;
        ++record.n_rejected;
        progress.print_rejection(reason.str());

        const double begin = steps.time();
        if (result.converged ? steps.reject(quality) : steps.reject())
          continue;
        std::ostringstream message;
        message << "The time step from " << begin << " to " << record.time
                << " has no solution: " << reason.str()
                << ". The states before it are on disk.";
        AssertThrow(false, ExcRun(message.str()));
      }
  }



  StepMeasure
  DynamicRun::measure(const GeneralizedAlpha &method, const TimeStepping &steps)
  {
    StepMeasure result;
    if (dynamics.largest_displacement > 0.)
      result.displacement =
        method.largest_displacement(system) / dynamics.largest_displacement;
    if (steps.is_adaptive())
      result.error = method.error(system) / dynamics.tolerance;
    return result;
  }



  void
  DynamicRun::run_ida(const Motion &initial, const StepVisitor &visit)
  {
    double last_time = 0.;
    Ida(dynamics).run(system,
                      initial,
                      [&](const double       time,
                          const Motion      &motion,
                          const unsigned int n_solved) {
                        SolverResult result;
                        result.converged    = true;
                        result.n_iterations = n_solved;
                        result.evaluation   = evaluate(motion, time);

                        StepRecord record;
                        record.time      = time;
                        record.step_size = time - last_time;
                        record.motion =
                          report(motion, record.step_size, result.evaluation);
                        last_time = time;
                        visit(record, result, motion.displacement);
                      });
  }
} // namespace Setae
