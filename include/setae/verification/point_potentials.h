// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_verification_point_potentials_h
#define setae_verification_point_potentials_h

#include <setae/laws/point_potential.h>
#include <setae/verification/hypergeometric.h>
#include <setae/verification/quadrature.h>
#include <setae/verification/segments.h>

namespace Setae
{
  namespace References
  {
    /**
     * The integral of r^-p over a disk as a function of a point in its plane,
     * outside of it at the distance t from its center:
     * @f$\pi R^2 t^{-p} F(\tfrac p2,\tfrac p2;2;R^2/t^2)@f$, by Euler's
     * transformation with the singularity of p > 2 in front of a bounded
     * function.
     */
    class PlanarDisk
    {
    public:
      PlanarDisk(unsigned int exponent, double radius);

      /** @param gap t-R [length], positive. */
      double
      value(double gap) const;

      /** The derivative with respect to the gap. */
      double
      derivative(double gap) const;

    private:
      double         p;
      double         R;
      Hypergeometric value_function;
      Hypergeometric derivative_function;
    };



    /**
     * The potential of a point and an infinite cylinder, exact at every gap
     * (energy times length^3 per point, without densities). Exponents m >= 2.
     */
    class PointCylinder
    {
    public:
      PointCylinder(const InversePower &power, double radius);

      /** @param gap The distance from the surface [length], positive. */
      double
      value(double gap) const;

      /** The derivative with respect to the gap. */
      double
      derivative(double gap) const;

    private:
      double     factor;
      PlanarDisk disk;
    };



    /**
     * The integral of r^-q over a cylinder's section with the chord lengths
     * 2 sqrt(R^2-z^2) as weights, x-z for r:
     * @f$\pi R^2 x^{-q}F(\tfrac q2,\tfrac{q+1}2;2;R^2/x^2)@f$, an elementary
     * function for integer q >= 1. Up to the factor 2 pi/(m-2), q = m-2, it is
     * the potential of a plane of points and a cylinder.
     */
    double
    chord_integral(unsigned int q, double radius, double gap);



    /**
     * The integral of a radial function over a disk that is seen from a point
     * in its plane, in the coordinates p (distance) and half angle of the arc
     * of radius p inside of the disk (inner integral of ISSIP eq. A6).
     *
     * @param f A function of p.
     * @param radius Radius R of the disk.
     * @param gap Distance t-R of the point from the edge; negative if the point
     * is inside.
     * @param scale The length at which f varies near p = 0 if the point is
     * inside.
     */
    Estimate
    integrate_over_disk(const Function &f,
                        double          radius,
                        double          gap,
                        double          tolerance,
                        double          scale = 0.);

    /**
     * The derivative of integrate_over_disk() with respect to the gap.
     *
     * @param slope The derivative of f.
     */
    Estimate
    slope_over_disk(const Function &slope,
                    double          radius,
                    double          gap,
                    double          tolerance);



    /**
     * The potential of a point and a straight cylinder that occupies an
     * interval of z (energy times length^3 per point, without densities), with
     * the point at z = 0 and outside of the cylinder.
     *
     * @param gap Distance of the point from the axis minus the radius
     * [length]; may be negative beyond an end.
     */
    Estimate
    point_and_cylinder(const InversePower &power,
                       double              radius,
                       double              gap,
                       const Interval     &z,
                       double              tolerance = default_tolerance);

    /**
     * The potential of a point and a disk at any position (energy times
     * length^2 per point, without densities).
     *
     * @param gap Distance of the point from the axis minus the radius.
     * @param height Distance of the point from the plane of the disk.
     */
    Estimate
    point_and_disk(const InversePower &power,
                   double              radius,
                   double              gap,
                   double              height,
                   double              tolerance = default_tolerance);
  } // namespace References
} // namespace Setae

#endif
