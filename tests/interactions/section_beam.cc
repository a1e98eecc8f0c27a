// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

// Residual and tangent matrix of one site and a target cell, in which the
// closest point moves, against automatic and numerical derivatives, and the
// balance laws that follow from the invariance of the energy.

#include "section_beam.h"

#include <deal.II/base/quadrature_lib.h>

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

using namespace Setae;
using namespace Setae::SectionBeamTests;

namespace
{
  /** @p source with the given direction of the centerline at @p x. */
  void
  turn(HermiteCell<> &source, const double x, const Tensor<1, 3> &direction)
  {
    const Tensor<1, 3> point  = source.position(x);
    const Tensor<1, 3> change = direction - source.derivative(x) / source.h;
    source.coefficients[1] += change;
    source.coefficients[2] += source.h * change;
    source.coefficients[3] += change;
    move_to(source, x, point);
  }

  /**
   * All derivatives and all balance laws. @p amplification is the factor by
   * which the configuration amplifies rounding errors of the coordinates.
   */
  template <typename Interaction>
  void
  expect_consistent(const Interaction   &interaction,
                    const Configuration &c,
                    const double         amplification = 1.)
  {
    const LocalSystem<24> local     = by_hand(interaction, c);
    const double          tolerance = 1e-13 * amplification;
    ASSERT_NE(local.energy, 0.);
    expect_equal(local, by_sacado(interaction, c), tolerance);
    expect_balance_of_momentum(c.cells, local, tolerance);
    expect_objective(
      [&](const CellPair &cells) {
        return by_hand(interaction, {cells, c.x, c.place});
      },
      c.cells,
      50. * tolerance);
  }
} // namespace



TEST(SectionBeam, HasTheDerivativesOfTheEnergy)
{
  std::mt19937   random(1);
  const Balanced interaction(BalancedLaw(), .1);
  for (unsigned int i = 0; i < 200; ++i)
    expect_consistent(interaction,
                      random_configuration(random, .3, .1 + .004 * i, .4));
}



// The site is almost in the center of curvature of the target: a small motion
// of the site is a large one of the closest point.
TEST(SectionBeam, HasThemOnAStronglyCurvedTarget)
{
  std::mt19937   random(2);
  const Balanced interaction(BalancedLaw(), .1);
  for (unsigned int i = 0; i < 50; ++i)
    {
      expect_consistent(interaction,
                        random_configuration(random, 1., .6, .3, .5, .8),
                        30.);
      expect_consistent(interaction,
                        random_configuration(random, 1., .6, .3, .9, .95),
                        1e4);
      expect_consistent(interaction,
                        random_configuration(random, 1., .6, .3, -5., -.8));
    }
}



TEST(SectionBeam, HasThemForParallelPerpendicularAndTiltedSources)
{
  std::mt19937   random(3);
  const Balanced interaction(BalancedLaw(), .1);
  for (unsigned int i = 0; i < 50; ++i)
    {
      Configuration      c      = random_configuration(random, .3, .4, .4);
      HermiteCell<>     &source = c.cells.source, &target = c.cells.target;
      const Tensor<1, 3> tangent  = target.derivative(.4);
      const Tensor<1, 3> normal   = source.position(c.x) - target.position(.4);
      const Tensor<1, 3> binormal = cross_product_3d(tangent, normal);
      for (const Tensor<1, 3> &direction :
           {tangent, Tensor<1, 3>(-2. * tangent), binormal, normal})
        {
          turn(source, c.x, direction / direction.norm());
          expect_consistent(interaction, c, 3.);
        }
    }
}



TEST(SectionBeam, HasThemAtTheEndOfAFiber)
{
  std::mt19937   random(4);
  const Balanced interaction(BalancedLaw(), .1);
  for (unsigned int i = 0; i < 50; ++i)
    for (const double end : {0., 1.})
      {
        Configuration      c = random_configuration(random, .1, end, .4, -.5);
        const Tensor<1, 3> beyond = (2. * end - 1.) * .3 *
                                    c.cells.target.derivative(end) /
                                    c.cells.target.derivative(end).norm();
        move_to(c.cells.source, c.x, c.cells.source.position(c.x) + beyond);

        EXPECT_EQ(by_hand(interaction, c).energy, 0.);
        c.place.ends = {end == 0., end == 1.};
        expect_consistent(interaction, c);
      }
}



// Two projections on one cell, which add up.
TEST(SectionBeam, HasThemBetweenTheLegsOfAHairpin)
{
  std::mt19937        random(5);
  const Balanced      interaction(BalancedLaw(), .1);
  const Tensor<1, 3>  e({1., 0., 0.}), f({0., 1., 0.});
  const HermiteCell<> hairpin = {{{Tensor<1, 3>(), 6. * e, f, -6. * e}}, 1.};
  for (unsigned int i = 0; i < 20; ++i)
    {
      Configuration c;
      c.cells = {random_cell(random_direction(random), .4, .3, random),
                 hairpin};
      const Tensor<1, 3> point = .5 * e + .5 * f + .05 * random_vector(random);
      move_to(c.cells.source, c.x, point);
      ASSERT_EQ(closest_points(hairpin, point, {}).size(), 2u);
      expect_consistent(interaction, c);
    }
}



