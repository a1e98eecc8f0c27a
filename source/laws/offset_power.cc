// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <setae/laws/offset_power.h>

#include <array>
#include <limits>

namespace Setae
{
  namespace
  {
    // More digits than the result has to have: the second derivative of a
    // polynomial amplifies the errors of its coefficients.
    using Real = boost::multiprecision::cpp_bin_float_quad;

    /** Gauss' series, which converges at least as fast as @f$2^{-j}@f$ here. */
    Real
    gauss_series(const Real &a, const Real &b, const Real &c, const Real &w)
    {
      Real term = 1, sum = 0;
      for (unsigned int j = 0;
           abs(term) > std::numeric_limits<Real>::epsilon() * abs(sum);
           ++j)
        {
          sum += term;
          term *= (a + j) * (b + j) / ((c + j) * (1 + j)) * w;
        }
      return sum;
    }

    /**
     * The coefficients @f$a_i@f$ of the Chebyshev interpolant
     * @f$\sum_i a_i T_i(x)@f$ of a function on [-1,1].
     */
    template <std::size_t n, typename Function>
    std::array<Real, n>
    chebyshev_interpolant(const Function &function)
    {
      const Real          pi = acos(Real(-1));
      std::array<Real, n> result{};
      for (unsigned int j = 0; j < n; ++j)
        {
          const Real x     = cos(Real(pi * (2 * j + 1) / (2 * n)));
          const Real value = function(x);
          Real       T = 1, T_next = x;
          for (unsigned int i = 0; i < n; ++i)
            {
              result[i] += (i == 0 ? 1 : 2) * value * T / n;
              const Real T_after_next = 2 * x * T_next - T;
              T                       = T_next;
              T_next                  = T_after_next;
            }
        }
      return result;
    }
  } // namespace



  std::vector<double>
  OffsetPower::polynomial() const
  {
    // The coefficients fall as (3 + sqrt(8))^-i, since F is singular at w = 1
    // only. Those are left out that are of the size of rounding errors even in
    // the second derivative, where they count i^4 / 3 times.
    constexpr unsigned int n = 30;
    const Real             a = (Real(m) - 5) / 2 + k, b = (7 - Real(m)) / 2 - k;
    const auto   chebyshev = chebyshev_interpolant<n>([&](const Real &x) {
      return gauss_series(a, b, Real(m) / 2, (x + 1) / 4);
    });
    unsigned int size      = n;
    while (size > 1 && abs(chebyshev[size - 1]) * pow(Real(size), 4) <
                         4 * std::numeric_limits<double>::epsilon())
      --size;

    // In powers of x instead of Chebyshev polynomials T_i(x), whose
    // coefficients grow as (1 + sqrt(2))^i: much less than those of the series
    // fall.
    std::array<Real, n> power{}, T{}, T_next{};
    T[0]      = 1;
    T_next[1] = 1;
    for (unsigned int i = 0; i < size; ++i)
      {
        std::array<Real, n> T_after_next{};
        for (unsigned int j = 0; j < n; ++j)
          {
            power[j] += chebyshev[i] * T[j];
            T_after_next[j] = -T[j];
            if (j > 0)
              T_after_next[j] += 2 * T_next[j - 1];
          }
        T      = T_next;
        T_next = T_after_next;
      }
    std::vector<double> result;
    for (unsigned int i = 0; i < size; ++i)
      result.push_back(static_cast<double>(power[i]));
    return result;
  }
} // namespace Setae
