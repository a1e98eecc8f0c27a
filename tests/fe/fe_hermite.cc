// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <deal.II/base/function.h>
#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>

#include <deal.II/distributed/shared_tria.h>

#include <deal.II/fe/fe_values.h>

#include <deal.II/lac/affine_constraints.h>

#include <deal.II/numerics/vector_tools.h>

#include <gtest/gtest.h>

#include <setae/kinematics/hermite.h>

#include "interpolation.h"

using namespace Setae::Testing;
using Setae::FE_Hermite;
namespace Hermite = Setae::Hermite;

namespace
{
  const UpdateFlags all_values =
    update_values | update_gradients | update_hessians | update_3rd_derivatives;

  /**
   * A cubic and its derivatives over the arc length of a straight line.
   */
  double
  cubic(const double s, const unsigned int derivative = 0)
  {
    return derivative == 0 ? 1. + s * (2. + s * (-3. + s * 0.5)) :
           derivative == 1 ? 2. + s * (-6. + s * 1.5) :
           derivative == 2 ? -6. + 3. * s :
                             3.;
  }

  const Tensor<1, 3> oblique({1. / 3., 2. / 3., -2. / 3.});

  Interpolation
  cubic_on_a_line(const unsigned int n_cells)
  {
    return Interpolation([](const double s) { return Point<3>(s * oblique); },
                         uneven_nodes(4., n_cells),
                         1,
                         [](auto, auto s) { return cubic(s); },
                         [](auto, auto s) { return cubic(s, 1); });
  }
} // namespace



TEST(FEHermite, HasAValueAndADerivativeAtEachVertex)
{
  const FE_Hermite<1, 3> fe;
  EXPECT_EQ(fe.n_dofs_per_vertex(), 2u);
  EXPECT_EQ(fe.n_dofs_per_line(), 0u);
  EXPECT_EQ(fe.degree, 3u);
  EXPECT_TRUE(fe.conforms(FiniteElementData<1>::H2));
  EXPECT_FALSE(fe.has_support_points());
  EXPECT_FALSE(fe.has_generalized_support_points());
  EXPECT_EQ(fe.get_name(), "FE_Hermite<1,3>()");
  EXPECT_TRUE(*fe.clone() == fe);
}



TEST(FEHermite, UnitCellHasTheHermitePolynomialsOfUnitLength)
{
  const FE_Hermite<1, 3> fe;
  for (const double x : {0., 0.1, 0.35, 0.5, 0.8, 1.})
    {
      const Point<1> p(x);
      for (unsigned int i = 0; i < Hermite::n_shapes; ++i)
        {
          EXPECT_NEAR(fe.shape_value(i, p),
                      Hermite::shape_values(x, 1.)[i],
                      1e-15);
          EXPECT_NEAR(fe.shape_grad(i, p)[0],
                      Hermite::shape_derivatives(x, 1.)[i],
                      1e-14);
          EXPECT_NEAR(fe.shape_grad_grad(i, p)[0][0],
                      Hermite::shape_second_derivatives(x, 1.)[i],
                      1e-14);
        }
      EXPECT_NEAR(fe.shape_value(0, p) + fe.shape_value(2, p), 1., 1e-15);
      EXPECT_NEAR(fe.shape_grad(0, p)[0] + fe.shape_grad(2, p)[0], 0., 1e-15);
    }
}



TEST(FEHermite, CountsTwoDofsPerNodeAndComponent)
{
  const unsigned int n_cells = 6;
  for (const unsigned int n_components : {1, 3, 5})
    {
      const Interpolation zero(
        [](const double s) { return Point<3>(s * oblique); },
        uneven_nodes(4., n_cells),
        n_components,
        [](auto, auto) { return 0.; },
        [](auto, auto) { return 0.; });
      EXPECT_EQ(zero.dof_handler.n_dofs(), (n_cells + 1) * 2 * n_components);
    }
}



// Equal neighbours matter: FEValues then takes the second cell for a
// translation of the first and may reuse what it holds.
TEST(FEHermite, ScalesTheDerivativeShapesCellByCell)
{
  Triangulation<1, 3> mesh;
  make_polygon({{0., 0., 0.},
                {1., 2., 2.},
                {2., 4., 4.},
                {3., 6., 6.},
                {3., 6., 8.},
                {3., 6., 8.5}},
               mesh);
  const FE_Hermite<1, 3> fe;
  FEValues<1, 3> fe_values(fe, QGauss<1>(3), all_values | update_JxW_values);

  for (unsigned int visit = 0; visit < 2; ++visit)
    for (const auto &cell : mesh.active_cell_iterators())
      {
        fe_values.reinit(cell);
        const double       h    = FE_Hermite<1, 3>::length_scale(cell);
        const Tensor<1, 3> e    = chord_direction(cell);
        double             size = 0.;
        for (const unsigned int q : fe_values.quadrature_point_indices())
          {
            const double x = fe_values.get_quadrature().point(q)[0];
            size += fe_values.JxW(q);
            for (unsigned int i = 0; i < Hermite::n_shapes; ++i)
              {
                const auto value = Hermite::shape_values(x, h)[i];
                const auto first = Hermite::shape_derivatives(x, h)[i] / h;
                const auto second =
                  Hermite::shape_second_derivatives(x, h)[i] / (h * h);
                const auto third =
                  Hermite::shape_third_derivatives(h)[i] / (h * h * h);
                const Tensor<2, 3> ee  = outer_product(e, e);
                const Tensor<3, 3> eee = outer_product(ee, e);

                EXPECT_NEAR(fe_values.shape_value(i, q), value, 1e-14);
                EXPECT_LT((fe_values.shape_grad(i, q) - first * e).norm(),
                          1e-13);
                EXPECT_LT((fe_values.shape_hessian(i, q) - second * ee).norm(),
                          1e-12);
                EXPECT_LT(
                  (fe_values.shape_3rd_derivative(i, q) - third * eee).norm(),
                  1e-11);
              }
          }
        EXPECT_NEAR(size, h, 1e-14);
      }
}



