// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <setae/base/exceptions.h>
#include <setae/fiber_equations.h>

namespace Setae
{
  using namespace dealii;

  Evaluation
  FiberEquations::evaluate_motion(const Vector &solution,
                                  const Vector &rate,
                                  const double  mass_factor,
                                  const double  time,
                                  const Request request)
  {
    const State state = this->state(solution, time);
    find_pairs(state);

    increment_at_rest = true;
    const InertiaForce inertia_force{rate, mass_factor};
    Evaluation         evaluation;
    assemble_system(
      state, request, supports.at_rest(), &inertia_force, evaluation);
    judge(evaluation);
    return evaluation;
  }



  double
  FiberEquations::add_force(const Vector &force)
  {
    system.residual += force;
    Vector free_force(force);
    supports.at_rest().set_zero(free_force);
    system.right_hand_side -= free_force;

    return force_norm(system.residual);
  }



  void
  FiberEquations::prescribe(Motion &motion, const double time)
  {
    // The integrators see motions through their time steps; IDA takes shorter
    // ones than it reports.
    const DynamicsParameters &dynamics = scene.dynamics;
    const double              spacing =
      (dynamics.integrator == "IDA" ? .01 : 1.) * dynamics.time_step;
    for (const auto &[dof, values] : supports.motion_at(time, spacing))
      if (fibers.owned_dofs.is_element(dof))
        {
          motion.displacement(dof) = values[0];
          motion.velocity(dof)     = values[1];
          motion.acceleration(dof) = values[2];
        }
    for (Vector *vector :
         {&motion.displacement, &motion.velocity, &motion.acceleration})
      vector->compress(VectorOperation::insert);
  }



  FiberEquations::Vector
  FiberEquations::unit_displacements() const
  {
    Vector result(fibers.owned_dofs, communicator);
    std::copy(units.begin(), units.end(), result.begin());
    return result;
  }



  void
  FiberEquations::set_supports_to_zero(Vector &vector) const
  {
    supports.at_rest().set_zero(vector);
  }



  Motion
  FiberEquations::initial_motion()
  {
    const Vector zero(fibers.owned_dofs, communicator);
    Motion       motion{zero, inertia->initial_velocity(), zero};
    prescribe(motion, 0.);

    Vector rate(motion.acceleration);
    rate.add(scene.dynamics.damping, motion.velocity);
    evaluate_motion(motion.displacement, rate, 0., 0., Request::residual);
    Vector force(system.residual);
    force *= -1.;
    set_supports_to_zero(force);

    // The matrix is that of the mass alone.
    has_product = false;
    solver.clear();
    system.start(Request::tangent, supports.at_rest());
    inertia->add(zero, 1., system);
    system.finish();
    Vector acceleration(zero);
    AssertThrow(solve(force, acceleration),
                ExcRun("There is no initial acceleration: the mass matrix is "
                       "singular."));
    motion.acceleration += acceleration;
    return motion;
  }



  FiberEquations::Vector
  FiberEquations::times_mass(const Vector &vector)
  {
    return inertia->multiply(vector);
  }



  Momenta
  FiberEquations::momenta(const Motion &motion)
  {
    return inertia->momenta(state(motion.displacement, 0.), motion.velocity);
  }



  double
  FiberEquations::support_power(const Motion &motion)
  {
    Vector reactions(system.residual), free(system.residual);
    set_supports_to_zero(free);
    reactions -= free;
    return reactions * motion.velocity;
  }


  std::vector<ExternalWork>
  FiberEquations::external_work(const Motion &motion, const double time)
  {
    const State               state = this->state(motion.displacement, time);
    std::vector<ExternalWork> result;
    for (const auto &term : terms)
      term->add_external_work(state, result);
    return result;
  }
} // namespace Setae
