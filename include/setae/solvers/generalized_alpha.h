// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_solvers_generalized_alpha_h
#define setae_solvers_generalized_alpha_h

#include <setae/scene.h>
#include <setae/solvers/dynamic_system.h>
#include <setae/solvers/newton.h>

namespace Setae
{
  /**
   * One step of the implicit generalized-alpha method (Chung, Hulbert 1993) in
   * the form of Arnold and Bruels (2007): the balance of forces holds at the
   * end of each step,
   * @f[ M\ddot X_{n+1} + cM\dot X_{n+1} + R(X_{n+1},t_{n+1}) = 0, @f]
   * and Newmark's formulas take an auxiliary acceleration a with
   * @f[ (1-\alpha_m)\,a_{n+1}+\alpha_m a_n
   *     = (1-\alpha_f)\,\ddot X_{n+1}+\alpha_f\ddot X_n. @f]
   * With a constant mass matrix these are the displacements of Chung and
   * Hulbert's method with the weighted mean of the forces of both ends. Second
   * order, unconditionally stable for linear systems; one parameter, the
   * spectral radius at infinity. With the value one it is the trapezoidal rule,
   * which keeps the energy of linear systems.
   *
   * *Steps of any size.* a is an acceleration at the time
   * @f$t_n+\Delta_n@f$, not at @f$t_n@f$. The formula above says what follows
   * for @f$\Delta_{n+1}@f$, and Newmark's formula of the velocity has order two
   * with
   * @f[ \gamma=\frac{h/2-\Delta_n}{h+\Delta_{n+1}-\Delta_n},\qquad
   *     \beta=\tfrac14(\tfrac12+\gamma)^2. @f]
   * a itself is never changed: scaling its difference from @f$\ddot X_n@f$ with
   * the step, as is usual, makes it grow without bound with steps that grow.
   *
   * *The first step* starts from @f$(M+\gamma hcM+\beta h^2R')\,a_0=M\ddot
   * X_0@f$. Where the step resolves the motion, this is the acceleration; what
   * decays or vibrates faster would otherwise be extrapolated over the step.
   *
   * *Conservation.* The mean force of both ends does not do the work that the
   * potential energy gives: with @f$d=X_{n+1}-X_n@f$ it misses
   * @f[ \delta = \Pi_{n+1}-\Pi_n-\tfrac12(R_n+R_{n+1})\cdot d, @f]
   * of third order, but of second where a contact begins. The integrator
   * 'energy-conserving' adds the force @f$\lambda Md,\ \lambda=\delta/(d\cdot
   * Md)@f$ during the step, as Gonzalez (1996) does in his discrete gradient. It
   * takes @f$\tfrac12h^2\lambda d@f$ from Newmark's displacement and
   * @f$h\lambda d@f$ from the velocity; the balance at the end of the step stays
   * what it is. With the spectral radius one the energy is then constant
   * whatever the step; below one, only the numerical damping changes it. The
   * order remains two.
   *
   * Prescribed entries take displacement, velocity and acceleration of their
   * formulas; Newmark's formulas would let their accelerations oscillate.
   */
  class GeneralizedAlpha
  {
  public:
    using Vector = NonlinearSystem::Vector;

    /** What a conservative step needs to know of the state at one of its ends.
     */
    struct Potential
    {
      double                    energy = 0.;   ///< of all terms
      Vector                    force;         ///< R, without inertia
      std::vector<ExternalWork> external_work; ///< of this rank
    };

    /** The constants of a step. */
    struct Coefficients
    {
      double alpha_m, alpha_f, beta, gamma;

      /** @f$\Delta_n@f$ and @f$\Delta_{n+1}@f$ in parts of the step. */
      double delay, next_delay;

      /**
       * Of equal steps. @p rho_infinity is the spectral radius at infinity, in
       * [0,1].
       */
      explicit Coefficients(const double rho_infinity);

