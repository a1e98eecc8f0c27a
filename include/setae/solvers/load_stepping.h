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
   * take: halved or less after a failure, grown again after success.
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

    /** The time to solve for next. */
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
     * @return False if it has the smallest size already.
     */
    bool
    reject();

    /** The step went on to another branch: start again with the first size. */
    void
    restart();

  private:
    LoadSteppingParameters parameters;
    Expression             largest_step;
    double                 current_time = 0.;
    double failed_time = std::numeric_limits<double>::infinity();
    double size;
  };
} // namespace Setae

#endif
