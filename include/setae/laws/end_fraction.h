// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_laws_end_fraction_h
#define setae_laws_end_fraction_h

#include <setae/base/integer_power.h>
#include <setae/base/jet.h>
#include <setae/laws/line_pairs.h>
#include <setae/laws/nearest_part.h>
#include <setae/laws/short_range.h>
#include <setae/laws/smooth_cutoff.h>

#include <cmath>
#include <limits>

namespace Setae
{
  /**
   * The part of the potential of an infinite straight target that comes from
   * the half of it on this side of its end, at the axial distance z inside the
   * end (negative beyond it).
   *
   * Of a pair of lines at the distance x the half with
   * @f$u=z/x=\tan\theta@f$ has the part
   * @f[ \varphi(u) = \frac12 + \frac{\int_0^\theta\cos^{m-2}}
   *                               {\int_{-\pi/2}^{\pi/2}\cos^{m-2}}, @f]
   * elementary for every m, and the fraction is its mean over all LinePairs. At
   * an angle a section extends along the target, which widens the transition.
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
      , pairs(exponent, sections)
      , far_switch(One(), range.cutoff_begin, range.cutoff)
    {}

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
      // By comparison with sections of all directions
      constexpr double by_edge = .6, by_face = .64;

      const auto near = nearest_part(R1, distance, cosine, tilt);
      const auto part = [&](const Number &depth) -> Number {
        using std::sqrt;
        const Number x = near.distance + depth;
        return of_line(
          Number((z + near.offset) / sqrt(x * x + by_edge * near.edge * depth +
                                          by_face * near.face)));
      };
      return reach(gap, z) * pairs.mean(part, near.distance);
    }

    /** The distance that value() expects, from DiskContact::H. */
    template <typename Number>
    Number
    distance(const Number &H) const
    {
      return distance_of_softened(R1, H);
    }

  private:
    struct One
    {
      template <typename Number>
      Number
      value(const Number &) const
      {
        return 1.;
      }
    };

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

    unsigned int      m;
    double            R1, R2, cutoff;
    double            quarter; ///< integral of cos^(m-2) from 0 to pi / 2
    LinePairs         pairs;
    SmoothCutoff<One> far_switch;
  };
} // namespace Setae

#endif
