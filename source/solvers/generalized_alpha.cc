// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <setae/solvers/generalized_alpha.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace Setae
{
  namespace
  {
    using Potential = GeneralizedAlpha::Potential;

    /** After an evaluation with @p rate as the factor of the mass. */
    Potential
    potential(DynamicSystem                 &system,
              const Evaluation              &evaluation,
              const NonlinearSystem::Vector &displacement,
              const NonlinearSystem::Vector &rate,
              const double                   time)
    {
      Potential result{evaluation.energy,
                       system.residual(),
                       system.external_work({displacement, rate, rate}, time)};
      result.force -= system.times_mass(rate);
      return result;
    }



    /**
     * The balance at the end of a step as a function of the displacement X
     * there: rate and mass are linear in X, starting from a prediction. If the
     * energy is to be conserved, what that takes from the displacement has a
     * part in the rate.
     */
    class EndOfStep : public NonlinearSystem
    {
    public:
      /** The beginning of the step, if the energy is to be conserved. */
      struct Beginning
      {
        const Vector    &displacement;
        const Potential &potential;
        double           step_size;
        double           rate_factor; ///< of what is taken
      };

      EndOfStep(DynamicSystem                  &system,
                const Vector                   &predicted,
                const Vector                   &predicted_rate,
                const double                    mass_factor,
                const std::optional<Beginning> &beginning)
        : taken(predicted)
        , system(system)
        , predicted(predicted)
        , predicted_rate(predicted_rate)
        , mass_factor(mass_factor)
        , beginning(beginning)
        , rate(predicted_rate)
      {
        taken = 0.;
      }

      Evaluation
      evaluate(const Vector &solution,
               const double  time,
               const SupportIncrement) override
      {
        rate = predicted_rate;
        rate.add(mass_factor, solution, -mass_factor, predicted);
        Evaluation evaluation = system.evaluate_motion(
          solution, rate, mass_factor, time, Request::tangent);
        if (beginning && evaluation.is_valid)
          conserve_energy(solution, time, evaluation);
        return evaluation;
      }

      bool
      solve(Vector &increment) override
      {
        return system.solve(increment);
      }

      double
      add_damping(const Vector &coefficients, const Vector &motion) override
      {
        return system.add_damping(coefficients, motion);
      }

      Vector
      diagonal() const override
      {
        return system.diagonal();
      }

      double
      largest_displacement(const Vector &increment) const override
      {
        return system.largest_displacement(increment);
      }

      double
      increment_norm(const Vector &increment) const override
      {
        return system.increment_norm(increment);
      }

      double
      length_scale() const override
      {
        return system.length_scale();
      }

      std::string
      passage(const Vector &from, const Vector &to) const override
      {
        return system.passage(from, to);
      }

      // Of the last evaluation.
      Vector    taken; ///< from the displacement to conserve the energy
      double    correction = 0.; ///< the work of the force that does it
      Potential end;

    private:
      /**
       * The matrix stays without the derivative of this force: that is smaller
       * than the rest by the error of the energy over the kinetic one.
       */
      void
      conserve_energy(const Vector &solution,
                      const double  time,
                      Evaluation   &evaluation)
      {
        // Where nothing moves, there is nothing to take energy from, and far
        // from the end of the step any energy may be missing. What this bound
        // leaves out is seen in the balance of energy of the step, which then
        // has to be shorter.
        constexpr double largest_part = .1;

        const double h = beginning->step_size;
        end            = potential(system, evaluation, solution, rate, time);
        taken          = solution;
        taken -= beginning->displacement;
        Vector mean_force(end.force);
        mean_force.sadd(.5, .5, beginning->potential.force);
        const double missing =
          end.energy - beginning->potential.energy -
          system.sum(work_between(beginning->potential.external_work,
                                  end.external_work)) -
          mean_force * taken;

        system.project_motion(taken);
        Vector       force                = system.times_mass(taken);
        const double twice_kinetic_energy = force * taken / (h * h);
        const double part                 = twice_kinetic_energy > 0. ?
                                              std::clamp(.5 * missing / twice_kinetic_energy,
                                         -largest_part,
                                         largest_part) :
                                              0.;
        correction                        = 2. * part * twice_kinetic_energy;
        taken *= part;
        force *= part * beginning->rate_factor;
        evaluation.residual_norm = system.add_force(force);
      }

      DynamicSystem                 &system;
      const Vector                  &predicted, &predicted_rate;
      const double                   mass_factor;
      const std::optional<Beginning> beginning;
      Vector                         rate;
    };
  } // namespace



  GeneralizedAlpha::GeneralizedAlpha(const DynamicsParameters &dynamics,
                                     const NewtonParameters   &newton,
                                     const Newton::Log        &log,
                                     const Motion             &motion)
    : rho_infinity(dynamics.rho_infinity)
    , damping(dynamics.damping)
    , conserves_energy(dynamics.integrator == "energy-conserving")
    , newton(newton, log)
    , last(motion)
    , next(motion)
    , last_auxiliary(motion.acceleration)
    , next_auxiliary(motion.acceleration)
    , last_delay(Coefficients(rho_infinity).next_delay)
    , coefficients(rho_infinity)
  {}



  double
  GeneralizedAlpha::auxiliary_factor() const
  {
    return 1. / (coefficients.beta * step_size * step_size);
  }



  double
  GeneralizedAlpha::velocity_factor() const
  {
    return coefficients.gamma / (coefficients.beta * step_size);
  }



  double
  GeneralizedAlpha::acceleration_factor() const
  {
    return (1. - coefficients.alpha_m) / (1. - coefficients.alpha_f) *
           auxiliary_factor();
  }



  GeneralizedAlpha::Vector
  GeneralizedAlpha::rate(const Motion &motion) const
  {
    Vector result(motion.acceleration);
    result.add(damping, motion.velocity);
    return result;
  }



  GeneralizedAlpha::Prediction
  GeneralizedAlpha::predict(DynamicSystem &system,
                            const double   time,
                            const Vector  &auxiliary) const
  {
    const double alpha_m = coefficients.alpha_m, alpha_f = coefficients.alpha_f,
                 beta = coefficients.beta, gamma = coefficients.gamma,
                 h = step_size;

    Prediction result{last, auxiliary};
    result.motion.acceleration = recursion_acceleration();
    Vector &u = result.motion.displacement, &v = result.motion.velocity,
           &a = result.motion.acceleration;
    u.add(h, last.velocity);
    u.add(h * h * (.5 - beta), last_auxiliary, h * h * beta, auxiliary);
    v.add(h * (1. - gamma), last_auxiliary, h * gamma, auxiliary);
    a *= -alpha_f;
    a.add(alpha_m, last_auxiliary, 1. - alpha_m, auxiliary);
    a *= 1. / (1. - alpha_f);
    system.prescribe(result.motion, time);
    return result;
  }



  SolverResult
  GeneralizedAlpha::correct(DynamicSystem    &system,
                            const double      time,
                            const Prediction &prediction)
  {
    const Vector predicted_rate = rate(prediction.motion);

    // What is taken counts like a part of the increment from the prediction,
    // but for the velocity that goes with it.
    const double a = acceleration_factor(), v = velocity_factor(),
                 v_taken = v - 2. / step_size;
    std::optional<EndOfStep::Beginning> beginning;
    if (conserves_energy)
      beginning.emplace(EndOfStep::Beginning{
        last.displacement, last_potential, step_size, a + damping * v_taken});
    EndOfStep balance(system,
                      prediction.motion.displacement,
                      predicted_rate,
                      a + damping * v,
                      beginning);

    next = prediction.motion;
    const SolverResult result =
      newton.solve(balance, next.displacement, time, SupportIncrement::at_rest);
    if (!result.converged)
      return result;

    Vector correction(next.displacement);
    correction -= prediction.motion.displacement;
    next.velocity.add(v, correction, v_taken, balance.taken);
    correction += balance.taken;
    next.acceleration.add(a, correction);
    next_auxiliary = prediction.auxiliary;
    next_auxiliary.add(auxiliary_factor(), correction);
    next_potential  = std::move(balance.end);
    next_correction = balance.correction;
    return result;
  }



  void
  GeneralizedAlpha::evaluate_first(DynamicSystem &system, const double time)
  {
    Vector zero(last.velocity);
    zero                        = 0.;
    const Evaluation evaluation = system.evaluate_motion(
      last.displacement, zero, 0., time, Request::residual);
    last_potential =
      potential(system, evaluation, last.displacement, zero, time);
  }



  void
  GeneralizedAlpha::filter_first_auxiliary(DynamicSystem &system,
                                           const double   time)
  {
    const double factor = 1. + coefficients.gamma * step_size * damping;
    last_auxiliary      = last.acceleration;
    system.project_motion(last_auxiliary);
    Vector force = system.times_mass(last_auxiliary);
    system.project_force(force);
    const double before = last_auxiliary * force;

    Vector filtered(last_auxiliary), right_hand_side(force);
    right_hand_side *= auxiliary_factor();
    const bool has_matrix = system
                              .evaluate_motion(last.displacement,
                                               rate(last),
                                               factor * auxiliary_factor(),
                                               time,
                                               Request::tangent)
                              .is_valid;
    // Where the state is unstable, the matrix need not be a filter.
    if (has_matrix && system.solve(right_hand_side, filtered) &&
        filtered * system.times_mass(filtered) <= before)
      last_auxiliary = filtered;
    else
      last_auxiliary *= 1. / factor;

    // Prescribed entries are not Newmark's.
    Vector prescribed(last.acceleration);
    system.project_motion(prescribed);
    prescribed.sadd(-1., 1., last.acceleration);
    last_auxiliary += prescribed;
  }



  SolverResult
  GeneralizedAlpha::try_step(DynamicSystem &system,
                             const double   time,
                             const double   step_size)
  {
    this->step_size     = step_size;
    const bool is_first = last_step_size == 0.;
    if (is_first && damping * step_size > 1.)
      coefficients = Coefficients::of_implicit_euler();
    else
      coefficients = Coefficients(rho_infinity,
                                  is_first ? 1. : step_size / last_step_size,
                                  last_delay);
    if (is_first)
      filter_first_auxiliary(system, time - step_size);
    if (conserves_energy && last_potential.force.size() == 0)
      evaluate_first(system, time - step_size);

    SolverResult result =
      correct(system, time, predict(system, time, last_auxiliary));
    if (!result.converged)
      {
        // Fibers that go on as they did may end up in each other; if they stay
        // where they are, they do not.
        Vector to_rest(last.velocity);
        to_rest *= -1. / (coefficients.beta * step_size);
        to_rest.add(1. - .5 / coefficients.beta, last_auxiliary);
        const unsigned int n_iterations = result.n_iterations;
        result = correct(system, time, predict(system, time, to_rest));
        result.n_iterations += n_iterations;
      }
    if (result.converged && coefficients.is_euler)
      forget_jump(system);
    return result;
  }



  void
  GeneralizedAlpha::forget_jump(DynamicSystem &system)
  {
    Vector free(next_auxiliary);
    system.project_motion(free);
    next_auxiliary.add(1. / (1. + damping * step_size) - 1., free);
  }



  const GeneralizedAlpha::Vector &
  GeneralizedAlpha::recursion_acceleration() const
  {
    return follows_euler ? last_auxiliary : last.acceleration;
  }



  void
  GeneralizedAlpha::accept()
  {
    last           = next;
    last_auxiliary = next_auxiliary;
    last_potential = next_potential;
    last_step_size = step_size;
    last_delay     = coefficients.next_delay;
    follows_euler  = coefficients.is_euler;
  }



  double
  GeneralizedAlpha::largest_displacement(const DynamicSystem &system) const
  {
    Vector difference(next.displacement);
    difference -= last.displacement;
    return system.largest_displacement(difference);
  }



  double
  GeneralizedAlpha::error(DynamicSystem &system) const
  {
    Vector truncation(next.acceleration);
    truncation -= recursion_acceleration();
    truncation *= coefficients.error_constant() * step_size * step_size *
                  (acceleration_factor() + damping * velocity_factor());
    system.project_motion(truncation);
    Vector force = system.times_mass(truncation);
    system.project_force(force);
    Vector filtered(force);
    if (!system.solve(force, filtered))
      return std::numeric_limits<double>::infinity();
    return system.largest_displacement(filtered);
  }
} // namespace Setae
