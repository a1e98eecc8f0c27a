// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_solvers_work_between_h
#define setae_solvers_work_between_h

#include <setae/solvers/dynamic_system.h>

#include <vector>

namespace Setae
{
  /** A state in which the forces balance, with the forces that do work. */
  struct BalancedState
  {
    Motion motion;

    /** What the supports do; zero for free unknowns [force]. */
    NonlinearSystem::Vector reactions;

    std::vector<ExternalWork> external_work; ///< of this rank

    /** @p motion at @p time, the state that @p system has evaluated last. */
    BalancedState(DynamicSystem &system,
                  const Motion  &motion,
                  const double   time);
  };



  /** What forces do on the way from one state to another one [energy]. */
  struct Work
  {
    double supports = 0.; ///< on the fibers
    double external = 0.; ///< of formulas of time, on the fibers
    double damping  = 0.; ///< taken from the fibers
    double inertia  = 0.; ///< of mass times acceleration

    /** The sum of the magnitudes of all increments, for round-off. */
    double path = 0.;

    Work &
    operator+=(const Work &other);
  };



  /**
   * The work of the mean forces of both ends along the chord
   * @f$d=X_{n+1}-X_n@f$. The balance of forces at both ends makes
   * @f[ \tfrac12(R_n+R_{n+1})\cdot d + W_{damping} + W_{inertia}
   *     - W_{supports} = 0 @f]
   * to the tolerance of Newton's method, whatever the size of the step: unlike
   * with the mean power times that size, nothing is lost or created where
   * velocities change within a step.
   *
   * @param decay The rate of damping times the size of the step, for the first
   * one of a motion: its velocities may be far from those that the forces ask
   * for, and then decay to them within the step. What damping takes on the way
   * is moved to it from inertia; for a small decay this is of fourth order.
   */
  Work
  work_between(DynamicSystem       &system,
               const double         damping,
               const BalancedState &first,
               const BalancedState &second,
               const double         decay = 0.);



  /**
   * The work since time 0 of an integrator that takes steps of its own and asks
   * for forces in many states on the way. Those of a step have the time of its
   * end; when it is asked for a later one, the step has been taken.
   */
  class WorkMeter
  {
  public:
    /** @p initial is the motion at time 0, evaluated last. */
    WorkMeter(DynamicSystem &system,
              const double   damping,
              const Motion  &initial);

    /** The motion evaluated last, a guess of that at @p time. */
    void
    add(const Motion &motion, const double time);

    /** The work up to @p state, after the last step before it. */
    Work
    until(const BalancedState &state) const;

  private:
    DynamicSystem &system;
    const double   damping;
    BalancedState  last, next;
    double         next_time = 0.;
    Work           sum; ///< up to the last step
  };
} // namespace Setae

#endif
