// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_laws_contact_powers_h
#define setae_laws_contact_powers_h

#include <setae/base/law_derivatives.h>
#include <setae/laws/point_potential.h>

#include <cmath>
#include <vector>

namespace Setae
{
  /**
   * The dependence of the energy of a disk and a cylinder on their softened
   * distance H (DiskContact) alone, for each power m of the point potential
   * @f[ P_m(H) = a_m k_m\rho_1\rho_2 R_1\, h^{9/2-m}
   *     \Bigl(\frac{2R_2}{h+2R_2}\Bigr)^2
   *     \Bigl(\frac{2(h+R_2)}{h+2R_2}\Bigr)^{\lfloor m/2\rfloor-2},\qquad
   *     h = H+\sqrt{R_1^2+H^2}-R_1. @f]
   * h is the gap if the cylinders are parallel. At a small gap P is that of a
   * half-space,
   * @f$a_m=\frac{2\pi}{(m-2)(m-3)(m-4)}\sqrt{2\pi}\,
   * \Gamma(m-\frac92)/\Gamma(m-4)@f$; the factors on the right turn it into a
   * thin cylinder at a large one.
   */
  class ContactPowers
  {
  public:
    ContactPowers(const PointPotential &potential, const SectionPair &sections)
      : R1(sections.radius_1)
      , R2(sections.radius_2)
    {
      for (const InversePower &power : potential)
        terms.push_back({power.exponent - 5,
                         power.exponent / 2 - 2,
                         power.prefactor * sections.density_1 *
                           sections.density_2 * coefficient(power.exponent) *
                           R1});
    }

    /** a_m */
    static double
    coefficient(const double m)
    {
      return 2. * M_PI / ((m - 2.) * (m - 3.) * (m - 4.)) *
             std::sqrt(2. * M_PI) * std::tgamma(m - 4.5) / std::tgamma(m - 4.);
    }

    /** The value alone, on any number type; @p H must be positive. */
    template <typename Number>
    Number
    value(const Number &H) const
    {
      using std::sqrt;
      const Number h = H + H * H / (sqrt(R1 * R1 + H * H) + R1);
      const Number e = 1. / (h + 2. * R2);
      const Number b = 1. / h, f = 2. * (h + R2) * e;
      Number       sum = 0.;
      for (const Term &term : terms)
        sum += term.coefficient * power(b, term.n) * power(f, term.n_far);
      return sum * (4. * R2 * R2) * e * e * sqrt(b);
    }

    /** Value and derivatives; @p H must be positive. */
    GapDerivatives
    derivatives(const double H) const
    {
      const double root = std::sqrt(R1 * R1 + H * H);
      const double h    = H + H * H / (root + R1);
      const double h_1 = 1. + H / root, h_2 = R1 * R1 / (root * root * root);

      const double e = 1. / (h + 2. * R2), b = 1. / h;
      const double f     = 2. * (h + R2) * e;
      const double front = 4. * R2 * R2 * e * e * std::sqrt(b);
      const double f_1   = R2 / (h + R2) * e; // logarithmic

      GapDerivatives sum;
      for (const Term &term : terms)
        {
          const double n = term.n + .5, n_far = term.n_far;
          const double value =
            term.coefficient * front * power(b, term.n) * power(f, term.n_far);
          const double first = n_far * f_1 - 2. * e - n * b;
          const double second =
            -n_far * f_1 * (e + 1. / (h + R2)) + 2. * e * e + n * b * b;
          sum.value += value;
          sum.first += value * first;
          sum.second += value * (first * first + second);
        }
      return {sum.value,
              sum.first * h_1,
              sum.second * h_1 * h_1 + sum.first * h_2};
    }

  private:
    struct Term
    {
      unsigned int n, n_far;
      double       coefficient;
    };

    template <typename Number>
    static Number
    power(Number base, unsigned int n)
    {
      Number result = 1.;
      for (; n > 0; n /= 2, base *= Number(base))
        if (n % 2 == 1)
          result *= base;
      return result;
    }

    double            R1, R2;
    std::vector<Term> terms;
  };
} // namespace Setae

#endif
