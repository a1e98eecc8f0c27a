// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <gtest/gtest.h>

#include <setae/output/progress.h>

#include <cmath>
#include <limits>
#include <sstream>

namespace
{
  using namespace Setae;

  /** The lines of a run from time 0 to 1 with a step a second. */
  class Screen
  {
  public:
    explicit Screen(const double silence = 1e9)
      : progress(dealii::ConditionalOStream(text, true),
                 scene,
                 {"strain"},
                 silence)
    {}

    /** The line of a step. */
    std::string
    step(const double time)
    {
      StepRecord record;
      record.step                = ++n_steps;
      record.time                = time;
      record.wall_time           = n_steps;
      record.evaluation.energies = {1.};
      text.str("");
      progress.print_step(record);
      return text.str();
    }

    Scene              scene;
    std::ostringstream text;
    Progress           progress;
    unsigned int       n_steps = 0;
  };

  bool
  has_expected_time(const std::string &line)
  {
    return line.find("of about") != std::string::npos;
  }
} // namespace



TEST(Progress, EqualStepsTellTheTimeOfTheRunFromTheEleventhOn)
{
  Screen      screen;
  std::string line;
  for (unsigned int i = 1; i <= 10; ++i)
    EXPECT_FALSE(has_expected_time(screen.step(i / 40.))) << i;
  for (unsigned int i = 11; i < 40; ++i)
    EXPECT_NE(screen.step(i / 40.).find("of about 40.0 s"), std::string::npos)
      << i;
  EXPECT_FALSE(has_expected_time(screen.step(1.)));
}



TEST(Progress, StepsThatGrowOrShrinkTellNoTime)
{
  Screen growing, shrinking;
  for (int i = 0; i < 40; ++i)
    {
      EXPECT_FALSE(has_expected_time(growing.step(std::pow(1.5, i - 40.))));
      EXPECT_FALSE(
        has_expected_time(shrinking.step(1. - std::pow(1.5, -i - 1.))))
        << i;
    }
}



TEST(Progress, ALongSearchIsSeenToGoOn)
{
  Screen                loud(0.), quiet;
  const IterationReport report{57, 1e-3, 1e-2, 1., .5};
  loud.progress.print_relaxation(report);
  EXPECT_NE(loud.text.str().find("overdamped motion, iteration  57"),
            std::string::npos)
    << loud.text.str();
  quiet.progress.print_relaxation(report);
  EXPECT_TRUE(quiet.text.str().empty());
}



TEST(Progress, TheSummaryTellsOnlyWhatWasSeen)
{
  Screen screen;
  screen.scene.interactions.resize(1);
  screen.scene.interactions[0].name           = "adhesion";
  screen.scene.interactions[0].regularization = .1;

  const auto summary_of = [&screen](const double gap) {
    RunSummary summary;
    summary.smallest_gap       = gap;
    summary.smallest_gap_place = "between 'a' (at s = 1) and 'b' in step 3";
    screen.text.str("");
    screen.progress.print_summary(summary);
    return screen.text.str();
  };
  const auto contains = [](const std::string &text, const std::string &part) {
    return text.find(part) != std::string::npos;
  };
  const std::string far   = summary_of(std::numeric_limits<double>::infinity()),
                    above = summary_of(.2), below = summary_of(.05);
  EXPECT_TRUE(contains(far, "No fibers have come near enough")) << far;
  EXPECT_FALSE(contains(far, "does not depend")) << far;
  EXPECT_TRUE(contains(above, "0.2 between 'a' (at s = 1) and 'b' in step 3"))
    << above;
  EXPECT_TRUE(contains(above, "does not depend")) << above;
  EXPECT_TRUE(contains(below,
                       "'adhesion' is regularized below 0.1: there are "
                       "smaller gaps"))
    << below;
}
