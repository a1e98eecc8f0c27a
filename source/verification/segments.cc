// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <setae/verification/segments.h>

#include <algorithm>
#include <cmath>

namespace Setae
{
  namespace References
  {
    namespace
    {
      /** A power series of positive terms, as far as they matter. */
      double
      sum(const std::vector<double> &coefficients, const double x)
      {
        double result = 0., power = 1.;
        for (const double c : coefficients)
          {
            result += c * power;
            if (c * power < 1e-17 * result)
              break;
            power *= x;
          }
        return result;
      }



      /** The integral of z (p^2+z^2)^(-m/2). */
      double
      first_moment(const unsigned int m, const double p, const Interval &z)
      {
        const double a = p * p + z.begin * z.begin, b = p * p + z.end * z.end;
        const double log_ratio =
          2. * std::min(a, b) < std::max(a, b) ?
            std::log(b / a) :
            std::log1p((z.end - z.begin) * (z.end + z.begin) / a);
        if (m == 2)
          return .5 * log_ratio;
        return std::pow(std::min(a, b), 1. - .5 * m) / (2. - m) *
               (b >= a ? std::expm1((1. - .5 * m) * log_ratio) :
                         -std::expm1((.5 * m - 1.) * log_ratio));
      }
    } // namespace



    double
    line_factor(const unsigned int m)
    {
      return std::sqrt(M_PI) * std::tgamma(.5 * (m - 1.)) / std::tgamma(.5 * m);
    }



    SegmentIntegral::SegmentIntegral(const unsigned int exponent)
      : m(exponent)
    {
      // Both arguments are at most 1/2; the first series takes long to start
      // falling if m is large.
      const unsigned int n_terms = 80 + 2 * m;
      double             h = 1., t = 1.;
      for (unsigned int n = 0; n < n_terms; ++n)
        {
          head_series.push_back(h);
          tail_series.push_back(t);
          h *= (.5 * m + n) / (1.5 + n);
          t *= (.5 * m + n) / (.5 * (m + 1) + n);
        }
    }



    double
    SegmentIntegral::head(const double p, const double a) const
    {
      if (a >= p)
        return .5 * line_factor(m) * std::pow(p, 1. - m) - tail(p, a);
      const double rho2 = p * p + a * a;
      return a * std::pow(rho2, -.5 * m) * sum(head_series, a * a / rho2);
    }



    double
    SegmentIntegral::tail(const double p, const double a) const
    {
      if (std::isinf(a))
        return 0.;
      if (a < p)
        return .5 * line_factor(m) * std::pow(p, 1. - m) - head(p, a);
      const double rho2 = p * p + a * a;
      return a * std::pow(rho2, -.5 * m) / (m - 1.) *
             sum(tail_series, p * p / rho2);
    }



    double
    SegmentIntegral::operator()(const double p, const Interval &z) const
    {
      if (m == 1)
        return std::asinh(z.end / p) - std::asinh(z.begin / p);
      if (z.begin < 0. && z.end > 0.)
        return head(p, -z.begin) + head(p, z.end);

      const double near = std::min(std::abs(z.begin), std::abs(z.end));
      const double far  = std::max(std::abs(z.begin), std::abs(z.end));
      return near < p ? head(p, far) - head(p, near) :
                        tail(p, near) - tail(p, far);
    }



    DoubleSegmentIntegral::DoubleSegmentIntegral(const unsigned int exponent,
                                                 const Overlap     &overlap)
      : m(exponent)
      , plateau(std::min(overlap.length_1, overlap.length_2))
      , segment(exponent)
    {
      const double begin = -overlap.shift - overlap.length_2;
      const double end   = overlap.length_1 - overlap.shift;
      rise               = {begin, begin + plateau};
      top                = {begin + plateau, end - plateau};
      fall               = {end - plateau, end};
    }



    double
    DoubleSegmentIntegral::operator()(const double p) const
    {
      double sum = first_moment(m, p, rise) - rise.begin * segment(p, rise) +
                   fall.end * segment(p, fall) - first_moment(m, p, fall);
      if (top.begin < top.end)
        sum += plateau * segment(p, top);
      return sum;
    }
  } // namespace References
} // namespace Setae
