// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_laws_end_fraction_h
#define setae_laws_end_fraction_h

#include <setae/base/integer_power.h>
#include <setae/base/jet.h>
#include <setae/laws/point_potential.h>
#include <setae/laws/short_range.h>
#include <setae/laws/smooth_cutoff.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace Setae
{
  /**
   * The part of the potential of an infinite straight target that comes from
   * the half of it on this side of its end, at the axial distance z inside the
   * end (negative beyond it).
   *
   * Two parallel sections are full of pairs of lines. Of a pair at the distance
   * x the half with @f$u=z/x=\tan\theta@f$ has the part
   * @f[ \varphi(u) = \frac12 + \frac{\int_0^\theta\cos^{m-2}}
   *                               {\int_{-\pi/2}^{\pi/2}\cos^{m-2}}, @f]
   * elementary for every m, of an energy that goes as @f$x^{1-m}@f$. With
   * @f$2S=2(R_1+R_2)@f$ for the range of x from the gap g on, the pairs at the
   * distance x = g + Y are as many as
   * @f[ n(Y)\sim\sqrt x\,\frac{P^2}{(1+aP+bP^2)^{3/4}},\qquad
   *     P=Y\Bigl(1-\frac Y{2S}\Bigr). @f]
   * The fraction is the product of the chords of both sections normal to the
   * gap, of all whose depths add up to Y: a and b give it the right growth at
   * both ends and the right value in the middle. So n is exact next to the gap
   * and on the far sides, and everywhere if the gap is large.
   *
   * The trapezoidal rule in @f$s=\ln\frac Y{1-Y/2S}@f$, for which dY/ds = P,
   * resolves lines and distances z of all magnitudes alike. At an angle a
   * section extends along the target, which widens the transition.
   */
  class EndFraction
  {
  public:
    EndFraction(const unsigned int exponent,
                const SectionPair &sections,
                const GapRange    &range)
      : m(exponent)
      , R1(sections.radius_1)
      , R2(sections.radius_2)
      , cutoff(range.cutoff)
      , quarter(.5 * std::sqrt(M_PI) * std::tgamma((m - 1.) / 2.) /
                std::tgamma(m / 2.))
      , far_switch(One(), range.cutoff_begin, range.cutoff)
    {
      // The product of the chords, summed over all depths that add up to Y, is
      // pi sqrt(R1 R2) Y^2 (1 - Y S / (8 R1 R2)) for small Y. In the middle,
      // where Y = S, it is known for equal radii and for a small one; in
      // between this is right to one percent.
      const double S = R1 + R2, r = std::min(R1, R2), R = std::max(R1, R2);
      const double middle = 2. * M_PI * R * r * r *
                            (1. - (1. - 8. / (3. * M_PI)) * (r / R) * (r / R));
      const double parabola = M_PI * std::sqrt(R1 * R2) * .25 * S * S;
      a                     = 4. / 3. * (S / (8. * R1 * R2) - 1. / S);
      b = (std::pow(parabola / middle, 4. / 3.) - 1. - .5 * a * S) /
          (.25 * S * S);

      for (unsigned int k = 0; k < n_lines; ++k)
        depths.push_back(std::exp(k - 3.));
      slices = make_slices();
    }

    /**
     * The fraction, between zero and one.
     *
     * @param distance From the section to the surface of the infinite target.
     * @param cosine Of the section's normal and the axis, which points inwards.
     */
    template <typename Number>
    Number
    value(const Number &distance,
          const Number &gap,
          const Number &cosine,
          const Number &tilt,
          const Number &z) const
    {
      using std::sqrt;
      const Section<Number> section = this->section(distance, cosine, tilt);
      const Number          nearest = z + section.offset;
      return reach(gap, z) * mean(
                               [&](const Number &depth) -> Number {
                                 const Number x = section.distance + depth;
                                 return of_line(Number(
                                   nearest / sqrt(x * x + section.edge * depth +
                                                  section.face)));
                               },
                               section.distance);
    }

    /** The distance of a disk that is not inclined, from its DiskContact::H. */
    template <typename Number>
    Number
    hardened(const Number &H) const
    {
      using std::sqrt;
      return H + H * H / (sqrt(R1 * R1 + H * H) + R1);
    }

    /**
     * The same for a target that does not end but fades: over the length 2b
     * with CutoffSwitch, half of it at z = 0. That is averaged over the
     * potential of an infinite target along its axis, with the second moment of
     * all lines and the shape of one of them, in slices of mean and variance:
     * of one slice the transition is as wide as fading and slice together,
     * measured by their variances.
     */
    template <typename Number>
    Number
    of_fading(const Number &distance,
              const Number &cosine,
              const Number &tilt,
              const Number &z,
              const Number &b) const
    {
      const Section<Number> section = this->section(distance, cosine, tilt);
      const Number          depth =
        evaluate_reduced([this](const auto &g) { return mean_depth(g); },
                         section.distance);
      const Number square =
        evaluate_reduced([this](const auto &g) { return mean_square(g); },
                         section.distance);
      return evaluate_reduced([this](const auto &...x) { return faded(x...); },
                              Number(z + section.offset),
                              Number(square + section.edge * depth +
                                     section.face),
                              b);
    }

    /** How far inside of where the fading begins it is not seen; a bound. */
    template <typename Number>
    Number
    widest_fading(const Number &distance) const
    {
      // See section(): edge and face add at most 1.24 (R1 + R2)^2 to the mean
      // square of the distance of a line, which is at most that of
      // g + 1.42 (R1 + R2).
      const Slice &last  = slices.back();
      const double slope = last.mean + std::sqrt(7. * last.variance);
      const double sum   = R1 + R2;
      const Number g     = distance > 0. ? distance : Number(0.);
      return R1 + slope * (g + 2.54 * sum);
    }

  private:
    static constexpr unsigned int n_lines = 12, n_slices = 5;
    static constexpr double       smallest = 1e-6;

    /** An equal part of the density of a line, over its distance. */
    struct Slice
    {
      double mean = 0., variance = 0.;
    };

    struct One
    {
      template <typename Number>
      Number
      value(const Number &) const
      {
        return 1.;
      }
    };

    /** @p n angles with equal parts of the density, whose means are taken. */
    std::array<Slice, n_slices>
    make_slices() const
    {
      constexpr unsigned int       n = 20000;
      std::array<Slice, n_slices>  result;
      std::array<double, n_slices> weight = {};
      double                       below  = 0.;
      for (unsigned int k = 0; k < n; ++k)
        {
          const double theta = M_PI * ((k + .5) / n - .5), u = std::tan(theta);
          const double part =
            std::pow(std::cos(theta), m - 2.) * M_PI / (2. * quarter * n);
          const unsigned int i =
            std::min<unsigned int>(n_slices * (below + .5 * part),
                                   n_slices - 1);
          below += part;
          weight[i] += part;
          result[i].mean += part * u;
          result[i].variance += part * u * u;
        }
      for (unsigned int i = 0; i < n_slices; ++i)
        {
          result[i].mean /= weight[i];
          result[i].variance =
            result[i].variance / weight[i] - result[i].mean * result[i].mean;
        }
      return result;
    }

    /** The mean of the switch over the density of all lines. */
    template <typename Number>
    Number
    faded(const Number &z, const Number &x_square, const Number &b) const
    {
      using std::sqrt;
      constexpr double n = 7.; // b^2 / 7 is the variance of the switch
      const Number     x = sqrt(x_square), b_square = b * b;
      Number           sum = 0.;
      for (const Slice &slice : slices)
        sum += CutoffSwitch(-1., 1.).value(
          Number((slice.mean * x - z) /
                 sqrt(b_square + n * slice.variance * x_square)));
      return sum / double(n_slices);
    }

    /** How a section stands before the axis, for all lines. */
    template <typename Number>
    struct Section
    {
      Number distance; ///< positive
      Number offset;   ///< of its nearest point from its center, inwards
      Number edge,
        face; ///< squares of how wide it is there, over a depth and whole
    };

    /**
     * The point of the section that is nearest, and how wide the section is
     * there along the target: by the curvature of its edge and, where it turns
     * its face to the target, by its face.
     */
    template <typename Number>
    Section<Number>
    section(const Number &distance,
            const Number &cosine,
            const Number &tilt) const
    {
      using std::sqrt;
      const Number T = tilt * tilt, C = cosine * cosine, W = R1 * R1 * (1. - T);
      const Number g =
        .5 *
        (distance + sqrt(distance * distance + R1 * R1 * smallest * smallest));
      const Number Q    = sqrt(W + g * g);
      const Number face = .8 * R1 * g / Q;
      return {g,
              R1 * R1 / Q * cosine * tilt,
              .6 * R1 * R1 / Q * (1. - C - T),
              face * face * (1. - C)};
    }

    /** The pairs of lines at one depth Y and how much they count. */
    template <typename Number>
    struct Lines
    {
      Number depth, weight;
    };

    template <typename Number>
    Lines<Number>
    lines_at(const double e, const Number &g) const
    {
      using std::sqrt;
      const double width = 2. * (R1 + R2);
      const Number near  = 1. / (1. + e * g / (g + width)); // 1 - Y / 2S
      const Number y     = e * width * near / (g + width);  // Y / g
      const Number p = y * near, P = g * p, x = 1. + y;
      const Number square = 1. + P * (a + P * b);
      return {g * y,
              p * p * p * sqrt(x / (square * sqrt(square))) /
                integer_power(x, m - 1)};
    }

    /** The mean over all lines of a function of their depth. */
    template <typename Number, typename Function>
    Number
    mean(const Function &function, const Number &g) const
    {
      Number part = 0., all = 0.;
      for (const double e : depths)
        {
          const Number depth = evaluate_reduced(
            [&](const auto &g) { return lines_at(e, g).depth; }, g);
          const Number weight = evaluate_reduced(
            [&](const auto &g) { return lines_at(e, g).weight; }, g);
          part += weight * function(depth);
          all += weight;
        }
      return part / all;
    }

    /** The mean of the depths and that of the squares of x. */
    template <typename Number>
    Number
    mean_depth(const Number &g) const
    {
      return mean([](const Number &depth) { return depth; }, g);
    }

    template <typename Number>
    Number
    mean_square(const Number &g) const
    {
      return mean([&](const Number &depth)
                    -> Number { return (g + depth) * (g + depth); },
                  g);
    }

    /** The part of a line, phi. */
    template <typename Number>
    Number
    of_line(const Number &u) const
    {
      using std::atan;
      using std::sqrt;
      const Number c = 1. / sqrt(1. + u * u), s = u * c, square = c * c;
      if (u < -2.)
        return far_beyond(c);
      // The integral of cos^n from that of cos^(n-2), and over a quarter
      unsigned int n     = m % 2;
      Number       part  = n == 0 ? Number(atan(u)) : s;
      Number       power = n == 0 ? c : square;
      for (n += 2; n <= m - 2; n += 2)
        {
          part = (power * s + (n - 1.) * part) / double(n);
          power *= square;
        }
      return .5 + part / (2. * quarter);
    }

    /** The small rest far beyond the end, in powers of the cosine of theta. */
    template <typename Number>
    Number
    far_beyond(const Number &c) const
    {
      constexpr unsigned int n_terms = 22; // c^2 < 1/5
      const Number           square  = c * c;
      Number                 sum     = 0.;
      for (unsigned int k = n_terms; k > 0; --k)
        sum = 1. / (m + 2. * k - 3.) + square * ((k - .5) / k) * sum;
      return sum * integer_power(c, m - 1) / (2. * quarter);
    }

    /** With its known derivatives, because many are needed. */
    template <unsigned int n>
    Jet<n>
    of_line(const Jet<n> &u) const
    {
      const double v = u.val(), square = 1. / (1. + v * v);
      const double density =
        integer_power(std::sqrt(square), m) / (2. * quarter);
      return Jet<n>::template function<1>(
        {{u}},
        Jet<1>(of_line(v), {{density}}, {{-(m * v * square * density)}}));
    }

    /** Switches off beyond the end where the end is farther than the cutoff. */
    template <typename Number>
    Number
    reach(const Number &gap, const Number &z) const
    {
      using std::sqrt;
      if (!(z < 0.) || !(cutoff < std::numeric_limits<double>::infinity()))
        return 1.;
      const Number d = gap + (R1 + R2);
      const Number far =
        far_switch.value(Number(sqrt(d * d + z * z) - R1 - R2));
      const Number y = -10. / cutoff * z;
      if (y >= 1.)
        return far;
      return 1. - (1. - far) * y * y * y * (10. - y * (15. - 6. * y));
    }

    unsigned int        m;
    double              R1, R2, cutoff;
    double              quarter; ///< integral of cos^(m-2) from 0 to pi / 2
    double              a, b;
    SmoothCutoff<One>   far_switch;
    std::vector<double> depths; ///< Y / (1 - Y / 2S) over 1 / (1 / g + 1 / 2S)
    std::array<Slice, n_slices> slices;
  };
} // namespace Setae

#endif
