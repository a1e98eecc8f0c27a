// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <deal.II/base/quadrature_lib.h>

#include <deal.II/fe/fe_values.h>

#include <deal.II/numerics/data_out.h>

#include <gtest/gtest.h>

#include <setae/kinematics/hermite.h>

#include <sstream>
#include <string>

#include "interpolation.h"

using namespace Setae::Testing;
using Setae::FE_Hermite;

namespace
{
  /**
   * The L2 norms, over the chords, of what separates the interpolated helix
   * from the exact one.
   */
  struct Errors
  {
    double position; // at the same interpolated arc length
    double tangent;  // at the same interpolated arc length
    double slip;     // position at the proportional arc length
    double radius;   // distance from the cylinder around which it winds
  };

  Errors
  interpolation_errors(const unsigned int n_cells)
  {
    const Helix         helix;
    const Interpolation curve = helix.interpolate(n_cells);
    const UpdateFlags   flags =
      update_values | update_gradients | update_JxW_values;
    FEValues<1, 3>     fe_values(curve.fe, QGauss<1>(6), flags);
    const unsigned int n_q = fe_values.n_quadrature_points;

    std::vector<Vector<double>>            values(n_q, Vector<double>(4));
    std::vector<std::vector<Tensor<1, 3>>> gradients(
      n_q, std::vector<Tensor<1, 3>>(4));

    Errors squares{};
    for (const auto &cell : curve.dof_handler.active_cell_iterators())
      {
        fe_values.reinit(cell);
        fe_values.get_function_values(curve.solution, values);
        fe_values.get_function_gradients(curve.solution, gradients);
        const Tensor<1, 3> e  = chord_direction(cell);
        const double       s1 = curve.nodes[cell->vertex_index(0)];
        const double       s2 = curve.nodes[cell->vertex_index(1)];
        for (unsigned int q = 0; q < n_q; ++q)
          {
            const double x          = fe_values.get_quadrature().point(q)[0];
            const double s          = values[q][3];
            const double s_l        = gradients[q][3] * e;
            const auto   add_square = [&](double &sum, const double error) {
              sum += fe_values.JxW(q) * error * error;
            };
            for (unsigned int c = 0; c < 3; ++c)
              {
                const double r   = values[q][c];
                const double r_l = gradients[q][c] * e;
                add_square(squares.position, r - helix.value(c, s));
                add_square(squares.tangent, r_l - helix.derivative(c, s) * s_l);
                add_square(squares.slip,
                           r - helix.value(c, s1 + x * (s2 - s1)));
              }
            add_square(squares.radius,
                       std::hypot(values[q][0], values[q][1]) - Helix::radius);
          }
      }
    return {std::sqrt(squares.position),
            std::sqrt(squares.tangent),
            std::sqrt(squares.slip),
            std::sqrt(squares.radius)};
  }



  void
  expect_order(const double order, const double coarse, const double fine)
  {
    const double measured = std::log2(coarse / fine);
    EXPECT_GT(measured, order - 0.1) << "error " << fine;
    EXPECT_LT(measured, order + 0.2) << "error " << fine;
  }
} // namespace



TEST(FEHermite, InterpolatesAHelixOnAnUnevenMeshWithOrderFour)
{
  Errors coarse = interpolation_errors(8);
  for (const unsigned int n_cells : {16, 32, 64, 128})
    {
      const Errors fine = interpolation_errors(n_cells);
      expect_order(4., coarse.position, fine.position);
      expect_order(4., coarse.radius, fine.radius);
      expect_order(3., coarse.tangent, fine.tangent);
      coarse = fine;
    }
}



TEST(FEHermite, SlipsAlongTheCurveWithOrderThree)
{
  Errors coarse = interpolation_errors(32);
  for (const unsigned int n_cells : {64, 128, 256})
    {
      const Errors fine = interpolation_errors(n_cells);
      expect_order(3., coarse.slip, fine.slip);
      coarse = fine;
    }
}



TEST(FEHermite, TangentIsContinuousOnAnUnevenCurvedMesh)
{
  const Interpolation curve = Helix().interpolate(10);
  FEValues<1, 3>      fe_values(curve.fe, QTrapezoid<1>(), update_gradients);
  std::vector<std::vector<Tensor<1, 3>>> gradients(
    2, std::vector<Tensor<1, 3>>(4));

  std::vector<std::vector<Tensor<1, 3>>> tangents(curve.nodes.size());
  for (const auto &cell : curve.dof_handler.active_cell_iterators())
    {
      fe_values.reinit(cell);
      fe_values.get_function_gradients(curve.solution, gradients);
      for (unsigned int v = 0; v < 2; ++v)
        {
          Tensor<1, 3> tangent;
          for (unsigned int c = 0; c < 3; ++c)
            tangent[c] = gradients[v][c] * chord_direction(cell);
          tangents[cell->vertex_index(v)].push_back(tangent);
        }
    }

  for (unsigned int node = 0; node < tangents.size(); ++node)
    {
      const bool is_end = node == 0 || node == tangents.size() - 1;
      ASSERT_EQ(tangents[node].size(), is_end ? 1u : 2u);
      EXPECT_NEAR(tangents[node].front().norm(), 1., 1e-13);
      EXPECT_LT((tangents[node].front() - tangents[node].back()).norm(), 1e-13);
    }
}



