// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <boost/math/special_functions/digamma.hpp>

#include <setae/verification/hypergeometric.h>

#include <algorithm>
#include <cmath>

namespace Setae
{
  namespace References
  {
    namespace
    {
      /** Enough for arguments up to 1/2. */
      constexpr unsigned int n_terms = 80;

      bool
      is_pole_of_gamma(const double x)
      {
        return x <= 0. && x == std::floor(x);
      }



      double
      horner(const std::vector<double> &coefficients, const double x)
      {
        double sum = 0.;
        for (auto c = coefficients.rbegin(); c != coefficients.rend(); ++c)
          sum = sum * x + *c;
        return sum;
      }
    } // namespace



    Hypergeometric::Hypergeometric(const double       a,
                                   const double       b,
                                   const unsigned int d)
      : series(n_terms)
      , regular(n_terms + d)
      , logarithmic(n_terms + d)
    {
      const double c = a + b + d;
      series[0]      = 1.;
      for (unsigned int n = 0; n + 1 < n_terms; ++n)
        series[n + 1] = series[n] * (a + n) * (b + n) / ((c + n) * (n + 1.));

      // The finite sum of 15.3.11; there is none in 15.3.10.
      double factor = d == 0 ? 0. :
                               std::tgamma(d) * std::tgamma(c) /
                                 (std::tgamma(a + d) * std::tgamma(b + d));
      for (unsigned int n = 0; n < d; ++n)
        {
          regular[n] = factor;
          if (n + 1 < d)
            factor *= (a + n) * (b + n) / ((n + 1.) * (1. - d + n));
        }

      // The infinite one vanishes if F is a polynomial.
      if (is_pole_of_gamma(a) || is_pole_of_gamma(b))
        return;
      using boost::math::digamma;
      factor = (d % 2 == 0 ? -1. : 1.) * std::tgamma(c) /
               (std::tgamma(a) * std::tgamma(b) * std::tgamma(d + 1.));
      for (unsigned int n = 0; n < n_terms; ++n)
        {
          logarithmic[n + d] = factor;
          regular[n + d] += factor * (digamma(a + d + n) + digamma(b + d + n) -
                                      digamma(n + 1.) - digamma(n + d + 1.));
          factor *= (a + d + n) * (b + d + n) / ((n + 1.) * (n + d + 1.));
        }
    }



    double
    Hypergeometric::operator()(const double z, const double complement) const
    {
      if (z <= .5)
        return horner(series, z);
      return horner(regular, complement) +
             horner(logarithmic, complement) * std::log(complement);
    }
  } // namespace References
} // namespace Setae
