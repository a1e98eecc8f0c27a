// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_verification_quadrature_h
#define setae_verification_quadrature_h

#include <functional>

namespace Setae
{
  /**
   * Energies and forces of rigid disks, cylinders and rings, to ten digits and
   * down to gaps of a millionth of the radius: what the reduced laws are
   * verified against. All are integrals over the point potential k_m r^-m that
   * are reduced analytically as far as possible; what is left is adaptive
   * quadrature in one to three dimensions.
   */
  namespace References
  {
    /** A number and an estimate of its absolute error. */
    struct Estimate
    {
      double value = 0.;
      double error = 0.;
    };

    Estimate
    operator*(double factor, const Estimate &estimate);

    Estimate
    operator+(const Estimate &a, const Estimate &b);

    /**
     * An energy and the force -dE/dgap that goes with it; positive repels.
     */
    struct EnergyAndForce
    {
      Estimate energy;
      Estimate force;
    };

    EnergyAndForce
    operator*(double factor, const EnergyAndForce &pair);

    EnergyAndForce
    operator+(const EnergyAndForce &a, const EnergyAndForce &b);

    /** The relative error that is asked of every reference by default. */
    constexpr double default_tolerance = 1e-10;

    using Function = std::function<double(double)>;

    /**
     * The integral of @p f from @p a to @p b, globally adaptive (QUADPACK's QAG
     * as found in GSL).
     *
     * @param tolerance Largest relative error.
     * @param negligible An absolute error that is good enough, for a part of
     * something larger.
     * @throws ExcRun if neither can be reached.
     */
    Estimate
    integrate(const Function &f,
              double          a,
              double          b,
              double          tolerance,
              double          negligible = 0.);

    /**
     * The same for a function that has its peak at @p peak, inside or outside of
     * the interval, and varies on the scale @p scale there and ever more slowly
     * away from it: integrated over u in x = peak + scale sinh(u), so that a
     * peak of a millionth of the interval costs little more than none.
     *
     * The bounds may be infinite if @p f decays at least as |x|^(-3/2); then
     * @p far, many times the lengths at which @p f varies, is the distance
     * from the peak beyond which x = peak + far/y^2 is substituted, which makes
     * a smooth function of all half-integer powers.
     */
    Estimate
    integrate_peak(const Function &f,
                   double          a,
                   double          b,
                   double          peak,
                   double          scale,
                   double          tolerance,
                   double          far        = 0.,
                   double          negligible = 0.);

    /**
     * The relative tolerance of an integral that is the integrand of another
     * one.
     */
    inline double
    inner(const double tolerance)
    {
      return .1 * tolerance;
    }
  } // namespace References
} // namespace Setae

#endif
