// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <setae/solvers/time_stepping.h>

#include <algorithm>
#include <cmath>

namespace Setae
{
  TimeStepping::TimeStepping(const DynamicsParameters &parameters)
    : parameters(parameters)
    , smallest(parameters.smallest_step > 0. ? parameters.smallest_step :
                                               1e-6 * parameters.time_step)
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
  TimeStepping::factor(const double error) const
  {
    constexpr double safety = .9, least = .2, most = 2.;
    if (error == 0.)
      return most;
    return std::clamp(safety * std::cbrt(parameters.tolerance / error),
                      least,
                      most);
  }



  void
  TimeStepping::accept(const double error)
  {
    constexpr double worth_changing = 1.2;

    current_time = next_time();
    ++n_equal_steps;
    double new_size = size;
    if (is_adaptive())
      {
        const double ratio = factor(error);
        if (ratio < 1. || ratio > worth_changing)
          new_size = std::clamp(size * ratio, smallest, largest);
      }
    else
      new_size = std::min(2. * size, parameters.time_step);
    if (new_size != size)
      {
        size          = new_size;
        start_time    = current_time;
        n_equal_steps = 0;
      }
  }



  bool
  TimeStepping::reject(const double error)
  {
    constexpr double after_failure = .5;

    if (step_size() <= smallest * (1. + 1e-10))
      return false;
    const double ratio =
      error > 0. ? std::min(factor(error), .9) : after_failure;
    size          = std::max(step_size() * ratio, smallest);
    start_time    = current_time;
    n_equal_steps = 0;
    return true;
  }
} // namespace Setae
