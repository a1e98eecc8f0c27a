// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_fibers_fiber_system_h
#define setae_fibers_fiber_system_h

#include <deal.II/base/index_set.h>
#include <deal.II/base/mpi.h>

#include <deal.II/distributed/shared_tria.h>

#include <deal.II/dofs/dof_handler.h>

#include <deal.II/fe/fe_system.h>

#include <deal.II/lac/trilinos_vector.h>

#include <setae/fibers/cell_place.h>
#include <setae/fibers/centerline.h>
#include <setae/scene.h>

#include <limits>

namespace Setae
{
  /**
   * One fiber of the mesh: a chain of cells with consecutive indices.
   */
  struct Fiber
  {
    unsigned int section; ///< index of its section of the scene
    std::string  name;    ///< with the number of the copy in an array
    Constants    copy;    ///< the numbers i, j, k of the copy
    unsigned int first_cell;
    unsigned int n_cells;
    bool         closed;

    /** Initial arc length of each node from the start [length]. */
    std::vector<double> arc_length;
  };



  /**
   * The state of all fibers at one time: displacements and positions of every
   * cell, on every rank.
   */
  struct State
  {
    double                     time = 0.;
    std::vector<HermiteCell<>> displacement;
    std::vector<HermiteCell<>> current;
  };



  /**
   * All fibers of a scene: mesh, degrees of freedom, initial centerlines.
   *
   * The unknowns are the displacements of the active coordinates in the space
   * of FE_Hermite. Every rank knows the whole mesh (lines are light) and owns a
   * contiguous part of the cells. The kernels always see three coordinates; the
   * entries of a coordinate that is switched off have the degree of freedom
   * numbers::invalid_dof_index and are dropped in the assembly.
   */
  class FiberSystem
  {
  public:
    using CellDofs = std::array<dealii::types::global_dof_index, 12>;

    FiberSystem(const Scene &scene, MPI_Comm communicator);

    const Scene       &scene;
    const MPI_Comm     communicator;
    std::vector<Fiber> fibers;

    /** The parameters of each fiber, with the numbers of its copy. */
    std::vector<FiberParameters> parameters;

    std::vector<HermiteCell<>> initial; ///< initial curve of each cell

    /** The fiber of each cell. */
    std::vector<unsigned int> fiber_of_cell;

    /** Cells of this rank, ascending. */
    std::vector<unsigned int> owned_cells;

    /** Index 3 a + c for shape function a and coordinate c, of each cell. */
    std::vector<CellDofs> cell_dofs;

    dealii::parallel::shared::Triangulation<1, 3> triangulation;
    dealii::FESystem<1, 3>                        fe;
    dealii::DoFHandler<1, 3>                      dof_handler;
    dealii::IndexSet                              owned_dofs;

    /** Whether the fiber of @p cell keeps its shape. */
    bool
    is_rigid(const unsigned int cell) const;

    const FiberParameters &
    parameters_of_cell(const unsigned int cell) const
    {
      return parameters[fiber_of_cell[cell]];
    }

    /** Where on its fiber @p cell is. */
    CellPlace
    place_of_cell(const unsigned int cell) const;

    /** How many cells lie between two cells of one fiber, plus one. */
    unsigned int
    distance_along_fiber(const unsigned int cell_1,
                         const unsigned int cell_2) const;

    /** The indices of the fibers that any of @p names refers to, ascending. */
    std::vector<unsigned int>
    select(const std::vector<std::string> &names) const;

    /**
     * The fibers among them whose copy meets a condition, a formula of i, j, k
     * or 'all'.
     *
     * @param parameter The full name of the condition, for messages.
     * @throws ExcParameter if it is no formula, or holds for no fiber.
     */
    std::vector<unsigned int>
    select(const std::vector<std::string> &names,
           const std::string              &copies,
           const std::string              &parameter) const;

    /**
     * A degree of freedom of a node of a fiber, or invalid_dof_index for a
     * coordinate that is switched off.
     */
    dealii::types::global_dof_index
    node_dof(const unsigned int fiber,
             const unsigned int node,
             const bool         tangent,
             const unsigned int coordinate) const;

    /** The initial tangent at a node of a fiber, of length 1. */
    Tensor<1, 3>
    initial_tangent(const unsigned int fiber, const unsigned int node) const;

    /**
     * Where on a fiber an arc length is: cell and reference coordinate.
     */
    std::pair<unsigned int, double>
    locate(const unsigned int fiber, const double arc_length) const;

    /**
     * The cells for a solution that knows all its entries on every rank.
     */
    State
    state(const dealii::TrilinosWrappers::MPI::Vector &solution,
          const double                                 time) const;

    /** What became of the geometry that a user should know, in sentences. */
    std::vector<std::string> notices;

  private:
    void
    make_grid();

    void
    distribute_dofs();

    void
    check_curvature(const Centerline &line, const std::string &parameter) const;

    /** Whether coordinates have the digits that gaps and radii need. */
    void
    check_distance(const Centerline &line, const FiberParameters &fiber) const;
  };
} // namespace Setae

#endif
