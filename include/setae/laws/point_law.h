// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_laws_point_law_h
#define setae_laws_point_law_h

#include <deal.II/base/config.h>

#include <setae/base/lanes.h>
#include <setae/laws/point_potential.h>

#include <array>
#include <utility>

namespace Setae
{
  /**
   * Two points at distance r: @f$\Phi(r)=\sum_m k_m r^{-m}@f$, the law that all
   * others are integrals of. It is evaluated from @f$r^2@f$ with integer powers,
   * and one square root if an exponent is odd.
   */
  class PointLaw
  {
  public:
    template <typename Number>
    struct Derivatives
    {
      Number value;        ///< @f$\Phi@f$ [energy]
      Number first_over_r; ///< @f$\Phi'/r@f$ [energy/length^2]
    };

    explicit PointLaw(PointPotential potential)
      : potential(std::move(potential))
    {}

    /** The square of the distance, which the law is a function of. */
    template <typename Number>
    DEAL_II_ALWAYS_INLINE Number
    coordinate(const std::array<Number, 3> &d) const
    {
      return d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
    }

    /** Energy and radial derivative, on numbers or Lanes. */
    template <typename Number>
    DEAL_II_ALWAYS_INLINE Derivatives<Number>
                          operator()(const Number &distance_square) const
    {
      const Number        inverse = 1. / distance_square;
      Derivatives<Number> sum     = {};
      for (const InversePower &power : potential)
        {
          const Number term =
            power.prefactor * inverse_power(inverse, power.exponent);
          sum.value += term;
          sum.first_over_r -= double(power.exponent) * term;
        }
      sum.first_over_r *= inverse;
      return sum;
    }

    /** The energy alone, on any number type. */
    template <typename Number>
    Number
    energy(const Number &distance_square) const
    {
      const Number inverse = 1. / distance_square;
      Number       sum     = 0. * inverse;
      for (const InversePower &power : potential)
        sum += power.prefactor * inverse_power(inverse, power.exponent);
      return sum;
    }

  private:
    /** @f$(r^{-2})^{m/2}@f$ */
    template <typename Number>
    static DEAL_II_ALWAYS_INLINE Number
    inverse_power(const Number &inverse_square, const unsigned int exponent)
    {
      Number base   = inverse_square;
      Number result = 1. + 0. * base;
      if (exponent % 2 == 1)
        result = square_root(base);
      for (unsigned int n = exponent / 2; n > 0; n /= 2, base *= Number(base))
        if (n % 2 == 1)
          result *= base;
      return result;
    }

    PointPotential potential;
  };
} // namespace Setae

#endif
