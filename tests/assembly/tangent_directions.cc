// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <gtest/gtest.h>

#include <setae/fiber_problem.h>

#include <cmath>
#include <sstream>

using namespace Setae;

namespace
{
  constexpr double EA = 1e4 * M_PI * .05 * .05;

  /** The unit vectors of a fiber: along it, and across in the plane x, y. */
  struct Axes
  {
    Tensor<1, 3> along, across;
  };

  const Axes along_x = {Tensor<1, 3>({1., 0., 0.}), Tensor<1, 3>({0., 1., 0.})};
  const Axes slanted = {Tensor<1, 3>({.6, -.8, 0.}),
                        Tensor<1, 3>({.8, .6, 0.})};
  const Axes in_space = {Tensor<1, 3>({.48, .6, .64}),
                         Tensor<1, 3>({-.64, .8, -.27})};

  std::string
  formulas(const Tensor<1, 3> &vector, const std::string &factor)
  {
    std::ostringstream text;
    text.precision(17);
    for (unsigned int c = 0; c < 3; ++c)
      text << (c == 0 ? "" : "; ") << vector[c] << "*(" << factor << ")";
    return text.str();
  }

  /** A rod of length 1, clamped at its start but free to stretch there. */
  std::string
  rod(const Tensor<1, 3> &along)
  {
    return R"(
subsection fibers
  set names = rod
  subsection rod
    set centerline     = )" +
           formulas(along, "s") + R"(
    set radius         = 0.05
    set youngs modulus = 1e4
    set density        = 1
    set cells          = 4
  end
end
subsection supports
  set names = clamp
  subsection clamp
    set displacement      = 0; 0; 0
    set tangent direction = initial
  end
end
subsection newton
  set residual tolerance  = 1e-9
  set increment tolerance = 1e-10
end
subsection load stepping
  set first step = 1
end
)";
  }

  std::string
  load(const Tensor<1, 3> &force, const std::string &factor)
  {
    return R"(
subsection loads
  set names = end
  subsection end
    set force = )" +
           formulas(force, factor) + "\n  end\nend\n";
  }

  StepRecord
  last_step(const std::string &text)
  {
    std::ostringstream screen;
    FiberProblem problem(Scene::read(text, "test.prm"), MPI_COMM_SELF, screen);
    StepRecord   last;
    problem.run([&last](const StepRecord &record) { last = record; });
    return last;
  }

  /** The displacement of the end and its energies, seen from the fiber. */
  std::array<double, 4>
  bent(const Axes &axes, const std::string &factor, const std::string &dynamics)
  {
    const StepRecord step =
      last_step(rod(axes.along) +
                load(1. * axes.along + .3 * axes.across, factor) + dynamics);
    const Tensor<1, 3> u = step.loads[0].displacement;
    return {{u * axes.along,
             u * axes.across,
             step.evaluation.energies[0],
             step.motion ? step.motion->momenta.kinetic_energy : 0.}};
  }
} // namespace



TEST(TangentDirections, LetASlantedClampedFiberStretchByForceOverStiffness)
{
  constexpr double force = 2.;
  for (const Axes &axes : {along_x, slanted, in_space})
    {
      // The unit vectors have few digits: in space, 1 is 1 to 1e-3.
      const Tensor<1, 3> along = axes.along / axes.along.norm();
      const StepRecord step = last_step(rod(along) + load(force * along, "t"));
      const Tensor<1, 3> stretch = force / EA * along;
      EXPECT_LT((step.loads[0].displacement - stretch).norm(),
                1e-9 * stretch.norm());
      EXPECT_NEAR(step.evaluation.energies[0] / (.5 * force * force / EA),
                  1.,
                  1e-9);
      EXPECT_LT((step.supports[0].reaction + force * along).norm(),
                1e-8 * force);
    }
}



TEST(TangentDirections, DoNotDependOnTheAxesInStaticsAndInAnyMotion)
{
  const auto motion = [](const std::string &integrator,
                         const std::string &more) {
    return "\nsubsection dynamics\n  set integrator = " + integrator +
           "\n  set time step = 1e-3\n  set end time = 2e-2\n" + more + "end\n";
  };
  struct Case
  {
    std::string factor, dynamics;
    double      tolerance;
  };
  for (const Case &c :
       {Case{"t", "", 1e-9},
        Case{"0.05", motion("generalized-alpha", "set damping = 0.5\n"), 1e-8},
        Case{"0.05", motion("energy-conserving", "set damping = 0.5\n"), 1e-8},
        Case{"0.05", motion("IDA", "set tolerance = 1e-6\n"), 1e-3}})
    {
      const auto a = bent(along_x, c.factor, c.dynamics);
      const auto b = bent(slanted, c.factor, c.dynamics);
      EXPECT_GT(std::abs(a[1]), 1e-4) << c.dynamics;
      for (unsigned int i = 0; i < a.size(); ++i)
        EXPECT_LE(std::abs(a[i] - b[i]), c.tolerance * std::abs(a[i]))
          << i << " of " << c.dynamics;
    }
}



TEST(TangentDirections, ThatTurnAllTheWayRoundTurnAFreeRodRigidly)
{
  // Each component leads for a part of the turn.
  for (const double end : {.3, .55, .8})
    {
      std::ostringstream more;
      more << R"(
subsection supports
  set names = clamp
  subsection clamp
    set tangent direction = 5*cos(2*pi*t); 4*sin(2*pi*t); 3*sin(2*pi*t)
  end
end
subsection loads
  set names = end
end
subsection load stepping
  set first step   = 0.05
  set largest step = 0.05
  set end time     = )"
           << end << "\nend\n";
      const StepRecord   step = last_step(rod(along_x.along) + more.str());
      const double       phi  = 2. * M_PI * end;
      const Tensor<1, 3> direction(
        {std::cos(phi), .8 * std::sin(phi), .6 * std::sin(phi)});
      EXPECT_LT(
        (step.loads[0].displacement - (direction - along_x.along)).norm(),
        1e-9);
      EXPECT_LT(std::abs(step.evaluation.energies[0]), 1e-12);
    }
}



TEST(TangentDirections, AreNotMetByATangentThatPointsAgainstThem)
{
  // A rod cannot follow half a turn within one step: such steps are repeated.
  const StepRecord step = last_step(rod(along_x.along) + R"(
subsection supports
  set names = clamp
  subsection clamp
    set tangent direction = cos(pi*t); sin(pi*t); 0
  end
end
subsection loads
  set names = end
end)");
  EXPECT_LT((step.loads[0].displacement + 2. * along_x.along).norm(), 1e-9);
}
