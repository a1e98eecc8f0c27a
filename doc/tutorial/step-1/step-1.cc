// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

// Step 1: the Hermite element and the elastica. A cantilever under a force at
// its tip is computed on a sequence of meshes and compared with the exact
// solution. The introduction is in doc/intro.md, the output is discussed in
// doc/results.md.

// Mesh, degrees of freedom, constraints and linear algebra are deal.II's:

#include <deal.II/base/convergence_table.h>

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/dofs/dof_tools.h>

#include <deal.II/fe/fe_system.h>

#include <deal.II/grid/tria.h>

#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/sparse_direct.h>
#include <deal.II/lac/sparse_matrix.h>
#include <deal.II/lac/sparsity_pattern.h>
#include <deal.II/lac/vector.h>

// The element and the strain energy of a cell are Setae's. Neither of them
// knows of the other: the element belongs to the mesh, the strain energy is a
// function of the twelve coefficients of one cell.

#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/ellint_2.hpp>
#include <boost/math/tools/roots.hpp>

#include <setae/beams/torsion_free_kirchhoff.h>
#include <setae/fe/fe_hermite.h>

#include <cmath>
#include <iomanip>
#include <iostream>

namespace Step1
{
  using namespace dealii;
  using namespace Setae;

  // Length and bending stiffness are one, the tip is pulled in the direction -y
  // with ten times EI/l^2. The rod of the exact solution cannot stretch, so the
  // axial stiffness is taken so large that stretching does not show in the
  // table: the strain is of the order of 10/EA.
  constexpr double length            = 1.;
  constexpr double bending_stiffness = 1.;
  constexpr double axial_stiffness   = 1e10;
  constexpr double force             = 10.;



  // The elastica in closed form. Let phi(s) be the angle of the tangent with
  // the initial axis and phi_0 the one at the tip. Moment equilibrium is
  // EI phi'' + P cos(phi) = 0 with phi(0) = 0 and phi'(l) = 0. Multiplied by
  // phi' and integrated once it becomes
  // EI/2 phi'^2 = P (sin(phi_0) - sin(phi)), and the substitution
  // sin(phi) = 2 k^2 sin^2(psi) - 1, 2 k^2 = 1 + sin(phi_0), turns ds and dy
  // into Legendre's elliptic integrals.
  Tensor<1, 3>
  exact_tip_displacement()
  {
    using boost::math::ellint_1;
    using boost::math::ellint_2;

    const double a = std::sqrt(force * length * length / bending_stiffness);
    const auto   lower_end = [](const double k) {
      return std::asin(1. / (k * std::sqrt(2.)));
    };
    // The length of the rod determines the modulus k.
    const auto excess_length = [&](const double k) {
      return ellint_1(k) - ellint_1(k, lower_end(k)) - a;
    };
    const auto bracket =
      boost::math::tools::bisect(excess_length,
                                 std::sqrt(.5) * (1. + 1e-14),
                                 1. - 1e-14,
                                 [](const double x, const double y) {
                                   return std::abs(x - y) < 1e-15;
                                 });
    const double k = .5 * (bracket.first + bracket.second);

    const double sin_tip = 2. * k * k - 1.;
    Tensor<1, 3> tip;
    tip[0] = std::sqrt(2. * sin_tip) / a * length - length;
    tip[1] =
      -(1. - 2. / a * (ellint_2(k) - ellint_2(k, lower_end(k)))) * length;
    return tip;
  }



  // The class has the shape of a deal.II tutorial program: mesh and degrees of
  // freedom, assembly, solution, and a function that calls them in turn.
  class Elastica
  {
  public:
    explicit Elastica(const unsigned int n_cells);

    // Find the equilibrium and return the number of Newton iterations.
    unsigned int
    run();

    Tensor<1, 3>
    tip_displacement() const;

    unsigned int
    n_dofs() const
    {
      return dof_handler.n_dofs();
    }

  private:
    void
    setup_system();

    void
    assemble_system(const double load);

    const unsigned int        n_cells;
    Triangulation<1, 3>       triangulation;
    const FESystem<1, 3>      fe;
    DoFHandler<1, 3>          dof_handler;
    AffineConstraints<double> constraints;
    SparsityPattern           sparsity_pattern;
    SparseMatrix<double>      tangent_matrix;
    Vector<double>            displacement, residual;
    types::global_dof_index   tip_dofs[3];
  };



  // The three coordinates of the displacement are three copies of the scalar
  // Hermite element.
  Elastica::Elastica(const unsigned int n_cells)
    : n_cells(n_cells)
    , fe(FE_Hermite<1, 3>(), 3)
    , dof_handler(triangulation)
  {}



  void
  Elastica::setup_system()
  {
    // A chain of cells along the x axis: the polygon of the vertices is the
    // mesh, and the curve will be in the coefficients of the element.
    std::vector<Point<3>>    vertices;
    std::vector<CellData<1>> cells(n_cells);
    for (unsigned int i = 0; i <= n_cells; ++i)
      vertices.emplace_back(i * length / n_cells, 0., 0.);
    for (unsigned int i = 0; i < n_cells; ++i)
      cells[i].vertices = {i, i + 1};
    triangulation.create_triangulation(vertices, cells, SubCellData());
    dof_handler.distribute_dofs(fe);

    // Each vertex owns six degrees of freedom: displacement and derivative of
    // the displacement along the fiber, three coordinates each. A local index
    // belongs to coordinate c and to shape function a = 0..3, in the order
    // value and derivative at the first, value and derivative at the second
    // vertex. The clamp holds the displacement and the direction of the
    // tangent: the derivative in y and z is zero, the one in x, the stretch,
    // is free.
    std::vector<types::global_dof_index> dofs(fe.n_dofs_per_cell());
    for (const auto &cell : dof_handler.active_cell_iterators())
      {
        cell->get_dof_indices(dofs);
        for (unsigned int i = 0; i < dofs.size(); ++i)
          {
            const auto [c, a] = fe.system_to_component_index(i);
            if (cell->active_cell_index() == 0 &&
                (a == 0 || (a == 1 && c != 0)))
              constraints.add_line(dofs[i]);
            if (cell->active_cell_index() == n_cells - 1 && a == 2)
              tip_dofs[c] = dofs[i];
          }
      }
    constraints.close();

    DynamicSparsityPattern pattern(dof_handler.n_dofs());
    DoFTools::make_sparsity_pattern(dof_handler, pattern, constraints, false);
    sparsity_pattern.copy_from(pattern);
    tangent_matrix.reinit(sparsity_pattern);
    displacement.reinit(dof_handler.n_dofs());
    residual.reinit(dof_handler.n_dofs());
  }



