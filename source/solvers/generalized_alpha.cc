// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <setae/solvers/generalized_alpha.h>

#include <cmath>
#include <limits>

namespace Setae
{
  namespace
  {
    /**
     * The balance at the end of a step as a function of the displacement X
     * there: rate and mass are linear in X, starting from a prediction.
     */
    class EndOfStep : public NonlinearSystem
    {
    public:
      EndOfStep(DynamicSystem &system,
                const Vector  &predicted,
                const Vector  &predicted_rate,
                const double   mass_factor)
        : system(system)
        , predicted(predicted)
        , predicted_rate(predicted_rate)
        , mass_factor(mass_factor)
        , rate(predicted_rate)
      {}

      Evaluation
      evaluate(const Vector &solution,
               const double  time,
               const SupportIncrement) override
      {
        rate = predicted_rate;
        rate.add(mass_factor, solution, -mass_factor, predicted);
        return system.evaluate_motion(
          solution, rate, mass_factor, time, Request::tangent);
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

    private:
      DynamicSystem &system;
      const Vector  &predicted, &predicted_rate;
      const double   mass_factor;
      Vector         rate;
    };
  } // namespace



  GeneralizedAlpha::Coefficients::Coefficients(const double rho_infinity)
    : alpha_m((2. * rho_infinity - 1.) / (rho_infinity + 1.))
    , alpha_f(rho_infinity / (rho_infinity + 1.))
    , beta(.25 * (1. - alpha_m + alpha_f) * (1. - alpha_m + alpha_f))
    , gamma(.5 - alpha_m + alpha_f)
  {}



  GeneralizedAlpha::GeneralizedAlpha(const DynamicsParameters &dynamics,
                                     const NewtonParameters   &newton,
                                     const Newton::Log        &log,
                                     const Motion             &motion)
    : coefficients(dynamics.rho_infinity)
    , damping(dynamics.damping)
    , newton(newton, log)
    , last(motion)
    , next(motion)
    , last_auxiliary(motion.acceleration)
    , next_auxiliary(motion.acceleration)
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
    const auto [alpha_m, alpha_f, beta, gamma] = coefficients;
    const double h                             = step_size;

    Prediction result{last, auxiliary};
    Vector    &u = result.motion.displacement, &v = result.motion.velocity,
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
    EndOfStep    balance(system,
                      prediction.motion.displacement,
                      predicted_rate,
                      acceleration_factor() + damping * velocity_factor());

    next = prediction.motion;
    const SolverResult result =
      newton.solve(balance, next.displacement, time, SupportIncrement::at_rest);
    if (!result.converged)
      return result;

    Vector correction(next.displacement);
    correction -= prediction.motion.displacement;
    next.velocity.add(velocity_factor(), correction);
    next.acceleration.add(acceleration_factor(), correction);
    next_auxiliary = prediction.auxiliary;
    next_auxiliary.add(auxiliary_factor(), correction);
    return result;
  }



  SolverResult
  GeneralizedAlpha::try_step(DynamicSystem &system,
                             const double   time,
                             const double   step_size)
  {
    this->step_size = step_size;

    // The auxiliary acceleration is that of a time (alpha_m - alpha_f) h after
    // the last one: another step size means another time.
    if (last_step_size > 0. && step_size != last_step_size)
      {
        const double ratio = step_size / last_step_size;
        last_auxiliary.sadd(ratio, 1. - ratio, last.acceleration);
      }
    last_step_size = step_size;

    SolverResult result =
      correct(system, time, predict(system, time, last_auxiliary));
    if (result.converged)
      return result;

    // Fibers that go on as they did may end up in each other; if they stay
    // where they are, they do not.
    Vector to_rest(last.velocity);
    to_rest *= -1. / (coefficients.beta * step_size);
    to_rest.add(1. - .5 / coefficients.beta, last_auxiliary);
    SolverResult second = correct(system, time, predict(system, time, to_rest));
    second.n_iterations += result.n_iterations;
    return second;
  }



  void
  GeneralizedAlpha::accept()
  {
    last           = next;
    last_auxiliary = next_auxiliary;
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
    truncation -= last.acceleration;
    truncation *= coefficients.error_constant() * step_size * step_size *
                  (acceleration_factor() + damping * velocity_factor());
    system.set_supports_to_zero(truncation);
    Vector force = system.times_mass(truncation);
    system.set_supports_to_zero(force);
    Vector filtered(force);
    if (!system.solve(force, filtered))
      return std::numeric_limits<double>::infinity();
    return system.largest_displacement(filtered);
  }
} // namespace Setae
