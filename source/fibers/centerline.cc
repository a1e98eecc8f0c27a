// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <deal.II/grid/grid_in.h>
#include <deal.II/grid/tria.h>

#include <boost/math/differentiation/finite_difference.hpp>

#include <setae/base/exceptions.h>
#include <setae/fibers/centerline.h>

#include <algorithm>

namespace Setae
{
  using namespace dealii;

  namespace
  {
    std::string
    path(const FiberParameters &parameters, const std::string &entry)
    {
      return "fibers/" + parameters.name + "/" + entry;
    }

    /** Nodes at equal steps of s. */
    Centerline
    from_formula(const FiberParameters &parameters,
                 const Constants       &constants,
                 const Constants       &copy)
    {
      Constants all = constants;
      all.insert(copy.begin(), copy.end());
      const VectorExpression x(path(parameters, "centerline"),
                               parameters.centerline,
                               "s",
                               all);

      Centerline line;
      line.copy = copy;
      for (unsigned int i = 0; i <= parameters.n_cells; ++i)
        {
          const double s = parameters.length * i / parameters.n_cells;
          Tensor<1, 3> derivative;
          for (unsigned int c = 0; c < 3; ++c)
            derivative[c] =
              boost::math::differentiation::finite_difference_derivative(
                [&](const double y) { return x(y)[c]; }, s);
          const double norm = derivative.norm();
          AssertThrow(norm > 1e-8,
                      ExcParameter(path(parameters, "centerline"),
                                   parameters.centerline,
                                   "a curve with a tangent at every s"));

          // What the differences leave of a component that is zero.
          Tensor<1, 3> tangent = derivative / norm;
          for (unsigned int c = 0; c < 3; ++c)
            if (std::abs(tangent[c]) < 1e-11)
              tangent[c] = 0.;
          line.positions.push_back(x(s));
          line.tangents.push_back(tangent / tangent.norm());
        }
      return line;
    }

    /** The array of copies, i running slowest. */
    std::vector<Centerline>
    from_formulas(const FiberParameters &parameters, const Constants &constants)
    {
      std::array<unsigned int, 3> n = {{1, 1, 1}};
      std::copy(parameters.copies.begin(), parameters.copies.end(), n.begin());

      std::vector<Centerline> lines;
      for (unsigned int i = 0; i < n[0]; ++i)
        for (unsigned int j = 0; j < n[1]; ++j)
          for (unsigned int k = 0; k < n[2]; ++k)
            lines.push_back(from_formula(
              parameters,
              constants,
              {{"i", double(i)}, {"j", double(j)}, {"k", double(k)}}));
      return lines;
    }

    /**
     * Tangent of the circle through three nodes at the middle one, or at the
     * first one if @p at_first.
     */
    Tensor<1, 3>
    circle_tangent(const Tensor<1, 3> &left,
                   const Tensor<1, 3> &middle,
                   const Tensor<1, 3> &right,
                   const bool          at_first = false)
    {
      const Tensor<1, 3> a = middle - left, b = right - middle;
      const double       l = a.norm(), r = b.norm();
      const Tensor<1, 3> t    = (r / l) * a + (l / r) * b;
      const Tensor<1, 3> unit = t / t.norm();

      // On a circle, a chord is the mirror axis of the tangents at its ends.
      const Tensor<1, 3> e = a / l;
      return at_first ? Tensor<1, 3>(2. * (e * unit) * e - unit) : unit;
    }

    /** The nodes of a chain of lines that starts at @p first. */
    std::vector<unsigned int>
    chain(const std::vector<std::vector<unsigned int>> &neighbors,
          const unsigned int                            first,
          std::vector<bool>                            &visited)
    {
      std::vector<unsigned int> nodes = {first};
      visited[first]                  = true;
      for (bool found = true; found;)
        {
          found = false;
          for (const unsigned int next : neighbors[nodes.back()])
            if (!visited[next])
              {
                visited[next] = true;
                nodes.push_back(next);
                found = true;
                break;
              }
        }
      return nodes;
    }

    Centerline
    from_nodes(const std::vector<Point<3>>     &vertices,
               const std::vector<unsigned int> &nodes,
               const bool                       closed)
    {
      Centerline line;
      line.closed = closed;
      line.copy   = {{"i", 0.}, {"j", 0.}, {"k", 0.}};
      for (const unsigned int node : nodes)
        line.positions.push_back(vertices[node]);

      const auto        &x = line.positions;
      const unsigned int n = x.size();
      for (unsigned int i = 0; i < n; ++i)
        if (closed || (i > 0 && i + 1 < n))
          line.tangents.push_back(
            circle_tangent(x[(i + n - 1) % n], x[i], x[(i + 1) % n]));
        else if (n == 2)
          line.tangents.push_back((x[1] - x[0]) / (x[1] - x[0]).norm());
        else if (i == 0)
          line.tangents.push_back(circle_tangent(x[0], x[1], x[2], true));
        else
          line.tangents.push_back(
            -circle_tangent(x[n - 1], x[n - 2], x[n - 3], true));
      return line;
    }

    std::vector<Centerline>
    from_mesh_file(const FiberParameters &parameters)
    {
      const std::string   parameter = path(parameters, "mesh file");
      Triangulation<1, 3> mesh;
      try
        {
          GridIn<1, 3>(mesh).read(parameters.mesh_file);
        }
      catch (const std::exception &)
        {
          AssertThrow(false,
                      ExcParameter(parameter,
                                   parameters.mesh_file,
                                   "a mesh of lines that GridIn can read"));
        }

      std::vector<std::vector<unsigned int>> neighbors(mesh.n_vertices());
      for (const auto &cell : mesh.active_cell_iterators())
        for (const unsigned int v : {0u, 1u})
          neighbors[cell->vertex_index(v)].push_back(cell->vertex_index(1 - v));
      for (const auto &list : neighbors)
        AssertThrow(list.size() <= 2,
                    ExcParameter(parameter,
                                 parameters.mesh_file,
                                 "a mesh of lines without branches"));

      std::vector<Centerline> lines;
      std::vector<bool>       visited(mesh.n_vertices(), false);
      for (const bool closed : {false, true})
        for (unsigned int v = 0; v < mesh.n_vertices(); ++v)
          if (!visited[v] && neighbors[v].size() == (closed ? 2 : 1))
            lines.push_back(from_nodes(mesh.get_vertices(),
                                       chain(neighbors, v, visited),
                                       closed));
      return lines;
    }
  } // namespace



  HermiteCell<>
  Centerline::cell(const unsigned int i) const
  {
    const unsigned int next = (i + 1) % positions.size();
    return {{{positions[i], tangents[i], positions[next], tangents[next]}},
            (positions[next] - positions[i]).norm()};
  }



  bool
  Centerline::is_straight() const
  {
    const auto deviates = [this](const Tensor<1, 3> &direction) {
      return (direction / direction.norm() - tangents[0]).norm() > 1e-10;
    };
    for (unsigned int i = 1; i < positions.size(); ++i)
      if (deviates(tangents[i]) || deviates(positions[i] - positions[i - 1]))
        return false;
    return true;
  }



  std::vector<Centerline>
  make_centerlines(const FiberParameters &parameters,
                   const Constants       &constants)
  {
    return parameters.mesh_file.empty() ? from_formulas(parameters, constants) :
                                          from_mesh_file(parameters);
  }
} // namespace Setae
