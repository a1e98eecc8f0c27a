// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_laws_nearest_part_h
#define setae_laws_nearest_part_h

#include <cmath>

namespace Setae
{
  /** The part of a section that is nearest to a cylinder. */
  template <typename Number>
  struct NearestPart
  {
    Number distance; ///< from there to the cylinder, positive
    Number offset;   ///< along the axis from the center of the section

    /**
     * How far it extends along the axis, by the curvature of its edge (square
     * over depth) and by its face (square).
     */
    Number edge, face;
  };

  /**
   * @param distance From the section to the surface of the cylinder.
   * @param cosine Of the normal of the section and the axis.
   * @param tilt Of the normal and the direction away from the axis.
   */
  template <typename Number>
  NearestPart<Number>
  nearest_part(const double  radius,
               const Number &distance,
               const Number &cosine,
               const Number &tilt)
  {
    using std::sqrt;
    constexpr double smallest = 1e-6;
    const double     R        = radius * radius;
    const Number     T = tilt * tilt, C = cosine * cosine;
    const Number     g =
      .5 * (distance + sqrt(distance * distance + R * smallest * smallest));
    const Number Q    = sqrt(R * (1. - T) + g * g);
    const Number face = radius * g / Q;
    return {g,
            R / Q * cosine * tilt,
            R / Q * (1. - C - T),
            face * face * (1. - C)};
  }

  /** The distance of a disk that is not inclined, from its DiskContact::H. */
  template <typename Number>
  Number
  distance_of_softened(const double radius, const Number &H)
  {
    using std::sqrt;
    return H + H * H / (sqrt(radius * radius + H * H) + radius);
  }
} // namespace Setae

#endif
