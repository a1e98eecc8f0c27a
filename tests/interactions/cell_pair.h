// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_tests_interactions_cell_pair_h
#define setae_tests_interactions_cell_pair_h

// Pairs of cells for the tests of the interactions, and what every interaction
// has to fulfill.

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <deal.II/physics/transformations.h>

#include <gtest/gtest.h>

#include <setae/base/local_system.h>
#include <setae/interactions/line_sites.h>
#include <setae/kinematics/closest_point.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "../random_vectors.h"

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



  /**
   * A cell along @p direction; @p bend is the size of the random deviation from
   * a straight one, about the angle [rad] between its ends.
   */
  inline HermiteCell<>
  random_cell(const Tensor<1, 3> &direction,
              const double        h,
              const double        bend,
              std::mt19937       &random)
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
  largest(const std::array<std::array<double, 24>, 24> &matrix)
  {
    double result = 0.;
    for (const auto &row : matrix)
      result = std::max(result, largest(row));
    return result;
  }



  /**
   * Equal to @p tolerance times the largest entries of @p expected, or to what
   * a perturbation of the coordinates by their rounding error does, which is
   * more where the forces vanish at an equilibrium.
   */
  inline void
  expect_equal(const LocalSystem<24> &actual,
               const LocalSystem<24> &expected,
               const double           tolerance)
  {
    constexpr double rounding_error = 1e-14; // of coordinates of order one

    std::array<double, 24>                 residual;
    std::array<std::array<double, 24>, 24> tangent;
    for (unsigned int i = 0; i < 24; ++i)
      {
        residual[i] = actual.residual[i] - expected.residual[i];
        for (unsigned int j = 0; j < 24; ++j)
          tangent[i][j] = actual.tangent[i][j] - expected.tangent[i][j];
      }
    EXPECT_NEAR(actual.energy,
                expected.energy,
                tolerance * std::abs(expected.energy) +
                  rounding_error * largest(expected.residual));
    EXPECT_LE(largest(residual),
              tolerance * largest(expected.residual) +
                rounding_error * largest(expected.tangent));
    EXPECT_LE(largest(tangent), tolerance * largest(expected.tangent));
  }

  /** Nothing at all, not even a rounding error. */
  inline void
  expect_zero(const LocalSystem<24> &local)
  {
    EXPECT_EQ(local.energy, 0.);
    EXPECT_EQ(largest(local.residual), 0.);
    EXPECT_EQ(largest(local.tangent), 0.);
  }



  /**
   * The energy does not change in a translation, which adds the same to all
   * positions, and in a rotation, in which positions and tangents turn: the
   * residual has no component along either, up to round-off.
   */
  inline void
  expect_balance_of_momentum(const CellPair        &cells,
                             const LocalSystem<24> &local,
                             const double           tolerance)
  {
    const Coefficients q = cells.coefficients();
    Tensor<1, 3>       force, moment;
    double             all_forces = 0., all_moments = 0.;
    for (unsigned int a = 0; a < 8; ++a)
      {
        Tensor<1, 3> q_a, f_a;
        for (unsigned int c = 0; c < 3; ++c)
          {
            q_a[c] = q[3 * a + c];
            f_a[c] = local.residual[3 * a + c];
          }
        moment += cross_product_3d(q_a, f_a);
        all_moments += q_a.norm() * f_a.norm();
        if (a % 2 == 0)
          {
            force += f_a;
            all_forces += f_a.norm();
          }
      }
    EXPECT_GT(all_forces, 0.);
    EXPECT_LE(force.norm(), tolerance * all_forces);
    EXPECT_LE(moment.norm(), tolerance * all_moments);
  }



  /** The cells after a rotation and a translation. */
  inline CellPair
  moved(const CellPair     &cells,
        const Tensor<2, 3> &rotation,
        const Tensor<1, 3> &translation)
  {
    CellPair result = cells;
    for (HermiteCell<> *cell : {&result.source, &result.target})
      for (unsigned int a = 0; a < 4; ++a)
        cell->coefficients[a] = rotation * cell->coefficients[a] +
                                (a % 2 == 0 ? translation : Tensor<1, 3>());
    return result;
  }

  /** Residual and tangent matrix in the rotated frame. */
  inline LocalSystem<24>
  rotated(const LocalSystem<24> &local, const Tensor<2, 3> &rotation)
  {
    LocalSystem<24> result;
    result.energy = local.energy;
    for (unsigned int a = 0; a < 8; ++a)
      for (unsigned int c = 0; c < 3; ++c)
        for (unsigned int d = 0; d < 3; ++d)
          {
            result.residual[3 * a + c] +=
              rotation[c][d] * local.residual[3 * a + d];
            for (unsigned int b = 0; b < 8; ++b)
              for (unsigned int e = 0; e < 3; ++e)
                for (unsigned int f = 0; f < 3; ++f)
                  result.tangent[3 * a + c][3 * b + e] +=
                    rotation[c][d] * local.tangent[3 * a + d][3 * b + f] *
                    rotation[e][f];
          }
    return result;
  }

  /**
   * @p evaluate, from a CellPair to its LocalSystem, gives the same after a
   * rigid motion.
   */
  template <typename Evaluate>
  void
  expect_objective(const Evaluate &evaluate,
                   const CellPair &cells,
                   const double    tolerance)
  {
    const Tensor<2, 3> rotation =
      dealii::Physics::Transformations::Rotations::rotation_matrix_3d(
        dealii::Point<3>(2. / 7., 3. / 7., 6. / 7.), 2.5);
    const Tensor<1, 3> translation({-1., .5, 2.});
    expect_equal(evaluate(moved(cells, rotation, translation)),
                 rotated(evaluate(cells), rotation),
                 tolerance);
  }



  /**
   * Central differences (fourth order, @p step) of energy and residual of
   * @p evaluate, in place of its residual and its tangent matrix.
   */
  template <typename Evaluate>
  LocalSystem<24>
  finite_differences(const Evaluate &evaluate,
                     const CellPair &cells,
                     const double    step)
  {
    LocalSystem<24> differences = evaluate(cells);
    for (unsigned int j = 0; j < 24; ++j)
      {
        const auto at = [&](const double distance) {
          Coefficients q = cells.coefficients();
          q[j] += distance;
          return evaluate(cells.with(q));
        };
        const auto central = [&](const double plus_1,
                                 const double minus_1,
                                 const double plus_2,
                                 const double minus_2) {
          return (8. * (plus_1 - minus_1) - (plus_2 - minus_2)) / (12. * step);
        };
        const LocalSystem<24> plus_1 = at(step), minus_1 = at(-step),
                              plus_2 = at(2. * step), minus_2 = at(-2. * step);
        differences.residual[j] =
          central(plus_1.energy, minus_1.energy, plus_2.energy, minus_2.energy);
        for (unsigned int i = 0; i < 24; ++i)
          differences.tangent[i][j] = central(plus_1.residual[i],
                                              minus_1.residual[i],
                                              plus_2.residual[i],
                                              minus_2.residual[i]);
      }
    return differences;
  }

  template <typename Evaluate>
  void
  expect_finite_differences(const Evaluate &evaluate,
                            const CellPair &cells,
                            const double    step,
                            const double    tolerance)
  {
    expect_equal(evaluate(cells),
                 finite_differences(evaluate, cells, step),
                 tolerance);
  }
} // namespace Setae

#endif
