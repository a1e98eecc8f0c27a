// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_tests_interactions_cell_pair_h
#define setae_tests_interactions_cell_pair_h

// Pairs of cells for the tests of the interactions, and what every interaction
// has to fulfill.

#include <setae/base/local_system.h>
#include <setae/interactions/line_sites.h>
#include <setae/kinematics/closest_point.h>

#include <deal.II/base/tensor.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

namespace Setae
{
  using Coefficients = std::array<double, 24>;

  struct CellPair
  {
    HermiteCell<> source, target;

    Coefficients
    coefficients() const
    {
      Coefficients result;
      for (unsigned int a = 0; a < 4; ++a)
        for (unsigned int c = 0; c < 3; ++c)
          {
            result[3 * a + c]      = source.coefficients[a][c];
            result[12 + 3 * a + c] = target.coefficients[a][c];
          }
      return result;
    }

    CellPair
    with(const Coefficients &q) const
    {
      CellPair result = *this;
      for (unsigned int a = 0; a < 4; ++a)
        for (unsigned int c = 0; c < 3; ++c)
          {
            result.source.coefficients[a][c] = q[3 * a + c];
            result.target.coefficients[a][c] = q[12 + 3 * a + c];
          }
      return result;
    }
  };



  /** The cell that begins at entry @p first of @p q, on any number type. */
  template <typename Number>
  HermiteCell<Number>
  cell_of(const std::array<Number, 24> &q,
          const unsigned int            first,
          const double                  h)
  {
    HermiteCell<Number> result;
    result.h = h;
    for (unsigned int a = 0; a < 4; ++a)
      for (unsigned int c = 0; c < 3; ++c)
        result.coefficients[a][c] = q[first + 3 * a + c];
    return result;
  }



  /** The site at @p x of a cell, with weight one. */
  inline LineSite
  site_at(const HermiteCell<> &cell, const double x)
  {
    LineSite s;
    s.x      = x;
    s.N      = Hermite::shape_values(x, cell.h);
    s.N_x    = Hermite::shape_derivatives(x, cell.h);
    s.r      = cell.combine(s.N);
    s.r_x    = cell.combine(s.N_x);
    s.weight = 1.;
    return s;
  }



  inline Tensor<1, 3>
  random_vector(std::mt19937 &random)
  {
    std::normal_distribution<double> normal;
    Tensor<1, 3>                     result;
    for (unsigned int c = 0; c < 3; ++c)
      result[c] = normal(random);
    return result;
  }



  inline Tensor<1, 3>
  random_normal_to(const Tensor<1, 3> &v, std::mt19937 &random)
  {
    const Tensor<1, 3> e = cross_product_3d(v, random_vector(random));
    return e / e.norm();
  }



  /**
   * A cell along @p direction; @p bend is the size of the random deviation from
   * a straight one, about the angle [rad] between its ends.
   */
  inline HermiteCell<>
  random_cell(const Tensor<1, 3> &direction,
              const double        h,
              const double        bend,
              std::mt19937 &      random)
  {
    const Tensor<1, 3> begin = .3 * random_vector(random);
    const Tensor<1, 3> t1    = direction + bend * random_vector(random) / 2.;
    const Tensor<1, 3> t2    = direction + bend * random_vector(random) / 2.;
    const Tensor<1, 3> chord =
      .5 * (t1 + t2) + .1 * bend * random_vector(random);
    return {{{begin, t1, begin + h * chord, t2}}, h};
  }



  /** Move @p cell such that its point at @p x is @p point. */
  inline void
  move_to(HermiteCell<> &cell, const double x, const Tensor<1, 3> &point)
  {
    const Tensor<1, 3> shift = point - cell.position(x);
    cell.coefficients[0] += shift;
    cell.coefficients[2] += shift;
  }



  template <typename Container>
  double
  largest(const Container &values)
  {
    double result = 0.;
    for (const double v : values)
      result = std::max(result, std::abs(v));
    return result;
  }

  inline double
  largest(const LocalSystem<24> &system)
  {
    double result = 0.;
    for (const auto &row : system.tangent)
      result = std::max(result, largest(row));
    return result;
  }



  /** The largest deviations relative to the largest entries. */
  struct Deviation
  {
    double energy, residual, tangent;
  };

  inline Deviation
  deviation(const LocalSystem<24> &a, const LocalSystem<24> &b)
  {
    Deviation result = {std::abs(a.energy - b.energy) / std::abs(b.energy),
                        0.,
                        0.};
    for (unsigned int i = 0; i < 24; ++i)
      {
        result.residual = std::max(result.residual,
                                   std::abs(a.residual[i] - b.residual[i]) /
                                     largest(b.residual));
        for (unsigned int j = 0; j < 24; ++j)
          result.tangent = std::max(result.tangent,
                                    std::abs(a.tangent[i][j] -
                                             b.tangent[i][j]) /
                                      largest(b));
      }
    return result;
  }

  inline void
  expect_equal(const LocalSystem<24> &a,
               const LocalSystem<24> &b,
               const double           tolerance)
  {
    const Deviation difference = deviation(a, b);
    EXPECT_LT(difference.energy, tolerance);
    EXPECT_LT(difference.residual, tolerance);
    EXPECT_LT(difference.tangent, tolerance);
  }
} // namespace Setae

#endif
