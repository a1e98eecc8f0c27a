// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_verification_segments_h
#define setae_verification_segments_h

#include <limits>
#include <vector>

namespace Setae
{
  namespace References
  {
    /** @f$r^{-m}@f$ of the square of a distance. */
    double
    inverse_power(double distance_square, unsigned int exponent);



    /** The factor between a line of points and one point,
     * @f[ \int_{-\infty}^{\infty}(x^2+z^2)^{-m/2}\,dz =
     *     \frac{\sqrt\pi\,\Gamma(\frac{m-1}2)}{\Gamma(\frac m2)}\,x^{1-m},
     *     \qquad m\ge 2. @f]
     */
    double
    line_factor(unsigned int exponent);



    /**
     * Of a straight segment parallel to z: where it begins and ends. Infinite
     * bounds are allowed.
     */
    struct Interval
    {
      double begin = -std::numeric_limits<double>::infinity();
      double end   = std::numeric_limits<double>::infinity();
    };

    /**
     * The integral of (p^2+z^2)^(-m/2) over an interval of z, without
     * cancellation far from it. Infinite intervals need m >= 2.
     *
     * For @f$0<a<p@f$ and @f$\rho^2=p^2+a^2@f$ the part from 0 to a is
     * @f$a\rho^{-m}F(1,\frac m2;\frac32;\frac{a^2}{\rho^2})@f$, and for
     * @f$a\ge p@f$ the rest to infinity is
     * @f$\frac{a\rho^{-m}}{m-1}F(1,\frac m2;\frac{m+1}2;\frac{p^2}{\rho^2})@f$;
     * all terms of both series are positive.
     */
    class SegmentIntegral
    {
    public:
      explicit SegmentIntegral(unsigned int exponent);

      double
      operator()(double p, const Interval &z) const;

    private:
      /** From 0 to @p a. */
      double
      head(double p, double a) const;

      /** From @p a to infinity. */
      double
      tail(double p, double a) const;

      unsigned int m;
      double       half_line; ///< half of line_factor(), finite if m >= 2
      std::vector<double> head_series;
      std::vector<double> tail_series;
    };



    /** How two parallel cylinders of finite length lie side by side. */
    struct Overlap
    {
      double length_1;
      double length_2;
      double shift = 0.; ///< from the begin of the source to that of the target
    };

    /**
     * The measure of the pairs of points of two parallel segments by z = z1-z2:
     * it rises from zero to the length of the shorter segment, stays there and
     * falls again.
     */
    struct PairMeasure
    {
      explicit PairMeasure(const Overlap &overlap);

      /**
       * Of two segments of which one begins where the other one ends but for a
       * gap, as long as it is; a negative one if they are side by side.
       *
       * @param half_1, half_2 Half of their lengths.
       */
      PairMeasure(double gap, double half_1, double half_2);

      double   plateau; ///< length of the shorter segment
      Interval rise, top, fall;
    };

    /**
     * The integral of (p^2+(z1-z2)^2)^(-m/2) over two parallel segments. Any
     * exponent m >= 1.
     */
    class DoubleSegmentIntegral
    {
    public:
      explicit DoubleSegmentIntegral(unsigned int exponent);

      double
      operator()(double p, const PairMeasure &pairs) const;

    private:
      /** With z - z.begin as weight. */
      double
      ramp(double p, const Interval &z) const;

      unsigned int    m;
      SegmentIntegral segment;
    };
  } // namespace References
} // namespace Setae

#endif
