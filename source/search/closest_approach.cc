// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <setae/search/closest_approach.h>
#include <setae/search/hull_distance.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>

namespace Setae
{
  namespace
  {
    /**
     * How much the derivative of a part changes, relative to its mean, for the
     * part to count as almost straight.
     */
    constexpr double almost_straight = .1;

    /** No part is shorter than this in its cell, also where it has a cusp. */
    constexpr double shortest = 1. / 1024;

    /** Bounds that differ by less are equal up to round-off. */
    constexpr double round_off = 1e-14;

    bool
    is_simple(const CubicPart &part)
    {
      if (part.end - part.begin <= shortest)
        return true;
      const auto        &P      = part.points;
      const Tensor<1, 3> mean   = (P[3] - P[0]) / 3.;
      double             square = 0.;
      for (unsigned int k = 0; k < 3; ++k)
        square = std::max(square, (P[k + 1] - P[k] - mean).norm_square());
      return square <= almost_straight * almost_straight * mean.norm_square();
    }

    /**
     * About where a part is nearest to a point: on its chord, then two steps of
     * Newton's method.
     */
    double
    nearest(const CubicPart &part, const Tensor<1, 3> &point)
    {
      const Tensor<1, 3> chord = part.points[3] - part.points[0];
      double t = internal::minimizer(chord * (point - part.points[0]),
                                     chord.norm_square());
      for (unsigned int i = 0; i < 2; ++i)
        {
          const Tensor<1, 3> d   = point - part.position(t),
                             b   = part.derivative(t);
          const double curvature = b * b - d * part.second_derivative(t);
          if (curvature <= 0.)
            break;
          t = std::clamp(t + d * b / curvature, 0., 1.);
        }
      return t;
    }

    /** A pair of coordinates on two parts and half the squared distance. */
    struct Candidate
    {
      double s, t, value;
    };

    Candidate
    evaluate(const CubicPart &first,
             const CubicPart &second,
             const double     s,
             const double     t)
    {
      return {s,
              t,
              .5 * (first.position(s) - second.position(t)).norm_square()};
    }

    /** Half the squared distance about a place, to second order in a step. */
    struct Model
    {
      double g_s, g_t, H_ss, H_st, H_tt;

      double
      value(const double s, const double t) const
      {
        return g_s * s + g_t * t + .5 * H_ss * s * s + H_st * s * t +
               .5 * H_tt * t * t;
      }
    };

    Model
    expand(const CubicPart &first, const CubicPart &second, const Candidate &at)
    {
      const Tensor<1, 3> d = first.position(at.s) - second.position(at.t);
      const Tensor<1, 3> a = first.derivative(at.s),
                         b = second.derivative(at.t);
      return {d * a,
              -(d * b),
              a * a + d * first.second_derivative(at.s),
              -(a * b),
              b * b - d * second.second_derivative(at.t)};
    }

    /** Where g x + H x^2 / 2 is smallest in [lower, upper]. */
    double
    minimizer_in_interval(const double g,
                          const double H,
                          const double lower,
                          const double upper)
    {
      if (H > 0.)
        return std::clamp(-g / H, lower, upper);
      return g * upper + .5 * H * upper * upper <
                 g * lower + .5 * H * lower * lower ?
               upper :
               lower;
    }

    /**
     * The place in [0,1]^2 where the model is smallest: inside, if it is
     * convex, or else on an edge.
     */
    std::pair<double, double>
    minimizer_in_box(const Model &m, const Candidate &at)
    {
      const double determinant = m.H_ss * m.H_tt - m.H_st * m.H_st;
      if (m.H_ss > 0. && determinant > 0.)
        {
          const double s =
            at.s + (m.H_st * m.g_t - m.H_tt * m.g_s) / determinant;
          const double t =
            at.t + (m.H_st * m.g_s - m.H_ss * m.g_t) / determinant;
          if (s >= 0. && s <= 1. && t >= 0. && t <= 1.)
            return {s, t};
        }
      std::pair<double, double> best{at.s, at.t};
      double                    smallest = 0.;
      const auto                see      = [&](const double s, const double t) {
        const double value = m.value(s - at.s, t - at.t);
        if (value < smallest)
          {
            smallest = value;
            best     = {s, t};
          }
      };
      for (const double x : {0., 1.})
        {
          see(x,
              at.t + minimizer_in_interval(
                       m.g_t + m.H_st * (x - at.s), m.H_tt, -at.t, 1. - at.t));
          see(at.s + minimizer_in_interval(
                       m.g_s + m.H_st * (x - at.t), m.H_ss, -at.s, 1. - at.s),
              x);
        }
      return best;
    }

