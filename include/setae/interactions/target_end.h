// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_interactions_target_end_h
#define setae_interactions_target_end_h

#include <setae/base/jet.h>
#include <setae/interactions/site_projection.h>
#include <setae/kinematics/closest_point.h>
#include <setae/kinematics/gap_angle.h>
#include <setae/laws/end_fraction.h>

#include <type_traits>
#include <utility>
#include <vector>

namespace Setae
{
  /** Energy of a site before a target that ends. */
  struct EndEnergy
  {
    PointPairEnergy       pair;
    CoordinateDerivatives coordinate;
  };


  /**
   * The laws of a target that ends: that of each power of the point potential
   * times the part of an infinite target that exists (EndFraction), which
   * depends on the coordinate of the closest point and on the length of the
   * derivative of the target there.
   */
  template <typename Law>
  class TargetEnd
  {
  public:
    /** The law of one power of the point potential and its part. */
    struct Term
    {
      Law         law;
      EndFraction fraction;
    };

    explicit TargetEnd(std::vector<Term> terms)
      : terms(std::move(terms))
    {}

    /** Whether the ends of a target are treated as such. */
    bool
    is_finite() const
    {
      return !terms.empty();
    }

    /** Whether they matter in a cell with these ends. */
    bool
    is_finite(const FiberEnds &ends) const
    {
      return !terms.empty() && (ends.left || ends.right);
    }

    /** Energy of a site at the coordinate @p x, times @p weight. */
    EndEnergy
    energy(const FiberEnds &ends,
           const double     x,
           const GapAngle  &geometry,
           const double     weight) const
    {
      return chain(sum(ends, x, geometry, weight), geometry);
    }

    /**
     * The sum of the terms on any number type. @p evaluate returns the energy
     * of a law there.
     */
    template <typename Number, typename Evaluate>
    Number
    value(const FiberEnds &ends,
          const Number    &gap,
          const Number    &cosine,
          const Number    &tilt,
          const Number    &x,
          const Number    &length,
          const Evaluate  &evaluate) const
    {
      Number sum = 0.;
      for (const Term &term : terms)
        sum += evaluate(term.law) *
               existing_part(term.fraction, ends, gap, cosine, tilt, x, length);
      return sum;
    }

  private:
    using Variables = Jet<5>; // of gap, cosine, tilt, x, |a2|

    /**
     * What a target that ends on the left, on the right or on both sides of a
     * cell contributes of an infinite one. The length of the remaining part is
     * measured by the tangent at the closest point. The effect of an end is
     * switched off towards the inner node of its cell, because no other cell
     * knows of it.
     */
    template <typename Number>
    static Number
    existing_part(const EndFraction &fraction,
                  const FiberEnds   &ends,
                  const Number      &gap,
                  const Number      &cosine,
                  const Number      &tilt,
                  const Number      &x,
                  const Number      &length)
    {
      const bool is_fiber = ends.left && ends.right;
      Number     result   = 1.;
      const auto subtract = [&](const Number &x) {
        Number missing =
          1. - fraction.value(gap, cosine, tilt, Number(x * length));
        const Number y = 2. - 2. * x;
        if (!is_fiber && !(y > 0.))
          missing = 0.;
        else if (!is_fiber && y < 1.)
          missing = missing * (y * y * y * (10. - y * (15. - 6. * y)));
        result = result - missing;
      };
      if (ends.left)
        subtract(x);
      if (ends.right)
        subtract(Number(1. - x));
      return result;
    }

    Variables
    sum(const FiberEnds &ends,
        const double     x,
        const GapAngle  &geometry,
        const double     weight) const
    {
      using Number = Variables;
      Number sum   = 0.;
      for (const Term &term : terms)
        {
          GapAngleTiltDerivatives f;
          if constexpr (std::is_invocable_v<Law, double, double, double>)
            f = term.law(geometry.gap, geometry.cosine, geometry.tilt);
          else
            {
              const GapAngleDerivatives e =
                term.law(geometry.gap, geometry.cosine);
              f.value = e.value, f.g = e.g, f.c = e.c;
              f.gg = e.gg, f.gc = e.gc, f.cc = e.cc;
            }
          const Number law(weight * f.value,
                           {{weight * f.g, weight * f.c, weight * f.t}},
                           {{weight * f.gg,
                             weight * f.gc,
                             weight * f.cc,
                             weight * f.gt,
                             weight * f.ct,
                             weight * f.tt}});
          sum += law * existing_part(term.fraction,
                                     ends,
                                     Number::variable(0, geometry.gap),
                                     Number::variable(1, geometry.cosine),
                                     Number::variable(2, geometry.tilt),
                                     Number::variable(3, x),
                                     Number::variable(4, geometry.length_2));
        }
      return sum;
    }

    /** The chain rule to the four vectors and the explicit coordinate. */
    static EndEnergy
    chain(const Variables &sum, const GapAngle &geometry)
    {
      using namespace PointPairIndex;
      const GapAngleTiltDerivatives f = {sum.val(),
                                         sum.d(0),
                                         sum.d(1),
                                         sum.d(2),
                                         sum.dd(0, 0),
                                         sum.dd(1, 0),
                                         sum.dd(2, 0),
                                         sum.dd(1, 1),
                                         sum.dd(2, 1),
                                         sum.dd(2, 2)};
      EndEnergy                     result{geometry.energy(f, true), {}};

      // The gradients of gap, cosine and tilt, and the one of the length, t2.
      const auto        &n = geometry.n, &t1 = geometry.t1, &t2 = geometry.t2;
      const Tensor<1, 3> m = (t1 - geometry.tilt * n) / geometry.distance;
      const auto         gradient =
        [&](const double g, const double c, const double t) {
          std::array<Tensor<1, 3>, 4> v;
          v[r1] = g * n + t * m;
          v[r2] = -v[r1];
          v[a1] =
            (c * (t2 - geometry.cosine * t1) + t * (n - geometry.tilt * t1)) /
            geometry.length_1;
          v[a2] = c / geometry.length_2 * (t1 - geometry.cosine * t2);
          return v;
        };
      const auto by_length = gradient(sum.dd(4, 0), sum.dd(4, 1), sum.dd(4, 2));
      result.pair.gradient[a2] += sum.d(4) * t2;
      for (unsigned int v = 0; v < 4; ++v)
        for (unsigned int i = 0; i < 3; ++i)
          for (unsigned int j = 0; j < 3; ++j)
            {
              result.pair.hessian[v][a2][i][j] += by_length[v][i] * t2[j];
              result.pair.hessian[a2][v][j][i] += by_length[v][i] * t2[j];
            }
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = 0; j < 3; ++j)
          result.pair.hessian[a2][a2][i][j] +=
            sum.dd(4, 4) * t2[i] * t2[j] +
            sum.d(4) / geometry.length_2 * ((i == j) - t2[i] * t2[j]);

      result.coordinate.x  = sum.d(3);
      result.coordinate.xx = sum.dd(3, 3);
      result.coordinate.gradient_x =
        gradient(sum.dd(3, 0), sum.dd(3, 1), sum.dd(3, 2));
      result.coordinate.gradient_x[a2] += sum.dd(4, 3) * t2;
      return result;
    }

    std::vector<Term> terms;
  };
} // namespace Setae

#endif
