// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <setae/base/exceptions.h>
#include <setae/solvers/load_stepping.h>

#include <algorithm>
#include <limits>
#include <sstream>

namespace Setae
{
  LoadStepping::LoadStepping(const LoadSteppingParameters &parameters,
                             const Constants              &constants)
    : parameters(parameters)
    , largest_step("load stepping/largest step",
                   parameters.largest_step,
                   "t",
                   constants)
    , smallest_step(parameters.smallest_step > 0. ?
                      parameters.smallest_step :
                      std::min({1e-6 * parameters.end_time,
                                parameters.first_step,
                                parameters.instability_resolution}))
    , size(parameters.first_step)
  {
    largest_step_now();
  }



  double
  LoadStepping::largest_step_now() const
  {
    const double value = largest_step(current_time);
    if (value < smallest_step)
      {
        std::ostringstream allowed;
        allowed << (value > 0. ? "at least 'load stepping/smallest step', " :
                                 "positive");
        if (value > 0.)
          allowed << smallest_step;
        allowed << " at every time, but is " << value
                << " at t = " << current_time;
        AssertThrow(false,
                    ExcParameter("load stepping/largest step",
                                 parameters.largest_step,
                                 allowed.str()));
      }
    return value;
  }



  double
  LoadStepping::next_time() const
  {
    const double step = std::min(size, largest_step_now());
    const double left = parameters.end_time - current_time;

    // No tiny last step: the remainder is taken at once or in two halves.
    if (left <= step * (1. + 1e-10))
      return parameters.end_time;
    return current_time + (left < 2. * step ? .5 * left : step);
  }



  void
  LoadStepping::accept(const unsigned int n_iterations)
  {
    const double step = step_size();
    current_time      = next_time();

    // Newton's method converges in a number of iterations that grows slowly
    // with the size of the step; the square keeps the reaction gentle.
    const double ratio =
      static_cast<double>(parameters.target_n_iterations) / n_iterations;
    size = step * std::clamp(ratio * ratio, .5, parameters.growth);

    // Where a longer step has failed, close in on the place by bisection.
    if (current_time >= failed_time)
      failed_time = std::numeric_limits<double>::infinity();
    size = std::min(size,
                    std::max(.5 * (failed_time - current_time),
                             parameters.instability_resolution));
    size = std::max(size, smallest_step);
  }



  bool
  LoadStepping::reject()
  {
    constexpr double reduction = .25;

    // A size that is a difference of times has their round-off.
    constexpr double least_reduction = 1e-6;

    const double next =
      std::max(reduction * step_size(), parameters.instability_resolution);
    if (next >= (1. - least_reduction) * step_size())
      return false;
    failed_time = next_time();
    size        = next;
    return true;
  }



  void
  LoadStepping::restart()
  {
    current_time = next_time();
    failed_time  = std::numeric_limits<double>::infinity();
    size         = parameters.first_step;
  }
} // namespace Setae
