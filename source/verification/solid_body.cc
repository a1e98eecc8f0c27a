// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <deal.II/base/quadrature_lib.h>

#include <deal.II/grid/cell_id.h>

#include <setae/verification/solid_body.h>

#include <algorithm>

namespace Setae
{
  using namespace dealii;

  SolidBody::SolidBody(const FiberChart  &chart,
                       const Distribution distribution,
                       MPI_Comm           communicator)
    : chart(chart)
    , distribution(distribution)
    , communicator(communicator)
    , triangulation(communicator)
  {
    make_grid();
    make_tree();
  }



  void
  SolidBody::make_grid()
  {
    // Between two blocks, there are the corners of the inner square and,
    // farther out, four points on the surface.
    constexpr unsigned int n_per_plane = 8;
    std::vector<Point<3>>  vertices;
    for (unsigned int plane = 0; plane <= chart.n_blocks(); ++plane)
      {
        const bool         is_last = plane == chart.n_blocks();
        const unsigned int block   = is_last ? plane - 1 : plane;
        for (const double x : {0., 1.})
          for (unsigned int sector = 0; sector < 4; ++sector)
            vertices.emplace_back(
              chart.position(FiberChart::n_sectors * block + sector,
                             Point<3>(x, 0., is_last ? 1. : 0.)));
      }

    std::vector<CellData<3>> cells;
    for (unsigned int block = 0; block < chart.n_blocks(); ++block)
      for (unsigned int sector = 0; sector < FiberChart::n_sectors; ++sector)
        {
          const unsigned int                next = (sector + 1) % 4;
          const std::array<unsigned int, 4> corners =
            sector == FiberChart::inner_sector ?
              std::array<unsigned int, 4>{{3, 0, 2, 1}} :
              std::array<unsigned int, 4>{{sector, 4 + sector, next, 4 + next}};
          CellData<3> cell;
          for (unsigned int v = 0; v < 8; ++v)
            cell.vertices[v] = n_per_plane * (block + v / 4) + corners[v % 4];
          cells.push_back(cell);
        }
    triangulation.create_triangulation(vertices, cells, SubCellData());
  }



  void
  SolidBody::make_tree()
  {
    std::vector<CellId> owned;
    for (const auto &cell : triangulation.active_cell_iterators())
      if (cell->is_locally_owned())
        owned.push_back(cell->id());
    const std::vector<std::vector<CellId>> cells =
      Utilities::MPI::all_gather(communicator, owned);

    tree.clear();
    for (unsigned int cube = 0; cube < n_roots(); ++cube)
      {
        Node root{};
        root.cube = cube;
        root.size = 1.;
        locate(root);
        tree.push_back(root);
      }
    for (unsigned int rank = 0; rank < cells.size(); ++rank)
      for (const CellId &id : cells[rank])
        tree[find_or_add(id)].owner = rank;

    // Children come later than their parents.
    for (auto node = tree.rbegin(); node != tree.rend(); ++node)
      if (!node->is_active())
        node->owner = tree[node->first_child].owner;
  }



  unsigned int
  SolidBody::find_or_add(const CellId &id)
  {
    unsigned int node = id.get_coarse_cell_id();
    for (const auto child : id.get_child_indices())
      {
        if (tree[node].is_active())
          {
            tree[node].first_child = tree.size();
            for (unsigned int c = 0; c < GeometryInfo<3>::max_children_per_cell;
                 ++c)
              {
                Node part{};
                part.cube = tree[node].cube;
                part.size = tree[node].size / 2.;
                for (unsigned int d = 0; d < 3; ++d)
                  part.corner[d] =
                    tree[node].corner[d] + ((c >> d) % 2) * part.size;
                locate(part);
                tree.push_back(part);
              }
          }
        node = tree[node].first_child + child;
      }
    return node;
  }



