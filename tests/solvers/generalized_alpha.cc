// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <gtest/gtest.h>

#include <setae/solvers/generalized_alpha.h>
#include <setae/solvers/time_stepping.h>

#include <cmath>
#include <vector>

#include "oscillator.h"

using namespace Setae;
using Setae::Test::Oscillator;

namespace
{
  /** A motion with everything that the method has to cope with. */
  Oscillator
  shaken_oscillator()
  {
    Oscillator system;
    system.stiffness            = 4.;
    system.hardening            = 2.;
    system.load                 = 1.;
    system.amplitude            = .3;
    system.initial_displacement = 1.;
    system.initial_velocity     = -.5;
    system.damping              = .1;
    return system;
  }

  NewtonParameters
  tight()
  {
    NewtonParameters result;
    result.residual_tolerance  = 1e-12;
    result.increment_tolerance = 1e-6;
    return result;
  }

  GeneralizedAlpha
  method(Oscillator        &system,
         const double       rho_infinity,
         const std::string &integrator = "generalized-alpha")
  {
    DynamicsParameters dynamics;
    dynamics.integrator   = integrator;
    dynamics.rho_infinity = rho_infinity;
    dynamics.damping      = system.damping;
    return GeneralizedAlpha(
      dynamics,
      tight(),
      [](const IterationReport &) {},
      system.initial_motion());
  }

  /** After steps whose sizes are @p sizes again and again, up to time @p end. */
  Motion
  integrate(Oscillator                &system,
            const double               rho_infinity,
            const double               end,
            const std::vector<double> &sizes,
            const std::string         &integrator = "generalized-alpha")
  {
    GeneralizedAlpha generalized_alpha =
      method(system, rho_infinity, integrator);
    double time = 0.;
    for (unsigned int i = 0; time < end - 1e-9; ++i)
      {
        const double h = sizes[i % sizes.size()];
        time += h;
        EXPECT_TRUE(generalized_alpha.try_step(system, time, h).converged);
        generalized_alpha.accept();
      }
    EXPECT_NEAR(time, end, 1e-9);
    return generalized_alpha.motion();
  }

  /** Errors of displacement and velocity at time 3. */
  std::array<double, 2>
  errors(const double               rho_infinity,
         const std::vector<double> &sizes,
         const std::string         &integrator = "generalized-alpha")
  {
    Oscillator   system = shaken_oscillator();
    const Motion motion =
      integrate(system, rho_infinity, 3., sizes, integrator);
    const auto exact = system.exact(3.);
    return {{std::abs(motion.displacement(0) - exact[0]),
             std::abs(motion.velocity(0) - exact[1])}};
  }
} // namespace



TEST(GeneralizedAlpha, HasTheConstantsOfChungAndHulbert)
{
  for (const double rho : {0., .25, .5, .9, 1.})
    {
      const GeneralizedAlpha::Coefficients c(rho);
      EXPECT_NEAR(c.gamma, .5 - c.alpha_m + c.alpha_f, 1e-15);

      // The double root for infinite frequencies: with a = -gamma-ratio both
      // parasitic roots are -rho.
      EXPECT_NEAR(c.alpha_f / (c.alpha_f - 1.), -rho, 1e-14);
      const double root = 1. - .5 * (c.gamma + .5) / c.beta;
      EXPECT_NEAR(root, -rho, 1e-14);
    }
  // The trapezoidal rule.
  const GeneralizedAlpha::Coefficients c(1.);
  EXPECT_EQ(c.beta, .25);
  EXPECT_EQ(c.gamma, .5);
}



TEST(GeneralizedAlpha, ConvergesWithOrderTwo)
{
  for (const double rho : {0., .5, .9, 1.})
    {
      SCOPED_TRACE(rho);
      const auto coarse = errors(rho, {3. / 400}),
                 fine   = errors(rho, {3. / 800});
      for (const unsigned int i : {0, 1})
        EXPECT_NEAR(std::log2(coarse[i] / fine[i]), 2., .1);
    }
}



TEST(GeneralizedAlpha, ConvergesWithOrderTwoIfStepsChangeAbruptly)
{
  for (const double rho : {0., .5, .9, 1.})
    {
      SCOPED_TRACE(rho);
      const double h      = 3. / 400.;
      const auto   coarse = errors(rho, {h, .25 * h, .75 * h}),
                 fine     = errors(rho, {.5 * h, .125 * h, .375 * h});
      for (const unsigned int i : {0, 1})
        EXPECT_NEAR(std::log2(coarse[i] / fine[i]), 2., .15);
    }
}



TEST(GeneralizedAlpha, KeepsTheEnergyOfALinearVibrationWithoutNumericalDamping)
{
  Oscillator system;
  system.stiffness            = 4.;
  system.initial_displacement = 1.;
  for (const unsigned int n : {10, 1000})
    {
      const Motion motion = integrate(system, 1., .1 * n, {.1});
      const double x = motion.displacement(0), v = motion.velocity(0);
      EXPECT_NEAR(.5 * v * v + 2. * x * x, 2., 1e-10);
    }
}



