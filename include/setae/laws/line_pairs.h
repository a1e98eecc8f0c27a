// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_laws_line_pairs_h
#define setae_laws_line_pairs_h

#include <setae/base/integer_power.h>
#include <setae/base/jet.h>
#include <setae/laws/point_potential.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace Setae
{
  /**
   * The pairs of lines that two parallel sections are full of, as they count
   * for an energy that goes as @f$x^{1-m}@f$ with their distance x.
   *
   * With @f$2S=2(R_1+R_2)@f$ for the range of x from the gap g on, the pairs at
   * the distance x = g + Y are as many as
   * @f[ n(Y)\sim\sqrt x\,\frac{P^2}{(1+aP+bP^2)^{3/4}},\qquad
   *     P=Y\Bigl(1-\frac Y{2S}\Bigr). @f]
   * The fraction is the product of the chords of both sections normal to the
   * gap, of all whose depths add up to Y: a and b give it the right growth at
   * both ends and the right value in the middle. So n is exact next to the gap
   * and on the far sides, and some percent off in between.
   *
   * The trapezoidal rule in @f$s=\ln\frac Y{1-Y/2S}@f$, for which dY/ds = P,
   * resolves lines of all magnitudes alike.
   */
  class LinePairs
  {
  public:
    LinePairs(const unsigned int exponent, const SectionPair &sections)
      : m(exponent)
      , width(2. * (sections.radius_1 + sections.radius_2))
    {
      // The product of the chords, summed over all depths that add up to Y, is
      // pi sqrt(R1 R2) Y^2 (1 - Y S / (8 R1 R2)) for small Y. In the middle,
      // where Y = S, it is known for equal radii and for a small one; in
      // between this is right to one percent.
      const double R1 = sections.radius_1, R2 = sections.radius_2;
      const double S = R1 + R2, r = std::min(R1, R2), R = std::max(R1, R2);
      const double middle = 2. * M_PI * R * r * r *
                            (1. - (1. - 8. / (3. * M_PI)) * (r / R) * (r / R));
      const double parabola = M_PI * std::sqrt(R1 * R2) * .25 * S * S;
      a                     = 4. / 3. * (S / (8. * R1 * R2) - 1. / S);
      b = (std::pow(parabola / middle, 4. / 3.) - 1. - .5 * a * S) /
          (.25 * S * S);
      for (unsigned int k = 0; k < n_lines; ++k)
        depths[k] = std::exp(k - 3.);
    }

    /** The mean over all pairs at the gap @p g of a function of their depth. */
    template <typename Number, typename Function>
    Number
    mean(const Function &function, const Number &g) const
    {
      Number part = 0., all = 0.;
      for (const double depth : depths)
        {
          const Pairs<Number> pairs = composed_pairs(depth, g);
          part += pairs.weight * function(pairs.depth);
          all += pairs.weight;
        }
      return part / all;
    }

    /** The means of Y and of x^2. */
    template <typename Number>
    struct Moments
    {
      Number depth, square;
    };

    template <typename Number>
    Moments<Number>
    moments(const Number &g) const
    {
      Number depth = 0., square = 0., all = 0.;
      for (const double d : depths)
        {
          const Pairs<Number> pairs = pairs_at(d, g);
          const Number        x     = g + pairs.depth;
          depth += pairs.weight * pairs.depth;
          square += pairs.weight * (x * x);
          all += pairs.weight;
        }
      return {depth / all, square / all};
    }

    /** Functions of one variable, of which the derivatives are enough. */
    template <unsigned int n>
    Moments<Jet<n>>
    moments(const Jet<n> &g) const
    {
      const auto of_g = moments<Jet<1>>(Jet<1>::variable(0, g.val()));
      return {Jet<n>::template function<1>({{g}}, of_g.depth),
              Jet<n>::template function<1>({{g}}, of_g.square)};
    }

  private:
    static constexpr unsigned int n_lines = 12;

    /** Those at one depth Y and how much they count. */
    template <typename Number>
    struct Pairs
    {
      Number depth, weight;
    };

    /** @param depth Y / (1 - Y / 2S) over 1 / (1 / g + 1 / 2S) */
    template <typename Number>
    Pairs<Number>
    pairs_at(const double depth, const Number &g) const
    {
      using std::sqrt;
      const Number near = 1. / (1. + depth * g / (g + width)); // 1 - Y / 2S
      const Number y    = depth * width * near / (g + width);  // Y / g
      const Number p = y * near, P = g * p, x = 1. + y;
      const Number square = 1. + P * (a + P * b);
      return {g * y,
              p * p * p * sqrt(x / (square * sqrt(square))) /
                integer_power(x, m - 1)};
    }

    template <typename Number>
    Pairs<Number>
    composed_pairs(const double depth, const Number &g) const
    {
      return pairs_at(depth, g);
    }

    template <unsigned int n>
    Pairs<Jet<n>>
    composed_pairs(const double depth, const Jet<n> &g) const
    {
      const auto of_g = pairs_at(depth, Jet<1>::variable(0, g.val()));
      return {Jet<n>::template function<1>({{g}}, of_g.depth),
              Jet<n>::template function<1>({{g}}, of_g.weight)};
    }

    unsigned int                m;
    double                      width; ///< 2S
    double                      a, b;
    std::array<double, n_lines> depths;
  };
} // namespace Setae

#endif
