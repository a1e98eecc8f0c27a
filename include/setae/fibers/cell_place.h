// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_fibers_cell_place_h
#define setae_fibers_cell_place_h

#include <setae/kinematics/closest_point.h>

#include <limits>

namespace Setae
{
  /** Where a cell is on its fiber, by initial arc length. */
  struct CellPlace
  {
    static constexpr double infinity = std::numeric_limits<double>::infinity();

    FiberEnds ends;
    double from_left    = infinity; ///< of the left node, from the left end
    double from_right   = infinity; ///< of the right node, from the right end
    double length       = 1.;       ///< of the cell
    double fiber_length = infinity; ///< infinite for one that is closed
  };
} // namespace Setae

#endif
