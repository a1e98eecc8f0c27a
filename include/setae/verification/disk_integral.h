// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_verification_disk_integral_h
#define setae_verification_disk_integral_h

#include <setae/verification/quadrature.h>

#include <functional>

namespace Setae
{
  namespace References
  {
    /** A function of Cartesian coordinates in the plane of a disk. */
    using PlaneFunction = std::function<double(double, double)>;

    /** A point of a disk in polar coordinates around the center. */
    struct DiskPoint
    {
      double radius   = 0.;
      double angle    = 0.;
      double distance = 0.; ///< from the other body
    };

    /**
     * The point of a disk around the origin that is nearest to a convex body.
     *
     * @param distance The distance from the body, a convex function.
     */
    DiskPoint
    nearest_point_of_disk(const PlaneFunction &distance, double radius);

    /**
     * The angle at which a function on a circle, with at most a few minima, is
     * smallest.
     */
    double
    angle_of_minimum(const Function &f);

    /**
     * The integral over a disk of a function with a peak, in polar coordinates
     * around that point. The width of the peak is the distance of the other
     * body.
     *
     * @param f A function of the Cartesian coordinates relative to the peak:
     * near a body a millionth of the radius away, absolute ones would leave
     * nothing but noise of the last six digits.
     */
    Estimate
    integrate_over_disk(const PlaneFunction &f,
                        double               radius,
                        const DiskPoint     &peak,
                        double               tolerance);
  } // namespace References
} // namespace Setae

#endif
