// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_laws_end_fraction_h
#define setae_laws_end_fraction_h

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
      const Section<Number> section = this->section(distance, cosine, tilt);
      const Number          nearest = z + section.offset;
      return reach(gap, z) * mean<Number>([&](const Sheet &sheet) -> Number {
               const Number x = x_of(sheet, section.distance);
               return of_sheet(Number(
                 nearest /
                 sqrt(x * x + section.edge * depth_of(sheet, section.distance) +
                      section.face)));
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
     * with CutoffSwitch, half of it at z = 0. That is averaged over the
     * potential of an infinite target along its axis, with the second moment of
     * all sheets and the shape of one of them, in slices of mean and variance:
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
      // See section(): edge and face add at most 0.65 (R1 + R2)^2 to the square
      // of the distance of a sheet, which is at most g + R1 + R2 before
      // scaling.
      const Slice &last  = slices.back();
      const double slope = last.mean + std::sqrt(7. * last.variance);
      const double sum   = R1 + R2;
      const Number g     = distance > 0. ? distance : Number(0.);
      return R1 + slope * (std::max(1., far_scale) * (g + sum) + .81 * sum);
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

    /** The mean of the switch over the density of all sheets. */
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

    /** How a section stands before the axis, for all sheets. */
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
      const Number face = .5 * R1 * g / Q;
      return {g,
              R1 * R1 / Q * cosine * tilt,
              .4 * R1 * R1 / Q * (1. - C - T),
              face * face * (1. - C)};
    }

    template <typename Number>
    Number
    depth_of(const Sheet &sheet, const Number &g) const
    {
      return (R1 + R2) * sheet.depth * g / (R1 + R2 + sheet.depth * g);
    }

    /** The distance of a sheet, as it counts for the transition. */
    template <typename Number>
    Number
    x_of(const Sheet &sheet, const Number &g) const
    {
      return (g + depth_of(sheet, g)) * (R1 + R2 + far_scale * g) /
             (R1 + R2 + g);
    }

    /** The mean over all sheets of a function that returns a Number. */
    template <typename Number, typename Function>
    Number
    mean(const Function &function) const
    {
      Number sum = 0.;
      for (const Sheet &sheet : sheets)
        sum += sheet.weight * function(sheet);
      return sum;
    }

    /** The mean of the depths and that of the squares of x. */
    template <typename Number>
    Number
    mean_depth(const Number &g) const
    {
      return mean<Number>(
        [&](const Sheet &sheet) { return depth_of(sheet, g); });
    }

    template <typename Number>
    Number
    mean_square(const Number &g) const
    {
      return mean<Number>([&](const Sheet &sheet) -> Number {
        const Number x = x_of(sheet, g);
        return x * x;
      });
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
