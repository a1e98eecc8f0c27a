// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_solvers_linear_solver_h
#define setae_solvers_linear_solver_h

#include <deal.II/lac/trilinos_sparse_matrix.h>
#include <deal.II/lac/trilinos_vector.h>

#include <functional>
#include <memory>
#include <string>

namespace Setae
{
  /**
   * Solves for a matrix A, or for A + B where only products with B are known:
   * what couples distant fibers is a full matrix that nobody wants to store.
   * The direct solver for A is then the preconditioner of GMRES, which takes a
   * few iterations as B is small beside A, or smooth.
   */
  class LinearSolver
  {
  public:
    using Vector = dealii::TrilinosWrappers::MPI::Vector;
    using Matrix = dealii::TrilinosWrappers::SparseMatrix;

    /** Writes B x into a vector. */
    using Product = std::function<void(const Vector &x, Vector &result)>;

    /**
     * @param type a direct solver of Trilinos' Amesos
     * @param units The size of a unit of each unknown, all in one unit: pivots
     * are compared after rows and columns have been divided by it, as a pivot
     * is no larger for being written in nanometres.
     */
    LinearSolver(const std::string &type, const Vector &units);
    ~LinearSolver();

    /**
     * Take the factors of @p A for all solutions until the next call, unless
     * they are there already. The matrix must live as long.
     *
     * @return Whether A is regular, the same on all ranks.
     */
    bool
    factorize(const Matrix &A);

    /** Forget the factors: the matrix changes. */
    void
    clear();

    /** @return Whether the solution is finite, the same on all ranks. */
    bool
    solve(const Vector &right_hand_side, Vector &result);

    /**
     * Solve for A + B to round-off.
     *
     * @return Whether GMRES converged, the same on all ranks.
     */
    bool
    solve(const Product &B, const Vector &right_hand_side, Vector &result);

  private:
    struct Factors;

    /** With the inverse for the matrix that has been scaled. */
    void
    multiply_by_inverse(Vector &result, const Vector &x) const;

    const std::string        type;
    Vector                   scaling; ///< inverse units, powers of two
    std::unique_ptr<Factors> factors;
    const Matrix            *matrix = nullptr;
  };
} // namespace Setae

#endif
