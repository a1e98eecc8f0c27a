// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_verification_hypergeometric_h
#define setae_verification_hypergeometric_h

#include <vector>

namespace Setae
{
  namespace References
  {
    /**
     * Gauss' function F(a,b;a+b+d;z), d = 0, 1, 2, ..., on 0 <= z < 1, the
     * family that the potentials of disks and cylinders lead to. (GSL 2.7 is
     * wrong near z = 1 for the half-integer a, b of even exponents.)
     *
     * The series in z serves up to z = 1/2, from there on the one in 1-z, with
     * its logarithm (Abramowitz and Stegun, 15.3.10-11).
     */
    class Hypergeometric
    {
    public:
      /** @param difference d = c-a-b */
      Hypergeometric(double a, double b, unsigned int difference);

      /**
       * @param z The argument, in [0,1).
       * @param complement 1-z, to be computed without cancellation.
       */
      double
      operator()(double z, double complement) const;

    private:
      std::vector<double> series;      ///< in z
      std::vector<double> regular;     ///< in 1-z
      std::vector<double> logarithmic; ///< in 1-z, times log(1-z)
    };
  } // namespace References
} // namespace Setae

#endif
