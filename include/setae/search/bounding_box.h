// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_search_bounding_box_h
#define setae_search_bounding_box_h

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/tensor.h>

#include <algorithm>
#include <array>

namespace Setae
{
  using dealii::BoundingBox;
  using dealii::Tensor;

  /**
   * The smallest axis-aligned box [length] around the four Bernstein-Bezier
   * control points of a cell. A cubic lies in the convex hull of its control
   * points, and so in this box.
   */
  inline BoundingBox<3>
  bounding_box(const std::array<Tensor<1, 3>, 4> &control_points)
  {
    dealii::Point<3> lower(control_points[0]);
    dealii::Point<3> upper(control_points[0]);
    for (unsigned int k = 1; k < 4; ++k)
      for (unsigned int c = 0; c < 3; ++c)
        {
          lower[c] = std::min(lower[c], control_points[k][c]);
          upper[c] = std::max(upper[c], control_points[k][c]);
        }
    return BoundingBox<3>({lower, upper});
  }



  /**
   * Square of the Euclidean distance [length^2] of a point from a box; zero
   * inside. A point whose distance from the box of a cell is larger than the
   * reach has no partner on that cell: a few operations that spare loops over
   * points the evaluation of the curve.
   */
  inline double
  distance_square(const BoundingBox<3> &box, const Tensor<1, 3> &point)
  {
    const auto &[lower, upper] = box.get_boundary_points();
    double sum                 = 0.;
    for (unsigned int c = 0; c < 3; ++c)
      {
        const double gap =
          std::max(0., std::max(lower[c] - point[c], point[c] - upper[c]));
        sum += gap * gap;
      }
    return sum;
  }



  /**
   * Square of the Euclidean distance [length^2] of two boxes; zero if they
   * intersect. It is a lower bound for the curves inside of them.
   */
  inline double
  distance_square(const BoundingBox<3> &first, const BoundingBox<3> &second)
  {
    const auto &[lower_1, upper_1] = first.get_boundary_points();
    const auto &[lower_2, upper_2] = second.get_boundary_points();
    double sum                     = 0.;
    for (unsigned int c = 0; c < 3; ++c)
      {
        const double gap =
          std::max(0.,
                   std::max(lower_1[c] - upper_2[c], lower_2[c] - upper_1[c]));
        sum += gap * gap;
      }
    return sum;
  }
} // namespace Setae

#endif
