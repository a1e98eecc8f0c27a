// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_search_cubic_part_h
#define setae_search_cubic_part_h

#include <deal.II/base/tensor.h>

#include <array>

namespace Setae
{
  using dealii::Tensor;

  /**
   * A part of a cell: where it begins and ends in the reference coordinate of
   * the cell, and its own Bernstein-Bezier control points [length].
   */
  struct CubicPart
  {
    using ControlPoints = std::array<Tensor<1, 3>, 4>;

    double        begin = 0., end = 1.;
    ControlPoints points;

    /** Both halves (de Casteljau). */
    std::array<CubicPart, 2>
    halves() const
    {
      const auto        &P      = points;
      const double       middle = .5 * (begin + end);
      const Tensor<1, 3> P01 = .5 * (P[0] + P[1]), P12 = .5 * (P[1] + P[2]),
                         P23 = .5 * (P[2] + P[3]), P012 = .5 * (P01 + P12),
                         P123 = .5 * (P12 + P23), Q = .5 * (P012 + P123);
      return {{{begin, middle, {{P[0], P01, P012, Q}}},
               {middle, end, {{Q, P123, P23, P[3]}}}}};
    }

    /** The coordinate on the cell of the coordinate @p x on this part. */
    double
    on_cell(const double x) const
    {
      return x <= 0. ? begin : x >= 1. ? end : begin + x * (end - begin);
    }

    /** The length of the control polygon, an upper bound for that of the part.
     */
    double
    length() const
    {
      return (points[1] - points[0]).norm() + (points[2] - points[1]).norm() +
             (points[3] - points[2]).norm();
    }

    /** The position [length] at the coordinate @p x on this part. */
    Tensor<1, 3>
    position(const double x) const
    {
      const double y = 1. - x;
      return (y * y * y) * points[0] + (3. * x * y * y) * points[1] +
             (3. * x * x * y) * points[2] + (x * x * x) * points[3];
    }

    /** Its derivative with respect to that coordinate. */
    Tensor<1, 3>
    derivative(const double x) const
    {
      const double y = 1. - x;
      return (3. * y * y) * (points[1] - points[0]) +
             (6. * x * y) * (points[2] - points[1]) +
             (3. * x * x) * (points[3] - points[2]);
    }

    /** The second derivative. */
    Tensor<1, 3>
    second_derivative(const double x) const
    {
      return (6. * (1. - x)) * (points[2] - 2. * points[1] + points[0]) +
             (6. * x) * (points[3] - 2. * points[2] + points[1]);
    }
  };
} // namespace Setae

#endif