      /**
       * Of a step that is @p ratio times as long as the last one, whose
       * @p last_delay was @f$\Delta_n@f$ in parts of that one. Equal steps with
       * the spectral radius one are the only ones without numerical damping
       * that are stable at high frequencies if their size changes: with a
       * radius below one, such a step takes the inverse of the ratio at most.
       * And
       * @f$\Delta@f$ is never positive, as otherwise @f$\gamma@f$ has a pole.
       */
      Coefficients(const double rho_infinity,
                   const double ratio,
                   const double last_delay);

      /**
       * Of implicit Euler steps, which are for a first step that is longer than
       * the decay of velocities: fibers then move by the last velocity during
       * all of it.
       */
      static Coefficients
      of_implicit_euler();

      /**
       * The factor of @f$h^3\dddot X@f$ in the displacement after one step,
       * less that of the exact solution.
       */
      double
      error_constant() const
      {
        return (.5 - beta) * delay + beta * (1. + next_delay) - 1. / 6.;
      }
    };

    /** @p motion is the state at time 0. */
    GeneralizedAlpha(const DynamicsParameters &dynamics,
                     const NewtonParameters   &newton,
                     const Newton::Log        &log,
                     const Motion             &motion);

    /** The state after the last step. */
    const Motion &
    motion() const
    {
      return last;
    }

    /** The state that the step tried last has found. */
    const Motion &
    trial() const
    {
      return next;
    }

    /**
     * Solve for the state at @p time, a step of @p step_size after the last
     * one. It becomes the last state only by accept().
     */
    SolverResult
    try_step(DynamicSystem &system, const double time, const double step_size);

    /** Take the state that try_step() has found. */
    void
    accept();

    /**
     * The work of the force that conserves the energy, in the step tried last;
     * zero if it is not to be conserved [energy].
     */
    double
    energy_correction() const
    {
      return next_correction;
    }

    /** The acceleration in Newmark's formulas after the last step. */
    const Vector &
    auxiliary_acceleration() const
    {
      return last_auxiliary;
    }

    /** The largest displacement of a node in the step tried last [length]. */
    double
    largest_displacement(const DynamicSystem &system) const;

    /**
     * The estimated error of the displacement in the step tried last, the
     * largest of any node [length]: the leading term of the truncation error,
     * with the third derivative from the difference of the accelerations. Fast
     * vibrations that the step does not resolve, and does not have to, are
     * filtered out with the matrix of the last iteration (as in Hairer and
     * Wanner, Solving ODEs II, IV.8).
     */
    double
    error(DynamicSystem &system) const;

  private:
    /** Motion and auxiliary acceleration as the step is predicted. */
    struct Prediction
    {
      Motion motion;
      Vector auxiliary;
    };

    Prediction
    predict(DynamicSystem &system,
            const double   time,
            const Vector  &auxiliary) const;

    SolverResult
    correct(DynamicSystem    &system,
            const double      time,
            const Prediction &prediction);

    Vector
    rate(const Motion &motion) const;

    /** Evaluate the state at the beginning of the first step. */
    void
    evaluate_first(DynamicSystem &system, const double time);

    /** What the first step takes as the auxiliary acceleration. */
    void
    filter_first_auxiliary(DynamicSystem &system, const double time);

    /** The derivatives by the displacement at the end of the step. */
    double
    auxiliary_factor() const;
    double
    velocity_factor() const;
    double
    acceleration_factor() const;

    const double rho_infinity;
    const double damping;
    const bool   conserves_energy;
    const Newton newton;

    Motion       last, next;
    Vector       last_auxiliary, next_auxiliary;
    double       step_size = 0., last_step_size = 0.; ///< the last accepted one
    double       last_delay;   ///< in parts of the last step
    Coefficients coefficients; ///< of the step tried last
    double       next_correction = 0.;

    Potential last_potential, next_potential; ///< only to conserve energy
  };
} // namespace Setae

#endif
