// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_benchmarks_laws_interaction_h
#define setae_benchmarks_laws_interaction_h

#include <algorithm>
#include <cmath>
#include <ctime>
#include <limits>
#include <utility>

namespace Setae
{
  /**
   * Error and cost of the reduced laws: what the benchmarks of this folder have
   * in common. Radii and densities are one, prefactors one in magnitude:
   * lengths are in units of the radius R, energies in units of
   * rho_1 rho_2 |k_m| and powers of R.
   */
  namespace LawReport
  {
    /** An energy and the force -dE/dgap that goes with it. */
    struct Interaction
    {
      double energy = 0.;
      double force  = 0.;

      Interaction &
      operator+=(const Interaction &other)
      {
        energy += other.energy;
        force += other.force;
        return *this;
      }

      friend Interaction
      operator*(const double factor, const Interaction &other)
      {
        return {factor * other.energy, factor * other.force};
      }
    };



    /** CPU time [s] */
    inline double
    seconds_since(const std::clock_t begin)
    {
      return double(std::clock() - begin) / CLOCKS_PER_SEC;
    }

    /**
     * The result of @p evaluate, and the CPU time of one evaluation [s]: of at
     * least 50 ms of them, or not a number.
     */
    template <typename Function>
    auto
    timed(const Function &evaluate, const bool with_time = true)
      -> std::pair<decltype(evaluate()), double>
    {
      constexpr double smallest_time = .05;

      const std::clock_t begin  = std::clock();
      auto               result = evaluate();
      double             time = seconds_since(begin), n = 1.;
      if (!with_time)
        return {result, std::numeric_limits<double>::quiet_NaN()};
      while (time < smallest_time)
        {
          n = std::ceil(
            n * std::clamp(1.2 * smallest_time / (time + 1e-9), 2., 1000.));
          const std::clock_t begin = std::clock();
          for (double i = 0.; i < n; ++i)
            {
              result = evaluate();
              // The compiler must not see that all results are the same.
              asm volatile("" : : "r"(&result) : "memory");
            }
          time = seconds_since(begin);
        }
      return {result, time / n};
    }
  } // namespace LawReport
} // namespace Setae

#endif
