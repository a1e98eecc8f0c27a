// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <setae/solvers/work_between.h>

#include <utility>

namespace Setae
{
  BalancedState::BalancedState(DynamicSystem &system,
                               const Motion  &motion,
                               const double   time)
    : motion(motion)
    , reactions(system.residual())
    , external_work(system.external_work(motion, time))
  {
    NonlinearSystem::Vector free(reactions);
    system.project_force(free);
    reactions -= free;
  }



  Work &
  Work::operator+=(const Work &other)
  {
    supports += other.supports;
    external += other.external;
    damping += other.damping;
    inertia += other.inertia;
    path += other.path;
    return *this;
  }



  Work
  work_between(DynamicSystem       &system,
               const double         damping,
               const BalancedState &first,
               const BalancedState &second,
               const double         decay)
  {
    using Vector    = NonlinearSystem::Vector;
    const Motion &a = first.motion, &b = second.motion;
    Vector        chord(b.displacement);
    chord -= a.displacement;
    const Vector momentum = system.times_mass(chord);
    const auto   mean = [](const Vector &x, const Vector &y, const Vector &z) {
      return .5 * (x * z + y * z);
    };
    Work result;
    result.supports = mean(first.reactions, second.reactions, chord);
    result.external = system.sum(
      Setae::work_between(first.external_work, second.external_work));
    result.damping = damping * mean(a.velocity, b.velocity, momentum);
    result.inertia = mean(a.acceleration, b.acceleration, momentum);

    Vector lengths(system.unit_displacements());
    lengths.scale(chord);
    result.path = lengths.l1_norm();

    // Right for a mass that a constant force accelerates from rest, whether it
    // comes to its last velocity slowly or at once.
    Vector change(b.velocity);
    change -= a.velocity;
    const double moved = .5 * damping * decay * decay / (12. + decay * decay) *
                         (change * momentum);
    result.damping += moved;
    result.inertia -= moved;
    return result;
  }



  WorkMeter::WorkMeter(DynamicSystem &system,
                       const double   damping,
                       const Motion  &initial)
    : system(system)
    , damping(damping)
    , last(system, initial, 0.)
    , next(last)
  {}



  void
  WorkMeter::add(const Motion &motion, const double time)
  {
    if (time > next_time)
      {
        sum  = until(next);
        last = std::move(next);
      }
    next      = BalancedState(system, motion, time);
    next_time = time;
  }



  Work
  WorkMeter::until(const BalancedState &state) const
  {
    Work result = sum;
    result += work_between(system, damping, last, state);
    return result;
  }
} // namespace Setae
