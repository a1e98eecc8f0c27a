// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_verification_charged_surfaces_h
#define setae_verification_charged_surfaces_h

#include <setae/verification/cylinders.h>
#include <setae/verification/disks.h>

namespace Setae
{
  /**
   * The same for points that sit on the surface of the fibers: all densities
   * are per area [1/length^2]. What interacts are rings and the lateral
   * surfaces of cylinders, their flat ends are bare.
   */
  namespace References
  {
    /**
     * Two rings at any position and orientation that do not touch, per length
     * squared of two fibers.
     */
    Estimate
    energy_of_rings(const InversePower &power,
                    const SectionPair  &sections,
                    const Disk         &ring_1,
                    const Disk         &ring_2,
                    double              tolerance = default_tolerance);

    /** Two parallel cylindrical surfaces of finite length. */
    Estimate
    energy_of_parallel_surfaces(const InversePower &power,
                                const SectionPair  &sections,
                                double              gap,
                                const Overlap      &overlap,
                                double tolerance = default_tolerance);

    /**
     * Two cylindrical surfaces of finite length that cross at their midpoints.
     *
     * @param angle Angle between the axes.
     */
    Estimate
    energy_of_crossing_surfaces(const InversePower &power,
                                const SectionPair  &sections,
                                double              gap,
                                double              angle,
                                double              length_1,
                                double              length_2,
                                double tolerance = default_tolerance);

    /**
     * What SSIP eq. 35 makes of two straight fibers that cross at their
     * midpoints, @f$2\pi R_1\sigma_1\, 2\pi R_2\sigma_2\,\Phi(|r_1-r_2|)@f$
     * integrated along both: the charges gathered on the centerlines.
     */
    Estimate
    energy_of_crossing_monopoles(const InversePower &power,
                                 const SectionPair  &sections,
                                 double              gap,
                                 double              angle,
                                 double              length_1,
                                 double              length_2,
                                 double tolerance = default_tolerance);
  } // namespace References
} // namespace Setae

#endif
