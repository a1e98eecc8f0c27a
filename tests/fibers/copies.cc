// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <gtest/gtest.h>

#include <setae/base/exceptions.h>
#include <setae/fiber_problem.h>

#include <cmath>
#include <sstream>

using namespace Setae;

namespace
{
  // Cantilevers side by side whose bending stiffness grows as (1 + i)^4 and
  // whose cells as 4 + i, each with its own load; the last one is clamped at
  // both ends.
  const std::string rods = R"(
set coordinates = x, y
set constants   = R = 0.01, n = 4
subsection fibers
  set names = rod
  subsection rod
    set centerline     = s; i; 0
    set copies         = n - 1
    set length         = 50*2*R
    set radius         = R*(1 + i)
    set youngs modulus = 4/(pi*R^4)
    set cells          = n + i
  end
end
subsection supports
  set names = clamps, ends
  subsection clamps
    set at           = 0
    set displacement = 0; 0; free
    set tangent      = 0; 0; free
  end
  subsection ends
    set copies       = i == 2
    set at           = 50*2*R
    set displacement = 0; 0; free
  end
end
subsection loads
  set names = tip, middle
  subsection tip
    set copies = i < 2
    set force  = 0; 1e-6*(1 + i)*t; 0
  end
  subsection middle
    set copies = i == 1
    set at     = 0.5
    set force  = 0; -1e-30; 0
  end
end
subsection load stepping
  set first step = 0.5*2
end
subsection newton
  set residual tolerance  = 1e-12
  set increment tolerance = 1e-12
end
)";

  std::string
  refusal(const std::string &override_text)
  {
    try
      {
        std::ostringstream screen;
        FiberProblem(Scene::read(rods, "rods.prm", {override_text}),
                     MPI_COMM_SELF,
                     screen);
      }
    catch (const ExcParameter &exception)
      {
        return reason(exception);
      }
    return "";
  }
} // namespace



TEST(Copies, HaveNumbersOfTheirOwn)
{
  const Scene       scene = Scene::read(rods, "rods.prm");
  const FiberSystem fibers(scene, MPI_COMM_SELF);
  ASSERT_EQ(fibers.fibers.size(), 3u);
  for (unsigned int i = 0; i < 3; ++i)
    {
      EXPECT_DOUBLE_EQ(fibers.parameters[i].radius, .01 * (1 + i));
      EXPECT_EQ(fibers.fibers[i].n_cells, 4 + i);
      EXPECT_DOUBLE_EQ(fibers.fibers[i].arc_length.back(), 1.);
      EXPECT_DOUBLE_EQ(
        fibers.parameters_of_cell(fibers.fibers[i].first_cell).radius,
        .01 * (1 + i));
    }
}



TEST(Copies, KeepTheirBeamIfTheirNumbersDiffer)
{
  const Scene scene = Scene::read(rods, "rods.prm", {"fibers/rod/beam=rigid"});
  const FiberSystem fibers(scene, MPI_COMM_SELF);
  for (const Fiber &fiber : fibers.fibers)
    EXPECT_TRUE(fibers.is_rigid(fiber.first_cell)) << fiber.name;
}



TEST(Copies, BendAsTheirOwnNumbersSay)
{
  std::ostringstream screen;
  FiberProblem problem(Scene::read(rods, "rods.prm"), MPI_COMM_SELF, screen);
  problem.run([](const StepRecord &) {});
  const State state = problem.state();
  // F l^3 / (3 E I) with E I = (1 + i)^4 and F = 1e-6 (1 + i).
  for (unsigned int i = 0; i < 2; ++i)
    {
      const unsigned int last = i == 0 ? 3 : 8;
      EXPECT_NEAR(state.displacement[last].position(1.)[1] * 3e6 *
                    std::pow(1. + i, 3),
                  1.,
                  1e-6);
    }
  EXPECT_EQ(state.displacement[14].position(1.)[1], 0.);
}



TEST(Copies, WithANumberThatIsNotAllowedAreRefused)
{
  EXPECT_NE(refusal("fibers/rod/radius=R*(1 - i)").find("'fibers/rod/radius'"),
            std::string::npos);
  EXPECT_NE(refusal("fibers/rod/radius=R*(2 - i)")
              .find("'0', but must be "
                    "positive"),
            std::string::npos);
  EXPECT_NE(refusal("fibers/rod/cells=4 + i/2").find("i = 1, j = 0, k = 0"),
            std::string::npos);
  EXPECT_NE(refusal("fibers/rod/copies=2 + i").find("'2 + i'"),
            std::string::npos);
  EXPECT_NE(refusal("supports/ends/copies=i == 3").find("at least one"),
            std::string::npos);
  EXPECT_NE(refusal("loads/tip/copies=i = 0").find("'==' compares"),
            std::string::npos);
}



TEST(Scene, KeepsItsFormulasInWhatRepeatsTheRun)
{
  const Scene scene = Scene::read(rods, "rods.prm");
  EXPECT_NE(scene.used_parameters.find("R*(1 + i)"), std::string::npos);
  const Scene again = Scene::read(scene.used_parameters, "again.prm");
  EXPECT_EQ(again.fibers[0].copies, std::vector<unsigned int>{3});
  EXPECT_EQ(again.fibers[0].radius, scene.fibers[0].radius);
}



TEST(Scene, MayBeginWithAUtf8Mark)
{
  const Scene scene = Scene::read("\xEF\xBB\xBF" + rods.substr(1), "rods.prm");
  EXPECT_EQ(scene.coordinates, "x, y");
}
