// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_base_lanes_h
#define setae_base_lanes_h

#include <cmath>

namespace Setae
{
  inline constexpr unsigned int n_lanes = 8;

  /**
   * Eight numbers that are treated alike. The compiler spreads them over the
   * registers that the processor has: in a function with
   * SETAE_FOR_EVERY_PROCESSOR, of the processor that the program finds itself
   * on, whatever it was compiled for. (deal.II's VectorizedArray has the width
   * that deal.II was compiled with, which is one in the packages of
   * distributions.)
   */
  using Lanes = double __attribute__((vector_size(n_lanes * sizeof(double))));

  inline double
  sum(const Lanes &x)
  {
    double result = 0.;
    for (unsigned int i = 0; i < n_lanes; ++i)
      result += x[i];
    return result;
  }

  template <typename Number>
  Number
  square_root(const Number &x)
  {
    using std::sqrt;
    return sqrt(x);
  }

  inline Lanes
  square_root(const Lanes &x)
  {
    Lanes result;
    for (unsigned int i = 0; i < n_lanes; ++i)
      result[i] = __builtin_sqrt(x[i]);
    return result;
  }
} // namespace Setae

/**
 * Put before a function whose loops run over Lanes: it is compiled once for
 * each width of registers, and the loader chooses.
 */
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#  define SETAE_FOR_EVERY_PROCESSOR \
    __attribute__((target_clones("arch=x86-64-v4", "arch=haswell", "default")))
#else
#  define SETAE_FOR_EVERY_PROCESSOR
#endif

#endif
