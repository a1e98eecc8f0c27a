// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_laws_parallel_fibers_h
#define setae_laws_parallel_fibers_h

#include <boost/math/quadrature/exp_sinh.hpp>

#include <setae/base/invariants.h>
#include <setae/base/law_derivatives.h>

#include <cmath>

namespace Setae
{
  /** Energy and force of two infinite parallel fibers, by a law. */
  struct ParallelFibers
  {
    double energy; ///< per length [energy/length]
    double force;  ///< per length, positive repels [force/length]
  };



  /**
   * What @p law makes of two infinite parallel straight fibers at @p gap: its
   * value for a law of a section and a beam, its integral along one of the
   * fibers for a law of two sections, to a relative error below 1e-11. The law
   * must decay as the distance to the power -3/2 at least.
   */
  template <typename Law>
  ParallelFibers
  parallel_fibers(const Law &law, const double sum_of_radii, const double gap)
  {
    if constexpr (Law::depends_on == Invariants::gap_angle)
      {
        const GapAngleDerivatives p = law(gap, 1.);
        return {p.value, -p.g};
      }
    else if constexpr (Law::depends_on == Invariants::gap_angle_tilt)
      {
        const GapAngleTiltDerivatives p = law(gap, 1., 0.);
        return {p.value, -p.g};
      }
    else
      {
        constexpr double tolerance = 1e-12, far = 1e12;
        const double     d          = gap + sum_of_radii;
        const bool       has_offset = Law::depends_on == Invariants::gap_offset;
        const double     width = has_offset ? gap : std::sqrt(2. * gap * d);

        // Energy and its derivative per length, at an offset along the fibers.
        const auto at = [&](const double offset) {
          if constexpr (has_offset)
            {
              const OffsetGapDerivatives p = law(offset, gap);
              return GapDerivatives{p.value, p.g, 0.};
            }
          else
            {
              // The gap grows as offset^2 / (2 d), without a cancellation.
              const double         distance = std::hypot(d, offset);
              const double         lateral  = offset / (distance + d) * offset;
              const GapDerivatives p        = law(gap + lateral);
              return GapDerivatives{p.value, p.first * d / distance, 0.};
            }
        };
        boost::math::quadrature::exp_sinh<double> half_line;
        const auto integral = [&](const auto &function) {
          return 2. * width *
                 half_line.integrate(
                   [&](const double x) {
                     return x < far ? function(at(width * x)) : 0.;
                   },
                   tolerance);
        };
        return {integral([](const GapDerivatives &p) { return p.value; }),
                -integral([](const GapDerivatives &p) { return p.first; })};
      }
  }
} // namespace Setae

#endif
