// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_laws_fading_fraction_h
#define setae_laws_fading_fraction_h

#include <setae/base/jet.h>
#include <setae/laws/line_pairs.h>
#include <setae/laws/nearest_part.h>
#include <setae/laws/smooth_cutoff.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace Setae
{
  /**
   * The part of the potential of an infinite straight target that is left of
   * it if it does not end but fades: over the length 2b with CutoffSwitch, half
   * of it at z = 0.
   *
   * The potential of a target stretches along its axis. Of a pair of lines at
   * the distance x it does so with the density @f$(1+u^2)^{-m/2}@f$ in u over x
   * and the variance @f$x^2/(m-3)@f$; the mean over all LinePairs and what a
   * section extends along the axis itself is the variance
   * @f[ \sigma^2 = \frac{\overline{x^2}}{m-3} + \beta e\,\overline Y, @f]
   * e being the square over depth of NearestPart. Its shape is taken to be that
   * of one line, in slices. Of one slice the transition is as
   * wide as fading and slice together, measured by their variances: the part is
   * exact to second order in sigma / b, always between zero and one, and has
   * two continuous derivatives.
   *
   * For sections that cross, beta tends to 1/3 as the gap closes, for every m
   * > 6: along the axis the edge of a disk is at @f$y^2=2R_1Y@f$. At gaps that
   * are not so small @f$\beta=5/12-1/m@f$ is better, found by comparison with
   * the second moments of crossing sections.
   */
  class FadingFraction
  {
  public:
    FadingFraction(const unsigned int exponent, const SectionPair &sections)
      : m(exponent)
      , R1(sections.radius_1)
      , R2(sections.radius_2)
      , edge_variance(5. / 12. - 1. / exponent)
      , pairs(exponent, sections)
      , slices(make_slices())
    {}

    /**
     * @param distance From the section to the surface of the infinite target.
     * @param cosine Of the section's normal and the axis, which points inwards.
     */
    template <typename Number>
    Number
    value(const Number &distance,
          const Number &cosine,
          const Number &tilt,
          const Number &z,
          const Number &b) const
    {
      const auto near    = nearest_part(R1, distance, cosine, tilt);
      const auto moments = pairs.moments(near.distance);
      return evaluate_reduced(
        [this](const auto &...x) { return mean_of_slices(x...); },
        Number(z + near.offset),
        Number(moments.square / (m - 3.) +
               edge_variance * near.edge * moments.depth),
        b);
    }

    /** How far inside of where the fading begins it is not seen; a bound. */
    template <typename Number>
    Number
    reach(const Number &distance) const
    {
      // The mean of x^2 is at most (g + 1.42 S)^2, and e Y less than 2 S R1.
      const Slice &last  = slices.back();
      const double slope = last.mean + std::sqrt(n * last.variance);
      const double S     = R1 + R2;
      const Number g     = distance > 0. ? distance : Number(0.);
      return R1 + slope * ((g + 1.42 * S) / std::sqrt(m - 3.) +
                           std::sqrt(2. * edge_variance * S * R1));
    }

    /** The distance that value() expects, from DiskContact::H. */
    template <typename Number>
    Number
    distance(const Number &H) const
    {
      return distance_of_softened(R1, H);
    }

  private:
    static constexpr unsigned int n_slices = 7;
    static constexpr double       n = 7.; ///< b^2 / n is the switch's variance

    /** A part of a line's density, scaled to variance one. */
    struct Slice
    {
      double part = 0., mean = 0., variance = 0.;
    };

    /** Thinner ones farther out. */
    std::array<Slice, n_slices>
    make_slices() const
    {
      constexpr unsigned int       n_points = 2000;
      std::array<double, n_points> u, weight;
      double                       all = 0.;
      for (unsigned int k = 0; k < n_points; ++k)
        {
          const double theta = M_PI * ((k + .5) / n_points - .5);
          u[k]               = std::tan(theta) * std::sqrt(m - 3.);
          weight[k]          = std::pow(std::cos(theta), m - 2.);
          all += weight[k];
        }

      std::array<Slice, n_slices> result;
      double                      below = 0.;
      unsigned int                i     = 0;
      for (unsigned int k = 0; k < n_points; ++k)
        {
          below += weight[k] / all;
          while (i + 1 < n_slices &&
                 below > .5 * (1. - std::cos(M_PI * (i + 1) / n_slices)))
            ++i;
          result[i].part += weight[k] / all;
          result[i].mean += weight[k] / all * u[k];
          result[i].variance += weight[k] / all * u[k] * u[k];
        }
      for (Slice &slice : result)
        {
          slice.mean /= slice.part;
          slice.variance =
            slice.variance / slice.part - slice.mean * slice.mean;
        }
      return result;
    }

    template <typename Number>
    Number
    mean_of_slices(const Number &z,
                   const Number &variance,
                   const Number &b) const
    {
      using std::sqrt;
      const Number sigma = sqrt(variance), b_square = b * b;
      Number       sum = 0.;
      for (const Slice &slice : slices)
        sum += slice.part * CutoffSwitch(-1., 1.).value(Number(
                              (slice.mean * sigma - z) /
                              sqrt(b_square + n * slice.variance * variance)));
      return sum;
    }

    double                      m, R1, R2;
    double                      edge_variance; ///< beta
    LinePairs                   pairs;
    std::array<Slice, n_slices> slices;
  };
} // namespace Setae

#endif
