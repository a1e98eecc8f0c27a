// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_verification_disks_h
#define setae_verification_disks_h

#include <deal.II/base/tensor.h>

#include <setae/verification/point_potentials.h>

namespace Setae
{
  namespace References
  {
    /**
     * Two disks in one plane, per length squared of two fibers. Any exponent
     * m >= 1.
     *
     * @param gap Distance of the centers minus the sum of the radii [length],
     * positive.
     */
    EnergyAndForce
    coplanar_disks(const InversePower &power,
                   const SectionPair  &sections,
                   double              gap,
                   double              tolerance = default_tolerance);

    /**
     * Two disks in parallel planes, per length squared: the two-dimensional
     * integral of ISSIP eq. A6 with r^2 + offset^2 for r^2. The force is the
     * one in the direction of the gap, i.e. in the planes.
     *
     * @param gap Distance of the axes minus the sum of the radii [length],
     * positive.
     * @param offset Distance of the planes [length].
     */
    EnergyAndForce
    offset_disks(const InversePower &power,
                 const SectionPair  &sections,
                 double              gap,
                 double              offset,
                 double              tolerance = default_tolerance);

    /**
     * The integral of a radial function over two disks in one plane, ISSIP
     * eq. A6, with densities: what is left of every pair of parallel bodies
     * after the integration along the axes.
     *
     * @param f A function of the distance.
     */
    Estimate
    integrate_over_disks(const Function    &f,
                         const SectionPair &sections,
                         double             gap,
                         double             tolerance);

    /**
     * Minus the derivative of integrate_over_disks() with respect to the gap.
     *
     * @param slope The derivative of f.
     */
    Estimate
    force_over_disks(const Function    &slope,
                     const SectionPair &sections,
                     double             gap,
                     double             tolerance);



    /**
     * Two disks in parallel planes that face each other, also partly: the pairs
     * of points with the same difference of positions fill the overlap of the
     * two disks, one of them displaced. The force is the one along the normal.
     *
     * @param distance Distance of the planes [length], positive.
     * @param displacement Distance of the axes [length], at least zero and below
     * the sum of the radii.
     */
    EnergyAndForce
    facing_disks(const InversePower &power,
                 const SectionPair  &sections,
                 double              distance,
                 double              displacement,
                 double              tolerance = default_tolerance);

    /**
     * Minus the derivative of their energy with respect to the displacement:
     * the force that pushes them apart in their planes.
     */
    Estimate
    sideways_force_of_facing_disks(const InversePower &power,
                                   const SectionPair  &sections,
                                   double              distance,
                                   double              displacement,
                                   double tolerance = default_tolerance);

    /**
     * The integral over two facing disks of a function of the distance of two
     * points in the direction of the planes, with densities.
     *
     * @param f A function that decays from the @p distance of the planes on.
     */
    Estimate
    integrate_over_facing_disks(const Function    &f,
                                const SectionPair &sections,
                                double             distance,
                                double             displacement,
                                double             tolerance);



    /** A disk in space. */
    struct Disk
    {
      dealii::Tensor<1, 3> center; ///< [length]
      dealii::Tensor<1, 3> normal; ///< of length one
    };

    /**
     * Two disks at any position and orientation that do not touch, per length
     * squared, and the force on the first disk in the direction @p direction.
     * Both are taken apart into chords that are parallel to both planes. The
     * integrals along two chords are known, which leaves two dimensions, and
     * hardly any pose or gap is harder than another one.
     *
     * The force is the sum of its components along the chords, in the plane of
     * the second disk and normal to it; the tolerance of each is relative to
     * the integral of its magnitude.
     *
     * Positions have the round-off of their largest coordinate; divided by the
     * gap and multiplied by the exponent it is the relative error that no
     * quadrature can avoid.
     */
    EnergyAndForce
    disks(const InversePower         &power,
          const SectionPair          &sections,
          const Disk                 &disk_1,
          const Disk                 &disk_2,
          const dealii::Tensor<1, 3> &direction,
          double                      tolerance = default_tolerance);

    /** The energy alone. */
    Estimate
    energy_of_disks(const InversePower &power,
                    const SectionPair  &sections,
                    const Disk         &disk_1,
                    const Disk         &disk_2,
                    double              tolerance = default_tolerance);

    /**
     * The same once more in other coordinates, so that there are two ways to
     * every number: what a point of one disk feels of the other one, integrated
     * around the point that is nearest to it. Three dimensions are left, which
     * takes longer. Not for disks that are almost parallel, closer than a
     * hundredth of the radius and only partly in front of each other: the
     * steps where an edge is above the other disk are too many and too steep
     * to be found without fail.
     */
    EnergyAndForce
    disks_by_points(const InversePower         &power,
                    const SectionPair          &sections,
                    const Disk                 &disk_1,
                    const Disk                 &disk_2,
                    const dealii::Tensor<1, 3> &direction,
                    double                      tolerance = default_tolerance);

    /** The energy alone. */
    Estimate
    energy_of_disks_by_points(const InversePower &power,
                              const SectionPair  &sections,
                              const Disk         &disk_1,
                              const Disk         &disk_2,
                              double tolerance = default_tolerance);
  } // namespace References
} // namespace Setae

#endif
