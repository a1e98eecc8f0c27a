// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

// The assembled interaction of whole fibers: its residual and its tangent
// matrix are the differences of its energy and its residual, whatever the roles
// of the fibers, their radii and the law.

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "assembled.h"

using namespace Setae;

namespace
{
  /** Two fibers that cross in space, thick and thin, @p gap apart. */
  std::string
  crossing_fibers(const std::string &interaction)
  {
    return R"(
set constants = gap = 0.02
subsection fibers
  set names = thick, thin
  subsection thick
    set centerline = s - 0.5; 0; 0
    set radius     = 0.06
    set cells      = 2
    set number density = 2
  end
  subsection thin
    set centerline = 0.8*(s - 0.45); 0.6*(s - 0.4); 0.08 + gap
    set radius     = 0.02
    set cells      = 3
  end
end
subsection interactions
  set names = law
  subsection law
    set cutoff               = 0.4
    set switch width         = 0.5
    set integration segments = 1
    set integration tolerance = 0
    set prefactors           = -1e-2, 1e-13
)" + interaction +
           R"(
  end
end)";
  }

  /** A fiber bent to most of a circle, of which the ends interact. */
  std::string
  open_ring(const std::string &interaction)
  {
    return R"(
set coordinates = x, y
subsection fibers
  set names = ring
  subsection ring
    set centerline = cos(6*s); sin(6*s); 0
    set radius     = 0.05
    set cells      = 6
  end
end
subsection interactions
  set names = law
  subsection law
    set self interaction     = true
    set cutoff               = 0.8
    set switch width         = 0.9
    set integration segments = 2
    set integration tolerance = 0
    set prefactors           = -1, 1e-9
)" + interaction +
           R"(
  end
end)";
  }



  /** The same in some random states of the scene @p text. */
  void
  expect_differences_of(const std::string &text)
  {
    for (unsigned int seed = 0; seed < 5; ++seed)
      {
        Assembled problem(text);
        problem.perturb(seed);
        expect_differences(problem);
      }
  }

  double
  energy_of(const std::string &text)
  {
    Assembled problem(text);
    problem.perturb(1);
    return problem.assemble(Request::energy);
  }

  /** Without displacements. */
  double
  energy_of_rest(const std::string &text)
  {
    return Assembled(text).assemble(Request::energy);
  }

  /**
   * The end of one fiber an overhang beyond the axis of a long one that it
   * crosses, in units of the radius 0.02 of both, at the gap 0.1.
   */
  std::string
  end_across(const double overhang, const std::string &interaction)
  {
    const std::string end = std::to_string(.02 * overhang);
    return R"(
subsection fibers
  set names = long, ends
  subsection long
    set centerline = s - 0.5; 0; 0
    set radius     = 0.02
    set cells      = 10
  end
  subsection ends
    set centerline = 0; s - 1 + )" +
           end + R"(; 0.042
    set radius     = 0.02
    set cells      = 10
  end
end
subsection interactions
  set names = law
  subsection law
    set law                  = tabulated-disk-cylinder
    set cutoff               = 0.3
    set switch width         = 0.5
    set integration segments = 20
    set integration tolerance = 0
    set exponents            = 6
    set prefactors           = -1e-2
)" + interaction +
           R"(
  end
end)";
  }

  const std::string thick_on_thin = "set source = thick \n set target = thin";
  const std::string thin_on_thick = "set source = thin \n set target = thick";
} // namespace



TEST(Interaction, OfSectionsHasTheDerivativesOfItsEnergy)
{
  expect_differences_of(crossing_fibers("set law = disk-disk"));
}

TEST(Interaction, OfSectionAndBeamHasTheDerivativesOfItsEnergy)
{
  expect_differences_of(crossing_fibers(thick_on_thin));
  expect_differences_of(crossing_fibers(thin_on_thick));
}