// Steps so large that the trapezoidal rule is visibly wrong; the load is no
// part of the energy and does work.
TEST(GeneralizedAlpha, KeepsTheEnergyOfALargeVibrationIfTold)
{
  Oscillator system;
  system.stiffness                = 1.;
  system.hardening                = 20.;
  system.load                     = 1.;
  system.initial_displacement     = 1.;
  const std::vector<double> sizes = {.2, .1, .15};
  std::vector<double>       deviations;
  for (const std::string integrator :
       {"generalized-alpha", "energy-conserving"})
    {
      GeneralizedAlpha step = method(system, 1., integrator);
      double           time = 0., x = 1., force = 1., work = 0., largest = 0.;
      for (unsigned int i = 0; i < 60; ++i)
        {
          const double h = sizes[i % sizes.size()];
          time += h;
          ASSERT_TRUE(step.try_step(system, time, h).converged);
          step.accept();
          const double new_x     = step.motion().displacement(0),
                       new_force = std::cos(time),
                       v         = step.motion().velocity(0);
          work += .5 * (force + new_force) * (new_x - x);
          x     = new_x;
          force = new_force;
          const double energy =
            .5 * v * v + .5 * x * x + 5. * x * x * x * x - work;
          largest = std::max(largest, std::abs(energy / 5.5 - 1.));
        }
      deviations.push_back(largest);
    }
  EXPECT_GT(deviations[0], .05);
  EXPECT_LT(deviations[1], 1e-10);
}



TEST(GeneralizedAlpha, ConvergesWithOrderTwoIfItConservesEnergy)
{
  for (const double rho : {0., .5, .9, 1.})
    {
      SCOPED_TRACE(rho);
      const double h      = 3. / 400.;
      const auto   coarse = errors(rho, {h}, "energy-conserving"),
                 fine     = errors(rho, {.5 * h}, "energy-conserving");
      for (const unsigned int i : {0, 1})
        EXPECT_NEAR(std::log2(coarse[i] / fine[i]), 2., .15);
    }
}



TEST(GeneralizedAlpha, TakesAwayWhatItDoesNotResolveAsFastAsItIsTold)
{
  Oscillator system;
  system.stiffness            = 1e6;
  system.initial_displacement = 1.;

  // With the triple root rho, the amplitude after n steps is at most about
  // n^2 rho^n.
  EXPECT_LT(std::abs(integrate(system, 0., 4., {1.}).displacement(0)), 1e-4);
  const double amplitude =
    std::abs(integrate(system, .5, 20., {1.}).displacement(0));
  EXPECT_LT(amplitude, 400. * std::pow(.5, 20.));
  EXPECT_GT(amplitude, std::pow(.5, 22.));

  // The trapezoidal rule turns by 2 atan(omega h/2) in each step.
  EXPECT_NEAR(integrate(system, 1., 20., {1.}).displacement(0),
              std::cos(40. * std::atan(500.)),
              1e-6);
}



TEST(GeneralizedAlpha, EstimatesTheErrorOfAStep)
{
  for (const double rho : {0., .9, 1.})
    {
      SCOPED_TRACE(rho);
      Oscillator       system = shaken_oscillator();
      GeneralizedAlpha step   = method(system, rho);
      const double     h      = .01;
      // Small against the period, so that filtering does not matter.
      ASSERT_TRUE(step.try_step(system, h, h).converged);
      const double estimate = step.error(system);
      // The first auxiliary acceleration is the true one: what differs is
      // known.
      const GeneralizedAlpha::Coefficients c(rho);
      const double                         first_constant =
        c.beta / (1. - c.alpha_m) * (1. - c.alpha_f) - 1. / 6.;
      step.accept();
      const double error =
        std::abs(step.motion().displacement(0) - system.exact(h)[0]);
      EXPECT_GT(estimate, 0.);
      EXPECT_NEAR(error / estimate,
                  std::abs(first_constant) / c.error_constant(),
                  .2);
    }
}



TEST(GeneralizedAlpha, EstimatesNoErrorForVibrationsThatItNeedNotResolve)
{
  Oscillator system;
  system.stiffness            = 1e6;
  system.initial_displacement = 1e-6;
  GeneralizedAlpha step       = method(system, .9);
  ASSERT_TRUE(step.try_step(system, .1, .1).converged);
  EXPECT_LT(step.error(system), 1e-6);
}



TEST(TimeStepping, ReachesTheEndWithEqualStepsAndNoTinyOne)
{
  DynamicsParameters parameters;
  parameters.end_time  = .3;
  parameters.time_step = 1e-4;
  TimeStepping steps(parameters);
  unsigned int n = 0;
  for (; !steps.is_finished(); ++n)
    {
      EXPECT_EQ(steps.step_size(), 1e-4);
      EXPECT_NEAR(steps.next_time(), (n + 1) * 1e-4, 1e-15);
      steps.accept({});
    }
  EXPECT_EQ(n, 3000u);
  EXPECT_EQ(steps.time(), .3);
}



