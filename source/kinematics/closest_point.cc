// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <setae/kinematics/closest_point.h>

#include <algorithm>
#include <cmath>

namespace Setae
{
  namespace
  {
    /** Bernstein coefficients of a polynomial of degree five. */
    using Quintic = std::array<double, 6>;

    /**
     * p at a node up to a positive factor. It is not inlined so that the cells
     * on both sides of the node execute the same instructions and get the same
     * sign, whether or not the compiler fuses products and sums.
     */
    [[gnu::noinline]] double
    slope_at_node(const Tensor<1, 3> &position, const Tensor<1, 3> &tangent)
    {
      return position * tangent;
    }

    /** p(x) / h of a cell that is given relative to the point. */
    Quintic
    distance_derivative(const HermiteCell<> &cell)
    {
      const auto &[d1, t1, d2, t2] = cell.coefficients;
      const auto         P         = cell.control_points();
      const Tensor<1, 3> D1        = 3. / cell.h * (P[2] - P[1]);

      // The products of the cubic (P) and the quadratic (t1, D1, t2) Bernstein
      // form, weighted by binomials; the first and the last hold data of one
      // node.
      return {{slope_at_node(d1, t1),
               (3. * (P[1] * t1) + 2. * (P[0] * D1)) / 5.,
               (3. * (P[2] * t1) + 6. * (P[1] * D1) + P[0] * t2) / 10.,
               (P[3] * t1 + 6. * (P[2] * D1) + 3. * (P[1] * t2)) / 10.,
               (2. * (P[3] * D1) + 3. * (P[2] * t2)) / 5.,
               slope_at_node(d2, t2)}};
    }

    /** Whether p is positive next to the left end of its interval. */
    bool
    starts_upwards(const Quintic &p)
    {
      for (const double coefficient : p)
        if (coefficient != 0.)
          return coefficient > 0.;
      return true;
    }

    unsigned int
    n_sign_changes(const Quintic &p)
    {
      unsigned int n = 0;
      for (unsigned int i = 1; i < p.size(); ++i)
        n += (p[i - 1] < 0.) != (p[i] < 0.);
      return n;
    }

    /** De Casteljau: the coefficients on both halves of the interval. */
    std::pair<Quintic, Quintic>
    halves(Quintic p)
    {
      Quintic left, right;
      for (unsigned int k = 0; k < p.size(); ++k)
        {
          left[k]                 = p.front();
          right[p.size() - 1 - k] = p[p.size() - 1 - k];
          for (unsigned int i = 0; i + 1 + k < p.size(); ++i)
            p[i] = .5 * (p[i] + p[i + 1]);
        }
      return {left, right};
    }

    /** Where the control polygon with one sign change crosses zero. */
    double
    crossing(const Quintic &p)
    {
      unsigned int i = 1;
      while ((p[i - 1] < 0.) == (p[i] < 0.))
        ++i;
      return (i - 1 + p[i - 1] / (p[i - 1] - p[i])) / (p.size() - 1);
    }

    /**
     * The root of p in [a, b] with p(a) < 0 <= p(b): Newton's method, and
     * bisection where its steps leave the interval or do not halve.
     */
    double
    polish(const HermiteCell<> &cell, double a, double b, double x)
    {
      constexpr unsigned int n_max              = 200;
      constexpr double       newton_tolerance   = 1e-10; // the next: squared
      constexpr double       smallest_bisection = 1e-16;

      double last_step = b - a;
      for (unsigned int i = 0; i < n_max; ++i)
        {
          const Tensor<1, 3> r   = cell.position(x);
          const Tensor<1, 3> r_x = cell.derivative(x);
          const double       p   = r * r_x;
          const double       p_x = r_x * r_x + r * cell.second_derivative(x);
          (p < 0. ? a : b)       = x;

          double     step      = -p / p_x;
          const bool is_newton = x + step > a - newton_tolerance &&
                                 x + step < b + newton_tolerance &&
                                 std::abs(step) <= .5 * std::abs(last_step);
          if (!is_newton)
            step = .5 * (a + b) - x;
          x = std::min(std::max(x + step, a), b);
          if (std::abs(step) <=
              (is_newton ? newton_tolerance : smallest_bisection))
            return x;
          last_step = step;
        }
      return x;
    }

    void
    find_minima(const HermiteCell<> &cell,
                const Quintic       &p,
                const double         a,
                const double         b,
                Projections         &result)
    {
      // Two roots closer than this are one flat place of the distance.
      constexpr double smallest_interval = 1e-9;

      const unsigned int n = n_sign_changes(p);
      if (n == 0)
        return;
      if (n == 1 || b - a < smallest_interval)
        {
          if (p.front() < 0. && p.back() >= 0.)
            {
              const double guess =
                n == 1 ? a + (b - a) * crossing(p) : .5 * (a + b);
              result.push_back({polish(cell, a, b, guess), true});
            }
          return;
        }
      const auto [left, right] = halves(p);
      const double middle      = .5 * (a + b);
      find_minima(cell, left, a, middle, result);
      find_minima(cell, right, middle, b, result);
    }
  } // namespace



  Projections
  closest_points(const HermiteCell<> &cell,
                 const Tensor<1, 3>  &point,
                 const FiberEnds     &ends)
  {
    HermiteCell<> relative = cell;
    relative.coefficients[0] -= point;
    relative.coefficients[2] -= point;
    const Quintic p = distance_derivative(relative);

    Projections result;
    if (ends.left && starts_upwards(p))
      result.push_back({0., false});
    find_minima(relative, p, 0., 1., result);
    if (ends.right && p.back() < 0.)
      result.push_back({1., false});
    return result;
  }
} // namespace Setae
