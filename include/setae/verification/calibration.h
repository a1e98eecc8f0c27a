// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_verification_calibration_h
#define setae_verification_calibration_h

#include <setae/laws/point_potential.h>
#include <setae/verification/quadrature.h>

#include <iosfwd>
#include <string>
#include <vector>

namespace Setae
{
  struct Scene;

  namespace References
  {
    /**
     * Two infinite straight fibers, source first: parallel if the angle is
     * zero, with energy and force per length, or else crossing.
     */
    struct StraightFibers
    {
      SectionPair sections;
      double      angle = 0.; ///< between the axes, at most pi/2
    };

    /** What is true: parallel_cylinders() or crossing_cylinders(). */
    EnergyAndForce
    exact(const InversePower &power, const StraightFibers &fibers, double gap);

    /**
     * What a law makes of them, integrated over one or both fibers as the law
     * wants, without regularization and cutoff.
     *
     * @param law The name of one of PotentialLaws.
     */
    EnergyAndForce
    by_law(const std::string    &law,
           const InversePower   &power,
           const StraightFibers &fibers,
           double                gap);

    /** A prefactor that makes up for the error of a law at one gap. */
    struct FittedPrefactor
    {
      unsigned int exponent;
      double       factor;    ///< fitted over given prefactor
      double       prefactor; ///< fitted [energy length^m]
    };

    /**
     * The prefactors with which a law gives the exact force of two fibers at
     * the given gap, each power for itself (SSIP Sec. 7.1.1; SBIP Sec. 8.1.5 by
     * trial and error).
     */
    std::vector<FittedPrefactor>
    fit(const std::string    &law,
        const PointPotential &potential,
        const StraightFibers &fibers,
        double                gap);

    /**
     * Print the fitted prefactors of every interaction of a scene, and the
     * errors of energy and force that remain from a tenth to ten times the gap.
     *
     * @param gap [length]
     * @param angle As in StraightFibers.
     *
     * @throws ExcInput if a law or a distribution has no exact counterpart.
     */
    void
    calibrate(const Scene &scene, double gap, double angle, std::ostream &out);
  } // namespace References
} // namespace Setae

#endif
