// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_kinematics_closest_point_h
#define setae_kinematics_closest_point_h

#include <boost/container/static_vector.hpp>

#include <setae/kinematics/hermite.h>

namespace Setae
{
  /**
   * A point of a curve that is closest to a given one among its neighbours.
   */
  struct Projection
  {
    double x;     ///< reference coordinate on the cell
    bool   moves; ///< whether it moves along the curve with the given point
  };

  /**
   * The projections of one point on one cell. Of the five roots that a quintic
   * can have at most three are minima, or two and both ends of the fiber.
   */
  using Projections = boost::container::static_vector<Projection, 4>;

  /** Which nodes of a cell are ends of its fiber. */
  struct FiberEnds
  {
    bool left  = false;
    bool right = false;
  };

  /**
   * All local minima of the distance between @p point and the curve on the
   * half-open cell @f$x\in(0,1]@f$ of a C1 fiber.
   *
   * The derivative of half the squared distance,
   * @f$p(x)=(r(x)-\mathrm{point})\cdot r_{,x}(x)@f$, is a quintic. Its
   * Bernstein coefficients bound the number of its roots (Descartes), so that
   * bisection isolates every root and Newton's method polishes it: no minimum
   * is missed and none is found twice, whatever the starting point.
   *
   * The sign of p at a node is computed from the data of that node alone, hence
   * is bitwise the same in both cells that share it, and zero counts as
   * positive. So a minimum at a node belongs to exactly one of the two cells,
   * and the closest point of a fiber can pass from cell to cell without being
   * lost or counted twice. A fiber end is a minimum where the distance grows
   * towards the inside; it does not move.
   */
  Projections
  closest_points(const HermiteCell<> &cell,
                 const Tensor<1, 3>  &point,
                 const FiberEnds     &ends);
} // namespace Setae

#endif
