// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_interactions_target_shapes_h
#define setae_interactions_target_shapes_h

#include <setae/kinematics/hermite.h>

#include <algorithm>
#include <cmath>

namespace Setae
{
  /**
   * Shape functions at the closest point, with derivatives. Beyond the cell
   * they continue linearly, the curve as its tangent.
   */
  struct TargetShapes
  {
    TargetShapes(const double x, const double h)
      : beyond(std::abs(x - inside(x)))
      , M(Hermite::shape_values(inside(x), h))
      , M_x(Hermite::shape_derivatives(inside(x), h))
    {
      if (beyond > 0.)
        for (unsigned int a = 0; a < 4; ++a)
          M[a] += (x - inside(x)) * M_x[a];
      else
        M_xx = Hermite::shape_second_derivatives(x, h);
    }

    const double          beyond; ///< the end, as reference coordinate
    std::array<double, 4> M, M_x, M_xx = {};

  private:
    static double
    inside(const double x)
    {
      return std::min(std::max(x, 0.), 1.);
    }
  };
} // namespace Setae

#endif
