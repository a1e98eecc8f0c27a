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
      const Vector                &scaling;

      void
      vmult(Vector &result, const Vector &scaled) const
      {
        Vector x(scaled);
        x.scale(scaling);
        A.vmult(result, x);
        Vector product(result);
        B(x, product);
        result += product;
        result.scale(scaling);
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

    /**
     * A matrix with scaled rows and columns for as long as this lives. By
     * powers of two, nothing is rounded on the way there and back.
     */
    class ScaledMatrix
    {
    public:
      ScaledMatrix(const LinearSolver::Matrix &A, const Vector &scaling)
        : matrix(const_cast<Epetra_CrsMatrix &>(A.trilinos_matrix()))
        , scaling(scaling)
      {
        apply();
      }

      ~ScaledMatrix()
      {
        for (double &factor : scaling)
          factor = 1. / factor;
        apply();
      }

    private:
      void
      apply()
      {
        const Epetra_Vector &factors = *scaling.trilinos_vector()(0);
        matrix.LeftScale(factors);
        matrix.RightScale(factors);
      }

      Epetra_CrsMatrix &matrix;
      Vector            scaling;
    };

    bool
    on_all_ranks(const bool is_solved, const Vector &result)
    {
      const bool is_good = is_solved && std::isfinite(result.l2_norm());
      return Utilities::MPI::min(is_good ? 1 : 0,
                                 result.get_mpi_communicator()) == 1;
    }
  } // namespace



  struct LinearSolver::Factors
  {
    explicit Factors(const std::string &type)
      : solver(control,
               TrilinosWrappers::SolverDirect::AdditionalData(false, type))
    {}

    SolverControl                  control; // means nothing to a direct solver
    TrilinosWrappers::SolverDirect solver;
  };



  LinearSolver::LinearSolver(const std::string &type, const Vector &units)
    : type(type)
    , scaling(units)
  {
    for (double &factor : scaling)
      factor = std::exp2(-std::round(std::log2(factor)));
  }



  LinearSolver::~LinearSolver() = default;



  bool
  LinearSolver::factorize(const Matrix &A)
  {
    if (factors)
      return true;
    bool is_regular = true;
    try
      {
        matrix = &A;
        const ScaledMatrix scaled(A, scaling);
        factors = std::make_unique<Factors>(type);
        factors->solver.initialize(A);
      }
    catch (const std::exception &)
      {
        is_regular = false;
      }
    is_regular =
      Utilities::MPI::min(is_regular ? 1 : 0, A.get_mpi_communicator()) == 1;
    if (!is_regular)
      clear();
    return is_regular;
  }



  void
  LinearSolver::clear()
  {
    factors.reset();
  }



  void
  LinearSolver::multiply_by_inverse(Vector &result, const Vector &x) const
  {
    Vector scaled(x);
    scaled.scale(scaling);
    factors->solver.solve(result, scaled);
    result.scale(scaling);
  }



  bool
  LinearSolver::solve(const Vector &right_hand_side, Vector &result)
  {
    Assert(factors, ExcNotInitialized());
    bool is_solved = true;
    try
      {
        multiply_by_inverse(result, right_hand_side);
      }
    catch (const std::exception &)
      {
        is_solved = false;
      }
    return on_all_ranks(is_solved, result);
  }



  bool
  LinearSolver::solve(const Product &B,
                      const Vector  &right_hand_side,
                      Vector        &result)
  {
    Assert(factors, ExcNotInitialized());
    bool is_solved = true;
    try
      {
        // In the unknowns that the matrix was scaled for, which have one unit.
        // With the preconditioner on the left, the residual that counts is in
        // that of the solution.
        const Inverse inverse{factors->solver};
        Vector        force(right_hand_side);
        force.scale(scaling);
        inverse.vmult(result, force);
        ReductionControl    control(100, 1e-14 * result.l2_norm(), 1e-10);
        SolverGMRES<Vector> gmres(control);
        gmres.solve(Sum{*matrix, B, scaling}, result, force, inverse);
        result.scale(scaling);
      }
    catch (const std::exception &)
      {
        is_solved = false;
      }
    return on_all_ranks(is_solved, result);
  }
} // namespace Setae
