// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <gtest/gtest.h>

#include <setae/solvers/generalized_alpha.h>
#include <setae/solvers/work_between.h>

#include <cmath>
#include <limits>
#include <memory>
#include <random>
#include <vector>

#include "oscillator.h"

using namespace Setae;
using Setae::Test::Oscillator;

namespace
{
  const std::vector<double> radii = {0., .25, .5, .75, .9, .99, 1.};

  std::unique_ptr<GeneralizedAlpha>
  method(Oscillator &system, const double rho_infinity)
  {
    DynamicsParameters dynamics;
    dynamics.integrator   = "generalized-alpha";
    dynamics.rho_infinity = rho_infinity;
    dynamics.damping      = system.damping;
    NewtonParameters newton;
    newton.residual_tolerance  = 1e-12;
    newton.increment_tolerance = 1e-6;
    return std::make_unique<GeneralizedAlpha>(
      dynamics,
      newton,
      [](const IterationReport &) {},
      system.initial_motion());
  }

  /** Sizes in which successive steps have these ratios, again and again. */
  std::vector<double>
  geometric(const double              first,
            const std::vector<double> ratios,
            const unsigned int        n)
  {
    std::vector<double> sizes = {first};
    while (sizes.size() < n)
      sizes.push_back(sizes.back() *
                      ratios[(sizes.size() - 1) % ratios.size()]);
    return sizes;
  }

  std::vector<double>
  random_sizes(const double least, const double most, const unsigned int n)
  {
    std::mt19937                           generator(7);
    std::uniform_real_distribution<double> exponent(std::log(.2), std::log(2.));
    std::vector<double>                    sizes = {std::sqrt(least * most)};
    while (sizes.size() < n)
      sizes.push_back(std::clamp(
        sizes.back() * std::exp(exponent(generator) + .35), least, most));
    return sizes;
  }

  /** Those that grow, shrink, jump, and end with equal ones. */
  std::vector<std::vector<double>>
  sequences()
  {
    std::vector<std::vector<double>> result = {
      geometric(1., {1.}, 40),
      geometric(1., {2.}, 20),
      geometric(1., {5.}, 8),
      geometric(1., {1.2}, 60),
      geometric(1., {.2}, 12),
      geometric(1., {2., .5}, 200),
      geometric(1., {.2, 2., 2., 1.25}, 80),
      geometric(1., {1e-3, 2., 2., 2., 2., 2., 2., 2., 2., 1.9, 2.}, 60),
      random_sizes(1e-3, 1e2, 200)};
    for (std::vector<double> &sizes : result)
      for (unsigned int i = 0; i < 20; ++i)
        sizes.push_back(sizes.back());
    return result;
  }

  struct Outcome
  {
    double largest_speed = 0.; ///< the square root of twice the energy
    double largest_drift = 0.; ///< of the auxiliary acceleration, over a step
  };

  Outcome
  run(Oscillator                &system,
      const double               rho_infinity,
      const std::vector<double> &sizes)
  {
    const auto step = method(system, rho_infinity);
    double     time = 0.;
    Outcome    result;
    for (const double h : sizes)
      {
        time += h;
        EXPECT_TRUE(step->try_step(system, time, h).converged);
        step->accept();
        const double x = step->motion().displacement(0),
                     v = step->motion().velocity(0);
        result.largest_speed =
          std::max(result.largest_speed,
                   std::sqrt(v * v + system.stiffness * x * x));
        result.largest_drift =
          std::max(result.largest_drift,
                   std::abs(h * step->auxiliary_acceleration()(0)));
      }
    return result;
  }
} // namespace



