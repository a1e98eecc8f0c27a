// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_solvers_dynamic_system_h
#define setae_solvers_dynamic_system_h

#include <setae/assembly/external_work.h>
#include <setae/assembly/momenta.h>
#include <setae/base/local_system.h>
#include <setae/solvers/nonlinear_system.h>

namespace Setae
{
  /**
   * The state of a motion: the locally owned unknowns X and their first two
   * derivatives in time.
   */
  struct Motion
  {
    using Vector = NonlinearSystem::Vector;

    Vector displacement, velocity, acceleration;
  };



  /**
   * What a time integrator sees of a problem
   * @f[ M\ddot X + c M\dot X + R(X,t) = 0 @f]
   * with the consistent mass matrix M, the rate c of a viscous damping and the
   * residual R of the static problem. Part of the unknowns is prescribed as a
   * function of time.
   */
  class DynamicSystem : public NonlinearSystem
  {
  public:
    /**
     * Assemble the residual R(X,t) + M @p rate and, if @p request goes that
     * far, the matrix R' + @p mass_factor M.
     */
    virtual Evaluation
    evaluate_motion(const Vector &solution,
                    const Vector &rate,
                    const double  mass_factor,
                    const double  time,
                    const Request request) = 0;

    /**
     * Add @p force to the residual of the last evaluation, and to the right-hand
     * side of its linear system.
     *
     * @return The norm of the new residual of the free unknowns [force].
     */
    virtual double
    add_force(const Vector &force) = 0;

    /** The residual of the last evaluation; reactions at the supports. */
    virtual const Vector &
    residual() const = 0;

    /**
     * Overwrite the prescribed entries of all three vectors by what the
     * supports do at @p time.
     */
    virtual void
    prescribe(Motion &motion, const double time) = 0;

    /**
     * The displacement of a node that a unit of each unknown makes [length per
     * unit]: 1 for a position, the length of the cells for a tangent.
     */
    virtual Vector
    unit_displacements() const = 0;

    /** Set the entries to zero that are not free. */
    virtual void
    set_supports_to_zero(Vector &vector) const = 0;

    /**
     * Take a force to what acts on the free unknowns, zero at all others. Where
     * an unknown follows free ones, its force acts on these.
     */
    virtual void
    project_force(Vector &force) const
    {
      set_supports_to_zero(force);
    }

    /**
     * Take a motion to one with the supports at rest: zero where unknowns are
     * prescribed. Those that follow free ones go with them.
     */
    virtual void
    project_motion(Vector &motion) const
    {
      set_supports_to_zero(motion);
    }

    /**
     * The motion at time 0: at rest but for the initial velocities of the
     * scene, with the acceleration that balances the forces.
     *
     * @throws ExcRun if the mass matrix is singular.
     */
    virtual Motion
    initial_motion() = 0;

    /** The product with the mass matrix. */
    virtual Vector
    times_mass(const Vector &vector) = 0;

    /**
     * Solve with the matrix of the last evaluation and the supports at rest.
     *
     * @return Whether there is a solution; false for a singular matrix.
     */
    virtual bool
    solve(const Vector &right_hand_side, Vector &result) = 0;
    using NonlinearSystem::solve;

    virtual Momenta
    momenta(const Motion &motion) = 0;

    /**
     * The power of the supports on the fibers, with the reactions of the last
     * evaluation [energy/time].
     */
    virtual double
    support_power(const Motion &motion) = 0;

    /**
     * What works from outside on the fibers of this rank, in the state
     * evaluated last: loads and interactions whose formulas depend on time.
     */
    virtual std::vector<ExternalWork>
    external_work(const Motion &motion, const double time) = 0;

    /** The sum over all ranks. */
    virtual double
    sum(const double value_of_rank) const = 0;
  };
} // namespace Setae

#endif
