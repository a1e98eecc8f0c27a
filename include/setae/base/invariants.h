// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_base_invariants_h
#define setae_base_invariants_h

namespace Setae
{
  /**
   * What a law depends on, and so which kernel evaluates it. Every law states
   * it as `depends_on`.
   */
  enum class Invariants
  {
    gap,           ///< of two sections: a double integral
    gap_offset,    ///< of two sections and a frame: a double integral
    gap_angle,     ///< of a section and the closest point of the target
    gap_angle_tilt ///< the same, and how far the section leans over
  };
} // namespace Setae

#endif