    /** The model with a multiple of the unit matrix that makes it convex. */
    Model
    convex(Model m)
    {
      const double mean     = .5 * (m.H_ss + m.H_tt);
      const double smallest = mean - std::hypot(.5 * (m.H_ss - m.H_tt), m.H_st);
      if (smallest < 0.)
        {
          m.H_ss -= 2. * smallest;
          m.H_tt -= 2. * smallest;
        }
      return m;
    }

    /**
     * Newton's method on [0,1]^2 for half the squared distance. The model need
     * not be convex, as the box bounds it; where it promises too much, a convex
     * one takes its place, along which the distance falls.
     */
    Candidate
    minimize(const CubicPart &first, const CubicPart &second, Candidate at)
    {
      constexpr unsigned int max_n_steps    = 50;
      constexpr unsigned int max_n_halvings = 20;
      constexpr double       sufficient     = .1;

      // The error of the distance is the square of this.
      constexpr double tolerance = 1e-9;

      for (unsigned int i = 0; i < max_n_steps; ++i)
        {
          const Model model = expand(first, second, at);
          auto [s, t]       = minimizer_in_box(model, at);
          Candidate next    = evaluate(first, second, s, t);
          if (next.value - at.value >
              sufficient * model.value(s - at.s, t - at.t))
            {
              std::tie(s, t) = minimizer_in_box(convex(model), at);
              next           = evaluate(first, second, s, t);
              double factor  = .5;
              for (unsigned int halvings = 0;
                   next.value > at.value && halvings < max_n_halvings;
                   ++halvings, factor *= .5)
                next = evaluate(first,
                                second,
                                at.s + factor * (s - at.s),
                                at.t + factor * (t - at.t));
            }
          if (next.value > at.value)
            return at;
          const double change =
            std::max(std::abs(next.s - at.s), std::abs(next.t - at.t));
          at = next;
          if (change < tolerance)
            return at;
        }
      return at;
    }

    /**
     * A point of the first part and about the one of the second that is nearest
     * to it; half the squared distance of the first point from the second part,
     * and two derivatives of it along the first part.
     */
    struct Sample
    {
      Candidate place;
      double    value, slope, curvature;
      bool      is_at_end; ///< of the second part, and stays there
    };

    Sample
    sample(const CubicPart &first, const CubicPart &second, const double s)
    {
      const double    t     = nearest(second, first.position(s));
      const Candidate place = evaluate(first, second, s, t);
      const Model     m     = expand(first, second, place);
      const bool      is_at_end =
        (t <= 0. && m.g_t >= 0.) || (t >= 1. && m.g_t <= 0.);
      if (is_at_end || m.H_tt <= 0.)
        return {place, place.value, m.g_s, m.H_ss, is_at_end};

      // With the step to the nearest point that is left: on nearly parallel
      // parts it changes the slope by more than the slope.
      return {place,
              place.value - .5 * m.g_t * m.g_t / m.H_tt,
              m.g_s - m.H_st / m.H_tt * m.g_t,
              m.H_ss - m.H_st / m.H_tt * m.H_st,
              false};
    }

    /**
     * The cubic polynomial that has the slopes of two samples and their
     * derivatives, by its Bernstein coefficients.
     */
    std::array<double, 4>
    slope_between(const Sample &left, const Sample &right)
    {
      const double third = (right.place.s - left.place.s) / 3.;
      return {{left.slope,
               left.slope + third * left.curvature,
               right.slope - third * right.curvature,
               right.slope}};
    }

    class Search
    {
    public:
      /** @param size of the cells [length] */
      Search(const double    bound,
             const double    size,
             const CellEnds &left_out_1,
             const CellEnds &left_out_2)
        : bound(bound)
        , resolution(round_off * size)
        , left_out_1(left_out_1)
        , left_out_2(left_out_2)
      {}

      /** @p distance is a lower bound. */
      void
      divide(const CubicPart &first,
             const CubicPart &second,
             const double     distance)
      {
        if (!(distance < bound * (1. - round_off)))
          return;
        const bool first_is_simple  = is_simple(first);
        const bool second_is_simple = is_simple(second);
        if (first_is_simple && second_is_simple)
          {
            find_minima(first, second);
            return;
          }
        const bool halve_first =
          !first_is_simple &&
          (second_is_simple || first.length() >= second.length());
        const auto halves = (halve_first ? first : second).halves();
        const auto parts  = [&](const unsigned int i) {
          return halve_first ? std::make_pair(halves[i], second) :
                                std::make_pair(first, halves[i]);
        };
        double distances[2];
        for (const unsigned int i : {0, 1})
          distances[i] =
            hull_distance(parts(i).first.points, parts(i).second.points);
        const unsigned int nearer = distances[1] < distances[0] ? 1 : 0;
        for (const unsigned int i : {nearer, 1 - nearer})
          divide(parts(i).first, parts(i).second, distances[i]);
      }

