// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_far_field_cluster_tree_h
#define setae_far_field_cluster_tree_h

#include <deal.II/base/tensor.h>

#include <array>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

namespace Setae
{
  using dealii::Tensor;

  /**
   * A hierarchy of clusters of cells: single cells at the bottom, halves of a
   * fiber, whole fibers, and groups of fibers that are near each other. Because
   * no cluster but those within a fiber holds a part of it, pairs of clusters
   * are pairs of different fibers or of parts of one, so that what does not
   * interact can be told from the clusters.
   *
   * Several such trees, of fibers with different roles, may be in one object.
   */
  class ClusterTree
  {
  public:
    static constexpr unsigned int none =
      std::numeric_limits<unsigned int>::max();

    /** Consecutive cells of a fiber. */
    struct Chain
    {
      unsigned int first_cell;
      unsigned int n_cells;
    };

    struct Cluster
    {
      Tensor<1, 3>                center;      ///< does not move with the cells
      double                      radius = 0.; ///< around all points [length]
      unsigned int                parent = none;
      std::array<unsigned int, 2> children{{none, none}};
      unsigned int                chain = none; ///< if all cells are of one

      /** Of a cluster in a chain, the first cell and the one after the last. */
      unsigned int begin = none, end = none;

      bool
      is_cell() const
      {
        return children[0] == none;
      }
    };

    /** The control points of a cell or any points whose hull contains it. */
    using ControlPoints = std::array<Tensor<1, 3>, 4>;

    /** Parents come before their children. */
    std::vector<Cluster> clusters;

    /** The cluster of each cell, or none. */
    std::vector<unsigned int> cluster_of_cell;

    /** Remove all clusters; there are @p n_cells cells. */
    void
    clear(const unsigned int n_cells);

    /**
     * Add a tree.
     *
     * @param cells control points of all cells [length]
     * @param all_chains all fibers
     * @param members indices of the fibers of this tree, at least one
     *
     * @return The cluster of all of them.
     */
    unsigned int
    add_tree(const std::vector<ControlPoints> &cells,
             const std::vector<Chain>         &all_chains,
             std::vector<unsigned int>         members);

    /** Says something about two different clusters. */
    using Predicate =
      std::function<bool(const unsigned int A, const unsigned int B)>;

    /** Pairs of clusters; of each two cells at most one pair has both. */
    struct Pairs
    {
      std::vector<std::pair<unsigned int, unsigned int>> far;
      std::vector<std::pair<unsigned int, unsigned int>> near; ///< of cells
    };

    /**
     * Divide all pairs of cells of the clusters @p A and @p B, which may be the
     * same, into pairs of clusters that are far by @p is_far and pairs of cells
     * that are not.
     *
     * @param within_chains whether a chain meets itself
     */
    void
    find_pairs(const unsigned int A,
               const unsigned int B,
               const bool         within_chains,
               const Predicate   &is_far,
               Pairs             &pairs) const;

  private:
    unsigned int
    add_group(const std::vector<ControlPoints>   &cells,
              const std::vector<Chain>           &all_chains,
              std::vector<unsigned int>::iterator first,
              std::vector<unsigned int>::iterator last,
              const unsigned int                  parent);

    unsigned int
    add_part(const std::vector<ControlPoints> &cells,
             const unsigned int                chain,
             const unsigned int                begin,
             const unsigned int                end,
             const unsigned int                parent);
  };
} // namespace Setae

#endif