TEST(SectionBeam, HasThemWithLennardJonesOverManyGaps)
{
  std::mt19937 random(6);
  for (const SectionPair &sections : {SectionPair{.02, .03, 1., 1.},
                                      SectionPair{1e-4, .1, 2., .5},
                                      SectionPair{.1, 1e-4, 1., 3.}})
    for (const double gap : {1e-9, 1e-6, 1e-4, 1e-3, 1e-2, .1})
      for (unsigned int i = 0; i < 10; ++i)
        {
          // A gap amplifies rounding errors of coordinates by their ratio.
          const LennardJones interaction = lennard_jones({}, sections);
          expect_consistent(interaction,
                            random_configuration(random,
                                                 .3,
                                                 .6,
                                                 sections.radius_1 +
                                                   sections.radius_2 + gap),
                            3. + .03 / gap);
        }
}



TEST(SectionBeam, HasThemWhereTheLawIsRegularizedOrSwitchedOff)
{
  std::mt19937       random(7);
  const LennardJones interaction = lennard_jones({1e-3, .05, .1});
  for (const double gap : {1e-3, 5e-4, 0., -.01, -.04, .051, .075, .099})
    for (unsigned int i = 0; i < 20; ++i)
      expect_consistent(interaction,
                        random_configuration(random, .3, .3, .05 + gap),
                        gap > .09 ? 100. : 20.);
}



TEST(SectionBeam, AgreesWithFiniteDifferences)
{
  std::mt19937   random(8);
  const Balanced balanced(BalancedLaw(), .1);
  for (unsigned int i = 0; i < 10; ++i)
    {
      const auto difference = [&](const auto          &interaction,
                                  const Configuration &c,
                                  const double         step) {
        expect_finite_differences(
          [&](const CellPair &cells) {
            return by_hand(interaction, {cells, c.x, c.place});
          },
          c.cells,
          step,
          1e-8);
      };
      difference(balanced, random_configuration(random, .3, .3, .3), 1e-3);
      difference(balanced,
                 random_configuration(random, 1., .5, .3, .3, .7),
                 1e-4);
      difference(lennard_jones({}),
                 random_configuration(random, .3, .3, .05 + 2e-3),
                 1e-5);
    }
}



TEST(SectionBeam, IsTheSameWithStraightParallelFibersSwapped)
{
  const SectionPair forward = {.02, .05, 2., .5}, backward = {.05, .02, .5, 2.};
  const Tensor<1, 3>  e({1., 0., 0.}), f({0., .071, .003});
  const HermiteCell<> a = {{{Tensor<1, 3>(), e, .3 * e, e}}, .3},
                      b = {{{f, e, .3 * e + f, e}}, .3};

  const auto integral = [](const LennardJones  &interaction,
                           const HermiteCell<> &source,
                           const HermiteCell<> &target) {
    std::vector<LineSite> sites;
    evaluate_sites(dealii::QGauss<1>(7), source, source, sites);
    LocalSystem<24> local;
    for (const LineSite &site : sites)
      interaction.add(site,
                      target,
                      CellPlace{FiberEnds{true, true}},
                      site.weight,
                      Request::residual,
                      local);
    return local;
  };
  const auto ab = integral(lennard_jones({}, forward), a, b);
  const auto ba = integral(lennard_jones({}, backward), b, a);

  EXPECT_NEAR(ab.energy, ba.energy, 1e-12 * std::abs(ab.energy));
  for (unsigned int i = 0; i < 24; ++i)
    EXPECT_NEAR(ab.residual[i],
                ba.residual[(i + 12) % 24],
                1e-11 * largest(ab.residual));
}



TEST(SectionBeam, EvaluatesNoMoreThanIsRequested)
{
  std::mt19937          random(9);
  const Balanced        interaction(BalancedLaw(), .1);
  const Configuration   c    = random_configuration(random, .3, .4, .3);
  const LocalSystem<24> full = by_hand(interaction, c);
  const LineSite        site = site_at(c.cells.source, c.x);

  LocalSystem<24> energy, residual;
  const double    gap =
    interaction.add(site, c.cells.target, {}, weight, Request::energy, energy);
  EXPECT_NEAR(gap, .2, 1e-15);
  EXPECT_EQ(energy.energy, full.energy);
  EXPECT_EQ(largest(energy.residual), 0.);
  EXPECT_EQ(largest(energy.tangent), 0.);

  interaction.add(
    site, c.cells.target, {}, weight, Request::residual, residual);
  EXPECT_EQ(residual.energy, full.energy);
  EXPECT_EQ(residual.residual, full.residual);
  EXPECT_EQ(largest(residual.tangent), 0.);
}



