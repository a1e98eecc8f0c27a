// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <setae/solvers/time_stepping.h>

#include <algorithm>
#include <cmath>

namespace Setae
{
  TimeStepping::TimeStepping(const DynamicsParameters &parameters)
    : parameters(parameters)
    , smallest(parameters.shortest_step())
    , largest(parameters.largest_step > 0. ? parameters.largest_step :
                                             parameters.end_time)
    , size(parameters.time_step)
  {}



  double
  TimeStepping::next_time() const
  {
    const double next = start_time + (n_equal_steps + 1) * size;

    // No tiny last step.
    return next > parameters.end_time - 1e-6 * size ? parameters.end_time :
                                                      next;
  }



  double
  TimeStepping::step_size() const
  {
    // The last step may be shorter, but for round-off.
    const double left = parameters.end_time - current_time;
    return left < (1. - 1e-6) * size ? left : size;
  }



  double
  TimeStepping::factor(const StepMeasure &measure)
  {
    constexpr double safety = .9, least = .2, most = 2.;
    double           result = most;
    if (measure.error > 0.)
      result = std::min(result, safety / std::cbrt(measure.error));
    for (const double energy : {measure.energy, measure.gain})
      if (energy > 0.)
        result = std::min(result, safety / std::sqrt(energy));
    if (measure.displacement > 0.)
      result = std::min(result, safety / measure.displacement);
    return std::max(result, least);
  }



  void
  TimeStepping::resize(const double new_size)
  {
    size          = new_size;
    start_time    = current_time;
    n_equal_steps = 0;
  }



  void
  TimeStepping::accept(const StepMeasure &measure)
  {
    constexpr double worth_changing = 1.2;

    current_time = next_time();
    ++n_equal_steps;
    const double ratio = factor(measure);
    double       next  = size;
    if (is_adaptive() && (ratio < 1. || ratio > worth_changing))
      next = std::clamp(size * ratio, smallest, largest);
    else if (!is_adaptive() && ratio > 1.)
      next = std::min(size * ratio, parameters.time_step);
    if (next != size)
      resize(next);
  }



  bool
  TimeStepping::repeat(const double factor)
  {
    if (step_size() <= smallest * (1. + 1e-10))
      return false;
    resize(std::max(step_size() * factor, smallest));
    return true;
  }



  bool
  TimeStepping::reject(const StepMeasure &measure)
  {
    return repeat(std::min(factor(measure), .9));
  }



  bool
  TimeStepping::reject()
  {
    return repeat(.5);
  }
} // namespace Setae
