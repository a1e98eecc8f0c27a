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

    /** p(x) of the cell seen from a point. */
    Quintic
    distance_derivative(const HermiteCell<> &cell, const Tensor<1, 3> &point)
    {
      const auto &[d1, t1, d2, t2] = cell.coefficients;
      std::array<Tensor<1, 3>, 4> P = cell.control_points();
      for (Tensor<1, 3> &control_point : P)
        control_point -= point;
      const Tensor<1, 3> D0 = cell.h * t1, D1 = 3. * (P[2] - P[1]),
                         D2 = cell.h * t2;

      // The products of the cubic (P) and the quadratic (D) Bernstein form,
      // weighted by binomials; the first and the last hold data of one node.
      return {{cell.h * ((d1 - point) * t1),
               (3. * (P[1] * D0) + 2. * (P[0] * D1)) / 5.,
               (3. * (P[2] * D0) + 6. * (P[1] * D1) + P[0] * D2) / 10.,
               (P[3] * D0 + 6. * (P[2] * D1) + 3. * (P[1] * D2)) / 10.,
               (2. * (P[3] * D1) + 3. * (P[2] * D2)) / 5.,
               cell.h * ((d2 - point) * t2)}};
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

    /** The root of p in [a, b] with p(a) < 0 <= p(b). */
    double
    polish(const HermiteCell<> &cell,
           const Tensor<1, 3> & point,
           double               a,
           double               b,
           double               x)
    {
      constexpr unsigned int n_max = 100;
      for (unsigned int i = 0; i < n_max; ++i)
        {
          const Tensor<1, 3> d   = cell.position(x) - point;
          const Tensor<1, 3> r_x = cell.derivative(x);
          const double       p   = d * r_x;
          const double       p_x = r_x * r_x + d * cell.second_derivative(x);
          (p < 0. ? a : b)       = x;

          double next = x - p / p_x;
          if (!(next >= a && next <= b))
            next = .5 * (a + b);
          if (std::abs(next - x) <= 2e-16)
            return next;
          x = next;
        }
      return x;
    }

    void
    find_minima(const HermiteCell<> &cell,
                const Tensor<1, 3> & point,
                const Quintic &      p,
                const double         a,
                const double         b,
                Projections &        result)
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
              result.push_back({polish(cell, point, a, b, guess), true});
            }
          return;
        }
      const auto [left, right] = halves(p);
      const double middle      = .5 * (a + b);
      find_minima(cell, point, left, a, middle, result);
      find_minima(cell, point, right, middle, b, result);
    }
  } // namespace



  Projections
  closest_points(const HermiteCell<> &cell,
                 const Tensor<1, 3> & point,
                 const FiberEnds &    ends)
  {
    const Quintic p = distance_derivative(cell, point);

    Projections result;
    if (ends.left && p.front() >= 0.)
      result.push_back({0., false});
    find_minima(cell, point, p, 0., 1., result);
    if (ends.right && p.back() < 0.)
      result.push_back({1., false});
    return result;
  }
} // namespace Setae
