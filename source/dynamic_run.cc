// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <setae/base/exceptions.h>
#include <setae/dynamic_run.h>
#include <setae/solvers/generalized_alpha.h>
#include <setae/solvers/ida.h>
#include <setae/solvers/time_stepping.h>

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
  {}



  Evaluation
  DynamicRun::evaluate(const Motion &motion, const double time)
  {
    Vector rate(motion.acceleration);
    rate.add(dynamics.damping, motion.velocity);
    return system.evaluate_motion(
      motion.displacement, rate, 0., time, Request::residual);
  }



  DynamicRun::Balance
  DynamicRun::balance(const Motion     &motion,
                      const double      time,
                      const double      step_size,
                      const Evaluation &evaluation)
  {
    Balance       result;
    MotionReport &report = result.report;
    report.momenta       = system.momenta(motion);
    report.total_energy  = evaluation.energy + report.momenta.kinetic_energy;

    result.support_power = system.support_power(motion);
    result.external_work = system.external_work(motion, time);
    if (step_size == 0.)
      return result;

    report.support_work =
      last.report.support_work +
      .5 * step_size * (last.support_power + result.support_power);
    report.external_work =
      last.report.external_work +
      system.sum(work_between(last.external_work, result.external_work));

    // Damping takes the power c V.MV, twice c times the kinetic energy.
    report.dissipation =
      last.report.dissipation +
      step_size * dynamics.damping *
        (last.report.momenta.kinetic_energy + report.momenta.kinetic_energy);
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
    last = balance(initial, 0., 0., at_start.evaluation);
    StepRecord record;
    record.motion = last.report;
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
        record.motion             = last.report;
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

        Balance     next;
        StepMeasure quality;
        if (result.converged)
          {
            next    = balance(method.trial(),
                           record.time,
                           record.step_size,
                           result.evaluation);
            quality = measure(method, steps, next.report);
          }
        if (result.converged && quality.is_acceptable())
          {
            last = std::move(next);
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
                 << quality.displacement << ", the error of the energy "
                 << quality.energy << " of what is allowed";
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
  DynamicRun::measure(const GeneralizedAlpha &method,
                      const TimeStepping     &steps,
                      const MotionReport     &motion)
  {
    StepMeasure result;
    if (dynamics.largest_displacement > 0.)
      result.displacement =
        method.largest_displacement(system) / dynamics.largest_displacement;
    if (dynamics.energy_tolerance > 0.)
      result.energy = std::abs(motion.balance() - last.report.balance()) /
                      dynamics.energy_tolerance;
    if (steps.is_adaptive())
      result.error = method.error(system) / dynamics.tolerance;
    return result;
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
          const unsigned int n_solved) {
        const std::string passage =
          system.passage(last_displacement, motion.displacement);
        AssertThrow(passage.empty(),
                    ExcRun("From time " + std::to_string(last_time) + " to " +
                           std::to_string(time) + " " + passage +
                           ": 'dynamics/time step' "
                           "or 'dynamics/tolerance' is too "
                           "large. The states before it are "
                           "on disk."));
        last_displacement = motion.displacement;

        SolverResult result;
        result.converged    = true;
        result.n_iterations = n_solved;
        result.evaluation   = evaluate(motion, time);

        StepRecord record;
        record.time      = time;
        record.step_size = time - last_time;
        last = balance(motion, time, record.step_size, result.evaluation);
        record.motion = last.report;
        last_time     = time;
        visit(record, result, motion.displacement);
      });
  }
} // namespace Setae
