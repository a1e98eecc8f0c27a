// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_solvers_time_stepping_h
#define setae_solvers_time_stepping_h

#include <setae/scene.h>

namespace Setae
{
  /** What a time step is judged by, each as a part of what is allowed. */
  struct StepMeasure
  {
    double error        = 0.; ///< that of the step, of third order in its size
    double displacement = 0.; ///< the largest one, of first order

    /** The error of its balance, of second order where a contact begins. */
    double energy = 0.;

    /** The energy that it creates, of second order as well. */
    double gain = 0.;

    bool
    is_acceptable() const
    {
      return error <= 1. && displacement <= 1. && energy <= 1. && gain <= 1.;
    }
  };



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

    /** The step has been taken. */
    void
    accept(const StepMeasure &measure);

    /**
     * The step is not acceptable by its @p measure and has to be shorter.
     *
     * @return False if it has the smallest size already.
     */
    bool
    reject(const StepMeasure &measure);

    /**
     * The step has no solution and has to be shorter.
     *
     * @return False if it has the smallest size already.
     */
    bool
    reject();

  private:
    /** The next size over the last one. */
    static double
    factor(const StepMeasure &measure);

    bool
    repeat(const double factor);

    void
    resize(const double new_size);

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
