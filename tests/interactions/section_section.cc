// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

// Residual and tangent matrix of the sites of two cells against automatic and
// numerical derivatives, and the balance laws.

#include <gtest/gtest.h>

#include <setae/interactions/section_section.h>
#include <setae/laws/disk_disk.h>
#include <setae/laws/lennard_jones.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "../nested_sacado.h"
#include "line_pair.h"

using namespace Setae;

namespace
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  constexpr double factor   = .5;

  /** A law that varies on distances of order one. */
  struct BalancedLaw
  {
    double
    cutoff() const
    {
      return infinity;
    }

    bool
    admits(const double) const
    {
      return true;
    }

    GapDerivatives
    operator()(const double g) const
    {
      return {1. + g - g * g, 1. - 2. * g, -2.};
    }

    template <typename Number>
    Number
    energy(const Number &g) const
    {
      return 1. + g - g * g;
    }
  };

  using Balanced     = SectionSection<BalancedLaw>;
  using LennardJones = SectionSection<DiskDisk>;

  LennardJones
  lennard_jones(const GapRange    &range,
                const SectionPair &sections = {.02, .03, 1., 1.})
  {
    return {DiskDisk(lennard_jones_of_cylinders(1e-3, -1., sections),
                     sections,
                     range),
            sections.radius_1 + sections.radius_2};
  }

  template <typename Interaction>
  LocalSystem<24>
  by_hand(const Interaction &interaction, const Configuration &c)
  {
    LocalSystem<24> local;
    for (const LineSite &source : c.source_sites)
      interaction.add(source, c.target_sites, factor, Request::tangent, local);
    local.symmetrize();
    return local;
  }

  template <typename Interaction>
  LocalSystem<24>
  by_sacado(const Interaction &interaction, const Configuration &c)
  {
    const auto    q      = variables<24>(c.cells.coefficients());
    const auto    source = cell_of(q, 0, c.cells.source.h);
    const auto    target = cell_of(q, 12, c.cells.target.h);
    NestedFad<24> energy = 0.;
    for (const LineSite &s : c.source_sites)
      for (const LineSite &t : c.target_sites)
        energy += (factor * s.weight * t.weight) *
                  interaction.energy(source.combine(s.N), target.combine(t.N));
    return local_system<24>(energy);
  }

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
        return by_hand(interaction, c.with(cells));
      },
      c.cells,
      50. * tolerance);
  }
} // namespace



TEST(SectionSection, HasTheDerivativesOfTheEnergy)
{
  std::mt19937   random(1);
  const Balanced interaction(BalancedLaw(), .1);
  for (const double bend : {0., .3, 1.})
    for (unsigned int i = 0; i < 20; ++i)
      expect_consistent(interaction,
                        random_configuration(random, bend, .2 + .05 * i));
}



TEST(SectionSection, HasThemWithLennardJonesOverManyGaps)
{
  std::mt19937 random(2);
  for (const SectionPair &sections : {SectionPair{.02, .03, 1., 1.},
                                      SectionPair{1e-4, .1, 2., .5},
                                      SectionPair{.1, 1e-4, 1., 3.}})
    for (const double gap : {1e-9, 1e-6, 1e-4, 1e-3, 1e-2, .1})
      for (unsigned int i = 0; i < 5; ++i)
        {
          // Other pairs of sites are rarely closer; one site each is enough.
          const Configuration c = random_configuration(
            random, .3, sections.radius_1 + sections.radius_2 + gap, 1);
          expect_consistent(lennard_jones({1e-10, infinity, infinity},
                                          sections),
                            c,
                            3. + .03 / gap);
        }
}



TEST(SectionSection, HasThemWhereTheLawIsRegularizedOrSwitchedOff)
{
  std::mt19937       random(3);
  const LennardJones interaction = lennard_jones({1e-3, .05, .1});
  for (const double gap : {1e-3, 5e-4, 0., -.01, -.04, .051, .075, .099})
    for (unsigned int i = 0; i < 10; ++i)
      expect_consistent(interaction,
                        random_configuration(random, .3, .05 + gap),
                        gap > .09 ? 100. : 20.);
}



TEST(SectionSection, AgreesWithFiniteDifferences)
{
  std::mt19937 random(4);
  for (unsigned int i = 0; i < 10; ++i)
    {
      const auto difference = [&](const auto          &interaction,
                                  const Configuration &c,
                                  const double         step) {
        expect_finite_differences(
          [&](const CellPair &cells) {
            return by_hand(interaction, c.with(cells));
          },
          c.cells,
          step,
          1e-8);
      };
      difference(Balanced(BalancedLaw(), .1),
                 random_configuration(random, .3, .3),
                 3e-4);
      difference(lennard_jones({}),
                 random_configuration(random, .3, .05 + 2e-3, 1),
                 1e-5);
    }
}



// The double integral knows no source and no target.
TEST(SectionSection, IsTheSameWithFibersSwapped)
{
  std::mt19937      random(5);
  const SectionPair forward = {.02, .05, 2., .5}, backward = {.05, .02, .5, 2.};
  const GapRange    range{.001, .2, .3};
  for (unsigned int i = 0; i < 20; ++i)
    {
      const Configuration c = random_configuration(random, .3, .09);
      Configuration       swapped({c.cells.target, c.cells.source});
      swapped.source_sites = c.target_sites;
      swapped.target_sites = c.source_sites;

      const LocalSystem<24> a = by_hand(lennard_jones(range, forward), c);
      const LocalSystem<24> b =
        by_hand(lennard_jones(range, backward), swapped);
      LocalSystem<24> c_of_b;
      c_of_b.energy = b.energy;
      for (unsigned int k = 0; k < 24; ++k)
        {
          c_of_b.residual[k] = b.residual[(k + 12) % 24];
          for (unsigned int l = 0; l < 24; ++l)
            c_of_b.tangent[k][l] = b.tangent[(k + 12) % 24][(l + 12) % 24];
        }
      expect_equal(a, c_of_b, 1e-13);
    }
}



