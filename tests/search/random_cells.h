// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_tests_search_random_cells_h
#define setae_tests_search_random_cells_h

#include <setae/kinematics/hermite.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

/** Cells, as their control points, for the tests of the search. */
namespace RandomCells
{
  using Setae::Tensor;

  using ControlPoints = std::array<Tensor<1, 3>, 4>;
  using Cells         = std::vector<ControlPoints>;

  /** A unit vector, any direction being as likely as another. */
  inline Tensor<1, 3>
  random_direction(std::mt19937 &random)
  {
    std::normal_distribution<double> normal;
    Tensor<1, 3>                     result;
    for (unsigned int c = 0; c < 3; ++c)
      result[c] = normal(random);
    return result / result.norm();
  }

  /**
   * Cells in a box of the given edge, with lengths from 0.02 to 20 and end
   * tangents of any direction and of a magnitude that bends some into loops.
   */
  inline Cells
  random_curved_cells(const unsigned int n,
                      const double       edge,
                      std::mt19937      &random)
  {
    std::uniform_real_distribution<double> coordinate(0., edge);
    std::uniform_real_distribution<double> exponent(std::log(0.02),
                                                    std::log(20.));
    std::uniform_real_distribution<double> magnitude(0., 2.);
    Cells                                  cells;
    for (unsigned int i = 0; i < n; ++i)
      {
        Setae::HermiteCell<> cell;
        cell.h                 = std::exp(exponent(random));
        auto &[d1, t1, d2, t2] = cell.coefficients;
        for (unsigned int c = 0; c < 3; ++c)
          d1[c] = coordinate(random);
        d2 = d1 + cell.h * random_direction(random);
        t1 = magnitude(random) * random_direction(random);
        t2 = magnitude(random) * random_direction(random);
        cells.push_back(cell.control_points());
      }
    return cells;
  }

  /** A straight cell with constant speed. */
  inline ControlPoints
  straight_cell(const Tensor<1, 3> &begin, const Tensor<1, 3> &end)
  {
    return {{begin,
             (2. / 3.) * begin + (1. / 3.) * end,
             (1. / 3.) * begin + (2. / 3.) * end,
             end}};
  }

  /** Straight cells that begin in a box of the given edge. */
  inline Cells
  random_straight_cells(const unsigned int n,
                        const double       length,
                        const double       edge,
                        std::mt19937      &random)
  {
    std::uniform_real_distribution<double> coordinate(0., edge);
    Cells                                  cells;
    for (unsigned int i = 0; i < n; ++i)
      {
        Tensor<1, 3> begin;
        for (unsigned int c = 0; c < 3; ++c)
          begin[c] = coordinate(random);
        cells.push_back(
          straight_cell(begin, begin + length * random_direction(random)));
      }
    return cells;
  }

  /** Points on a cell, from the Bernstein polynomials. */
  inline std::vector<std::array<double, 3>>
  sample(const ControlPoints &p, const unsigned int n)
  {
    std::vector<std::array<double, 3>> points(n + 1);
    for (unsigned int i = 0; i <= n; ++i)
      {
        const double x = double(i) / n, y = 1. - x;
        for (unsigned int c = 0; c < 3; ++c)
          points[i][c] = y * y * y * p[0][c] + 3. * x * y * y * p[1][c] +
                         3. * x * x * y * p[2][c] + x * x * x * p[3][c];
      }
    return points;
  }

  /**
   * The distance of two straight cells: that of a point of the first from the
   * second is convex, so its minimum can be bracketed.
   */
  inline double
  distance_of_straight_cells(const ControlPoints &first,
                             const ControlPoints &second)
  {
    const Tensor<1, 3> u = first[3] - first[0], v = second[3] - second[0];
    const auto         distance_from_second = [&](const double s) {
      const Tensor<1, 3> r = first[0] + s * u - second[0];
      return (r - std::clamp(r * v / (v * v), 0., 1.) * v).norm();
    };
    double left = 0., right = 1.;
    while (right - left > 1e-9)
      {
        const double a = (2. * left + right) / 3., b = (left + 2. * right) / 3.;
        if (distance_from_second(a) < distance_from_second(b))
          right = b;
        else
          left = a;
      }
    return distance_from_second(left);
  }
} // namespace RandomCells

#endif