TEST(GeneralizedAlphaSteps, OfAnySizeLetNoVibrationAndNoAccelerationGrow)
{
  for (const double rho : radii)
    for (const auto &sizes : sequences())
      for (const double frequency : {1e-4, 1e-2, 1., 3., 10., 1e3, 1e6})
        for (const double damping : {0., 1e-2, 1., 1e2, 1e8})
          {
            SCOPED_TRACE(testing::Message()
                         << "rho " << rho << ", sizes " << sizes[1] << ' '
                         << sizes[2] << ", frequency " << frequency
                         << ", damping " << damping);
            Oscillator system;
            system.stiffness            = frequency * frequency;
            system.initial_displacement = 1. / frequency;
            system.damping              = damping;
            const Outcome outcome       = run(system, rho, sizes);
            ASSERT_LT(outcome.largest_speed, 2.);
            // Vibrations that the trapezoidal rule keeps have accelerations of
            // any size.
            if (rho < 1.)
              {
                ASSERT_LT(outcome.largest_drift, 20.);
              }
          }
}



TEST(GeneralizedAlphaSteps, OfAnySizeHaveOrderTwo)
{
  const std::vector<std::vector<double>> patterns = {
    {1., 2., 4., 8., 4., 2.},         // grow and shrink
    {1., 1.2, 1.44, 1.2, 1.},         // a little
    {4., .5, .5, 1., 2.},             // jump
    {1., 2., .2, .4, .8, 1.6, .3, .6} // far
  };
  for (const double rho : {0., .5, .9, 1.})
    for (const auto &pattern : patterns)
      {
        SCOPED_TRACE(testing::Message() << "rho " << rho << ", " << pattern[1]);
        std::vector<std::array<double, 2>> errors;
        double                             sum = 0.;
        for (const double size : pattern)
          sum += size;
        for (const unsigned int n : {240, 480})
          {
            Oscillator system;
            system.stiffness            = 4.;
            system.hardening            = 2.;
            system.load                 = 1.;
            system.amplitude            = .3;
            system.initial_displacement = 1.;
            system.initial_velocity     = -.5;
            system.damping              = .1;
            const auto step             = method(system, rho);
            double     time             = 0.;
            for (unsigned int i = 0; i < n; ++i)
              for (const double size : pattern)
                {
                  const double h = 3. * size / (n * sum);
                  time += h;
                  ASSERT_TRUE(step->try_step(system, time, h).converged);
                  step->accept();
                }
            const auto exact = system.exact(3.);
            errors.push_back(
              {{std::abs(step->motion().displacement(0) - exact[0]),
                std::abs(step->motion().velocity(0) - exact[1])}});
          }
        for (const unsigned int i : {0, 1})
          EXPECT_NEAR(std::log2(errors[0][i] / errors[1][i]), 2., .15);
      }
}



TEST(GeneralizedAlphaSteps, ThatAreRejectedLeaveNoTrace)
{
  for (const double rho : {0., .9})
    {
      Oscillator system;
      system.stiffness            = 4.;
      system.hardening            = 2.;
      system.initial_displacement = 1.;
      std::vector<double> ends;
      for (const bool is_rejected : {false, true})
        {
          const auto step = method(system, rho);
          double     time = 0.;
          for (const double h : {.01, .02, .001})
            {
              if (is_rejected)
                for (const double factor : {3., 1.5})
                  EXPECT_TRUE(
                    step->try_step(system, time + factor * h, factor * h)
                      .converged);
              time += h;
              EXPECT_TRUE(step->try_step(system, time, h).converged);
              step->accept();
            }
          ends.push_back(step->motion().displacement(0));
        }
      EXPECT_EQ(ends[0], ends[1]);
    }
}



// A force that grows from nothing moves a mass in honey by f/c t.
TEST(GeneralizedAlphaSteps, LongerThanTheFastestDecayDoNotOvershoot)
{
  constexpr double damping = 1e8, h = .1;
  for (const double rho : radii)
    {
      SCOPED_TRACE(rho);
      Oscillator system;
      system.stiffness = 0.;
      system.load      = 1.;
      system.damping   = damping;
      const auto step  = method(system, rho);
      for (unsigned int i = 1; i <= 10; ++i)
        {
          ASSERT_TRUE(step->try_step(system, i * h, h).converged);
          step->accept();
          const double x = step->motion().displacement(0),
                       v = step->motion().velocity(0);
          EXPECT_NEAR(x, std::sin(i * h) / damping, 1.1 * h / damping);
          EXPECT_LT(std::abs(v), 2.1 / damping);
        }
    }
}