TEST(TimeStepping, CutsTheLastStep)
{
  DynamicsParameters parameters;
  parameters.end_time  = 1.;
  parameters.time_step = .4;
  TimeStepping steps(parameters);
  steps.accept({});
  steps.accept({});
  EXPECT_NEAR(steps.step_size(), .2, 1e-15);
  EXPECT_EQ(steps.next_time(), 1.);
}



TEST(TimeStepping, GrowsBackToEqualStepsAfterAFailure)
{
  DynamicsParameters parameters;
  parameters.time_step = .1;
  TimeStepping steps(parameters);
  ASSERT_TRUE(steps.reject());
  EXPECT_EQ(steps.step_size(), .05);
  ASSERT_TRUE(steps.reject());
  EXPECT_EQ(steps.step_size(), .025);
  for (const double size : {.025, .05, .1, .1})
    {
      EXPECT_EQ(steps.step_size(), size);
      steps.accept({});
    }
}



TEST(TimeStepping, FollowsTheErrorWithinItsBounds)
{
  DynamicsParameters parameters;
  parameters.time_step     = 1e-3;
  parameters.smallest_step = 1e-5;
  parameters.largest_step  = 5e-3;
  parameters.tolerance     = 1e-6;
  TimeStepping steps(parameters);
  // The error of a step is of third order.
  steps.accept({1. / 8., 0.});
  EXPECT_NEAR(steps.step_size(), 1.8e-3, 1e-12);
  for (unsigned int i = 0; i < 5; ++i)
    steps.accept({1e-6, 0.});
  EXPECT_EQ(steps.step_size(), 5e-3);
  ASSERT_TRUE(steps.reject({8., 0.}));
  EXPECT_NEAR(steps.step_size(), 5e-3 * .45, 1e-12);
  while (steps.reject({1e6, 0.}))
    EXPECT_GE(steps.step_size(), 1e-5);
  EXPECT_EQ(steps.step_size(), 1e-5);
}



TEST(TimeStepping, LeavesEqualStepsWhereTheEnergyIsTooWrong)
{
  DynamicsParameters parameters;
  parameters.time_step = .1;
  TimeStepping steps(parameters);
  // Of second order in the size of the step.
  EXPECT_FALSE((StepMeasure{0., 0., 1.01}).is_acceptable());
  ASSERT_TRUE(steps.reject({0., 0., 9.}));
  EXPECT_NEAR(steps.step_size(), .03, 1e-15);
  steps.accept({0., 0., .5});
  EXPECT_NEAR(steps.step_size(), .03 * .9 * std::sqrt(2.), 1e-15);
  steps.accept({0., 0., 1e-6});
  steps.accept({0., 0., 1e-6});
  EXPECT_EQ(steps.step_size(), .1);
}



TEST(TimeStepping, LeavesEqualStepsOnlyWhereNodesMoveTooFar)
{
  DynamicsParameters parameters;
  parameters.time_step = .1;
  TimeStepping steps(parameters);
  steps.accept({0., .99});
  EXPECT_EQ(steps.step_size(), .1);
  ASSERT_TRUE(steps.reject({0., 2.}));
  EXPECT_NEAR(steps.step_size(), .045, 1e-15);
  steps.accept({0., .9});
  EXPECT_NEAR(steps.step_size(), .045, 1e-15);
  steps.accept({0., .6});
  EXPECT_NEAR(steps.step_size(), .0675, 1e-15);
  steps.accept({0., .1});
  EXPECT_EQ(steps.step_size(), .1);
}



// Ten times the tolerance is about 10^(1/3) times the step and 10^(2/3) times
// the error at the end.
TEST(TimeStepping, MakesTheErrorAtTheEndFollowTheTolerance)
{
  std::vector<double>       errors;
  std::vector<unsigned int> n_steps;
  for (const double tolerance : {1e-4, 1e-7})
    {
      Oscillator         system = shaken_oscillator();
      DynamicsParameters dynamics;
      dynamics.end_time     = 3.;
      dynamics.time_step    = 1e-3;
      dynamics.tolerance    = tolerance;
      dynamics.damping      = system.damping;
      GeneralizedAlpha step = method(system, .9);
      TimeStepping     steps(dynamics);
      n_steps.push_back(0);
      while (!steps.is_finished())
        {
          ASSERT_TRUE(
            step.try_step(system, steps.next_time(), steps.step_size())
              .converged);
          const StepMeasure measure{step.error(system) / tolerance, 0.};
          if (!measure.is_acceptable())
            {
              ASSERT_TRUE(steps.reject(measure));
              continue;
            }
          step.accept();
          steps.accept(measure);
          ++n_steps.back();
        }
      errors.push_back(
        std::abs(step.motion().displacement(0) - system.exact(3.)[0]));
    }
  EXPECT_NEAR(std::log10(errors[0] / errors[1]), 2., .5);
  EXPECT_NEAR(std::log10(static_cast<double>(n_steps[1]) / n_steps[0]), 1., .2);
}
