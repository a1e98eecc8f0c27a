// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_verification_solid_body_h
#define setae_verification_solid_body_h

#include <deal.II/distributed/tria.h>

#include <setae/base/lanes.h>
#include <setae/laws/point_potential.h>
#include <setae/verification/fiber_chart.h>

#include <array>
#include <vector>

namespace Setae
{
  /** A quadrature point of a body [length] with its volume or surface. */
  struct SolidSite
  {
    double x, y, z;
    double weight;
  };

  /** Eight of them; those that are missing in the last block weigh nothing. */
  struct SolidSites
  {
    Lanes x, y, z;
    Lanes weight;
  };

  /** The vector from @p target to @p source, for double_sum(). */
  DEAL_II_ALWAYS_INLINE inline std::array<Lanes, 3>
  connect(const SolidSite &source, const SolidSites &target)
  {
    return {{source.x - target.x, source.y - target.y, source.z - target.z}};
  }



  /**
   * A fiber as a mesh of hexahedra, distributed over the ranks by p4est.
   *
   * The cells with all their ancestors, on all ranks, form a tree: for points
   * far away, an ancestor does as well as its many descendants.
   */
  class SolidBody
  {
  public:
    /** A cell of any level: a part of a cube of the chart. */
    struct Node
    {
      unsigned int     cube;
      dealii::Point<3> corner; ///< the lowest one, in the cube
      double           size;   ///< of the part of the cube

      Tensor<1, 3>                center;
      std::array<Tensor<1, 3>, 3> half_edges;
      double                      slack;  ///< by how far it bulges beyond these
      double                      extent; ///< its longest edge [length]

      unsigned int first_child = 0; ///< of eight; 0: it is an active cell
      unsigned int owner       = 0; ///< rank

      bool
      is_active() const
      {
        return first_child == 0;
      }
    };

    SolidBody(const FiberChart  &chart,
              const Distribution distribution,
              MPI_Comm           communicator);

    /** The cubes of the chart come first. */
    const std::vector<Node> &
    nodes() const
    {
      return tree;
    }

    unsigned int
    n_roots() const
    {
      return chart.n_cubes();
    }

    /** Whether there are points in a node at all. */
    bool
    is_populated(const Node &node) const;

    /** Refine the active cells whose node is marked; collective. */
    void
    refine(const std::vector<bool> &marked_nodes);

    /** Gauss points of the node, @p n_points in each direction. */
    std::vector<SolidSites>
    sites(const Node &node, const unsigned int n_points) const;

    const dealii::parallel::distributed::Triangulation<3> &
    mesh() const
    {
      return triangulation;
    }

    const FiberChart   chart;
    const Distribution distribution; ///< of the points
    const MPI_Comm     communicator;

  private:
    void
    make_grid();

    void
    make_tree();

    /** The node of a cell, with missing ones on the way added. */
    unsigned int
    find_or_add(const dealii::CellId &id);

    void
    locate(Node &node) const;

    dealii::parallel::distributed::Triangulation<3> triangulation;
    std::vector<Node>                               tree;
  };



  /**
   * The distance between two nodes along the line that connects their centers
   * [length]: at most the true one.
   */
  double
  separation(const SolidBody::Node &first, const SolidBody::Node &second);
} // namespace Setae

#endif