  /** Where the node is in space, from 27 points of it. */
  void
  SolidBody::locate(Node &node) const
  {
    std::array<Tensor<1, 3>, 27> points;
    for (unsigned int i = 0; i < 27; ++i)
      {
        const Point<3> p(.5 * (i % 3), .5 * (i / 3 % 3), .5 * (i / 9));
        points[i] =
          chart.position(node.cube, node.corner + node.size * Tensor<1, 3>(p));
      }
    node.center = points[13];
    node.extent = 0.;
    for (unsigned int d = 0; d < 3; ++d)
      {
        const unsigned int step = d == 0 ? 1 : d == 1 ? 3 : 9;
        node.half_edges[d]      = .5 * (points[13 + step] - points[13 - step]);
        node.extent = std::max(node.extent, 2. * node.half_edges[d].norm());
      }
    node.slack = 0.;
    for (unsigned int i = 0; i < 27; ++i)
      {
        Tensor<1, 3> deviation = points[i] - node.center;
        deviation -= (double(i % 3) - 1.) * node.half_edges[0];
        deviation -= (double(i / 3 % 3) - 1.) * node.half_edges[1];
        deviation -= (double(i / 9) - 1.) * node.half_edges[2];
        node.slack = std::max(node.slack, deviation.norm());
      }
  }



  bool
  SolidBody::is_populated(const Node &node) const
  {
    return distribution == Distribution::volume ||
           (FiberChart::is_outer(node.cube) &&
            node.corner[0] + node.size == 1.);
  }



  void
  SolidBody::refine(const std::vector<bool> &marked_nodes)
  {
    for (const auto &cell : triangulation.active_cell_iterators())
      if (cell->is_locally_owned() && marked_nodes[find_or_add(cell->id())])
        cell->set_refine_flag();
    triangulation.execute_coarsening_and_refinement();
    make_tree();
  }



  std::vector<SolidSites>
  SolidBody::sites(const Node &node, const unsigned int n_points) const
  {
    const QGauss<1>    rule(n_points);
    const bool         is_volume = distribution == Distribution::volume;
    const unsigned int n_radial  = is_volume ? n_points : 1;
    const unsigned int n         = n_radial * n_points * n_points;
    const double       measure   = std::pow(node.size, is_volume ? 3 : 2);
    const auto         x         = [&](const unsigned int q, const unsigned d) {
      return node.corner[d] + node.size * rule.point(q)[0];
    };

    std::vector<FiberChart::Place> places;
    for (unsigned int j = 0; j < n_points; ++j)
      for (unsigned int i = 0; i < n_radial; ++i)
        {
          places.push_back(is_volume ?
                             FiberChart::place(node.cube, x(i, 0), x(j, 1)) :
                             FiberChart::boundary_place(node.cube, x(j, 1)));
          places.back().area *=
            (is_volume ? rule.weight(i) : 1.) * rule.weight(j);
        }

    std::vector<SolidSites> result((n + n_lanes - 1) / n_lanes);
    unsigned int            index = 0;
    FiberChart::Site        site{};
    for (unsigned int k = 0; k < n_points; ++k)
      {
        const FiberChart::Section section = chart.section(node.cube, x(k, 2));
        for (const FiberChart::Place &place : places)
          {
            site = chart.site(section, place, is_volume ? 3 : 2);
            SolidSites        &block = result[index / n_lanes];
            const unsigned int lane  = index % n_lanes;
            block.x[lane]            = site.r[0];
            block.y[lane]            = site.r[1];
            block.z[lane]            = site.r[2];
            block.weight[lane]       = measure * rule.weight(k) * site.weight;
            ++index;
          }
      }
    // Fill up with weightless copies of the last one.
    for (; index % n_lanes != 0; ++index)
      {
        SolidSites        &block = result.back();
        const unsigned int lane  = index % n_lanes;
        block.x[lane]            = site.r[0];
        block.y[lane]            = site.r[1];
        block.z[lane]            = site.r[2];
        block.weight[lane]       = 0.;
      }
    return result;
  }



  double
  separation(const SolidBody::Node &first, const SolidBody::Node &second)
  {
    const Tensor<1, 3> d        = first.center - second.center;
    const double       distance = d.norm();
    double             reach    = 0.;
    for (unsigned int i = 0; i < 3; ++i)
      reach +=
        std::abs(first.half_edges[i] * d) + std::abs(second.half_edges[i] * d);
    return distance - reach / distance - first.slack - second.slack;
  }
} // namespace Setae
