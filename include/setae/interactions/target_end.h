// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_interactions_target_end_h
#define setae_interactions_target_end_h

#include <setae/base/jet.h>
#include <setae/interactions/site_projection.h>
#include <setae/kinematics/closest_point.h>
#include <setae/kinematics/gap_angle.h>
#include <setae/laws/end_fraction.h>
#include <setae/laws/flat_end.h>

#include <algorithm>
#include <limits>
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
   * The laws of a target that ends. Beside the target, that of each power of
   * the point potential counts times the part of an infinite target that exists
   * (EndFraction); in front of its end, FlatEnd takes over.
   *
   * All depends on @f$|d|^2@f$, @f$t_1\cdot d@f$ and @f$t_1\cdot t_2@f$ with
   * @f$d=r_1-r_2@f$ normal to the target, which are smooth where a site is on
   * its axis, on the coordinate of the closest point and on the length of the
   * derivative of the target there.
   */
  template <typename Law>
  class TargetEnd
  {
  public:
    /** The law of one power of the point potential and its end. */
    struct Term
    {
      Law         law;
      EndFraction fraction;
      FlatEnd     flat_end;
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

    /** Whether a site has an infinite surrogate beside it. */
    bool
    has_side(const double square) const
    {
      return terms[0].flat_end.has_side(square);
    }

    /** The distance from the ends of the target; a lower bound. */
    double
    clearance(const FiberEnds &ends,
              const double     x,
              const double     square,
              const double     along,
              const GapAngle  &geometry) const
    {
      const double c = geometry.cosine, length = geometry.length_2;
      double       result = -std::numeric_limits<double>::infinity();
      if (ends.left)
        result =
          std::max(result,
                   terms[0].flat_end.clearance({square, along, c, x * length}));
      if (ends.right)
        result = std::max(result,
                          terms[0].flat_end.clearance(
                            {square, along, -c, (1. - x) * length}));
      return result;
    }

    /** Energy of a site at the coordinate @p x, times @p weight. */
    EndEnergy
    energy(const FiberEnds &ends,
           const double     x,
           const GapAngle  &geometry,
           const double     weight) const
    {
      const auto evaluate = [](const Law       &law,
                               const Variables &gap,
                               const Variables &cosine,
                               const Variables &tilt) {
        if constexpr (has_tilt)
          return compose(law(gap.val(), cosine.val(), tilt.val()),
                         gap,
                         cosine,
                         tilt);
        else
          {
            const GapAngleDerivatives e = law(gap.val(), cosine.val());
            GapAngleTiltDerivatives   f;
            f.value = e.value, f.g = e.g, f.c = e.c;
            f.gg = e.gg, f.gc = e.gc, f.cc = e.cc;
            return compose(f, gap, cosine, tilt);
          }
      };
      return chain(weight *
                     value(ends,
                           Variables::variable(0, geometry.d * geometry.d),
                           Variables::variable(1, geometry.d * geometry.t1),
                           Variables::variable(2, geometry.cosine),
                           Variables::variable(3, x),
                           Variables::variable(4, geometry.length_2),
                           evaluate),
                   geometry);
    }

    /**
     * The sum of the terms on any number type. @p evaluate returns the energy
     * of a law at gap, cosine and tilt.
     */
    template <typename Number, typename Evaluate>
    Number
    value(const FiberEnds &ends,
          const Number    &square,
          const Number    &along,
          const Number    &cosine,
          const Number    &x,
          const Number    &length,
          const Evaluate  &evaluate) const
    {
      using std::sqrt;
      Number sum = 0.;
      for (const Term &term : terms)
        {
          const FlatEnd &flat_end = term.flat_end;
          Number         gap = 0., tilt = 0., H = 0.;
          if (flat_end.has_side(square))
            {
              const Number distance = sqrt(square);
              gap                   = flat_end.gap(distance);
              tilt                  = along / distance;
              if constexpr (has_tilt)
                H = term.law.softened_distance(gap, cosine, tilt);
              else if (gap > 0.)
                H = flat_end.softened(gap);
            }
          Number     side_share = 1., missing = 0.;
          const auto add_end = [&](const Number &inwards, const Number &x) {
            const Number z = x * length;
            const auto   front =
              flat_end.front(FlatEnd::Pose<Number>{square, along, inwards, z},
                             H);
            sum += front.energy;
            side_share = side_share - (1. - front.side_share);
            if (front.side_share > 0.)
              missing +=
                switched(Number(1. -
                                term.fraction.value(
                                  flat_end.hardened(H), gap, inwards, tilt, z)),
                         x,
                         ends);
          };
          if (ends.left)
            add_end(cosine, x);
          if (ends.right)
            add_end(Number(-cosine), Number(1. - x));
          if (side_share > 0. && flat_end.has_side(square))
            sum += side_share * (1. - missing) *
                   evaluate(term.law, gap, cosine, tilt);
        }
      return sum;
    }

  private:
    using Variables = Jet<5>; // of |d|^2, t1.d, cosine, x, |a2|

    static constexpr bool has_tilt =
      std::is_invocable_v<Law, double, double, double>;

    /**
     * The effect of an end is switched off towards the inner node of its cell,
     * because no other cell knows of it.
     */
    template <typename Number>
    static Number
    switched(const Number &missing, const Number &x, const FiberEnds &ends)
    {
      const Number y = 2. - 2. * x;
      if ((ends.left && ends.right) || y >= 1.)
        return missing;
      if (!(y > 0.))
        return 0.;
      return missing * (y * y * y * (10. - y * (15. - 6. * y)));
    }

    /** A law of three variables that themselves have derivatives. */
    static Variables
    compose(const GapAngleTiltDerivatives &f,
            const Variables               &g,
            const Variables               &c,
            const Variables               &t)
    {
      const Variables G = g - g.val(), C = c - c.val(), T = t - t.val();
      return f.value + f.g * G + f.c * C + f.t * T +
             .5 * (f.gg * (G * G) + f.cc * (C * C) + f.tt * (T * T)) +
             f.gc * (G * C) + f.gt * (G * T) + f.ct * (C * T);
    }

    /** The chain rule to the four vectors and the explicit coordinate. */
    static EndEnergy
    chain(const Variables &f, const GapAngle &geometry)
    {
      using namespace PointPairIndex;
      constexpr unsigned int n = 4, coordinate = 3;
      constexpr unsigned int variables[n] = {0, 1, 2, 4};

      // The gradients of |d|^2, s = t1.d, cosine and |a2| in the four vectors
      const auto        &d = geometry.d, &t1 = geometry.t1, &t2 = geometry.t2;
      const double       c = geometry.cosine, s = d * t1;
      const double       l1 = geometry.length_1, l2 = geometry.length_2;
      const Tensor<1, 3> q = d - s * t1, w1 = t2 - c * t1, w2 = t1 - c * t2;
      std::array<std::array<Tensor<1, 3>, 4>, n> G;
      G[0][r1] = 2. * d;
      G[0][r2] = -2. * d;
      G[1][r1] = t1;
      G[1][r2] = -t1;
      G[1][a1] = q / l1;
      G[2][a1] = w1 / l1;
      G[2][a2] = w2 / l2;
      G[3][a2] = t2;

      EndEnergy result;
      auto     &gradient   = result.pair.gradient;
      auto     &H          = result.pair.hessian;
      result.pair.value    = f.val();
      result.coordinate.x  = f.d(coordinate);
      result.coordinate.xx = f.dd(coordinate, coordinate);
      for (unsigned int k = 0; k < n; ++k)
        {
          const unsigned int i = variables[k];
          for (unsigned int v = 0; v < 4; ++v)
            {
              gradient[v] += f.d(i) * G[k][v];
              result.coordinate.gradient_x[v] +=
                f.dd(std::max(i, coordinate), std::min(i, coordinate)) *
                G[k][v];
            }
          for (unsigned int l = 0; l < n; ++l)
            {
              const unsigned int j    = variables[l];
              const double       f_ij = f.dd(std::max(i, j), std::min(i, j));
              for (unsigned int v = 0; v < 4; ++v)
                for (unsigned int w = 0; w < 4; ++w)
                  H[v][w] += f_ij * outer_product(G[k][v], G[l][w]);
            }
        }

      // Their second derivatives
      const double f_s = f.d(1), f_c = f.d(2);
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = 0; j < 3; ++j)
          {
            const double I  = i == j ? 1. : 0.;
            const double I1 = I - t1[i] * t1[j], I2 = I - t2[i] * t2[j];

            const double rr = 2. * f.d(0) * I, ra = f_s / l1 * I1;
            H[r1][r1][i][j] += rr;
            H[r2][r2][i][j] += rr;
            H[r1][r2][i][j] -= rr;
            H[r2][r1][i][j] -= rr;
            H[r1][a1][i][j] += ra;
            H[a1][r1][i][j] += ra;
            H[r2][a1][i][j] -= ra;
            H[a1][r2][i][j] -= ra;
            H[a1][a1][i][j] -=
              (f_s * (q[i] * t1[j] + t1[i] * q[j] + s * I1) +
               f_c * (w1[i] * t1[j] + t1[i] * w1[j] + c * I1)) /
              (l1 * l1);
            H[a2][a2][i][j] +=
              f.d(4) / l2 * I2 -
              f_c * (w2[i] * t2[j] + t2[i] * w2[j] + c * I2) / (l2 * l2);
            const double a1a2 =
              f_c / (l1 * l2) * (I1 - t2[i] * t2[j] + c * t1[i] * t2[j]);
            H[a1][a2][i][j] += a1a2;
            H[a2][a1][j][i] += a1a2;
          }
      return result;
    }

    std::vector<Term> terms;
  };
} // namespace Setae

#endif
