// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_solvers_nonlinear_system_h
#define setae_solvers_nonlinear_system_h

#include <deal.II/lac/trilinos_vector.h>

#include <setae/interactions/line_sites.h>

#include <limits>
#include <string>
#include <vector>

namespace Setae
{
  /** What is known of a state after an evaluation, the same on every rank. */
  struct Evaluation
  {
    /** Of the free unknowns, moments over the length of their cell [force]. */
    double residual_norm = 0.;
    double energy        = 0.; ///< the sum [energy]

    /**
     * What the residual is small in comparison with [force]: the forces of all
     * cells and pairs of cells, and no less than what bends the softest fiber.
     */
    double force_scale = 0.;

    /** What round-off leaves in the residual, however small it is [force]. */
    double round_off = 0.;

    std::vector<double> energies; ///< of each term [energy]
    GapReport           gaps;

    /** Whether all numbers are finite and every law could be evaluated. */
    bool is_valid = false;

    /** Whether, beyond that, no gap is below the regularization of its law. */
    bool is_admissible = false;

    /** What is wrong, in words, if something is. */
    std::string reason;
  };



  /** What the next increment does to the supports. */
  enum class SupportIncrement
  {
    at_rest,      ///< they stay where they are
    to_prescribed ///< it takes them to where they are prescribed
  };



  /**
   * What a solver for equilibria sees of a problem with unknowns X at time t.
   */
  class NonlinearSystem
  {
  public:
    using Vector = dealii::TrilinosWrappers::MPI::Vector;

    virtual ~NonlinearSystem() = default;

    /**
     * Assemble residual and tangent matrix. @p solution holds the locally owned
     * unknowns.
     */
    virtual Evaluation
    evaluate(const Vector          &solution,
             const double           time,
             const SupportIncrement supports) = 0;

    /**
     * Solve for the increment with matrix and residual of the last evaluation.
     *
     * @return Whether there is a solution; false for a singular matrix.
     */
    virtual bool
    solve(Vector &increment) = 0;

    /**
     * Turn the system of the last evaluation into one step of the implicit
     * Euler
     * method: add @p coefficients to the diagonal of the matrix, and their
     * product with @p motion, the change since the beginning of the step, to the
     * residual.
     *
     * @return The norm of the new residual [force].
     */
    virtual double
    add_damping(const Vector &coefficients, const Vector &motion) = 0;

    /** The magnitude of the diagonal of the matrix of the last evaluation. */
    virtual Vector
    diagonal() const = 0;

    /** The largest displacement of a node in an increment [length]. */
    virtual double
    largest_displacement(const Vector &increment) const = 0;

    /**
     * The Euclidean norm of an increment, changes of tangents times the length
     * of their cell [length].
     */
    virtual double
    increment_norm(const Vector &increment) const = 0;

    /** The length that an increment is small in comparison with [length]. */
    virtual double
    length_scale() const = 0;

    /**
     * What passes through what on the straight way between two solutions, in
     * words, or nothing: a solver must not go from one to the other in one step
     * although both may be admissible.
     */
    virtual std::string
    passage(const Vector &from, const Vector &to) const = 0;
  };



  /** What became of an attempt to find an equilibrium. */
  struct SolverResult
  {
    bool         converged    = false;
    unsigned int n_iterations = 0; ///< linear systems solved
    Evaluation   evaluation;       ///< of the last state
    std::string  reason;           ///< of a failure, in words
  };
} // namespace Setae

#endif
