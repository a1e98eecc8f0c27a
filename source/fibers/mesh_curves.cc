// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <setae/base/exceptions.h>
#include <setae/fibers/centerline.h>
#include <setae/fibers/line_mesh.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace Setae
{
  using namespace dealii;

  namespace
  {
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

    /** The rotation from one line to the next: axis times angle in degrees. */
    Tensor<1, 3>
    turn(const Tensor<1, 3> &left,
         const Tensor<1, 3> &middle,
         const Tensor<1, 3> &right)
    {
      const Tensor<1, 3> a = middle - left, b = right - middle;
      const Tensor<1, 3> normal = cross_product_3d(a, b);
      const double       sine   = normal.norm();
      const double       angle  = std::atan2(sine, a * b) * 180. / M_PI;

      // Exactly backwards, any axis is as good.
      return sine > 0. ? angle / sine * normal :
                         Tensor<1, 3>({angle > 0. ? angle : 0., 0., 0.});
    }

    /**
     * Along a curve that lines resolve, directions change by similar rotations
     * at neighbouring nodes. What a rotation has beyond them is a kink.
     */
    void
    check_kinks(const FiberParameters &parameters,
                const LineMesh        &mesh,
                const LineMesh::Chain &chain)
    {
      constexpr double largest_turn = 60.; // a ring of six lines

      const auto               &nodes = chain.nodes;
      const unsigned int        n     = nodes.size();
      const unsigned int        begin = chain.closed ? 0 : 1;
      const unsigned int        end   = chain.closed ? n : n - 1;
      std::vector<Tensor<1, 3>> turns(n);
      for (unsigned int i = begin; i < end; ++i)
        turns[i] = turn(mesh.nodes[nodes[(i + n - 1) % n]],
                        mesh.nodes[nodes[i]],
                        mesh.nodes[nodes[(i + 1) % n]]);
      for (unsigned int i = begin; i < end; ++i)
        {
          const double angle  = turns[i].norm();
          double       common = 0.;
          for (const unsigned int neighbor : {i + n - 1, i + 1})
            if (angle > 0.)
              common = std::max(common, turns[i] * turns[neighbor % n] / angle);
          const double kink =
            angle > largest_turn * (1. + 1e-6) ? angle : angle - common;
          std::ostringstream text;
          text << "a mesh of lines without kinks, but at "
               << mesh.describe(nodes[i]) << " it turns by " << angle
               << " degrees (see 'largest kink')";
          AssertThrow(kink <= parameters.largest_kink,
                      ExcParameter("fibers/" + parameters.name + "/mesh file",
                                   parameters.mesh_file,
                                   text.str()));
        }
    }

    Centerline
    from_chain(const LineMesh &mesh, const LineMesh::Chain &chain)
    {
      Centerline line;
      line.closed   = chain.closed;
      line.rounding = mesh.rounding;
      for (const unsigned int node : chain.nodes)
        line.positions.push_back(mesh.nodes[node]);

      const auto        &x = line.positions;
      const unsigned int n = x.size();
      for (unsigned int i = 0; i < n; ++i)
        if (line.closed || (i > 0 && i + 1 < n))
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
  } // namespace



  std::vector<Centerline>
  centerlines_of_mesh(const FiberParameters    &parameters,
                      std::vector<std::string> &notices)
  {
    const LineMesh     mesh(parameters.mesh_file,
                        "fibers/" + parameters.name + "/mesh file");
    std::ostringstream notice;
    if (mesh.n_joined > 0)
      {
        notice << "The mesh file '" << parameters.mesh_file << "' has "
               << mesh.n_joined
               << " node(s) at the place of another one, which are joined; the "
                  "first is "
               << mesh.describe(mesh.first_joined) << '.';
        notices.push_back(notice.str());
      }

    std::vector<Centerline> lines;
    double                  moved = 0.;
    for (const LineMesh::Chain &chain : mesh.chains())
      {
        check_kinks(parameters, mesh, chain);
        lines.push_back(from_chain(mesh, chain));
        lines.back().copy = {{"i", double(lines.size() - 1)},
                             {"j", 0.},
                             {"k", 0.}};
        if (lines.back().is_straight())
          {
            const auto  &x       = lines.back().positions;
            const double largest = x.front().norm() + x.back().norm();
            const double by      = lines.back().straighten();
            if (by > 1e-14 * largest)
              moved = std::max(moved, by);
          }
      }
    if (moved > 0.)
      {
        notice.str("");
        notice << "The mesh file '" << parameters.mesh_file
               << "' has fibers that are straight within the digits that it is "
                  "written with; their nodes are moved onto lines, by at most "
               << moved << '.';
        notices.push_back(notice.str());
      }
    return lines;
  }
} // namespace Setae
