// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_laws_point_cylinder_h
#define setae_laws_point_cylinder_h

#include <cmath>
#include <vector>

namespace Setae
{
  /**
   * The potential of an infinite straight cylinder of radius R with one point
   * per volume: the integral of @f$r^{-m}@f$ over the cylinder, at a point
   * outside. With the distance x from the axis and the gap h = x - R,
   * @f[ \Pi_m = \frac{\sqrt\pi\,\Gamma(\frac{m-1}2)}{\Gamma(\frac m2)}
   *     \frac{\pi R^2 x^{m-5}}{[h(x+R)]^{m-3}}\;
   *     {}_2F_1\Bigl(\tfrac{5-m}2,\tfrac{5-m}2;2;\tfrac{R^2}{x^2}\Bigr). @f]
   * The singularity stands in front of the hypergeometric function, which is
   * bounded and here a polynomial: exact for odd m, and otherwise with a
   * relative error below 1e-8.
   */
  class PointCylinder
  {
  public:
    PointCylinder(const unsigned int exponent, const double radius)
      : m(exponent)
      , R(radius)
      , coefficients(n_coefficients)
      , factor(std::sqrt(M_PI) * std::tgamma((m - 1.) / 2.) /
               std::tgamma(m / 2.) * M_PI * R * R)
    {
      // Interpolation in Chebyshev points. The values come from the power
      // series, whose terms decrease as k^(2-m) even at the end of the
      // interval.
      std::vector<double> values(n_coefficients);
      for (unsigned int i = 0; i < n_coefficients; ++i)
        values[i] =
          hypergeometric(.5 + .5 * std::cos(M_PI * (i + .5) / n_coefficients));
      for (unsigned int k = 0; k < n_coefficients; ++k)
        {
          for (unsigned int i = 0; i < n_coefficients; ++i)
            coefficients[k] +=
              values[i] * std::cos(M_PI * k * (i + .5) / n_coefficients);
          coefficients[k] *= (k == 0 ? 1. : 2.) / n_coefficients;
        }
    }

    /** The potential at the gap @p h > 0 and the distance x = R + h. */
    template <typename Number>
    Number
    operator()(const Number &h, const Number &x) const
    {
      const Number inverse = 1. / x;
      const Number a       = x / (h * (x + R)); // [1/length]
      return factor * power(a, m - 3) * inverse * inverse *
             series(Number(R * R * inverse * inverse));
    }

    /** The integer power of a number. */
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

  private:
    static constexpr unsigned int n_coefficients = 14;

    double
    hypergeometric(const double z) const
    {
      constexpr unsigned int n_terms = 2000;
      const double           a       = (5. - m) / 2.;
      double                 term = 1., sum = 1.;
      for (unsigned int k = 0; k < n_terms; ++k)
        {
          term *= (a + k) * (a + k) / ((2. + k) * (1. + k)) * z;
          sum += term;
        }
      return sum;
    }

    /** Clenshaw's sum of the Chebyshev series on [0, 1]. */
    template <typename Number>
    Number
    series(const Number &z) const
    {
      const Number t = 2. * z - 1.;
      Number       b = 0., b_next = 0.;
      for (unsigned int k = n_coefficients - 1; k > 0; --k)
        {
          const Number b_k = coefficients[k] + 2. * t * b - b_next;
          b_next           = b;
          b                = b_k;
        }
      return coefficients[0] + t * b - b_next;
    }

    unsigned int        m;
    double              R;
    std::vector<double> coefficients;
    double              factor;
  };
} // namespace Setae

#endif
