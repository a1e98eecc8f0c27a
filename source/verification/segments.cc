// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <boost/math/quadrature/gauss.hpp>

#include <setae/base/integer_power.h>
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



      /**
       * Whether an interval is so short and far away that the integrals up to
       * its ends would cancel, but also so smooth that a few points suffice.
       */
      bool
      is_far(const double p, const Interval &z)
      {
        const double near  = std::max({0., z.begin, -z.end});
        const double width = z.end - z.begin;
        return 4. * width * width < p * p + near * near;
      }



      template <typename Weight>
      double
      far_integral(const Weight      &weight,
                   const unsigned int m,
                   const double       p,
                   const Interval    &z)
      {
        return boost::math::quadrature::gauss<double, 10>::integrate(
          [&](const double z_i) {
            return weight(z_i) * inverse_power(p * p + z_i * z_i, m);
          },
          z.begin,
          z.end);
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
        const double near = std::min(a, b);
        return (m == 1 ? std::sqrt(near) : inverse_power(near, m - 2)) /
               (2. - m) *
               (b >= a ? std::expm1((1. - .5 * m) * log_ratio) :
                         -std::expm1((.5 * m - 1.) * log_ratio));
      }
    } // namespace



    double
    inverse_power(const double r2, const unsigned int m)
    {
      const double even = integer_power(1. / r2, m / 2);
      return m % 2 == 0 ? even : even / std::sqrt(r2);
    }



    double
    line_factor(const unsigned int m)
    {
      return std::sqrt(M_PI) * std::tgamma(.5 * (m - 1.)) / std::tgamma(.5 * m);
    }



    SegmentIntegral::SegmentIntegral(const unsigned int exponent)
      : m(exponent)
      , half_line(m > 1 ? .5 * line_factor(m) : 0.)
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
        return half_line * inverse_power(p * p, m - 1) - tail(p, a);
      const double rho2 = p * p + a * a;
      return a * inverse_power(rho2, m) * sum(head_series, a * a / rho2);
    }



    double
    SegmentIntegral::tail(const double p, const double a) const
    {
      if (std::isinf(a))
        return 0.;
      if (a < p)
        return half_line * inverse_power(p * p, m - 1) - head(p, a);
      const double rho2 = p * p + a * a;
      return a * inverse_power(rho2, m) / (m - 1.) *
             sum(tail_series, p * p / rho2);
    }



    double
    SegmentIntegral::operator()(const double p, const Interval &z) const
    {
      if (is_far(p, z))
        return far_integral([](const double) { return 1.; }, m, p, z);
      if (z.begin < 0. && z.end > 0.)
        return m == 1 ? std::asinh(z.end / p) - std::asinh(z.begin / p) :
                        head(p, -z.begin) + head(p, z.end);

      const double near = std::min(std::abs(z.begin), std::abs(z.end));
      const double far  = std::max(std::abs(z.begin), std::abs(z.end));
      if (m == 1)
        {
          const double r_near = std::hypot(p, near), r_far = std::hypot(p, far);
          return std::log1p((far - near) *
                            (1. + (far + near) / (r_far + r_near)) /
                            (near + r_near));
        }
      return near < p ? head(p, far) - head(p, near) :
                        tail(p, near) - tail(p, far);
    }



    PairMeasure::PairMeasure(const Overlap &overlap)
      : PairMeasure(-overlap.shift - overlap.length_2,
                    .5 * overlap.length_1,
                    .5 * overlap.length_2)
    {}



    PairMeasure::PairMeasure(const double gap,
                             const double half_1,
                             const double half_2)
      : plateau(2. * std::min(half_1, half_2))
    {
      const double longer = 2. * std::max(half_1, half_2);
      rise                = {gap, gap + plateau};
      top                 = {gap + plateau, gap + longer};
      fall                = {gap + longer, gap + (longer + plateau)};
    }



    DoubleSegmentIntegral::DoubleSegmentIntegral(const unsigned int exponent)
      : m(exponent)
      , segment(exponent)
    {}



    double
    DoubleSegmentIntegral::ramp(const double p, const Interval &z) const
    {
      if (is_far(p, z))
        return far_integral([&](const double z_i) { return z_i - z.begin; },
                            m,
                            p,
                            z);
      return first_moment(m, p, z) - z.begin * segment(p, z);
    }



    double
    DoubleSegmentIntegral::operator()(const double       p,
                                      const PairMeasure &pairs) const
    {
      const Interval &top = pairs.top;
      double          sum =
        ramp(p, pairs.rise) + ramp(p, {-pairs.fall.end, -pairs.fall.begin});
      if (top.begin < top.end)
        sum += pairs.plateau * segment(p, top);
      return sum;
    }
  } // namespace References
} // namespace Setae
