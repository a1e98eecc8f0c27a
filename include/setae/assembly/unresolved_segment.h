// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_assembly_unresolved_segment_h
#define setae_assembly_unresolved_segment_h

#include <setae/fibers/fiber_system.h>
#include <setae/interactions/line_sites.h>

#include <string>

namespace Setae
{
  /**
   * Compare an equal segment at the smallest gap with the longest one that
   * GradedSegments would allow for an error of ten percent.
   *
   * @param gaps Where fibers are nearest.
   * @param is_projected, is_long_range, is_contact See InteractionPoints.
   * @return A sentence if it is longer, or nothing.
   */
  std::string
  unresolved_segment(const FiberSystem           &fibers,
                     const InteractionParameters &parameters,
                     const State                 &state,
                     const GapReport             &gaps,
                     const bool                   is_projected,
                     const bool                   is_long_range,
                     const bool                   is_contact);
} // namespace Setae

#endif
