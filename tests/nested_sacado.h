// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_tests_nested_sacado_h
#define setae_tests_nested_sacado_h

// Energies on nested forward-mode numbers: value, gradient and Hessian in one
// evaluation, independent of every derivative that the library writes by hand.

#include <deal.II/base/numbers.h>
#include <deal.II/base/template_constraints.h>

#include <deal.II/differentiation/ad/sacado_math.h>
#include <deal.II/differentiation/ad/sacado_number_types.h>
#include <deal.II/differentiation/ad/sacado_product_types.h>

#include <Sacado.hpp>

#include <setae/base/local_system.h>

#include <array>

namespace dealii
{
  // deal.II knows the numbers of dynamic size only.

  template <typename T, int n>
  struct EnableIfScalar<Sacado::Fad::SFad<T, n>>
  {
    using type = Sacado::Fad::SFad<T, n>;
  };

  namespace internal
  {
    template <typename T, int n>
    struct ProductTypeImpl<Sacado::Fad::SFad<T, n>, double>
    {
      using type = Sacado::Fad::SFad<T, n>;
    };

    template <typename T, int n>
    struct ProductTypeImpl<double, Sacado::Fad::SFad<T, n>>
    {
      using type = Sacado::Fad::SFad<T, n>;
    };

    template <typename T, int n>
    struct ProductTypeImpl<Sacado::Fad::SFad<T, n>, Sacado::Fad::SFad<T, n>>
    {
      using type = Sacado::Fad::SFad<T, n>;
    };
  } // namespace internal
} // namespace dealii

namespace Setae
{
  /** A number with its first and second derivatives in n variables. */
  template <int n>
  using NestedFad = Sacado::Fad::SFad<Sacado::Fad::SFad<double, n>, n>;

  /** The variable number @p i of n. */
  template <int n>
  NestedFad<n>
  variable(const int i, const double value)
  {
    return {n, i, Sacado::Fad::SFad<double, n>(n, i, value)};
  }

  /** All n variables. */
  template <int n>
  std::array<NestedFad<n>, n>
  variables(const std::array<double, n> &values)
  {
    std::array<NestedFad<n>, n> result;
    for (int i = 0; i < n; ++i)
      result[i] = variable<n>(i, values[i]);
    return result;
  }

  /** Value, gradient and Hessian of @p energy. */
  template <int n>
  LocalSystem<n>
  local_system(const NestedFad<n> &energy)
  {
    LocalSystem<n> result;
    result.energy = energy.val().val();
    for (int i = 0; i < n; ++i)
      {
        result.residual[i] = energy.dx(i).val();
        for (int j = 0; j < n; ++j)
          result.tangent[i][j] = energy.dx(i).dx(j);
      }
    return result;
  }
} // namespace Setae

#endif
