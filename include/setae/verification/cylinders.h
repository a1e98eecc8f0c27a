// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_verification_cylinders_h
#define setae_verification_cylinders_h

#include <setae/verification/point_potentials.h>

namespace Setae
{
  namespace References
  {
    /**
     * Two infinite parallel cylinders, energy and force per length. Exponents
     * m >= 2.
     *
     * @param gap Distance of the surfaces [length], positive; so below.
     */
    EnergyAndForce
    parallel_cylinders(const InversePower &power,
                       const SectionPair  &sections,
                       double              gap,
                       double              tolerance = default_tolerance);

    /**
     * Two infinite cylinders whose axes cross at the angle alpha: both
     * integrals along the axes are analytic and leave
     * @f[ \Pi = \frac{\rho_1\rho_2 k_m}{\sin\alpha}\frac{2\pi}{m-2}
     *     \iint \ell_1(z_1)\ell_2(z_2)\,(d-z_1-z_2)^{2-m}\,dz_1\,dz_2,\qquad
     *     \ell_i = 2\sqrt{R_i^2-z_i^2}, @f]
     * of which the one over the target is elementary. Exponents m >= 3.
     *
     * @param angle Angle between the axes, in (0, pi).
     */
    EnergyAndForce
    crossing_cylinders(const InversePower &power,
                       const SectionPair  &sections,
                       double              gap,
                       double              angle,
                       double              tolerance = default_tolerance);

    /**
     * The same with a source that ends at the distance @p overhang beyond the
     * point of crossing (negative: before it), cut off normal to its axis.
     */
    EnergyAndForce
    crossing_half_cylinder(const InversePower &power,
                           const SectionPair  &sections,
                           double              gap,
                           double              angle,
                           double              overhang,
                           double              tolerance = default_tolerance);

    /**
     * A half-infinite source that points at an infinite target: its axis meets
     * the other one at a right angle, @p gap is the distance of its flat end
     * from the surface. Exponents m >= 4.
     */
    EnergyAndForce
    pointing_half_cylinder(const InversePower &power,
                           const SectionPair  &sections,
                           double              gap,
                           double              tolerance = default_tolerance);

    /** Energy, force along the gap and along the axes. */
    struct SlidingCylinders
    {
      Estimate energy;
      Estimate force;  ///< -dE/dgap
      Estimate thrust; ///< -dE/dshift
    };

    /**
     * Two parallel cylinders of finite length at any shift. Any exponent m
     * >= 1.
     */
    SlidingCylinders
    finite_parallel_cylinders(const InversePower &power,
                              const SectionPair  &sections,
                              double              gap,
                              const Overlap      &overlap,
                              double tolerance = default_tolerance);
  } // namespace References
} // namespace Setae

#endif