TEST(Interaction, WithTargetsThatEndHasTheDerivativesOfItsEnergy)
{
  const std::string finite =
    "set law = oriented-disk-cylinder \n set target ends = finite \n";
  expect_differences_of(crossing_fibers(finite + thick_on_thin));
  expect_differences_of(crossing_fibers(finite + "set two half passes = true"));
  expect_differences_of(open_ring(finite));
}

// The end of a source is where an integral ends, that of a target is made of
// two passes. Inside and outside of the zone where these share the target, both
// give the same but for what is not known of how a section sees a target that
// fades.
TEST(Interaction, DoesNotDependOnWhichFiberEnds)
{
  for (const double overhang : {-2., -.5, 0., .5, 1., 2., 3., 5., 8., 12.})
    {
      const double source = energy_of_rest(
        end_across(overhang, "set source = ends \n set target = long"));
      const double target = energy_of_rest(
        end_across(overhang, "set source = long \n set target = ends"));
      EXPECT_NEAR(target / source, 1., overhang < -1. ? 7e-3 : 2e-3)
        << "overhang " << overhang;
    }
}

TEST(Interaction, InTwoHalfPassesHasTheDerivativesOfItsEnergy)
{
  expect_differences_of(crossing_fibers("set two half passes = true"));
}

TEST(Interaction, OfAFiberWithItselfHasTheDerivativesOfItsEnergy)
{
  expect_differences_of(open_ring("set law = disk-cylinder"));
  expect_differences_of(open_ring("set law = disk-disk"));
}

// Segments change with the distance, and with them energy and forces by less
// than the tolerance.
TEST(Interaction, OnGradedSegmentsHasTheDerivativesOfItsEnergy)
{
  const std::string graded = "set integration tolerance = 1e-13 \n";
  expect_differences_of(crossing_fibers(graded + "set law = disk-disk"));
  expect_differences_of(crossing_fibers(graded + thick_on_thin));
  expect_differences_of(open_ring(graded + "set law = disk-disk"));
}

namespace
{
  /** Error of the energy on graded segments over the tolerance. */
  double
  error_over_tolerance(const std::string &law, const std::string &tolerance)
  {
    const double many = energy_of(
                   crossing_fibers(law + "set integration segments = 200")),
                 graded = energy_of(crossing_fibers(
                   law + "set integration tolerance = " + tolerance));
    return std::abs(graded / many - 1.) / std::stod(tolerance);
  }
} // namespace

// Beyond 1e-4, what limits a law of the closest point is the end of the target,
// beyond which that does not move: the integrand is not analytic there.
TEST(Interaction, OnGradedSegmentsIsThatOnManyEqualOnes)
{
  for (const std::string tolerance : {"1e-2", "1e-4"})
    EXPECT_LT(error_over_tolerance("set law = disk-cylinder \n", tolerance),
              1.);
  for (const std::string tolerance : {"1e-2", "1e-4", "1e-6"})
    EXPECT_LT(error_over_tolerance("set law = disk-disk \n", tolerance), 1.);
}

TEST(Interaction, InTwoHalfPassesIsTheMeanOfBothSides)
{
  const double thick = energy_of(crossing_fibers(thick_on_thin)),
               thin  = energy_of(crossing_fibers(thin_on_thick));
  const double both  = energy_of(crossing_fibers("set two half passes = true"));
  EXPECT_GT(std::abs(thick - thin), 1e-3 * std::abs(both));
  EXPECT_NEAR(both, .5 * (thick + thin), 1e-12 * std::abs(both));
}

// The integral over both sections of a pair of points does not ask which one
// comes first.
TEST(Interaction, OfSectionsIsTheSameFromBothSides)
{
  const std::string law   = "set law = disk-disk \n";
  const double      thick = energy_of(crossing_fibers(law + thick_on_thin)),
               thin       = energy_of(crossing_fibers(law + thin_on_thick));
  EXPECT_NE(thick, 0.);
  EXPECT_NEAR(thick, thin, 1e-12 * std::abs(thick));
}
