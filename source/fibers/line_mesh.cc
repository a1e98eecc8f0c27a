// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <deal.II/grid/grid_in.h>
#include <deal.II/grid/tria.h>

#include <setae/base/exceptions.h>
#include <setae/fibers/line_mesh.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <numeric>
#include <set>
#include <sstream>

namespace Setae
{
  using namespace dealii;

  namespace
  {
    /** Whether @p x has at most @p n_digits digits. */
    bool
    has_digits(const double x, const unsigned int n_digits)
    {
      char text[64];
      std::snprintf(text, sizeof(text), "%.*e", int(n_digits) - 1, x);
      return std::strtod(text, nullptr) == x;
    }

    /** Whether @p x was of single precision before it was written. */
    bool
    was_single(const double x)
    {
      return std::abs(x - static_cast<float>(x)) <= 1e-9 * std::abs(x);
    }

    /** The nodes of a chain of lines that starts at @p first. */
    std::vector<unsigned int>
    chain_from(const std::vector<std::vector<unsigned int>> &neighbors,
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
  } // namespace



  LineMesh::LineMesh(const std::string &file, const std::string &parameter)
    : file(file)
    , parameter(parameter)
  {
    try
      {
        if (std::filesystem::path(file).extension() == ".vtk")
          read_vtk_lines(file, nodes, lines);
        else
          {
            Triangulation<1, 3> mesh;
            GridIn<1, 3>(mesh).read(file);
            for (const Point<3> &vertex : mesh.get_vertices())
              nodes.emplace_back(vertex);
            for (const auto &cell : mesh.active_cell_iterators())
              lines.emplace_back(cell->vertex_index(0), cell->vertex_index(1));
          }
      }
    catch (const std::exception &exception)
      {
        AssertThrow(false,
                    ExcParameter(parameter,
                                 file,
                                 "a mesh of lines that can be read: " +
                                   reason(exception)));
      }
    AssertThrow(!lines.empty(),
                ExcParameter(parameter,
                             file,
                             "a mesh of lines, but it has none"));
    for (const Tensor<1, 3> &node : nodes)
      AssertThrow(std::isfinite(node.norm()),
                  ExcParameter(parameter,
                               file,
                               "a mesh with finite coordinates"));
    find_rounding();
    join_nodes();
  }



  void
  LineMesh::find_rounding()
  {
    // Programs write six digits or more; less are numbers that have no more.
    unsigned int n_digits  = 6;
    double       largest   = 0.;
    bool         is_single = true;
    for (const Tensor<1, 3> &node : nodes)
      for (unsigned int c = 0; c < 3; ++c)
        {
          largest   = std::max(largest, std::abs(node[c]));
          is_single = is_single && was_single(node[c]);
          while (n_digits < 17 && !has_digits(node[c], n_digits))
            ++n_digits;
        }
    if (largest == 0.)
      return;
    rounding =
      std::max(.5 *
                 std::pow(10., 1. + std::floor(std::log10(largest)) - n_digits),
               .5 * largest *
                 (is_single ? std::numeric_limits<float>::epsilon() :
                              std::numeric_limits<double>::epsilon()));
  }



  void
  LineMesh::join_nodes()
  {
    // Nodes at the same place are neighbours in an order along a direction that
    // no mesh has planes across.
    const double       tolerance = 4. * rounding;
    const Tensor<1, 3> skew({1., .6180339887, .3243877291});
    const auto along = [&](const unsigned int v) { return nodes[v] * skew; };
    std::vector<unsigned int> order(nodes.size()), joined_to(nodes.size());
    std::iota(order.begin(), order.end(), 0);
    std::iota(joined_to.begin(), joined_to.end(), 0);
    std::sort(order.begin(), order.end(), [&](unsigned int v, unsigned int w) {
      return std::make_pair(along(v), v) < std::make_pair(along(w), w);
    });
    for (unsigned int i = 0; i < order.size(); ++i)
      for (unsigned int j = i + 1;
           j < order.size() &&
           along(order[j]) - along(order[i]) <= 2. * tolerance;
           ++j)
        if ((nodes[order[i]] - nodes[order[j]]).norm() <= tolerance)
          {
            const unsigned int first =
              std::min(joined_to[order[i]], joined_to[order[j]]);
            joined_to[order[i]] = joined_to[order[j]] = first;
          }

    // What is joined to a node that is joined itself goes to that one's place.
    for (unsigned int v = 0; v < joined_to.size(); ++v)
      while (joined_to[joined_to[v]] != joined_to[v])
        joined_to[v] = joined_to[joined_to[v]];

    std::set<unsigned int> joined;
    for (auto &[first, second] : lines)
      {
        AssertThrow(joined_to[first] != joined_to[second],
                    ExcParameter(parameter,
                                 file,
                                 "a mesh of lines that have a length, but the "
                                 "one from " +
                                   describe(first) + " to " + describe(second) +
                                   " has none"));
        for (unsigned int *v : {&first, &second})
          if (joined_to[*v] != *v)
            {
              joined.insert(*v);
              *v = joined_to[*v];
            }
      }
    n_joined = joined.size();
    if (n_joined > 0)
      first_joined = *joined.begin();
  }



  std::vector<LineMesh::Chain>
  LineMesh::chains() const
  {
    std::vector<std::vector<unsigned int>> neighbors(nodes.size());
    for (const auto &[first, second] : lines)
      {
        neighbors[first].push_back(second);
        neighbors[second].push_back(first);
      }
    for (unsigned int v = 0; v < nodes.size(); ++v)
      {
        const auto &list = neighbors[v];
        AssertThrow(list.size() <= 2,
                    ExcParameter(parameter,
                                 file,
                                 "a mesh of lines without branches, but " +
                                   std::to_string(list.size()) +
                                   " lines meet at " + describe(v)));
        AssertThrow(list.size() < 2 || list[0] != list[1],
                    ExcParameter(parameter,
                                 file,
                                 "a mesh of different lines, but two lead "
                                 "from " +
                                   describe(v) + " to " + describe(list[0])));
      }

    std::vector<Chain> result;
    std::vector<bool>  visited(nodes.size(), false);
    for (const bool closed : {false, true})
      for (unsigned int v = 0; v < nodes.size(); ++v)
        if (!visited[v] && neighbors[v].size() == (closed ? 2 : 1))
          result.push_back({chain_from(neighbors, v, visited), closed});
    return result;
  }



  std::string
  LineMesh::describe(const unsigned int node) const
  {
    std::ostringstream text;
    text << "node " << node << " at (" << nodes[node][0] << ", "
         << nodes[node][1] << ", " << nodes[node][2] << ")";
    return text.str();
  }
} // namespace Setae
