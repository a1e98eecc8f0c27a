// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_laws_offset_power_h
#define setae_laws_offset_power_h

#include <setae/base/integer_power.h>
#include <setae/base/law_derivatives.h>

#include <cmath>
#include <vector>

namespace Setae
{
  /**
   * The power of the gap @f$q_2@f$ that an inverse power @f$r^{-m}@f$ between
   * points leaves between two disks in parallel planes at the offset @f$q_1@f$
   * (ISSIP eq. 28 and 35, with the argument of eq. 35), or its k-th derivative
   * with respect to the gap:
   * @f[ \phi = q_2^{h}\, {}_2F_1\left(-\tfrac h2,\tfrac{1-h}2;\tfrac m2;
   *     -\frac{q_1^2}{q_2^2}\right), \qquad h = \tfrac72-m-k, @f]
   * where the factors (7/2-m)(5/2-m)... of the derivatives are left out. It
   * equals
   * @f$\int_0^\infty x^{3/2-k}\,[(q_2+x)^2+q_1^2]^{(1-m)/2}\,dx@f$ up to a
   * constant, and, by a quadratic transformation,
   * @f[ \phi = \rho^{h}\,G(w), \quad
   *     G(w) = {}_2F_1(\tfrac52-k, -h; \tfrac m2; w) = (1-w)^{1-m/2} F(w),
   * \quad
   *     F(w) = {}_2F_1(\tfrac{m-5}2+k,\tfrac{7-m}2-k;\tfrac m2;w), @f]
   * with @f$\rho=\sqrt{q_1^2+q_2^2}@f$ and
   * @f$w=\frac{\rho-q_2}{2\rho}\in[0,\frac12)@f$ for positive gaps: a half of
   * the versine of the angle between connecting line and normal. The
   * singularity at w = 1 stands in front of F, which is a polynomial of low
   * degree to rounding errors on [0, 1/2]. So no hypergeometric function is
   * called, and large offsets cost and err no more than small ones.
   */
  class OffsetPower
  {
  public:
    /** @p m is 4 or more, @p k is 0, 1 or 2. */
    OffsetPower(const unsigned int m, const unsigned int k)
      : m(m)
      , k(k)
      , F(polynomial())
    {}

    /** The value alone, on any number type. */
    template <typename Number>
    Number
    value(const Number &offset, const Number &gap) const
    {
      using std::sqrt;
      const Number rho         = sqrt(Number(offset * offset + gap * gap));
      const Number one_minus_w = .5 * (1. + gap / rho);
      const Number w =
        offset * offset / (2. * rho * Number(rho + gap)); // (rho - gap) / 2 rho
      const Number x   = 4. * w - 1.;
      Number       sum = F.back();
      for (unsigned int i = F.size() - 1; i-- > 0;)
        sum = sum * x + F[i];
      return sum * front_factor(Number(1. / one_minus_w)) *
             radial_factor(Number(1. / rho));
    }

    /** Value and derivatives. */
    OffsetGapDerivatives
    derivatives(const double offset, const double gap) const
    {
      // Sine and cosine of the angle between connecting line and normal.
      const double inverse = 1. / std::sqrt(offset * offset + gap * gap);
      const double s = offset * inverse, c = gap * inverse;
      const double w   = s * s / (2. * (1. + c));
      const double s_s = s * s, c_c = c * c;

      // F and its derivatives, then those of G.
      const double x  = 4. * w - 1.;
      double       F0 = F.back(), F1 = 0., F2 = 0.;
      for (unsigned int i = F.size() - 1; i-- > 0;)
        {
          F2 = F2 * x + F1;
          F1 = F1 * x + F0;
          F0 = F0 * x + F[i];
        }
      F1 *= 4.;
      F2 *= 32.;
      const double u      = 2. / (1. + c); // 1 / (1 - w)
      const double p      = (.5 * m - 1.) * u;
      const double factor = front_factor(u) * radial_factor(inverse);
      const double G0     = factor * F0;
      const double G1     = factor * (F1 + p * F0);
      const double G2     = factor * (F2 + p * (2. * F1 + (p + u) * F0));

      // By the derivatives of rho and w = sin^2(angle/2) in offset and gap.
      const double h = 3.5 - m - k;
      return {
        G0,
        inverse * s * (h * G0 + .5 * c * G1),
        inverse * (h * c * G0 - .5 * s_s * G1),
        inverse * inverse *
          (h * ((h - 1.) * s_s + c_c) * G0 +
           .5 * c * (2. * (h - 1.) * s_s + c_c) * G1 + .25 * s_s * c_c * G2),
        inverse * inverse * s *
          (h * (h - 2.) * c * G0 + .5 * ((h - 2.) * c_c - (h - 1.) * s_s) * G1 -
           .25 * s_s * c * G2),
        inverse * inverse *
          (h * ((h - 1.) * c_c + s_s) * G0 + (1.5 - h) * s_s * c * G1 +
           .25 * s_s * s_s * G2)};
    }

  private:
    /** @f$(1-w)^{1-m/2}@f$ from @f$u=1/(1-w)@f$. */
    template <typename Number>
    Number
    front_factor(const Number &u) const
    {
      using std::sqrt;
      const Number whole = integer_power(u, m / 2 - 1);
      return m % 2 == 0 ? whole : Number(whole * sqrt(u));
    }

    /** @f$\rho^h@f$ from @f$1/\rho@f$. */
    template <typename Number>
    Number
    radial_factor(const Number &inverse) const
    {
      using std::sqrt;
      return integer_power(inverse, m + k - 4) * sqrt(inverse);
    }

    /** F in powers of x = 4 w - 1, for w in [0, 1/2]. */
    std::vector<double>
    polynomial() const;

    unsigned int        m, k;
    std::vector<double> F;
  };
} // namespace Setae

#endif