// Both difference formulas are exact for cubics, so that a wide step can be
// taken and round-off is all that is left.
TEST(FEHermite, DerivativesAreThoseOfTheValues)
{
  const double          step = 0.2;
  std::vector<Point<1>> points;
  for (int k = -2; k <= 2; ++k)
    points.emplace_back(0.55 + k * step);

  const Interpolation curve = Helix().interpolate(10);
  const UpdateFlags flags = update_values | update_gradients | update_hessians;
  FEValues<1, 3>    fe_values(curve.fe, Quadrature<1>(points), flags);

  std::vector<Vector<double>>            f(5, Vector<double>(4));
  std::vector<std::vector<Tensor<1, 3>>> gradients(
    5, std::vector<Tensor<1, 3>>(4));
  std::vector<std::vector<Tensor<2, 3>>> hessians(5,
                                                  std::vector<Tensor<2, 3>>(4));

  for (const auto &cell : curve.dof_handler.active_cell_iterators())
    {
      fe_values.reinit(cell);
      fe_values.get_function_values(curve.solution, f);
      fe_values.get_function_gradients(curve.solution, gradients);
      fe_values.get_function_hessians(curve.solution, hessians);
      const Tensor<1, 3> e  = chord_direction(cell);
      const double       dl = step * cell->measure();
      for (unsigned int c = 0; c < 4; ++c)
        {
          const double first =
            (8. * (f[3][c] - f[1][c]) - (f[4][c] - f[0][c])) / (12. * dl);
          const double second = (f[3][c] - 2. * f[2][c] + f[1][c]) / (dl * dl);
          EXPECT_LT((gradients[2][c] - first * e).norm(), 1e-13);
          EXPECT_LT((hessians[2][c] - second * outer_product(e, e)).norm(),
                    1e-11);
        }
    }
}



namespace
{
  /**
   * @p cell as a cubic that is evaluated without FEValues.
   */
  template <typename Cell>
  Setae::HermiteCell<>
  hermite_cell(const Interpolation &curve, const Cell &cell)
  {
    Vector<double> local(curve.fe.n_dofs_per_cell());
    cell->get_dof_values(curve.solution, local);

    Setae::HermiteCell<> result;
    result.h = FE_Hermite<1, 3>::length_scale(cell);
    for (unsigned int i = 0; i < local.size(); ++i)
      {
        const auto [c, shape] = curve.fe.system_to_component_index(i);
        if (c < 3)
          result.coefficients[shape][c] = local(i);
      }
    return result;
  }
} // namespace



// DataOut keeps its data in single precision.
TEST(FEHermite, DataOutWritesTheCubicBetweenTheNodes)
{
  const Interpolation            curve          = Helix().interpolate(6);
  const unsigned int             n_subdivisions = 4;
  const std::vector<std::string> names{"x", "y", "z", "s"};
  DataOut<1, 3>                  data_out;
  data_out.attach_dof_handler(curve.dof_handler);
  data_out.add_data_vector(curve.solution, names, DataOut<1, 3>::type_dof_data);
  data_out.build_patches(n_subdivisions);

  std::ostringstream vtu;
  data_out.write_vtu(vtu);
  EXPECT_NE(vtu.str().find("NumberOfPoints=\"30\""), std::string::npos);

  std::stringstream gnuplot;
  gnuplot.precision(10);
  data_out.write_gnuplot(gnuplot);
  const auto next_row = [&gnuplot]() {
    std::string line;
    while (std::getline(gnuplot, line) && (line.empty() || line[0] == '#'))
      ;
    return std::istringstream(line);
  };

  for (const auto &cell : curve.dof_handler.active_cell_iterators())
    for (unsigned int k = 0; k <= n_subdivisions; ++k)
      {
        const double x   = double(k) / n_subdivisions;
        auto         row = next_row();
        Point<3>     on_chord, on_curve;
        row >> on_chord >> on_curve;
        ASSERT_TRUE(row) << "cell " << cell << ", point " << k;
        EXPECT_LT(on_chord.distance(cell->vertex(0) +
                                    x * (cell->vertex(1) - cell->vertex(0))),
                  1e-8);
        EXPECT_LT((on_curve - hermite_cell(curve, cell).position(x)).norm(),
                  1e-6);
      }
}