// The integral of a constant law is the product of the initial lengths, however
// long the fibers are now.
TEST(SectionSection, IntegratesOverBothArcLengths)
{
  struct Constant : BalancedLaw
  {
    GapDerivatives
    operator()(const double) const
    {
      return {1., 0., 0.};
    }
  };
  const Tensor<1, 3>  e({1., 0., 0.}), f({0., 1., 0.});
  const HermiteCell<> initial = {{{Tensor<1, 3>(), e, .3 * e, e}}, .3};
  const HermiteCell<> current = {{{f, 2. * e, .6 * e + f, 2. * e}}, .3};

  std::vector<LineSite> source, target;
  evaluate_sites(dealii::QGauss<1>(3), initial, current, source);
  evaluate_sites(dealii::QGauss<1>(2), initial, initial, target);
  LocalSystem<24> local;
  for (const LineSite &site : source)
    SectionSection<Constant>(Constant(), .1)
      .add(site, target, factor, Request::energy, local);
  EXPECT_NEAR(local.energy, factor * .3 * .3, 1e-16);
  EXPECT_NEAR(source[1].r[0], .3, 1e-16);
  EXPECT_NEAR(source[1].r[1], 1., 1e-16);
}



TEST(SectionSection, EvaluatesNoMoreThanIsRequested)
{
  std::mt19937          random(6);
  const Balanced        interaction(BalancedLaw(), .1);
  const Configuration   c    = random_configuration(random, .3, .3);
  const LocalSystem<24> full = by_hand(interaction, c);

  LocalSystem<24> energy, residual;
  for (const LineSite &source : c.source_sites)
    {
      interaction.add(source, c.target_sites, factor, Request::energy, energy);
      interaction.add(
        source, c.target_sites, factor, Request::residual, residual);
    }
  EXPECT_EQ(energy.energy, full.energy);
  EXPECT_EQ(largest(energy.residual), 0.);
  EXPECT_EQ(largest(energy.tangent), 0.);
  EXPECT_EQ(residual.energy, full.energy);
  EXPECT_EQ(residual.residual, full.residual);
  EXPECT_EQ(largest(residual.tangent), 0.);
}



TEST(SectionSection, IsZeroBeyondTheCutoff)
{
  std::mt19937       random(7);
  const LennardJones interaction = lennard_jones({0., .05, .1});
  EXPECT_DOUBLE_EQ(interaction.reach(), .15);
  for (const double distance : {.1501, .2, .5})
    {
      const Configuration c = random_configuration(random, .1, distance, 1);
      LocalSystem<24>     local;
      EXPECT_EQ(interaction.add(c.source_sites[0],
                                {c.target_sites[1]},
                                factor,
                                Request::tangent,
                                local),
                infinity);
      expect_zero(local);
    }
}



TEST(SectionSection, ReportsOverlapThatTheLawDoesNotAdmit)
{
  std::mt19937       random(8);
  const LennardJones interaction = lennard_jones({0., .05, .1});
  for (const double gap : {-1e-9, -.01, -.049})
    {
      const Configuration c = random_configuration(random, .1, .05 + gap, 1);
      LocalSystem<24>     local;
      EXPECT_NEAR(interaction.add(c.source_sites[0],
                                  {c.target_sites[1]},
                                  factor,
                                  Request::tangent,
                                  local),
                  gap,
                  1e-15);
      expect_zero(local);
    }
}



TEST(SectionSection, ReportsContactToTheLastDigit)
{
  const LennardJones  interaction = lennard_jones({}, {.25, .25, 1., 1.});
  const Tensor<1, 3>  e({1., 0., 0.}), f({0., .5, 0.});
  const HermiteCell<> source = {{{Tensor<1, 3>(), e, e, e}}, 1.},
                      target = {{{f, e, f + e, e}}, 1.};
  LocalSystem<24> local;
  EXPECT_EQ(interaction.add(site_at(source, .5),
                            {site_at(target, .5)},
                            factor,
                            Request::tangent,
                            local),
            0.);
  expect_zero(local);
}



TEST(SectionSection, ReportsForcesForOutput)
{
  std::mt19937          random(9);
  const LennardJones    interaction = lennard_jones({1e-3, .2, .3});
  const Configuration   c           = random_configuration(random, .3, .06);
  const LocalSystem<24> local       = by_hand(interaction, c);

  // Forces per length, integrated, are the sums of the nodal forces.
  std::vector<SiteForce> on_source, on_target;
  interaction.add_forces(c.source_sites, c.target_sites, factor, on_source);
  interaction.add_forces(c.target_sites, c.source_sites, factor, on_target);
  ASSERT_EQ(on_source.size(), c.source_sites.size());
  ASSERT_EQ(on_target.size(), c.target_sites.size());
  for (unsigned int coordinate = 0; coordinate < 3; ++coordinate)
    {
      double source = 0., target = 0.;
      for (unsigned int i = 0; i < on_source.size(); ++i)
        source += c.source_sites[i].weight * on_source[i].force[coordinate];
      for (unsigned int i = 0; i < on_target.size(); ++i)
        target += c.target_sites[i].weight * on_target[i].force[coordinate];
      const double tolerance = 1e-13 * largest(local.residual);
      EXPECT_NEAR(source,
                  -local.residual[coordinate] - local.residual[6 + coordinate],
                  tolerance);
      EXPECT_NEAR(target, -source, tolerance);
    }
  EXPECT_NEAR(on_source[0].gap, .01, .005);
}
