// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_laws_end_fraction_h
#define setae_laws_end_fraction_h

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
   * Two parallel sections at a small gap g are full of sheets, at distances
   * @f$x=g/t@f$ with the weights @f$t^{m-11/2}(1-t)^{3/2}dt@f$: their depths and
   * the distance of their edges add up to x - g. Of a sheet at the distance x
   * the half with @f$u=z/x=\tan\theta@f$ has the part
   * @f[ \varphi(u) = \frac12 + \frac{\int_0^\theta\cos^{m-3}}
   *                               {\int_{-\pi/2}^{\pi/2}\cos^{m-3}}, @f]
   * elementary for every m. The midpoint rule in @f$t=\sin^2\vartheta@f$ adds
   * the sheets. At a large gap they move to the distance of the centerlines,
   * scaled to give the density of a line at its end. At an angle a section
   * extends along the target, which widens the transition.
   */
  class EndFraction
  {
  public:
    EndFraction(const unsigned int exponent,
                const SectionPair &sections,
                const GapRange    &range)
      : m(exponent - 1)
      , R1(sections.radius_1)
      , R2(sections.radius_2)
      , cutoff(range.cutoff)
      , quarter(quarter_of(exponent - 1))
      , far_scale(quarter_of(exponent) / quarter)
      , far_switch(One(), range.cutoff_begin, range.cutoff)
    {
      double sum = 0.;
      for (unsigned int k = 0; k < n_sheets; ++k)
        {
          const double theta = .5 * M_PI * (k + .5) / n_sheets;
          const double s = std::sin(theta), c = std::cos(theta);
          sheets.push_back({c * c / (s * s),
                            std::pow(s, 2. * exponent - 10.) * std::pow(c, 4)});
          sum += sheets.back().weight;
        }
      for (Sheet &sheet : sheets)
        sheet.weight /= sum;
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
      return reach(gap, z) *
             sum_of_sheets(
               distance,
               cosine,
               tilt,
               [&](const Number &offset, const Number &width_square) -> Number {
                 return of_sheet(Number((z + offset) / sqrt(width_square)));
               });
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
     * with CutoffSwitch, half of it at z = 0. That is averaged over each sheet,
     * with the density @f$\varphi'(u)@f$ in slices of mean and variance: of one
     * of them the transition is as wide as fading and slice together, measured
     * by their variances.
     */
    template <typename Number>
    Number
    of_fading(const Number &distance,
              const Number &cosine,
              const Number &tilt,
              const Number &z,
              const Number &b) const
    {
      using std::sqrt;
      constexpr double n = 7.; // b^2 / 7 is the variance of the switch
      return sum_of_sheets(
        distance,
        cosine,
        tilt,
        [&](const Number &offset, const Number &width_square) -> Number {
          const Number inside = -(z + offset), x = sqrt(width_square);
          Number       sum = 0.;
          for (const Slice &slice : slices)
            {
              const Number width =
                sqrt(b * b + n * slice.variance * width_square);
              sum += CutoffSwitch(-1., 1.).value(
                Number((inside + slice.mean * x) / width));
            }
          return sum / double(n_slices);
        });
    }

  private:
    static constexpr unsigned int n_sheets = 6, n_slices = 5;
    static constexpr double       smallest = 1e-6;

    struct Sheet
    {
      double depth, weight;
    };

    /** An equal part of the density of a sheet, over its distance. */
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

    /** The integral of @f$\cos^{m-2}@f$ from 0 to @f$\pi/2@f$. */
    static double
    quarter_of(const double m)
    {
      return .5 * std::sqrt(M_PI) * std::tgamma((m - 1.) / 2.) /
             std::tgamma(m / 2.);
    }

    /** Over all sheets of @p part, a function of how far the nearest point is
     * farther inside than the center of the section, and of the square of the
     * distance x. */
    template <typename Number, typename Part>
    Number
    sum_of_sheets(const Number &distance,
                  const Number &cosine,
                  const Number &tilt,
                  const Part   &part) const
    {
      using std::sqrt;
      const Number T = tilt * tilt;
      const Number g =
        .5 *
        (distance + sqrt(distance * distance + R1 * R1 * smallest * smallest));

      // The point of the section that is nearest, and how wide the section is
      // there along the target: by the curvature of its edge and, where it
      // turns its face to the target, by its face.
      const Number C = cosine * cosine, W = R1 * R1 * (1. - T);
      const Number Q      = sqrt(W + g * g);
      const Number offset = R1 * R1 / Q * cosine * tilt;
      const Number edge   = .4 * R1 * R1 / Q * (1. - C - T);
      const Number face   = .5 * R1 * g / Q;

      const Number scale = (R1 + R2 + far_scale * g) / (R1 + R2 + g);

      Number sum = 0.;
      for (const Sheet &sheet : sheets)
        {
          const Number depth =
            (R1 + R2) * sheet.depth * g / (R1 + R2 + sheet.depth * g);
          const Number x = (g + depth) * scale;
          sum +=
            sheet.weight *
            part(offset, Number(x * x + edge * depth + face * face * (1. - C)));
        }
      return sum;
    }

    template <typename Number>
    Number
    of_sheet(const Number &u) const
    {
      using std::atan;
      using std::sqrt;
      const Number c = 1. / sqrt(1. + u * u), s = u * c;
      if (u < -2.)
        return far_beyond(c);
      // The integral of cos^n from that of cos^(n-2), and over a quarter
      unsigned int n     = m % 2;
      Number       part  = n == 0 ? Number(atan(u)) : s;
      Number       power = n == 0 ? c : Number(c * c);
      for (n += 2; n <= m - 2; n += 2)
        {
          part = (power * s + (n - 1.) * part) / double(n);
          power *= c * c;
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
      Number                 power = 1., sum = 0.;
      for (unsigned int k = 0; k < n_terms; ++k)
        {
          sum += power / (m - 1. + 2. * k);
          power *= square * ((k + .5) / (k + 1.));
        }
      for (unsigned int k = 1; k < m; ++k)
        sum = sum * c;
      return sum / (2. * quarter);
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

    unsigned int       m; ///< the exponent of a sheet, one less
    double             R1, R2, cutoff;
    double             quarter;   ///< integral of cos^(m-2) from 0 to pi / 2
    double             far_scale; ///< of a sheet with the end density of a line
    SmoothCutoff<One>  far_switch;
    std::vector<Sheet> sheets;
    std::array<Slice, n_slices> slices;
  };
} // namespace Setae

#endif
