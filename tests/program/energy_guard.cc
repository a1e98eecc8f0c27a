// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <gtest/gtest.h>

#include <setae/energy_guard.h>
#include <setae/fiber_problem.h>

#include <cmath>
#include <fstream>
#include <sstream>

using namespace Setae;

namespace
{
  /** A state with kinetic energy, potential energies and what was taken. */
  struct Energies
  {
    MotionReport motion;
    Evaluation   evaluation;

    Energies(const double               kinetic,
             const std::vector<double> &terms,
             const double               dissipation = 0.,
             const double               numerical   = 0.)
    {
      evaluation.energies           = terms;
      motion.momenta.kinetic_energy = kinetic;
      motion.total_energy           = kinetic;
      for (const double term : terms)
        motion.total_energy += term;
      motion.dissipation           = dissipation;
      motion.numerical_dissipation = numerical;
    }
  };

  EnergyGuard
  guard(const std::string &integrator, const Energies &start)
  {
    DynamicsParameters dynamics;
    dynamics.integrator = integrator;
    EnergyGuard result(dynamics, true);
    result.start(start.motion, start.evaluation);
    return result;
  }

  double
  measure(const EnergyGuard &guard, const Energies &state)
  {
    return guard.measure(state.motion, state.evaluation, 0.);
  }

  /** A run of tests/program/NAME.prm without output. */
  struct SceneMotion
  {
    SceneMotion(const std::string              &name,
                const std::vector<std::string> &overrides)
    {
      const std::string file_name =
        SETAE_SCENES "/../tests/program/" + name + ".prm";
      std::ifstream      file(file_name);
      std::ostringstream text;
      text << file.rdbuf();
      FiberProblem problem(Scene::read(text.str(), file_name, overrides),
                           MPI_COMM_SELF,
                           screen);
      try
        {
          summary = problem.run(
            [this](const StepRecord &record) { records.push_back(record); });
        }
      catch (const ExcRun &error)
        {
          refusal = error.what();
        }
    }

    /** The largest change of the balance of energy, in parts of @p scale. */
    double
    imbalance(const double scale) const
    {
      double largest = 0.;
      for (const StepRecord &record : records)
        largest = std::max(largest,
                           std::abs(record.motion->balance() -
                                    records.front().motion->balance()));
      return largest / scale;
    }

    const StepRecord &
    last() const
    {
      return records.back();
    }

    std::ostringstream      screen;
    std::vector<StepRecord> records;
    RunSummary              summary;
    std::string             refusal;
  };
} // namespace



TEST(EnergyGuard, LetsAStepCreateHalfOfWhatIsLeft)
{
  const EnergyGuard of = guard("generalized-alpha", {2., {-5.}});
  // The energy is 2: a thousandth of it may come in, half of it in one step.
  EXPECT_NEAR(measure(of, {2. + 1e-3, {-5.}}), 1., 1e-3);
  EXPECT_GT(measure(of, {2. + 2e-3, {-5.}}), 1.9);
  EXPECT_LT(measure(of, {2. - 1e-3, {-5.}}), .1);

  EnergyGuard    later = of;
  const Energies next(2. + 1e-3, {-5.});
  later.accept(next.motion, next.evaluation);
  EXPECT_NEAR(measure(later, {2. + 1.5e-3, {-5.}}), 1., 2e-3);
}



TEST(EnergyGuard, KnowsNoZeroOfThePotential)
{
  for (const double constant : {0., 1e6})
    {
      const EnergyGuard of = guard("generalized-alpha", {1., {constant, 3.}});
      EXPECT_NEAR(measure(of, {1.001, {constant, 3.}}), 2., 1e-2);
    }
}



TEST(EnergyGuard, DoesNotLetNumericalDampingPayForWhatIsCreated)
{
  const EnergyGuard of = guard("generalized-alpha", {1., {0.}});
  EXPECT_EQ(measure(of, {.5, {0.}, 0., .5}), 0.);
  EXPECT_GT(measure(of, {.8, {0.}, 0., .5}), 100.);

  // Numerical damping that has given energy, after the first step.
  EnergyGuard    later = of;
  const Energies next(1., {0.});
  later.accept(next.motion, next.evaluation);
  EXPECT_GT(measure(later, {1.3, {0.}, 0., -.3}), 100.);
}



