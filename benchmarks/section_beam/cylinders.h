// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_benchmarks_section_beam_cylinders_h
#define setae_benchmarks_section_beam_cylinders_h

// Exact energies of straight cylinders with one point per volume, and what the
// section-beam laws make of them.

#include <deal.II/base/quadrature_lib.h>

#include <cmath>

namespace Setae
{
  namespace Cylinders
  {
    /** A depth behind the surface of a cylinder, its weight and the chord. */
    struct Depth
    {
      double depth, weight, chord;
    };

    /** The depths of a cylinder, refined towards the side of the gap. */
    inline Depth
    depth_at(const double x, const double radius, const double gap)
    {
      // Logarithmic in gap + depth, with the roots of the chord at both ends
      // removed; from the middle on the depth is measured from the other end.
      const double range = std::log1p(2. * radius / gap);
      const double s = std::sin(.5 * M_PI * x), y = s * s;
      const double y_x   = .5 * M_PI * std::sin(M_PI * x);
      const double depth = gap * std::expm1(range * y);
      const double c     = std::cos(.5 * M_PI * x);
      const double rest  = -(gap + 2. * radius) * std::expm1(-range * c * c);
      return {depth,
              gap * std::exp(range * y) * range * y_x,
              2. * std::sqrt(depth * rest)};
    }

    /** Two crossing infinite cylinders: the integral over both chords. */
    inline double
    crossing_energy(const unsigned int m,
                    const double       R1,
                    const double       R2,
                    const double       gap,
                    const double       angle)
    {
      static const dealii::QGauss<1> rule(120);
      double                         sum = 0.;
      for (unsigned int i = 0; i < rule.size(); ++i)
        {
          const Depth a = depth_at(rule.point(i)[0], R1, gap);
          for (unsigned int j = 0; j < rule.size(); ++j)
            {
              const Depth b = depth_at(rule.point(j)[0], R2, gap);
              sum += rule.weight(i) * rule.weight(j) * a.weight * b.weight *
                     a.chord * b.chord *
                     std::pow(gap + a.depth + b.depth, 2. - m);
            }
        }
      return sum * 2. * M_PI / ((m - 2.) * std::sin(angle));
    }

    /** The force between them, minus the derivative by the gap. */
    inline double
    crossing_force(const unsigned int m,
                   const double       R1,
                   const double       R2,
                   const double       gap,
                   const double       angle)
    {
      static const dealii::QGauss<1> rule(120);
      double                         sum = 0.;
      for (unsigned int i = 0; i < rule.size(); ++i)
        {
          const Depth a = depth_at(rule.point(i)[0], R1, gap);
          for (unsigned int j = 0; j < rule.size(); ++j)
            {
              const Depth b = depth_at(rule.point(j)[0], R2, gap);
              sum += rule.weight(i) * rule.weight(j) * a.weight * b.weight *
                     a.chord * b.chord *
                     std::pow(gap + a.depth + b.depth, 1. - m);
            }
        }
      return sum * 2. * M_PI / std::sin(angle);
    }

    /** Energy and force of two crossing cylinders by a law of a section. */
    struct EnergyAndForce
    {
      double energy, force;
    };

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
