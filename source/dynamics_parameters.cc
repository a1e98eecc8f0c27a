// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <setae/base/entries.h>
#include <setae/base/exceptions.h>
#include <setae/beams/all.h>
#include <setae/scene.h>

namespace Setae
{
  using namespace dealii;

  void
  DynamicsParameters::add_parameters(Entries &prm)
  {
    prm.add_parameter(
      "integrator",
      integrator,
      "'none' for a static scene. 'generalized-alpha': "
      "implicit, second order, with numerical damping as "
      "'rho infinity' says. 'energy-conserving': the same, "
      "with a force that makes the energy change by nothing "
      "but that damping, also in large steps. 'IDA': the variable-order BDF "
      "method of SUNDIALS with its own error control. With one "
      "of these, fibers have inertia and 'load stepping' is "
      "not used.",
      Patterns::Selection("none|generalized-alpha|energy-conserving|IDA"));
    prm.add_parameter("end time",
                      end_time,
                      "The motion goes from time 0 to this one.",
                      Patterns::Double(0.));
    prm.add_parameter("time step",
                      time_step,
                      "The time step of generalized-alpha, or its first one if "
                      "there is a tolerance. IDA chooses its steps itself and "
                      "reports after each interval of this length, and after "
                      "500 steps [time].",
                      Patterns::Double(0.));
    prm.add_parameter(
      "tolerance",
      tolerance,
      "The largest error of the displacement of a node in one "
      "step [length]. Generalized-alpha adapts its steps to it, "
      "or takes equal ones if it is 0. IDA needs it.",
      Patterns::Double(0.));
    prm.add_parameter("largest step",
                      largest_step,
                      "Upper bound of adapted steps of generalized-alpha "
                      "[time]; 0 means no bound.",
                      Patterns::Double(0.));
    prm.add_parameter(
      "smallest step",
      smallest_step,
      "A step of generalized-alpha that cannot be solved or is "
      "too inaccurate is repeated with a smaller size down to "
      "this one [time]; IDA ends where 500 of its steps are "
      "shorter together, twice in a row. 0 takes 1e-6 of 'time step'.",
      Patterns::Double(0.));
    prm.add_parameter(
      "largest displacement",
      largest_displacement,
      "A step of generalized-alpha that moves a node by more is "
      "repeated with a smaller size [length]; 0 means no bound. (A step on "
      "whose way fibers pass through each other always is.)",
      Patterns::Double(0.));
    prm.add_parameter(
      "energy tolerance",
      energy_tolerance,
      "The largest error of the balance of energy in one step [energy], that "
      "is of kinetic and potential energy less the work done from outside; "
      "numerical damping counts as an error. A step of generalized-alpha with "
      "a larger one, as when fibers hit, is repeated with a smaller size; 0 "
      "means no bound.",
      Patterns::Double(0.));
    prm.add_parameter(
      "largest energy gain",
      largest_energy_gain,
      "What the time integration may add, in the whole run, to the energy plus "
      "what damping took minus the work done from outside, as a part of the "
      "largest energy: the largest sum so far of the kinetic energy, what "
      "damping took, and what the energy of each term has changed by since time "
      "0. A step that adds more than half of what is left is repeated with a "
      "smaller size; with IDA, which may also add a part of the total energy, "
      "the run ends. What numerical damping takes away does not count; beyond "
      "it, generalized-alpha may lose 20 times as much, 'energy-conserving' "
      "only the same. 0 means no bound; interactions without a potential "
      "('interaction moments', 'cutoff of') have none.",
      Patterns::Double(0.));
    prm.add_parameter("rho infinity",
                      rho_infinity,
                      "The spectral radius of generalized-alpha for infinite "
                      "frequencies: 1 keeps the energy of linear vibrations, 0 "
                      "takes away high frequencies in one step.",
                      Patterns::Double(0., 1.));
    prm.add_parameter("damping",
                      damping,
                      "A viscous force against the velocity, as a multiple of "
                      "the mass [1/time].",
                      Patterns::Double(0.));
    prm.add_parameter("largest order",
                      max_order,
                      "The largest order of IDA's BDF methods, up to 5. Those "
                      "above 2 need few steps for damped motions, but are "
                      "unstable for fast vibrations without damping.",
                      Patterns::Integer(1, 5));
  }



  void
  DynamicsParameters::check(const std::vector<FiberParameters> &fibers) const
  {
    if (!is_on())
      return;
    for (const FiberParameters &fiber : fibers)
      require(fiber.density > 0. || fiber.beam == Rigid::name,
              "fibers/" + fiber.name + "/density",
              fiber.density,
              "positive in a scene with dynamics");
    require(end_time > 0., "dynamics/end time", end_time, "positive");
    require(time_step > 0., "dynamics/time step", time_step, "positive");
    require(smallest_step <= time_step,
            "dynamics/smallest step",
            smallest_step,
            "at most the time step");
    require(largest_step == 0. || largest_step >= time_step,
            "dynamics/largest step",
            largest_step,
            "0 or at least the time step");
    if (integrator == "IDA")
      {
        require(tolerance > 0.,
                "dynamics/tolerance",
                tolerance,
                "positive for the integrator IDA");
        require(largest_displacement == 0.,
                "dynamics/largest displacement",
                largest_displacement,
                "0 for the integrator IDA, which cannot bound it");
        require(energy_tolerance == 0.,
                "dynamics/energy tolerance",
                energy_tolerance,
                "0 for the integrator IDA, which cannot bound it");
      }
  }
} // namespace Setae
