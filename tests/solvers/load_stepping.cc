// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <gtest/gtest.h>

#include <setae/base/exceptions.h>
#include <setae/solvers/load_stepping.h>

using namespace Setae;

namespace
{
  LoadSteppingParameters
  parameters()
  {
    LoadSteppingParameters result;
    result.first_step             = .1;
    result.instability_resolution = 1e-3;
    return result;
  }
} // namespace



TEST(LoadStepping, EndsExactlyAtTheEndTime)
{
  LoadStepping steps(parameters(), {});
  while (!steps.is_finished())
    steps.accept(5);
  EXPECT_EQ(steps.time(), 1.);
}



TEST(LoadStepping, GrowsAfterEasyStepsAndShrinksAfterHardOnes)
{
  LoadStepping easy(parameters(), {}), hard(parameters(), {});
  easy.accept(4);
  hard.accept(28);
  EXPECT_GT(easy.step_size(), .1);
  EXPECT_LT(hard.step_size(), .1);
}



TEST(LoadStepping, StaysBelowTheLargestStepOfItsFormula)
{
  LoadSteppingParameters p = parameters();
  p.largest_step           = "if(t < 0.5, a, 1)";
  LoadStepping steps(p, {{"a", .02}});
  while (steps.time() < .5)
    {
      EXPECT_LE(steps.step_size(), .02 * (1. + 1e-12));
      steps.accept(1);
    }
  EXPECT_GT(steps.step_size(), .02);
}



TEST(LoadStepping, ClosesInOnAPlaceThatCannotBePassed)
{
  constexpr double fold = .3337;
  LoadStepping     steps(parameters(), {});
  unsigned int     n_attempts = 0;
  for (bool can_go_on = true; can_go_on; ++n_attempts)
    if (steps.next_time() < fold)
      steps.accept(5);
    else
      can_go_on = steps.reject();
  EXPECT_LT(steps.time(), fold);
  EXPECT_GT(steps.time() + 1.1e-3, fold);
  EXPECT_LT(n_attempts, 30u);

  const double time = steps.next_time();
  steps.restart();
  EXPECT_EQ(steps.time(), time);
  EXPECT_DOUBLE_EQ(steps.step_size(), .1);
}



TEST(LoadStepping, LocatesNothingFinerThanTheInstabilityResolution)
{
  // As in the peeling scenes, whose first steps are shorter.
  LoadSteppingParameters p = parameters();
  p.first_step             = 1e-5;
  p.instability_resolution = 1e-4;
  LoadStepping steps(p, {});
  EXPECT_FALSE(steps.reject());
}



TEST(LoadStepping, GivesUpWhereTheResolutionIsRoundOffOfTheTime)
{
  LoadSteppingParameters p = parameters();
  p.first_step             = .3;
  p.smallest_step          = 1e-16;
  p.instability_resolution = 1e-15;
  LoadStepping steps(p, {});
  steps.accept(5);
  unsigned int n_attempts = 0;
  while (n_attempts < 100 && steps.reject())
    ++n_attempts;
  EXPECT_LT(n_attempts, 100u);
}



TEST(LoadStepping, DoesNotCreepBelowTheSmallestStep)
{
  LoadSteppingParameters p = parameters();
  p.smallest_step          = 1e-3;
  LoadStepping steps(p, {});
  for (unsigned int i = 0; i < 50; ++i)
    {
      EXPECT_GE(steps.step_size(), 1e-3 * (1. - 1e-10));
      steps.accept(1000);
    }
}



TEST(LoadStepping, ChecksTheLargestStepWheneverItIsUsed)
{
  for (const char *formula : {"if(t < 0.5, 0.1, 0)",
                              "if(t < 0.5, 0.1, -0.1)",
                              "if(t < 0.5, 0.1, 1e-9)",
                              "if(t < 0.5, 0.1, log(0))"})
    {
      LoadSteppingParameters p = parameters();
      p.largest_step           = formula;
      LoadStepping steps(p, {});
      try
        {
          for (unsigned int i = 0; i < 1000 && !steps.is_finished(); ++i)
            steps.accept(5);
          FAIL() << formula << " is accepted at time " << steps.time();
        }
      catch (const ExcParameter &exception)
        {
          EXPECT_GE(steps.time(), .5) << formula;
          EXPECT_NE(std::string(exception.what()).find("largest step"),
                    std::string::npos);
        }
    }
}
