// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_laws_point_potential_h
#define setae_laws_point_potential_h

#include <vector>

namespace Setae
{
  /**
   * One inverse power @f$k_m r^{-m}@f$ of the potential between two points at
   * distance @f$r@f$.
   */
  struct InversePower
  {
    unsigned int exponent;  ///< m
    double       prefactor; ///< k_m [energy length^m]
  };

  /**
   * The potential between two points: a sum of inverse powers. Lennard-Jones is
   * {{6, k6 < 0}, {12, k12 > 0}}.
   */
  using PointPotential = std::vector<InversePower>;

  /** Where the points of a fiber are. */
  enum class Distribution
  {
    volume,
    surface
  };

  /**
   * What a reduced law has to know of the two cross-sections, source first:
   * radii [length] and points per volume [1/length^3] or per surface
   * [1/length^2].
   */
  struct SectionPair
  {
    double radius_1  = 1.;
    double radius_2  = 1.;
    double density_1 = 1.;
    double density_2 = 1.;

    Distribution distribution = Distribution::volume;
  };
} // namespace Setae

#endif
