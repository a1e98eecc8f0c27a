// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_assembly_global_system_h
#define setae_assembly_global_system_h

#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>
#include <deal.II/lac/trilinos_vector.h>
#include <deal.II/lac/vector.h>

#include <setae/base/local_system.h>
#include <setae/fibers/fiber_system.h>

namespace Setae
{
  /**
   * Where the energy terms add what they compute on cells and pairs of cells:
   * the tangent matrix and right-hand side of the Newton increment, with the
   * supports eliminated, and the complete residual, whose entries at the
   * supports are the reactions.
   */
  class GlobalSystem
  {
  public:
    GlobalSystem(const FiberSystem &fibers);

    /** Take the pattern of the tangent matrix; frees the old matrix. */
    void
    reinit_matrix(const dealii::DynamicSparsityPattern &pattern);

    /**
     * Set to zero. @p constraints hold the increments of the supported degrees of
     * freedom and must live until finish().
     */
    void
    start(const Request                            request,
          const dealii::AffineConstraints<double> &constraints);

    /** Add the system of one cell. */
    void
    add(const unsigned int cell, const LocalSystem<12> &local);

    /** Add the system of a pair of cells, source first. */
    void
    add(const unsigned int     source,
        const unsigned int     target,
        const LocalSystem<24> &local);

    /** Exchange contributions between ranks. */
    void
    finish();

    dealii::TrilinosWrappers::SparseMatrix tangent_matrix;
    dealii::TrilinosWrappers::MPI::Vector  right_hand_side;
    dealii::TrilinosWrappers::MPI::Vector  residual;

    /**
     * The sum of the squares of what cells and pairs of cells of this rank add
     * to the residual, moments over the length of their cell [force^2]: how
     * large the forces are that balance each other in it.
     */
    double sum_of_squares = 0.;

  private:
    /** Count the forces of a cell among the local ones that begin at @p first.
     */
    template <unsigned int n>
    void
    count_forces(const unsigned int    cell,
                 const LocalSystem<n> &local,
                 const unsigned int    first);

    template <unsigned int n>
    void
    add(const std::array<dealii::types::global_dof_index, n> &dofs,
        const LocalSystem<n>                                 &local);

    const FiberSystem                       &fibers;
    Request                                  request     = Request::energy;
    const dealii::AffineConstraints<double> *constraints = nullptr;

    // Scratch, to save allocations.
    dealii::FullMatrix<double>                   cell_matrix;
    dealii::Vector<double>                       cell_vector;
    std::vector<dealii::types::global_dof_index> cell_indices;
  };
} // namespace Setae

#endif
