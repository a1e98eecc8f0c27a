// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <setae/fiber_problem.h>

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

using namespace Setae;

namespace
{
  // A beam of length 1 with EI = 1 along x, supported simply at both ends.
  const std::string beam = R"(
set coordinates = x, y
subsection fibers
  set names = beam
  subsection beam
    set centerline     = s; 0; 0
    set radius         = 0.01
    set youngs modulus = 1.2732395447351628e8
    set cells          = 8
  end
end
subsection supports
  set names = start, end
  subsection start
    set at           = start
    set displacement = 0; 0; free
  end
  subsection end
    set at           = end
    set displacement = free; 0; free
  end
end
subsection load stepping
  set first step = 1
end
subsection newton
  set residual tolerance  = 1e-10
  set increment tolerance = 1e-12
end
)";

  StepRecord
  last_step(const std::string &text)
  {
    std::ostringstream screen;
    FiberProblem       problem(Scene::read(text, "test.prm"),
                         MPI_COMM_SELF,
                         screen);
    StepRecord         last;
    problem.run([&last](const StepRecord &record) { last = record; });
    return last;
  }
} // namespace



TEST(Loads, AtAPointBendABeamAsInLinearTheory)
{
  const StepRecord step = last_step(beam + R"(
subsection loads
  set names = point
  subsection point
    set at    = 0.5
    set force = 0; -1e-3*t; 0
  end
end)");
  EXPECT_NEAR(step.loads[0].displacement[1] / (-1e-3 / 48.), 1., 1e-6);
  EXPECT_NEAR(step.supports[0].reaction[1] / .5e-3, 1., 1e-9);
}



TEST(Loads, BetweenTwoNodesActWhereTheyAre)
{
  const StepRecord step = last_step(beam + R"(
subsection loads
  set names = point
  subsection point
    set at    = 0.3
    set force = 0; -1e-3*t; 0
  end
end)");
  EXPECT_NEAR(step.supports[0].reaction[1] / .7e-3, 1., 1e-6);
  EXPECT_NEAR(step.supports[1].reaction[1] / .3e-3, 1., 1e-6);
}



TEST(Loads, AlongALineBendABeamAsInLinearTheory)
{
  // The point load has no weight: it reports the displacement at midspan.
  const StepRecord step = last_step(beam + R"(
subsection loads
  set names = line, midspan
  subsection line
    set at    = all
    set force = 0; -1e-3*t; 0
  end
  subsection midspan
    set at = 0.5
  end
end)");
  EXPECT_NEAR(step.loads[0].displacement[1] / (-5e-3 / 384.), 1., 1e-6);
}



TEST(Loads, OfAMomentAtTheEndTurnABeamAsInLinearTheory)
{
  // A moment M at one end: both reactions are M / l, the midspan moves by
  // M l^2 / (16 EI).
  const StepRecord step = last_step(beam + R"(
subsection loads
  set names = midspan, moment
  subsection midspan
    set at = 0.5
  end
  subsection moment
    set at     = end
    set moment = 0; 0; 1e-3*t
  end
end)");
  EXPECT_NEAR(step.supports[0].reaction[1] / 1e-3, 1., 1e-5);
  EXPECT_NEAR(step.loads[0].displacement[1] / (-1e-3 / 16.), 1., 1e-5);
}



TEST(Supports, AtAnArcLengthHoldTheNodeThere)
{
  const StepRecord step = last_step(beam + R"(
subsection supports
  set names = start, end, middle
  subsection middle
    set at           = 0.5
    set displacement = free; 1e-3*t; free
  end
end)");
  EXPECT_NEAR(step.supports[2].reaction[1] / (48. * 1e-3), 1., 1e-4);
  EXPECT_EQ(step.supports[2].displacement[1], 1e-3);
}



TEST(Supports, ThatTurnARodRigidlyDoNotStrainIt)
{
  const StepRecord step = last_step(R"(
subsection fibers
  set names = rod
  subsection rod
    set radius = 0.01
    set youngs modulus = 1.2732395447351628e8
    set cells  = 8
  end
end
subsection supports
  set names = clamp
  subsection clamp
    set at           = start
    set displacement = 2*t; -t; 3*t
    set tangent      = cos(2*t) - 1; sin(2*t); 0
  end
end
subsection load stepping
  set first step   = 0.1
  set largest step = 0.1
end
subsection newton
  set residual tolerance  = 1e-8
  set increment tolerance = 1e-10
end)");
  EXPECT_LT(std::abs(step.evaluation.energies[0]), 1e-16);
  EXPECT_LT(step.supports[0].reaction.norm(), 1e-7);
}



TEST(Interactions, InTwoHalfPassesHaveTheEnergyOfOne)
{
  const auto energy = [](const std::string &passes, const std::string &law) {
    return last_step(R"(
set coordinates = x, y
subsection fibers
  set names = pair
  subsection pair
    set centerline     = 0.041*i; s; 0
    set copies         = 2
    set radius         = 0.02
    set youngs modulus = 1e5
    set cells          = 16
  end
end
subsection supports
  set names = rigid
  subsection rigid
    set at           = all
    set displacement = 0; 0; 0
    set tangent      = 0; 0; 0
  end
end
subsection interactions
  set names = adhesion
  subsection adhesion
    set prefactors         = -1e-7, 5e-25
    set cutoff             = 0.1
    set integration tolerance = 0
    set two half passes    = )" +
                     passes + "\n    set law = " + law + "\n  end\nend")
      .evaluation.energies[1];
  };
  for (const char *law : {"disk-cylinder", "disk-disk"})
    {
      const double once = energy("false", law);
      EXPECT_LT(once, 0.);
      EXPECT_NEAR(energy("true", law) / once, 1., 1e-9);
    }
}