TEST(EnergyGuard, MindsLossesMostIfTheEnergyIsToBeConserved)
{
  const Energies first(1., {0.}), next(.99, {0.});
  EXPECT_NEAR(measure(guard("generalized-alpha", first), next), 1., 1e-10);
  EXPECT_NEAR(measure(guard("energy-conserving", first), next), 20., 1e-10);
}



TEST(EnergyGuard, DoesNotMindRoundOff)
{
  const EnergyGuard of = guard("generalized-alpha", {0., {1., -1.}});
  EXPECT_EQ(measure(of, {0., {1. + 1e-15, -1.}}), 0.);
  EXPECT_GT(measure(of, {0., {1. + 1e-10, -1.}}), 1.);
}



// An auxiliary acceleration that is scaled with the step ends at a gap of 1.353
// and a total energy of +6.26.
TEST(EnergyInMotion, FibersThatSettleEndInTheirEquilibriumForEveryRhoInfinity)
{
  for (const std::string rho : {"0", "0.5", "0.9", "1"})
    {
      SCOPED_TRACE(rho);
      const SceneMotion run("settling_pair", {"dynamics/rho infinity=" + rho});
      ASSERT_EQ(run.refusal, "");
      // Of the curves; between integration points it is 0.995.
      EXPECT_NEAR(run.last().evaluation.gaps.smallest, .9935, 2e-4);
      EXPECT_NEAR(run.last().motion->total_energy, -1.5559, 1e-4);
      EXPECT_NEAR(run.last().motion->balance(), -1.5437, 1e-4);
      EXPECT_LT(run.imbalance(.0123), 1e-3);
    }
}



// A first step that extrapolates the first acceleration ends at (0.07, +0.17).
TEST(EnergyInMotion, AHeavilyDampedFiberMovesAsItsForcesAsk)
{
  for (const std::string rho : {"0", "0.9"})
    {
      SCOPED_TRACE(rho);
      const SceneMotion run("heavily_damped", {"dynamics/rho infinity=" + rho});
      ASSERT_EQ(run.refusal, "");
      const Tensor<1, 3> tip = run.last().loads[0].displacement;
      EXPECT_NEAR(tip[0], .01575, 5e-5);
      EXPECT_NEAR(tip[1], -.00760, 3e-5);
      EXPECT_LT(run.imbalance(9.04e-3), 1e-3);
    }
}



// Without the guard 43% of the energy come in by energy-conserving steps, 58%
// and 128 times as much by the others.
TEST(EnergyInMotion, AnAdhesiveImpactCreatesNoEnergyOrIsRefused)
{
  constexpr double kinetic_energy = 3.1416e-4;
  for (const std::vector<std::string> &integrator :
       {std::vector<std::string>{"dynamics/integrator=energy-conserving",
                                 "dynamics/rho infinity=1"},
        {"dynamics/integrator=generalized-alpha", "dynamics/rho infinity=0.9"},
        {"dynamics/integrator=IDA", "dynamics/tolerance=1e-5"}})
    {
      SCOPED_TRACE(integrator[0]);
      const SceneMotion run("impact", integrator);
      ASSERT_GT(run.records.size(), 5u);
      EXPECT_TRUE(run.refusal.empty() ||
                  run.refusal.find("'dynamics/largest energy gain'") !=
                    std::string::npos)
        << run.refusal;
      double largest_gain = 0., largest_energy = 0.;
      for (const StepRecord &record : run.records)
        {
          largest_gain   = std::max(largest_gain,
                                  record.motion->balance() -
                                    run.records.front().motion->balance());
          largest_energy = std::max(largest_energy,
                                    record.motion->momenta.kinetic_energy +
                                      std::abs(record.evaluation.energy) +
                                      std::abs(record.motion->total_energy));
        }
      EXPECT_LT(largest_gain, 1e-3 * largest_energy);
      if (integrator[0] == "dynamics/integrator=energy-conserving")
        {
          EXPECT_EQ(run.refusal, "");
          EXPECT_LT(run.imbalance(kinetic_energy), 1e-3);
        }
    }
}
