// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_solvers_load_stepping_h
#define setae_solvers_load_stepping_h

#include <setae/base/expression.h>
#include <setae/scene.h>

#include <limits>

namespace Setae
{
  /**
   * Chooses the size of the load steps from the number of iterations that they
   * take: halved or less after a failure, grown again after success. A place
   * that cannot be passed is located by bisection down to the instability
   * resolution; no size is below the smallest step.
   */
  class LoadStepping
  {
  public:
    LoadStepping(const LoadSteppingParameters &parameters,
                 const Constants              &constants);

    /** The last time with an equilibrium. */
    double
    time() const
    {
      return current_time;
    }

    /**
     * The time to solve for next.
     *
     * @throws ExcParameter if the formula of the largest step allows less than
     * the smallest one now.
     */
    double
    next_time() const;

    /** next_time() - time() */
    double
    step_size() const
    {
      return next_time() - current_time;
    }

    bool
    is_finished() const
    {
      return current_time >= parameters.end_time;
    }

    /** The step has been solved. */
    void
    accept(const unsigned int n_iterations);

    /**
     * The step could not be solved: the next one will be smaller.
     *
     * @return False if it locates the place well enough already.
     */
    bool
    reject();

    /** The step went on to another branch: start again with the first size. */
    void
    restart();

  private:
    /** The value of the formula now, checked. */
    double
    largest_step_now() const;

    LoadSteppingParameters parameters;
    Expression             largest_step;
    double                 smallest_step;
    double                 current_time = 0.;
    double failed_time = std::numeric_limits<double>::infinity();
    double size;
  };
} // namespace Setae

#endif
