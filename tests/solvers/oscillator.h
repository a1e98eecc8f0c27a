// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_tests_solvers_oscillator_h
#define setae_tests_solvers_oscillator_h

#include <deal.II/base/index_set.h>

#include <setae/solvers/dynamic_system.h>

#include <cmath>

namespace Setae::Test
{
  /**
   * A mass on a hardening spring, shaken by a support: the unknowns are X,
   * free, and Y = amplitude sin(3 t), prescribed, with
   * @f[ X'' + \tfrac15 Y'' + c(X' + \tfrac15 Y')
   *     + k (X-Y) + n X^3 - f\cos t = 0. @f]
   */
  class Oscillator : public DynamicSystem
  {
  public:
    double stiffness = 1., hardening = 0., load = 0., amplitude = 0.;
    double initial_displacement = 0., initial_velocity = 0., damping = 0.;

    Evaluation
    evaluate_motion(const Vector &solution,
                    const Vector &rate,
                    const double  mass_factor,
                    const double  time,
                    const Request) override
    {
      ++n_evaluations;
      const double x = solution(0), y = solution(1);
      force    = zero();
      force(0) = rate(0) + .2 * rate(1) + stiffness * (x - y) +
                 hardening * x * x * x - load * std::cos(time);
      force(1) = rate(1) + .2 * rate(0) + stiffness * (y - x);
      slope    = mass_factor + stiffness + 3. * hardening * x * x;
      Evaluation result;
      result.residual_norm = std::abs(force(0));
      result.energy =
        .5 * stiffness * (x - y) * (x - y) + .25 * hardening * x * x * x * x;
      result.round_off = 1e-15 * slope * (1. + std::abs(x));
      result.is_valid = result.is_admissible = true;
      return result;
    }

    double
    add_force(const Vector &more) override
    {
      force += more;
      return std::abs(force(0));
    }

    bool
    solve(const Vector &right_hand_side, Vector &result) override
    {
      result    = zero();
      result(0) = right_hand_side(0) / slope;
      return true;
    }

    bool
    solve(Vector &increment) override
    {
      Vector right_hand_side(force);
      right_hand_side *= -1.;
      return solve(right_hand_side, increment);
    }

    void
    prescribe(Motion &motion, const double time) override
    {
      const double phase     = 3. * time;
      motion.displacement(1) = amplitude * std::sin(phase);
      motion.velocity(1)     = 3. * amplitude * std::cos(phase);
      motion.acceleration(1) = -9. * amplitude * std::sin(phase);
    }

    Motion
    initial_motion() override
    {
      Motion motion{zero(), zero(), zero()};
      motion.displacement(0) = initial_displacement;
      motion.velocity(0)     = initial_velocity;
      prescribe(motion, 0.);
      Vector rate(motion.acceleration);
      rate.add(damping, motion.velocity);
      evaluate_motion(motion.displacement, rate, 0., 0., Request::residual);
      motion.acceleration(0) = -force(0);
      return motion;
    }

    Vector
    times_mass(const Vector &vector) override
    {
      Vector result(zero());
      result(0) = vector(0) + .2 * vector(1);
      result(1) = vector(1) + .2 * vector(0);
      return result;
    }

    Vector
    unit_displacements() const override
    {
      Vector result(zero());
      result = 1.;
      return result;
    }

    void
    set_supports_to_zero(Vector &vector) const override
    {
      vector(1) = 0.;
    }

    double
    largest_displacement(const Vector &increment) const override
    {
      return increment.linfty_norm();
    }

    double
    increment_norm(const Vector &increment) const override
    {
      return increment.l2_norm();
    }

    double
    length_scale() const override
    {
      return 1.;
    }

    std::string
    passage(const Vector &, const Vector &) const override
    {
      return {};
    }

    Momenta
    momenta(const Motion &motion) override
    {
      Momenta result;
      result.kinetic_energy =
        .5 * (motion.velocity * times_mass(motion.velocity));
      return result;
    }

    const Vector &
    residual() const override
    {
      return force;
    }

    double
    support_power(const Motion &motion) override
    {
      return force(1) * motion.velocity(1);
    }

    std::vector<ExternalWork>
    external_work(const Motion &motion, const double time) override
    {
      return {{load * std::cos(time), motion.displacement(0)}};
    }

    double
    sum(const double value) const override
    {
      return value;
    }

    /** Not for motions. */
    Evaluation
    evaluate(const Vector &, const double, const SupportIncrement) override
    {
      Assert(false, dealii::ExcNotImplemented());
      return {};
    }

    double
    add_damping(const Vector &, const Vector &) override
    {
      Assert(false, dealii::ExcNotImplemented());
      return 0.;
    }

    Vector
    diagonal() const override
    {
      Assert(false, dealii::ExcNotImplemented());
      return {};
    }

    /** X and X' at @p time, by many steps of a method of fourth order. */
    std::array<double, 2>
    exact(const double time) const
    {
      const auto acceleration = [this](double t, double x, double v) {
        const double y  = amplitude * std::sin(3. * t),
                     y1 = 3. * amplitude * std::cos(3. * t), y2 = -9. * y;
        return -.2 * y2 - damping * (v + .2 * y1) - stiffness * (x - y) -
               hardening * x * x * x + load * std::cos(t);
      };
      const unsigned int n = 20000;
      const double       h = time / n;
      double             x = initial_displacement, v = initial_velocity;
      for (unsigned int i = 0; i < n; ++i)
        {
          const double t  = i * h;
          const double a1 = acceleration(t, x, v);
          const double v2 = v + .5 * h * a1,
                       a2 = acceleration(t + .5 * h, x + .5 * h * v, v2);
          const double v3 = v + .5 * h * a2,
                       a3 = acceleration(t + .5 * h, x + .5 * h * v2, v3);
          const double v4 = v + h * a3,
                       a4 = acceleration(t + h, x + h * v3, v4);
          x += h / 6. * (v + 2. * v2 + 2. * v3 + v4);
          v += h / 6. * (a1 + 2. * a2 + 2. * a3 + a4);
        }
      return {{x, v}};
    }

    unsigned int n_evaluations = 0;

  private:
    static Vector
    zero()
    {
      return Vector(dealii::complete_index_set(2), MPI_COMM_SELF);
    }

    Vector force = zero();
    double slope = 1.;
  };
} // namespace Setae::Test

#endif
