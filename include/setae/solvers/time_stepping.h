// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_solvers_time_stepping_h
#define setae_solvers_time_stepping_h

#include <setae/scene.h>

namespace Setae
{
  /**
   * Chooses the time steps of a method of second order. With a tolerance, from
   * the estimated error of the last step; without one, they are equal. In both
   * cases a step that fails is repeated with a smaller size, and the next ones
   * grow again.
   */
  class TimeStepping
  {
  public:
    explicit TimeStepping(const DynamicsParameters &parameters);

    /** The end of the last step. */
    double
    time() const
    {
      return current_time;
    }

    /** The time to solve for next. */
    double
    next_time() const;

    /** The size of the next step. */
    double
    step_size() const;

    bool
    is_finished() const
    {
      return current_time >= parameters.end_time;
    }

    /** Whether steps adapt to an error. */
    bool
    is_adaptive() const
    {
      return parameters.tolerance > 0.;
    }

    /** Whether a step with @p error [length] is accurate enough. */
    bool
    is_accurate(const double error) const
    {
      return error <= parameters.tolerance;
    }

    /** The step has been taken, with the estimated @p error [length]. */
    void
    accept(const double error);

    /**
     * The step has to be repeated with a smaller size, because of its @p error
     * if that is not zero.
     *
     * @return False if it has the smallest size already.
     */
    bool
    reject(const double error);

  private:
    double
    factor(const double error) const;

    DynamicsParameters parameters;
    double             smallest, largest;
    double             current_time = 0.;
    double             size;

    /** Counts equal steps, so that their times have no accumulated error. */
    double       start_time    = 0.;
    unsigned int n_equal_steps = 0;
  };
} // namespace Setae

#endif