TEST(FEHermite, FacesShowTheNodalDegreesOfFreedom)
{
  const FE_Hermite<1, 3> fe;
  const Interpolation    curve = Helix().interpolate(6);
  FEFaceValues<1, 3>     face_values(fe,
                                 Quadrature<0>(1),
                                 update_values | update_gradients);
  for (const auto &cell : curve.mesh.active_cell_iterators())
    for (const unsigned int face : cell->face_indices())
      {
        face_values.reinit(cell, face);
        for (unsigned int i = 0; i < fe.n_dofs_per_cell(); ++i)
          {
            EXPECT_NEAR(face_values.shape_value(i, 0), i == 2 * face, 1e-14);
            EXPECT_NEAR(face_values.shape_grad(i, 0) * chord_direction(cell),
                        i == 2 * face + 1,
                        1e-13);
          }
      }
}



TEST(FEHermite, ReproducesCubicsOnAnUnevenLine)
{
  const Interpolation line = cubic_on_a_line(8);
  FEValues<1, 3>      fe_values(line.fe,
                           QGauss<1>(5),
                           all_values | update_quadrature_points);

  const unsigned int        n_q = fe_values.n_quadrature_points;
  std::vector<double>       values(n_q);
  std::vector<Tensor<1, 3>> gradients(n_q);
  std::vector<Tensor<2, 3>> hessians(n_q);
  std::vector<Tensor<3, 3>> third_derivatives(n_q);
  const Tensor<2, 3>        ee  = outer_product(oblique, oblique);
  const Tensor<3, 3>        eee = outer_product(ee, oblique);

  for (const auto &cell : line.dof_handler.active_cell_iterators())
    {
      fe_values.reinit(cell);
      fe_values.get_function_values(line.solution, values);
      fe_values.get_function_gradients(line.solution, gradients);
      fe_values.get_function_hessians(line.solution, hessians);
      fe_values.get_function_third_derivatives(line.solution,
                                               third_derivatives);
      for (unsigned int q = 0; q < n_q; ++q)
        {
          const double s = fe_values.quadrature_point(q) * oblique;
          EXPECT_NEAR(values[q], cubic(s), 1e-13);
          EXPECT_LT((gradients[q] - cubic(s, 1) * oblique).norm(), 1e-12);
          EXPECT_LT((hessians[q] - cubic(s, 2) * ee).norm(), 1e-11);
          EXPECT_LT((third_derivatives[q] - cubic(s, 3) * eee).norm(), 1e-9);
        }
    }
}



TEST(FEHermite, ProjectionFindsTheDerivativesOfACubic)
{
  const Interpolation                       line = cubic_on_a_line(8);
  const ScalarFunctionFromFunctionObject<3> function(
    [](const Point<3> &p) { return cubic(p * oblique); });

  AffineConstraints<double> constraints;
  constraints.close();
  Vector<double> projection(line.dof_handler.n_dofs());
  VectorTools::project(
    line.dof_handler, constraints, QGauss<1>(5), function, projection);

  projection -= line.solution;
  EXPECT_LT(projection.linfty_norm(), 1e-10 * line.solution.linfty_norm());

  Vector<double> errors(line.mesh.n_active_cells());
  VectorTools::integrate_difference(line.dof_handler,
                                    line.solution,
                                    function,
                                    errors,
                                    QGauss<1>(5),
                                    VectorTools::L2_norm);
  EXPECT_LT(errors.l2_norm(), 1e-13);
}



TEST(FEHermite, WorksOnASharedTriangulation)
{
  const unsigned int                    n_cells = 8;
  parallel::shared::Triangulation<1, 3> mesh(
    MPI_COMM_WORLD,
    Triangulation<1, 3>::none,
    false,
    parallel::shared::Triangulation<1, 3>::partition_zorder);
  std::vector<Point<3>> vertices;
  for (const double s : uneven_nodes(4., n_cells))
    vertices.emplace_back(s * oblique);
  make_polygon(vertices, mesh);

  const FESystem<1, 3> fe(FE_Hermite<1, 3>(), 3);
  DoFHandler<1, 3>     dof_handler(mesh);
  dof_handler.distribute_dofs(fe);
  EXPECT_EQ(dof_handler.n_dofs(), (n_cells + 1) * 2 * 3);
  EXPECT_EQ(Utilities::MPI::sum(dof_handler.n_locally_owned_dofs(),
                                MPI_COMM_WORLD),
            dof_handler.n_dofs());

  FEValues<1, 3> fe_values(fe, QGauss<1>(2), update_values | update_JxW_values);
  double         integral = 0.;
  for (const auto &cell : dof_handler.active_cell_iterators())
    if (cell->is_locally_owned())
      {
        fe_values.reinit(cell);
        for (const unsigned int q : fe_values.quadrature_point_indices())
          for (unsigned int i = 0; i < fe.n_dofs_per_cell(); ++i)
            if (fe.system_to_component_index(i).second == 1)
              integral += fe_values.shape_value(i, q) * fe_values.JxW(q);
      }
  // Three components times the sum over the cells of h^2 / 12.
  EXPECT_NEAR(Utilities::MPI::sum(integral, MPI_COMM_WORLD),
              3. * 4. * (std::pow(0.65, 2) + std::pow(0.35, 2)) / 12.,
              1e-14);
}
