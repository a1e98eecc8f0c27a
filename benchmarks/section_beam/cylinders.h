// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_benchmarks_section_beam_cylinders_h
#define setae_benchmarks_section_beam_cylinders_h

// Exact energies of straight cylinders with one point per volume, and what the
// section-beam laws make of them.

#include <setae/verification/cylinders.h>

#include <cmath>

namespace Setae
{
  namespace Cylinders
  {
    struct EnergyAndForce
    {
      double energy, force;
    };

    /** Two crossing infinite cylinders, exactly. */
    inline EnergyAndForce
    crossing(const unsigned int m,
             const double       R1,
             const double       R2,
             const double       gap,
             const double       angle)
    {
      const auto exact =
        References::crossing_cylinders({m, 1.}, {R1, R2}, gap, angle);
      return {exact.energy.value, exact.force.value};
    }

    /** The same by a law of a section of the source. */
    template <typename LawAt>
    EnergyAndForce
    crossing_by_law(const LawAt &law,
                    const double sum_of_radii,
                    const double gap,
                    const double angle)
    {
      // The midpoint rule in s = l sinh(x) along the source.
      constexpr unsigned int n    = 400;
      const double           sine = std::sin(angle), cosine = std::cos(angle);
      const double           D       = sum_of_radii + gap;
      const double           l       = std::sqrt(gap * D) / sine;
      const double           largest = std::asinh(1e3 * D / (sine * l));
      EnergyAndForce         sum     = {0., 0.};
      for (unsigned int i = 0; i < n; ++i)
        {
          const double x      = largest * (i + .5) / n;
          const double y      = l * std::sinh(x) * sine;
          const double weight = 2. * l * std::cosh(x) * largest / n;
          const double d      = std::sqrt(D * D + y * y);
          const auto   f = law(gap + y * y / (d + D), cosine, y / d * sine);
          // d(gap)/dD = D / d, d(tilt)/dD = -tilt D / d^2
          sum.energy += weight * f.value;
          sum.force -= weight * (f.g - f.t * (y / d * sine) / d) * D / d;
        }
      return sum;
    }
  } // namespace Cylinders
} // namespace Setae

#endif