TEST(GeneralizedAlphaSteps, LongerThanTheFastestVibrationStartWithNoMoreEnergy)
{
  for (const double rho : radii)
    {
      SCOPED_TRACE(rho);
      Oscillator system;
      system.stiffness            = 1e8;
      system.initial_displacement = 1e-4;
      EXPECT_LE(run(system, rho, {.1, .1, .1}).largest_speed, 1. + 1e-6);
    }
}



// With a linear spring nothing is missed but what the method takes.
TEST(Work, MakesTheBalanceOfALinearSystemExactWhateverTheSteps)
{
  for (const double rho : radii)
    for (const bool is_driven : {false, true})
      for (const double damping : {0., 3., 1e4})
        {
          SCOPED_TRACE(testing::Message() << rho << ' ' << damping);
          Oscillator system;
          system.stiffness                = 50.;
          system.load                     = is_driven ? 2. : 0.;
          system.amplitude                = is_driven ? .3 : 0.;
          system.initial_displacement     = 1.;
          system.damping                  = damping;
          const auto              step    = method(system, rho);
          const Motion            initial = step->motion();
          NonlinearSystem::Vector rate(initial.acceleration);
          rate.add(damping, initial.velocity);
          Evaluation evaluation = system.evaluate_motion(
            initial.displacement, rate, 0., 0., Request::residual);
          BalancedState last(system, initial, 0.);
          double        kinetic = system.momenta(initial).kinetic_energy;
          const double  first   = evaluation.energy + kinetic;
          double        sum = 0., numerical = 0., time = 0., largest = first;
          for (const double h : {.3, .1, .2, .2, .04, .08, .16, .32, .01, .3})
            {
              time += h;
              const SolverResult result = step->try_step(system, time, h);
              ASSERT_TRUE(result.converged);
              step->accept();
              const BalancedState next(system, step->motion(), time);
              const Work   work = work_between(system, damping, last, next);
              const double new_kinetic =
                system.momenta(step->motion()).kinetic_energy;
              numerical += work.inertia - (new_kinetic - kinetic);
              sum += work.damping - work.supports - work.external;
              kinetic = new_kinetic;
              last    = next;
              largest = std::max(largest, result.evaluation.energy + kinetic);
              EXPECT_NEAR(result.evaluation.energy + kinetic + sum + numerical,
                          first,
                          1e-9 * largest);
            }
          // Accelerations of supports are not those of Newmark's formulas, and
          // a first step that is longer than the decay, here 0.3, is one of
          // implicit Euler, which takes energy.
          if (!is_driven && rho == 1. && .3 * damping <= 1.)
            {
              EXPECT_NEAR(numerical, 0., 1e-9 * largest);
            }
          if (!is_driven && .3 * damping > 1.)
            {
              EXPECT_GE(numerical, -1e-9 * largest);
            }
          if (!is_driven && rho < 1. && damping == 0.)
            {
              EXPECT_GT(numerical, 1e-3 * largest);
            }
        }
}



// From rest to the last velocity at once: the damping takes all that the force
// gives.
TEST(Work, OfDampingIsThatOfTheForceInAFirstStepLongerThanItsDecay)
{
  Oscillator system;
  system.stiffness = 0.;
  system.load      = 1.;
  system.damping   = 1e6;
  const auto step  = method(system, 0.);
  system.evaluate_motion(step->motion().displacement,
                         step->motion().acceleration,
                         0.,
                         0.,
                         Request::residual);
  const BalancedState first(system, step->motion(), 0.);
  constexpr double    h = 1e-3;
  ASSERT_TRUE(step->try_step(system, h, h).converged);
  const BalancedState next(system, step->trial(), h);
  const Work          work =
    work_between(system, system.damping, first, next, system.damping * h);
  EXPECT_NEAR(work.damping / work.external, 1., 2e-3);
}
