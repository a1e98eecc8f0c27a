// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_tests_fe_interpolation_h
#define setae_tests_fe_interpolation_h

#include <deal.II/base/point.h>

#include <deal.II/dofs/dof_handler.h>

#include <deal.II/fe/fe_system.h>

#include <deal.II/grid/tria.h>

#include <deal.II/lac/vector.h>

#include <setae/fe/fe_hermite.h>

#include <cmath>
#include <functional>
#include <vector>

/**
 * Curves, and fields interpolated on them, for the tests of the element.
 */
namespace Setae::Testing
{
  using namespace dealii;

  /**
   * Nodes at arc lengths from 0 to @p length with cells alternately 1.3 and 0.7
   * times as long as the average. Doubling the (even) number of cells halves
   * every cell and leaves the mesh as uneven as it was.
   */
  inline std::vector<double>
  uneven_nodes(const double length, const unsigned int n_cells)
  {
    std::vector<double> nodes;
    for (unsigned int i = 0; i <= n_cells; ++i)
      nodes.push_back(length / n_cells * (i + (i % 2 == 1 ? 0.3 : 0.)));
    return nodes;
  }



  inline void
  make_polygon(const std::vector<Point<3>> &vertices, Triangulation<1, 3> &mesh)
  {
    std::vector<CellData<1>> cells(vertices.size() - 1);
    for (unsigned int i = 0; i < cells.size(); ++i)
      cells[i].vertices = {i, i + 1};
    mesh.create_triangulation(vertices, cells, SubCellData());
  }



  /**
   * The unit vector from the first to the second vertex of @p cell.
   */
  template <typename Cell>
  Tensor<1, 3>
  chord_direction(const Cell &cell)
  {
    const Tensor<1, 3> chord = cell->vertex(1) - cell->vertex(0);
    return chord / chord.norm();
  }



  /**
   * A polygon with its vertices on a curve as the mesh, and a field of one or
   * more components interpolated at these nodes.
   */
  struct Interpolation
  {
    /** A component of a field over the arc length of the curve. */
    using Field = std::function<double(const unsigned int c, const double s)>;

    Triangulation<1, 3>       mesh;
    const std::vector<double> nodes; // arc lengths of the vertices
    const FESystem<1, 3>      fe;
    DoFHandler<1, 3>          dof_handler;
    Vector<double>            solution;

    Interpolation(const std::function<Point<3>(const double s)> &curve,
                  const std::vector<double>                     &nodes,
                  const unsigned int                             n_components,
                  const Field                                   &value,
                  const Field                                   &derivative)
      : nodes(nodes)
      , fe(FE_Hermite<1, 3>(), n_components)
      , dof_handler(mesh)
    {
      std::vector<Point<3>> vertices;
      for (const double s : nodes)
        vertices.push_back(curve(s));
      make_polygon(vertices, mesh);
      dof_handler.distribute_dofs(fe);
      solution.reinit(dof_handler.n_dofs());

      Vector<double> local(fe.n_dofs_per_cell());
      for (const auto &cell : dof_handler.active_cell_iterators())
        {
          for (unsigned int i = 0; i < fe.n_dofs_per_cell(); ++i)
            {
              const auto [c, shape] = fe.system_to_component_index(i);
              const double s        = nodes[cell->vertex_index(shape / 2)];
              local(i) = shape % 2 == 0 ? value(c, s) : derivative(c, s);
            }
          cell->set_dof_values(local, solution);
        }
    }
  };



  /**
   * A helix of radius 1 and slope 1/2 over its arc length. Its fourth component
   * is the arc length.
   */
  struct Helix
  {
    static constexpr double radius = 1., slope = 0.5;
    const double            w = 1. / std::hypot(radius, slope);

    double
    value(const unsigned int c, const double s) const
    {
      return c == 0 ? radius * std::cos(w * s) :
             c == 1 ? radius * std::sin(w * s) :
             c == 2 ? slope * w * s :
                      s;
    }

    double
    derivative(const unsigned int c, const double s) const
    {
      return c == 0 ? -radius * w * std::sin(w * s) :
             c == 1 ? radius * w * std::cos(w * s) :
             c == 2 ? slope * w :
                      1.;
    }

    Interpolation
    interpolate(const unsigned int n_cells) const
    {
      return {[this](const double s) {
                return Point<3>(value(0, s), value(1, s), value(2, s));
              },
              uneven_nodes(5., n_cells),
              4,
              [this](const unsigned int c, const double s) {
                return value(c, s);
              },
              [this](const unsigned int c, const double s) {
                return derivative(c, s);
              }};
    }
  };
} // namespace Setae::Testing

#endif
