// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_kinematics_hermite_h
#define setae_kinematics_hermite_h

#include <deal.II/base/tensor.h>

#include <array>

namespace Setae
{
  using dealii::Tensor;

  /**
   * The four cubic Hermite shape functions of one cell on the reference
   * coordinate @f$x\in[0,1]@f$: position and tangent at the left node,
   * position and tangent at the right node. @p h is the length scale of the
   * tangent degrees of freedom [length]; derivatives are taken with respect to
   * the dimensionless @p x.
   */
  namespace Hermite
  {
    inline constexpr unsigned int n_shapes = 4;

    template <typename Number>
    std::array<Number, n_shapes>
    shape_values(const Number &x, const double h)
    {
      const Number y = 1. - x;
      return {{y * y * (1. + 2. * x),
               h * x * y * y,
               x * x * (3. - 2. * x),
               -h * x * x * y}};
    }

    template <typename Number>
    std::array<Number, n_shapes>
    shape_derivatives(const Number &x, const double h)
    {
      const Number y = 1. - x;
      return {{-6. * x * y,
               h * y * (1. - 3. * x),
               6. * x * y,
               h * x * (3. * x - 2.)}};
    }

    template <typename Number>
    std::array<Number, n_shapes>
    shape_second_derivatives(const Number &x, const double h)
    {
      return {
        {12. * x - 6., h * (6. * x - 4.), 6. - 12. * x, h * (6. * x - 2.)}};
    }

    inline std::array<double, n_shapes>
    shape_third_derivatives(const double h)
    {
      return {{12., 6. * h, -12., 6. * h}};
    }
  } // namespace Hermite



  /**
   * One cubic cell of a curve in space. The coefficients are, in the order of
   * the shape functions, position [length] and tangent [1] at the left and at
   * the right node; all derivatives are with respect to the reference
   * coordinate @p x of the cell and so carry the unit of a length.
   */
  template <typename Number = double>
  struct HermiteCell
  {
    std::array<Tensor<1, 3, Number>, Hermite::n_shapes> coefficients;
    double                                              h = 1.;

    template <typename X>
    Tensor<1, 3, Number>
    position(const X &x) const
    {
      return combine(Hermite::shape_values(x, h));
    }

    template <typename X>
    Tensor<1, 3, Number>
    derivative(const X &x) const
    {
      return combine(Hermite::shape_derivatives(x, h));
    }

    template <typename X>
    Tensor<1, 3, Number>
    second_derivative(const X &x) const
    {
      return combine(Hermite::shape_second_derivatives(x, h));
    }

    Tensor<1, 3, Number>
    third_derivative() const
    {
      return combine(Hermite::shape_third_derivatives(h));
    }

    /**
     * The Bernstein-Bezier points of the cell [length]; the cell lies in their
     * convex hull.
     */
    std::array<Tensor<1, 3, Number>, 4>
    control_points() const
    {
      const auto &[d1, t1, d2, t2] = coefficients;
      return {{d1, d1 + (h / 3.) * t1, d2 - (h / 3.) * t2, d2}};
    }

    /**
     * The curve for given values of the four shape functions (or of their
     * derivatives), for loops that have them tabulated.
     */
    template <typename Shape>
    Tensor<1, 3, Number>
    combine(const std::array<Shape, Hermite::n_shapes> &shape) const
    {
      Tensor<1, 3, Number> result;
      for (unsigned int a = 0; a < Hermite::n_shapes; ++a)
        for (unsigned int c = 0; c < 3; ++c)
          result[c] += shape[a] * coefficients[a][c];
      return result;
    }
  };
} // namespace Setae

#endif