TEST(SectionBeam, AddsToWhatIsThere)
{
  std::mt19937        random(10);
  const Balanced      interaction(BalancedLaw(), .1);
  const Configuration c    = random_configuration(random, .3, .4, .3);
  const LineSite      site = site_at(c.cells.source, c.x);

  LocalSystem<24> once, twice;
  for (LocalSystem<24> *local : {&once, &twice, &twice})
    interaction.add(site, c.cells.target, {}, weight, Request::tangent, *local);
  EXPECT_DOUBLE_EQ(twice.energy, 2. * once.energy);
  for (unsigned int i = 0; i < 24; ++i)
    {
      EXPECT_DOUBLE_EQ(twice.residual[i], 2. * once.residual[i]);
      for (unsigned int j = 0; j < 24; ++j)
        EXPECT_DOUBLE_EQ(twice.tangent[i][j], 2. * once.tangent[i][j]);
    }
}



TEST(SectionBeam, IsZeroBeyondTheCutoff)
{
  std::mt19937       random(11);
  const LennardJones interaction = lennard_jones({0., .05, .1});
  EXPECT_DOUBLE_EQ(interaction.reach(), .15);
  for (const double distance : {.1501, .2, .5})
    {
      const Configuration c = random_configuration(random, .1, .4, distance);
      LocalSystem<24>     local;
      EXPECT_EQ(interaction.add(site_at(c.cells.source, c.x),
                                c.cells.target,
                                c.place,
                                weight,
                                Request::tangent,
                                local),
                infinity);
      expect_zero(local);
    }
}



TEST(SectionBeam, ReportsOverlapThatTheLawDoesNotAdmit)
{
  std::mt19937       random(12);
  const LennardJones interaction = lennard_jones({0., .05, .1});
  for (const double gap : {-1e-9, -.01, -.049})
    {
      const Configuration c = random_configuration(random, .1, .4, .05 + gap);
      LocalSystem<24>     local;
      EXPECT_NEAR(interaction.add(site_at(c.cells.source, c.x),
                                  c.cells.target,
                                  c.place,
                                  weight,
                                  Request::tangent,
                                  local),
                  gap,
                  1e-15);
      expect_zero(local);
    }
}



TEST(SectionBeam, ReportsContactToTheLastDigit)
{
  const LennardJones  interaction = lennard_jones({}, {.25, .25, 1., 1.});
  const Tensor<1, 3>  e({1., 0., 0.}), f({0., .5, 0.});
  const HermiteCell<> source = {{{Tensor<1, 3>(), e, e, e}}, 1.},
                      target = {{{f, e, f + e, e}}, 1.};
  LocalSystem<24> local;
  EXPECT_EQ(interaction.add(
              site_at(source, .5), target, {}, weight, Request::tangent, local),
            0.);
  expect_zero(local);
}



// In the center of curvature of a vertex, here of a parabola, no direction is
// preferred and the closest point counts as fixed; right beside it, it moves by
// a large but finite amount.
TEST(SectionBeam, SurvivesTheCenterOfCurvature)
{
  std::mt19937   random(13);
  const Balanced interaction(BalancedLaw(), .1);
  Configuration  c;
  c.cells.target = {{{Tensor<1, 3>({-1., 0., 0.}),
                      Tensor<1, 3>({1., .5, 0.}),
                      Tensor<1, 3>({1., 0., 0.}),
                      Tensor<1, 3>({1., -.5, 0.})}},
                    2.};
  c.cells.source = random_cell(random_direction(random), .4, .3, random);
  for (const double distance : {0., 1e-6})
    {
      const Tensor<1, 3> point({0., -1.75 + distance, 0.});
      move_to(c.cells.source, c.x, point);
      const Projections found =
        closest_points(c.cells.target, c.cells.source.position(c.x), {});
      ASSERT_EQ(found.size(), 1u);
      EXPECT_TRUE(found[0].moves);

      const LocalSystem<24> local = by_hand(interaction, c);
      EXPECT_NE(local.energy, 0.);
      EXPECT_LT(largest(local.residual), distance == 0. ? 100. : 1e8);
      EXPECT_LT(largest(local.tangent), distance == 0. ? 100. : 1e20);
      expect_balance_of_momentum(c.cells, local, 1e-13);
    }
}



TEST(SectionBeam, ReportsTheForceForOutput)
{
  std::mt19937        random(14);
  const LennardJones  interaction = lennard_jones({0., .05, .1});
  const Configuration c = random_configuration(random, .1, .4, .05 + 2e-3);

  std::vector<SiteForce> forces;
  interaction.forces(
    site_at(c.cells.source, c.x), c.cells.target, c.place, .5, forces);
  ASSERT_EQ(forces.size(), 2u);
  EXPECT_LT((forces[0].force + forces[1].force).norm(), 1e-14);
  EXPECT_NEAR(forces[0].gap, 2e-3, 1e-15);
  EXPECT_LT((forces[0].position - c.cells.source.position(c.x)).norm(), 1e-15);
  EXPECT_LT((forces[1].position - c.cells.target.position(.4)).norm(), 1e-12);

  // Attractive beyond the equilibrium gap, and the sum of the nodal forces but
  // for the part that comes from the angle, which is a couple.
  const Tensor<1, 3> d = forces[1].position - forces[0].position;
  EXPECT_NEAR(forces[0].force * d, forces[0].force.norm() * d.norm(), 1e-13);
}
