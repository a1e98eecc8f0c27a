// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_base_differentiate_h
#define setae_base_differentiate_h

#include <deal.II/base/point.h>
#include <deal.II/base/polynomial.h>

#include <algorithm>
#include <array>
#include <vector>

namespace Setae
{
  /**
   * Value, first and second derivative of @p f at @p x, from the polynomial
   * through five values @p spacing apart. They surround @p x, or begin at
   * @p lower if @p x is too close to it: @p f is not asked for less. Errors of
   * order four and, next to @p lower, of order three in the second derivative.
   */
  template <typename Function>
  std::array<double, 3>
  differentiate(const Function &f,
                const double    x,
                const double    spacing,
                const double    lower)
  {
    constexpr unsigned int n = 5;
    static const auto      basis =
      dealii::Polynomials::generate_complete_Lagrange_basis(
        {dealii::Point<1>(-2.),
         dealii::Point<1>(-1.),
         dealii::Point<1>(0.),
         dealii::Point<1>(1.),
         dealii::Point<1>(2.)});

    const double          middle = std::max(x, lower + 2. * spacing);
    std::array<double, 3> result = {{f(x), 0., 0.}};
    std::vector<double>   derivatives(3);
    for (unsigned int i = 0; i < n; ++i)
      {
        const double value = f(middle + (i - 2.) * spacing) - result[0];
        basis[i].value((x - middle) / spacing, derivatives);
        result[1] += value * derivatives[1] / spacing;
        result[2] += value * derivatives[2] / (spacing * spacing);
      }
    return result;
  }
} // namespace Setae

#endif