      ClosestApproach result;

    private:
      /**
       * Sample the first part; a minimum is where the distance falls before and
       * grows after, or at an end.
       */
      void
      find_minima(const CubicPart &first, const CubicPart &second)
      {
        constexpr unsigned int n = 8;

        Sample left = sample(first, second, 0.);
        if (left.slope >= 0.)
          see(first, second, minimize(first, second, left.place));
        for (unsigned int i = 1; i <= n; ++i)
          {
            const Sample right = sample(first, second, double(i) / n);
            find_minima(first, second, left, right);
            left = right;
          }
        if (left.slope < 0.)
          see(first, second, minimize(first, second, left.place));

        // Where the second part ends beside the first one, the distance may
        // have a kink between two samples.
        for (const double t : {0., 1.})
          {
            const Tensor<1, 3> position = second.position(t);
            const double       s        = nearest(first, position);
            const Tensor<1, 3> d        = first.position(s) - position;
            if ((t > 0. ? d : -d) * second.derivative(t) >= 0.)
              see(first,
                  second,
                  minimize(first, second, {s, t, .5 * d.norm_square()}));
          }
      }

      /**
       * Halve the interval between two samples until the slope changes its sign
       * at most once (Descartes), or the distance is nowhere below the bound.
       * Where the second part ends, the slope has a kink.
       */
      void
      find_minima(const CubicPart &first,
                  const CubicPart &second,
                  const Sample    &left,
                  const Sample    &right)
      {
        constexpr double smallest_interval = 1e-5;

        const auto   slope = slope_between(left, right);
        unsigned int n     = 0;
        for (unsigned int k = 1; k < slope.size(); ++k)
          n += (slope[k - 1] < 0.) != (slope[k] < 0.);
        const bool has_kink = left.is_at_end != right.is_at_end;
        if (!has_kink && (n == 0 || (n == 1 && right.slope < 0.)))
          return;

        const double h = right.place.s - left.place.s;
        const auto [least, most] =
          std::minmax_element(slope.begin(), slope.end());
        const double lowest = std::max(left.value + h * std::min(0., *least),
                                       right.value - h * std::max(0., *most));
        const double limit  = bound - resolution;
        if (limit <= 0. || lowest >= .5 * limit * limit)
          return;

        const Sample middle =
          sample(first, second, .5 * (left.place.s + right.place.s));
        if ((n == 1 && !has_kink) || h < smallest_interval)
          see(first, second, minimize(first, second, middle.place));
        else
          {
            find_minima(first, second, left, middle);
            find_minima(first, second, middle, right);
          }
      }

      void
      see(const CubicPart &first,
          const CubicPart &second,
          const Candidate &candidate)
      {
        const double distance = std::sqrt(2. * candidate.value);
        const double x        = first.on_cell(candidate.s);
        const double y        = second.on_cell(candidate.t);
        if (distance >= bound || is_left_out(left_out_1, x) ||
            is_left_out(left_out_2, y))
          return;
        bound  = distance;
        result = {distance, x, y};
      }

      static bool
      is_left_out(const CellEnds &left_out, const double x)
      {
        return (left_out.first && x <= 0.) || (left_out.last && x >= 1.);
      }

      double         bound;
      const double   resolution; ///< of distances [length]
      const CellEnds left_out_1, left_out_2;
    };
  } // namespace



  ClosestApproach
  closest_approach(const CubicPart::ControlPoints &first,
                   const CubicPart::ControlPoints &second,
                   const double                    bound,
                   const CellEnds                 &left_out_1,
                   const CellEnds                 &left_out_2)
  {
    // Relative to a point of one of them, far from the origin as well.
    CubicPart A, B;
    double    size = 0.;
    for (unsigned int k = 0; k < 4; ++k)
      {
        A.points[k] = first[k] - first[0];
        B.points[k] = second[k] - first[0];
        size        = std::max({size, A.points[k].norm(), B.points[k].norm()});
      }
    Search search(bound, size, left_out_1, left_out_2);
    search.divide(A, B, hull_distance(A.points, B.points));
    return search.result;
  }
} // namespace Setae
