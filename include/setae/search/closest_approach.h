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
   * the two is halved until both are almost straight. Then the first part is
   * sampled, and an interval between two samples that may hold something nearer
   * is halved until the derivative of the squared distance from the second
   * part, taken as a cubic polynomial, changes its sign at most once, and until
   * nearest points at an end of the second part and others are apart. From
   * there the squared distance is minimized over both coordinates, which are
   * bounded by the ends of the parts, by Newton's method: a minimum is exact up
   * to the round-off of the coordinates relative to each other, and to 4e-13 of
   * the size of the cells where it is as flat as that of concentric arcs.
   *
   * That the smallest minimum is found is measured, not proved: as brute force
   * does, to 1e-15 of the size, for 100,000 random pairs of slender cells at
   * any angle and 100,000 with gaps and angles like their waves, and to 3e-15
   * for 60,000 pairs with loops.
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
