// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_fiber_equations_h
#define setae_fiber_equations_h

#include <deal.II/base/timer.h>

#include <setae/assembly/inertia.h>
#include <setae/assembly/load.h>
#include <setae/assembly/strain_energy.h>
#include <setae/assembly/supports.h>
#include <setae/solvers/dynamic_system.h>
#include <setae/solvers/linear_solver.h>

#include <memory>
#include <string>
#include <vector>

namespace Setae
{
  /**
   * The equations of a scene as the solvers see them: the sum of its energy
   * terms, with inertia if it moves, and its supports.
   */
  class FiberEquations : public DynamicSystem
  {
  public:
    /**
     * @throws ExcInput, ExcParameter if terms or supports do not fit the
     * fibers.
     */
    FiberEquations(const FiberSystem &fibers, dealii::TimerOutput &timer);

    Evaluation
    evaluate(const Vector          &solution,
             const double           time,
             const SupportIncrement supports) override;

    bool
    solve(Vector &increment) override;

    double
    add_damping(const Vector &coefficients, const Vector &motion) override;

    Vector
    diagonal() const override;

    double
    largest_displacement(const Vector &increment) const override;

    double
    increment_norm(const Vector &increment) const override;

    /** The smallest radius. */
    double
    length_scale() const override;

    /**
     * Make sure that the matrix of the last evaluation resists every motion.
     *
     * @throws ExcRun with the fiber that is free, if one is.
     */
    void
    check_free_fibers();

    std::string
    passage(const Vector &from, const Vector &to) const override;

    // For motions, in fiber_motion.cc.

    Evaluation
    evaluate_motion(const Vector &solution,
                    const Vector &rate,
                    const double  mass_factor,
                    const double  time,
                    const Request request) override;

    double
    add_force(const Vector &force) override;

    const Vector &
    residual() const override
    {
      return system.residual;
    }

    void
    prescribe(Motion &motion, const double time) override;

    Vector
    unit_displacements() const override;

    void
    set_supports_to_zero(Vector &vector) const override;

    void
    project_force(Vector &force) const override;

    void
    project_motion(Vector &motion) const override;

    Motion
    initial_motion() override;

    Vector
    times_mass(const Vector &vector) override;

    bool
    solve(const Vector &right_hand_side, Vector &result) override;

    Momenta
    momenta(const Motion &motion) override;

    double
    support_power(const Motion &motion) override;

    std::vector<ExternalWork>
    external_work(const Motion &motion, const double time) override;

    double
    sum(const double value_of_rank) const override
    {
      return dealii::Utilities::MPI::sum(value_of_rank, communicator);
    }

    // For the driver and its output.

    /** The state of locally owned unknowns, on every rank. */
    State
    state(const Vector &solution, const double time) const;

    /** Whether the residual is the gradient of the energy. */
    bool
    has_potential() const;

    /** Where the smallest gap is, in words. */
    std::string
    where(const GapReport &gaps) const;

    /** What the supports do, with the reactions of the last evaluation. */
    std::vector<SupportReport>
    support_reports(const double time) const
    {
      return supports.report(time, system.residual);
    }

    std::size_t
    n_nonzero_elements() const
    {
      return system.tangent_matrix.n_nonzero_elements();
    }

    std::vector<std::unique_ptr<EnergyTerm>> terms;
    const StrainEnergy                      *strain; ///< the first of the terms
    std::vector<const Load *>                loads;  ///< among the terms

  private:
    /** What inertia adds to an evaluation. */
    struct InertiaForce
    {
      const Vector &rate;
      double        mass_factor;
    };

    void
    setup_terms();

    void
    find_pairs(const State &state);

    void
    setup_matrix();

    void
    assemble_system(const State                             &state,
                    const Request                            request,
                    const dealii::AffineConstraints<double> &constraints,
                    const InertiaForce                      *inertia_force,
                    Evaluation                              &evaluation);

    void
    tangent_product(const Vector &x, Vector &product);

    // Gaps are in fiber_gaps.cc, norms and scales in fiber_norms.cc.

    void
    judge(Evaluation &evaluation) const;

    /** The norm of forces on the free unknowns [force]. */
    double
    force_norm(Vector forces) const;

    /** The largest row sum of the matrix, per displacement [force/length]. */
    double
    largest_stiffness() const;

    // Whether fibers can move without a force, in free_fibers.cc.

    double
    axial_force(const Vector &motion) const;

    double
    soften(Vector &motion);

    Vector
    irregular_forces() const;

    [[noreturn]] void
    refuse_free_fiber(const Vector &motion) const;

    const FiberSystem   &fibers;
    const Scene         &scene;
    const MPI_Comm       communicator;
    dealii::TimerOutput &timer;

    Supports                 supports;
    std::unique_ptr<Inertia> inertia; ///< none in a static scene
    GlobalSystem             system;

    /** unit_displacements() of the unknowns of this rank. */
    const std::vector<double> units;
    LinearSolver              solver; ///< with the factors of the matrix

    /** Whether terms have left something out of the tangent matrix. */
    bool has_product = false;

    bool is_damped = false; ///< whether the matrix is one of add_damping()

    dealii::IndexSet                  all_dofs;
    mutable Vector                    everywhere; ///< a solution, on all ranks
    dealii::AffineConstraints<double> increment_constraints;
    bool                              increment_at_rest = true;

    /** Inverse units of the columns of this rank's part of the matrix. */
    std::vector<double> inverse_column_units;

    /** EA over the length of a cell at each of these unknowns [force/length].
     */
    std::vector<double> axial_stiffness;

    double evaluated_time = 0.;

    double initial_extent; ///< of all nodes from the origin [length]
    double least_force;    ///< that bends the softest fiber [force]
  };
} // namespace Setae

#endif
