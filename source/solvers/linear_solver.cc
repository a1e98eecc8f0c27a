// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <deal.II/lac/solver_control.h>
#include <deal.II/lac/solver_gmres.h>
#include <deal.II/lac/trilinos_solver.h>

#include <setae/solvers/linear_solver.h>

#include <cmath>

namespace Setae
{
  using namespace dealii;

  namespace
  {
    using Vector = LinearSolver::Vector;

    struct Sum
    {
      const LinearSolver::Matrix  &A;
      const LinearSolver::Product &B;

      void
      vmult(Vector &result, const Vector &x) const
      {
        A.vmult(result, x);
        Vector product(result);
        B(x, product);
        result += product;
      }
    };

    struct Inverse
    {
      TrilinosWrappers::SolverDirect &solver;

      void
      vmult(Vector &result, const Vector &x) const
      {
        solver.solve(result, x);
      }
    };

    bool
    on_all_ranks(const bool is_solved, const Vector &result)
    {
      const bool is_good = is_solved && std::isfinite(result.l2_norm());
      return Utilities::MPI::min(is_good ? 1 : 0,
                                 result.get_mpi_communicator()) == 1;
    }
  } // namespace



  bool
  LinearSolver::solve(const Matrix &A,
                      const Vector &right_hand_side,
                      Vector       &result) const
  {
    bool is_solved = true;
    try
      {
        SolverControl                  control;
        TrilinosWrappers::SolverDirect solver(
          control, TrilinosWrappers::SolverDirect::AdditionalData(false, type));
        solver.solve(A, result, right_hand_side);
      }
    catch (const std::exception &)
      {
        is_solved = false;
      }
    return on_all_ranks(is_solved, result);
  }



  bool
  LinearSolver::solve(const Matrix  &A,
                      const Product &B,
                      const Vector  &right_hand_side,
                      Vector        &result) const
  {
    bool is_solved = true;
    try
      {
        SolverControl                  ignored;
        TrilinosWrappers::SolverDirect direct(
          ignored, TrilinosWrappers::SolverDirect::AdditionalData(false, type));
        direct.initialize(A);

        // With the preconditioner on the left, the residual that counts is in
        // the units of the solution.
        const Inverse inverse{direct};
        inverse.vmult(result, right_hand_side);
        ReductionControl    control(100, 1e-14 * result.l2_norm(), 1e-10);
        SolverGMRES<Vector> gmres(control);
        gmres.solve(Sum{A, B}, result, right_hand_side, inverse);
      }
    catch (const std::exception &)
      {
        is_solved = false;
      }
    return on_all_ranks(is_solved, result);
  }
} // namespace Setae
