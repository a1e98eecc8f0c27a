// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <gtest/gtest.h>

#include <setae/assembly/interaction.h>
#include <setae/laws/all.h>
#include <setae/verification/cylinders.h>

#include <algorithm>
#include <cmath>

using namespace Setae;

namespace
{
  constexpr unsigned int n_points = 4000;

  /**
   * The force per length of two parallel fibers by a law: its derivative,
   * summed along one of them with the midpoint rule in u, offset = w sinh u,
   * where it is a law of two sections.
   */
  template <typename Law>
  double
  force_of_parallel_fibers(const Law   &law,
                           const double sum_of_radii,
                           const double gap)
  {
    if constexpr (Law::depends_on == Invariants::gap_angle)
      return -law(gap, 1.).g;
    else if constexpr (Law::depends_on == Invariants::gap_angle_tilt)
      return -law(gap, 1., 0.).g;
    else
      {
        constexpr double largest = 25.;
        const double     d       = gap + sum_of_radii;
        const double     w =
          Law::depends_on == Invariants::gap_offset ? gap : std::sqrt(gap * d);
        double sum = 0.;
        for (unsigned int i = 0; i < n_points; ++i)
          {
            const double u      = largest * (2. * (i + .5) / n_points - 1.);
            const double x      = w * std::sinh(u);
            const double weight = w * std::cosh(u) * 2. * largest / n_points;
            if constexpr (Law::depends_on == Invariants::gap_offset)
              sum -= weight * law(x, gap).g;
            else
              {
                const double r = std::hypot(d, x);
                sum -= weight * law(gap + x * x / (r + d)).first * d / r;
              }
          }
        return sum;
      }
  }

  /** The smallest value of a function with one minimum. */
  template <typename Function>
  double
  minimum(const Function &f, double a, double b)
  {
    while (b - a > 1e-9 * b)
      {
        const double c = a + (b - a) / 3., d = b - (b - a) / 3.;
        (f(c) < f(d) ? b : a) = f(c) < f(d) ? d : c;
      }
    return f(.5 * (a + b));
  }

  InteractionParameters
  stated_gap(const std::string &law, const double gap, const double force)
  {
    InteractionParameters result;
    result.law             = law;
    result.equilibrium_gap = gap;
    result.force_minimum   = force;
    return result;
  }

  template <typename... Laws, typename Visitor>
  void
  for_each_short_range_law(TypeList<Laws...>, const Visitor &visit)
  {
    (
      [&] {
        if constexpr (!Laws::is_long_range)
          visit(static_cast<Laws *>(nullptr));
      }(),
      ...);
  }
} // namespace



// The scene stated_gap, and far smaller and larger gaps in other units.
TEST(PointPotential, OfAStatedGapHasNoForceThereByTheLawOfTheScene)
{
  struct Case
  {
    double radius, gap, force, density;
  };
  for (const Case &c : {Case{3.5, .5, -1.15, 1.},
                        Case{.02, 2e-5, -.1, 1.},
                        Case{1e-8, 3e-8, -2e-4, 1e28}})
    for_each_short_range_law(PotentialLaws(), [&](auto *tag) {
      using Law                  = std::remove_pointer_t<decltype(tag)>;
      const SectionPair sections = {c.radius, c.radius, c.density, c.density};
      const InteractionParameters parameters =
        stated_gap(Law::name, c.gap, c.force);
      const Law  law   = make_law<Law>(point_potential(parameters, sections),
                                    sections,
                                    GapRange());
      const auto force = [&](const double gap) {
        return force_of_parallel_fibers(law, 2. * c.radius, gap);
      };
      EXPECT_LT(std::abs(force(c.gap) / c.force), 1e-6)
        << Law::name << " at " << c.gap;
      EXPECT_NEAR(minimum(force, c.gap, 2. * c.gap) / c.force, 1., 1e-6)
        << Law::name << " at " << c.gap;
    });
}



TEST(PointPotential, OfAHamakerConstantGivesTheKnownEnergyOfCylinders)
{
  // -A / 24 sqrt(2 R1 R2 / (R1 + R2)) g^(-3/2) as the gap closes.
  constexpr double  A = 3e-3, gap = 1e-8;
  const SectionPair sections = {.5, 2., 7., 11.};
  const double      expected =
    -A / 24. * std::sqrt(2. * .5 * 2. / 2.5) * std::pow(gap, -1.5);

  InteractionParameters parameters;
  parameters.law                 = DiskCylinder::name;
  parameters.exponents           = {6};
  parameters.hamaker_constant    = A;
  const PointPotential potential = point_potential(parameters, sections);
  ASSERT_EQ(potential.size(), 1u);
  EXPECT_NEAR(DiskCylinder(potential, sections, {})(gap, 1.).value / expected,
              1.,
              1e-12);
  EXPECT_NEAR(
    References::parallel_cylinders(potential[0], sections, gap).energy.value /
      expected,
    1.,
    1e-6);
}



TEST(PointPotential, OfAHamakerConstantAndAGapAttractsAsThatAndRestsAtIt)
{
  constexpr double  A = 3e-3, gap = .07;
  const SectionPair sections = {.5, .5, 7., 7.};
  for_each_short_range_law(PotentialLaws(), [&](auto *tag) {
    using Law                        = std::remove_pointer_t<decltype(tag)>;
    InteractionParameters parameters = stated_gap(Law::name, gap, 0.);
    parameters.hamaker_constant      = A;
    const PointPotential potential   = point_potential(parameters, sections);
    ASSERT_EQ(potential.size(), 2u);
    EXPECT_NEAR(-potential[0].prefactor * M_PI * M_PI * 49. / A, 1., 1e-14);
    const auto force = [&](const PointPotential &of) {
      return force_of_parallel_fibers(make_law<Law>(of, sections, GapRange()),
                                      1.,
                                      gap);
    };
    EXPECT_LT(std::abs(force(potential) / force({potential[0]})), 1e-6)
      << Law::name;
  });
}
