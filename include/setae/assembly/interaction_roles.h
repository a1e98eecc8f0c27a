// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_assembly_interaction_roles_h
#define setae_assembly_interaction_roles_h

#include <setae/fibers/fiber_system.h>

#include <vector>

namespace Setae
{
  /** Which cells may interact, and how often each pair of them meets. */
  class InteractionRoles
  {
  public:
    InteractionRoles(const FiberSystem           &fibers,
                     const InteractionParameters &parameters)
      : fibers(fibers)
      , parameters(parameters)
      , is_source(fibers.fibers.size(), false)
      , is_target(fibers.fibers.size(), false)
    {
      for (const unsigned int f : fibers.select(parameters.source))
        is_source[f] = true;
      for (const unsigned int f : fibers.select(parameters.target))
        is_target[f] = true;
    }

    bool
    may_be_source(const unsigned int fiber) const
    {
      return is_source[fiber] ||
             (parameters.two_half_passes && is_target[fiber]);
    }

    bool
    may_be_target(const unsigned int fiber) const
    {
      return is_target[fiber] ||
             (parameters.two_half_passes && is_source[fiber]);
    }

    bool
    interact(const unsigned int source, const unsigned int target) const
    {
      const unsigned int s = fibers.fiber_of_cell[source],
                         t = fibers.fiber_of_cell[target];
      if (s == t)
        return parameters.self_interaction && is_source[s] && is_target[s] &&
               fibers.distance_along_fiber(source, target) >
                 parameters.n_excluded_neighbors;
      const bool forward  = is_source[s] && is_target[t];
      const bool backward = is_source[t] && is_target[s];
      if (parameters.two_half_passes)
        return forward || backward;
      return forward && (!backward || s < t);
    }

    /** One half where each pair of cells meets twice. */
    double
    factor(const unsigned int source, const unsigned int target) const
    {
      const bool twice =
        parameters.two_half_passes ||
        fibers.fiber_of_cell[source] == fibers.fiber_of_cell[target];
      return twice ? .5 : 1.;
    }

  private:
    const FiberSystem           &fibers;
    const InteractionParameters &parameters;
    std::vector<bool>            is_source, is_target;
  };
} // namespace Setae

#endif