  void
  Elastica::assemble_system(const double load)
  {
    tangent_matrix = 0.;
    residual       = 0.;

    const unsigned int                   n = fe.n_dofs_per_cell();
    std::vector<types::global_dof_index> dofs(n);
    FullMatrix<double>                   cell_matrix(n, n);
    Vector<double>                       cell_residual(n);
    for (const auto &cell : dof_handler.active_cell_iterators())
      {
        // The strain energy works on cubic curves. Collect the coefficients of
        // the initial one, which is straight, and of the displacement. Both
        // carry the same length scale, the one of the element.
        HermiteCell<> initial, current;
        initial.h = current.h = FE_Hermite<1, 3>::length_scale(cell);
        for (unsigned int v = 0; v < 2; ++v)
          {
            initial.coefficients[2 * v]        = Tensor<1, 3>(cell->vertex(v));
            initial.coefficients[2 * v + 1][0] = 1.;
          }
        cell->get_dof_indices(dofs);
        for (unsigned int i = 0; i < n; ++i)
          {
            const auto [c, a]          = fe.system_to_component_index(i);
            current.coefficients[a][c] = displacement(dofs[i]);
          }

        // Energy, gradient and Hessian of the cell. There the degree of freedom
        // of shape function a and coordinate c has the number 3 a + c, deal.II
        // numbers them in its own way: the only translation there is.
        const TorsionFreeKirchhoff beam(initial,
                                        {axial_stiffness, bending_stiffness});
        LocalSystem<12>            local;
        beam.add(current, Request::tangent, local);

        const auto place = [&](const unsigned int i) {
          const auto [c, a] = fe.system_to_component_index(i);
          return 3 * a + c;
        };
        for (unsigned int i = 0; i < n; ++i)
          {
            cell_residual(i) = local.residual[place(i)];
            for (unsigned int j = 0; j < n; ++j)
              cell_matrix(i, j) = local.tangent[place(i)][place(j)];
          }
        constraints.distribute_local_to_global(
          cell_matrix, cell_residual, dofs, tangent_matrix, residual);
      }

    // The energy of a dead load is minus force times displacement.
    residual(tip_dofs[1]) += load;
  }



  // Newton's method in load steps. The full increment is always taken. A fiber
  // that bends is stretched by the linearized solution first, so that the
  // residual may rise before it falls; this is harmless as long as the next
  // iterations take the stretch back.
  unsigned int
  Elastica::run()
  {
    setup_system();

    constexpr unsigned int n_load_steps = 10;
    unsigned int           n_iterations = 0;
    for (unsigned int step = 1; step <= n_load_steps; ++step)
      for (unsigned int iteration = 1;; ++iteration)
        {
          AssertThrow(iteration <= 50,
                      ExcMessage("Newton's method does not converge."));
          assemble_system(force * step / n_load_steps);
          SparseDirectUMFPACK solver;
          solver.initialize(tangent_matrix);
          solver.solve(residual);
          constraints.distribute(residual);
          displacement -= residual;
          ++n_iterations;
          if (residual.linfty_norm() < 1e-10)
            break;
        }
    return n_iterations;
  }



  Tensor<1, 3>
  Elastica::tip_displacement() const
  {
    Tensor<1, 3> tip;
    for (unsigned int c = 0; c < 3; ++c)
      tip[c] = displacement(tip_dofs[c]);
    return tip;
  }
} // namespace Step1



// Halve the cells four times and compare. The program fails if the order that
// it finds is not the one it promises, and so serves as a test as well.
int
main()
{
  using namespace Step1;

  const Tensor<1, 3> exact = exact_tip_displacement();
  std::cout << "Exact displacement of the tip: " << std::setprecision(10)
            << exact[0] << ' ' << exact[1] << "\n\n";

  ConvergenceTable table;
  double           last_error = 0., order = 0.;
  for (const unsigned int n_cells : {2, 4, 8, 16, 32})
    {
      Elastica           elastica(n_cells);
      const unsigned int n_iterations = elastica.run();
      const Tensor<1, 3> tip          = elastica.tip_displacement();
      const double       error        = (tip - exact).norm();

      table.add_value("cells", n_cells);
      table.add_value("dofs", elastica.n_dofs());
      table.add_value("iterations", n_iterations);
      table.add_value("u_x", tip[0]);
      table.add_value("u_y", tip[1]);
      table.add_value("error", error);
      order      = std::log2(last_error / error);
      last_error = error;
    }
  table.set_precision("u_x", 8);
  table.set_precision("u_y", 8);
  table.set_precision("error", 3);
  table.set_scientific("error", true);
  table.evaluate_convergence_rates("error",
                                   ConvergenceTable::reduction_rate_log2);
  table.write_text(std::cout);

  if (order < 3.8)
    {
      std::cerr << "The order of convergence is " << order
                << " instead of four.\n";
      return 1;
    }
  return 0;
}
