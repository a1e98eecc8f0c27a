// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_search_closest_approach_h
#define setae_search_closest_approach_h

#include <setae/search/cubic_part.h>

#include <limits>

namespace Setae
{
  /** Whether something concerns the first and the last point of a cell. */
  struct CellEnds
  {
    bool first = false;
    bool last  = false;
  };

  /** Where two cells are closest to each other. */
  struct ClosestApproach
  {
    double distance = std::numeric_limits<double>::infinity(); ///< [length]
    double x = 0., y = 0.; ///< reference coordinates on both cells
  };

  /**
   * The smallest distance of two cells, given by their Bernstein-Bezier control
   * points [length], and where it is.
   *
   * Branch and bound: a pair of parts is left out if the convex hulls of its
   * control points are not nearer than what has been found, and the longer of
   * the two is halved until both are almost straight. Then the squared distance
   * is minimized over both coordinates, which are bounded by the ends of the
   * parts, by Newton's method: the distance is exact up to the round-off of the
   * coordinates relative to each other. It starts from every local minimum of
   * nine points along the first part; that this finds all of the few minima
   * which two almost straight parts can have is what the tests against brute
   * force show.
   *
   * @param bound Nothing is looked for at this distance and beyond [length].
   * @param left_out_1, left_out_2 Ends of the cells at which a minimum does not
   * count; minima inside of both curves still do.
   *
   * @return Infinity as the distance if there is nothing nearer than @p bound.
   */
  ClosestApproach
  closest_approach(const CubicPart::ControlPoints &first,
                   const CubicPart::ControlPoints &second,
                   const double bound = std::numeric_limits<double>::infinity(),
                   const CellEnds &left_out_1 = {},
                   const CellEnds &left_out_2 = {});
} // namespace Setae

#endif
