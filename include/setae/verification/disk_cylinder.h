// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_verification_disk_cylinder_h
#define setae_verification_disk_cylinder_h

#include <setae/verification/disks.h>

namespace Setae
{
  namespace References
  {
    /**
     * How a disk lies beside an infinite cylinder, up to all symmetries. t1, t2
     * are the normal of the disk and the axis of the cylinder, n the unit
     * vector from the axis to the center of the disk and normal to the axis.
     */
    struct DiskPose
    {
      double gap;         ///< distance of the center from the axis - R1 - R2
      double cosine = 1.; ///< t1.t2
      double tilt   = 0.; ///< t1.n; at most sin(alpha) in magnitude
    };

    /**
     * A disk (source) and an infinite cylinder, per length of the source, and
     * the force on the disk along n. Exponents m >= 2. The gap may be negative
     * if the disk is tilted so much that it does not touch.
     */
    EnergyAndForce
    disk_and_cylinder(const InversePower &power,
                      const SectionPair  &sections,
                      const DiskPose     &pose,
                      double              tolerance = default_tolerance);

    /** The energy alone. */
    Estimate
    energy_of_disk_and_cylinder(const InversePower &power,
                                const SectionPair  &sections,
                                const DiskPose     &pose,
                                double tolerance = default_tolerance);

    /**
     * The smallest distance between the disk and the surface of the cylinder
     * [length]; not the gap if the disk is tilted.
     */
    double
    distance(const SectionPair &sections, const DiskPose &pose);

    /**
     * A disk (source) at any position and a cylinder that occupies an interval
     * of the z-axis, per length of the source: half-infinite for the end of a
     * long fiber, or finite.
     */
    Estimate
    energy_of_disk_and_cylinder(const InversePower &power,
                                const SectionPair  &sections,
                                const Disk         &disk,
                                const Interval     &cylinder,
                                double tolerance = default_tolerance);
  } // namespace References
} // namespace Setae

#endif
