// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_fibers_line_mesh_h
#define setae_fibers_line_mesh_h

#include <deal.II/base/tensor.h>

#include <string>
#include <utility>
#include <vector>

namespace Setae
{
  using dealii::Tensor;

  /** A mesh of lines in space, as a file has it. */
  struct LineMesh
  {
    /** A chain of lines; of a ring, the last node is followed by the first. */
    struct Chain
    {
      std::vector<unsigned int> nodes;
      bool                      closed;
    };

    std::vector<Tensor<1, 3>>                          nodes; ///< [length]
    std::vector<std::pair<unsigned int, unsigned int>> lines;

    /** Half a unit of the last digit that is written of a node [length]. */
    double rounding = 0.;

    /** How many nodes were joined with another one at the same place. */
    unsigned int n_joined = 0;

    /** The first of them. */
    unsigned int first_joined = 0;

    /**
     * Read lines, and polylines of a legacy VTK file in ASCII; points are left
     * out. Nodes at the same place are joined.
     *
     * @throws ExcParameter with what the reader says if it cannot.
     */
    LineMesh(const std::string &file, const std::string &parameter);

    /**
     * All chains, open ones first.
     *
     * @throws ExcParameter if more than two lines meet at a node.
     */
    std::vector<Chain>
    chains() const;

    /** A node with its place, for messages. */
    std::string
    describe(const unsigned int node) const;

  private:
    void
    find_rounding();

    void
    join_nodes();

    std::string file, parameter;
  };



  /**
   * The points and lines of a legacy VTK file in ASCII: an unstructured grid
   * (versions up to 5.1) or poly data.
   *
   * @throws ExcInput with what is wrong with it.
   */
  void
  read_vtk_lines(const std::string                                  &file,
                 std::vector<Tensor<1, 3>>                          &nodes,
                 std::vector<std::pair<unsigned int, unsigned int>> &lines);
} // namespace Setae

#endif
