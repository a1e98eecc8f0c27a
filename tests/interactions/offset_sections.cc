// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

// Residual and tangent matrix of the sites of two cells, with and without
// moments, against automatic derivatives of every pair, and the balance laws.

#include <boost/math/quadrature/exp_sinh.hpp>

#include <gtest/gtest.h>

#include <setae/interactions/offset_sections.h>
#include <setae/laws/disk_cylinder.h>
#include <setae/laws/lennard_jones.h>
#include <setae/laws/offset_disks.h>

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

  /** A law that varies on distances of order one, even in the offset. */
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

    OffsetGapDerivatives
    operator()(const double o, const double g) const
    {
      return {1. + g - g * g + o * o * g,
              2. * o * g,
              1. - 2. * g + o * o,
              2. * g,
              2. * o,
              -2.};
    }

    template <typename Number>
    Number
    energy(const Number &o, const Number &g) const
    {
      return 1. + g - g * g + o * o * g;
    }
  };

  using Balanced     = OffsetSections<BalancedLaw>;
  using LennardJones = OffsetSections<OffsetDisks>;

  LennardJones
  lennard_jones(const GapRange     &range,
                const OffsetAxis    axis         = OffsetAxis::averaged,
                const bool          with_moments = true,
                const SectionPair  &sections     = {.02, .03, 1., 1.},
                const CutoffSwitch &force_switch = CutoffSwitch())
  {
    return {OffsetDisks(lennard_jones_of_cylinders(1e-3, -1., sections),
                        sections,
                        range),
            sections.radius_1 + sections.radius_2,
            axis,
            with_moments,
            force_switch};
  }

  template <typename Interaction>
  LocalSystem<24>
  by_hand(const Interaction   &interaction,
          const Configuration &c,
          const Request        request = Request::tangent)
  {
    LocalSystem<24> local;
    SitePairSums    sums;
    sums.start(c.target_sites.size(), request);
    const double spacing = interaction.largest_spacing(c.target_sites);
    for (const LineSite &source : c.source_sites)
      interaction.add(
        source, c.target_sites, spacing, factor, request, sums, local);
    sums.finish(c.target_sites, local);
    if (interaction.is_symmetric())
      local.symmetrize();
    return local;
  }

  /**
   * The derivatives of each pair in its twelve coordinates, times the shape
   * functions as a full matrix. Without moments, the rows of the tangents are
   * zero.
   */
  template <typename Interaction>
  LocalSystem<24>
  by_sacado(const Interaction &interaction, const Configuration &c)
  {
    using Vector = Tensor<1, 3, NestedFad<12>>;
    LocalSystem<24> result;
    for (const LineSite &s : c.source_sites)
      for (const LineSite &t : c.target_sites)
        {
          std::array<Vector, 4> v;
          unsigned int          k = 0;
          for (const Tensor<1, 3> &vector : {s.r, s.r_x, t.r, t.r_x})
            {
              for (unsigned int e = 0; e < 3; ++e)
                v[k][e] = variable<12>(3 * k + e, vector[e]);
              ++k;
            }
          LocalSystem<12> pair = local_system<12>(
            NestedFad<12>(factor * s.weight * t.weight *
                          interaction.energy(v[0], v[1], v[2], v[3])));
          if (!interaction.is_symmetric())
            for (const unsigned int i : {3, 4, 5, 9, 10, 11})
              {
                pair.residual[i] = 0.;
                pair.tangent[i]  = {};
              }

          std::array<std::array<double, 24>, 12> B = {};
          for (unsigned int a = 0; a < 4; ++a)
            for (unsigned int e = 0; e < 3; ++e)
              {
                B[e][3 * a + e]          = s.N[a];
                B[3 + e][3 * a + e]      = s.N_x[a];
                B[6 + e][12 + 3 * a + e] = t.N[a];
                B[9 + e][12 + 3 * a + e] = t.N_x[a];
              }
          result.energy += pair.energy;
          for (unsigned int i = 0; i < 24; ++i)
            for (unsigned int p = 0; p < 12; ++p)
              {
                result.residual[i] += B[p][i] * pair.residual[p];
                for (unsigned int q = 0; q < 12; ++q)
                  for (unsigned int j = 0; j < 24; ++j)
                    result.tangent[i][j] +=
                      B[p][i] * pair.tangent[p][q] * B[q][j];
              }
        }
    return result;
  }

  /**
   * Two random cells as in random_configuration(), of about one direction: the
   * offset of distant sites is then no gap.
   */
  Configuration
  aligned_configuration(std::mt19937      &random,
                        const double       angle,
                        const double       distance,
                        const unsigned int n = 3)
  {
    const Tensor<1, 3> direction = random_direction(random);
    const Tensor<1, 3> other =
      std::cos(angle) * direction +
      std::sin(angle) * random_normal_to(direction, random);
    CellPair cells;
    cells.source    = random_cell(direction, .4, .1, random);
    cells.target    = random_cell(other, .5, .1, random);
    const double x  = dealii::QGauss<1>(n).point(0)[0];
    const double xi = dealii::QGauss<1>(n + 1).point(1)[0];
    move_to(cells.source,
            x,
            cells.target.position(xi) +
              distance * random_normal_to(cells.target.derivative(xi), random));
    return Configuration(cells, n);
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
    if (interaction.is_symmetric())
      expect_balance_of_momentum(c.cells, local, tolerance);
    expect_objective(
      [&](const CellPair &cells) {
        return by_hand(interaction, c.with(cells));
      },
      c.cells,
      50. * tolerance);
  }

  /** All variants. */
  template <typename Visitor>
  void
  for_each_variant(const Visitor &visit)
  {
    for (const OffsetAxis axis : {OffsetAxis::averaged, OffsetAxis::source})
      for (const bool with_moments : {true, false})
        {
          SCOPED_TRACE(testing::Message()
                       << (axis == OffsetAxis::averaged ? "averaged" : "source")
                       << (with_moments ? "" : ", no moments"));
          visit(axis, with_moments);
        }
  }
} // namespace



TEST(OffsetSections, HaveTheDerivativesOfTheEnergy)
{
  std::mt19937 random(1);
  for_each_variant([&](const OffsetAxis axis, const bool with_moments) {
    const Balanced interaction(BalancedLaw(), .1, axis, with_moments);
    for (const double bend : {0., .3, 1.})
      for (unsigned int i = 0; i < 10; ++i)
        expect_consistent(interaction,
                          random_configuration(random, bend, .2 + .05 * i),
                          100.);
  });
}



// In space, at every angle between nearly parallel and nearly perpendicular.
TEST(OffsetSections, HaveThemWithLennardJonesOverManyGaps)
{
  std::mt19937 random(2);
  for_each_variant([&](const OffsetAxis axis, const bool with_moments) {
    for (const SectionPair &sections :
         {SectionPair{.02, .03, 1., 1.}, SectionPair{.1, 1e-4, 1., 3.}})
      for (const double gap : {1e-6, 1e-4, 1e-3, 1e-2, .1})
        for (const double angle : {0., .1, 1.5, 3.})
          {
            // The gap across an averaged axis is a bit larger.
            const Configuration c = aligned_configuration(
              random, angle, sections.radius_1 + sections.radius_2 + gap, 1);
            expect_consistent(lennard_jones({1e-8, infinity, infinity},
                                            axis,
                                            with_moments,
                                            sections),
                              c,
                              100. + 1. / gap);
          }
  });
}



TEST(OffsetSections, HaveThemWhereTheLawIsRegularizedOrSwitchedOff)
{
  std::mt19937 random(3);
  for_each_variant([&](const OffsetAxis axis, const bool with_moments) {
    const LennardJones interaction =
      lennard_jones({1e-3, .05, .1}, axis, with_moments);
    for (const double gap : {1e-3, 5e-4, 0., -.01, -.04, .051, .075, .095})
      for (unsigned int i = 0; i < 5; ++i)
        expect_consistent(interaction,
                          aligned_configuration(random, .1, .05 + gap, 1),
                          gap > .09 ? 1e4 : 1e3);
  });
}



TEST(OffsetSections, AgreeWithFiniteDifferences)
{
  std::mt19937 random(4);
  for (const OffsetAxis axis : {OffsetAxis::averaged, OffsetAxis::source})
    for (unsigned int i = 0; i < 5; ++i)
      {
        const LennardJones  interaction = lennard_jones({}, axis);
        const Configuration c =
          aligned_configuration(random, .1 * i, .05 + 3e-3, 1);
        expect_finite_differences(
          [&](const CellPair &cells) {
            return by_hand(interaction, c.with(cells));
          },
          c.cells,
          1e-5,
          1e-7);
      }
}



// What the paper's simplification gives away: without moments, forces are in
// balance but do not turn each other.
TEST(OffsetSections, ViolateTheBalanceOfMomentsWithoutTheirOwn)
{
  std::mt19937 random(5);
  const auto   imbalance = [&](const LennardJones  &interaction,
                             const Configuration &c) {
    const LocalSystem<24> local = by_hand(interaction, c);
    const Coefficients    q     = c.cells.coefficients();
    Tensor<1, 3>          force, moment;
    double                size = 0.;
    for (unsigned int a = 0; a < 8; ++a)
      {
        Tensor<1, 3> q_a, f_a;
        for (unsigned int e = 0; e < 3; ++e)
          {
            q_a[e] = q[3 * a + e];
            f_a[e] = local.residual[3 * a + e];
          }
        moment += cross_product_3d(q_a, f_a);
        size += q_a.norm() * f_a.norm();
        if (a % 2 == 0)
          force += f_a;
      }
    EXPECT_LE(force.norm(), 1e-11 * size);
    return moment.norm() / size;
  };
  for (const OffsetAxis axis : {OffsetAxis::averaged, OffsetAxis::source})
    {
      const Configuration c = aligned_configuration(random, .1, .06);
      EXPECT_LE(imbalance(lennard_jones({}, axis, true), c), 1e-11);
      EXPECT_GE(imbalance(lennard_jones({}, axis, false), c), 1e-6);
    }
}



// Forces that are switched off themselves: the factor of the distance is that
// of the residual, and the tangent matrix is its derivative without a
// potential.
TEST(OffsetSections, SwitchForcesOff)
{
  std::mt19937       random(10);
  const CutoffSwitch factor_of_gap(.005, .02);
  for_each_variant([&](const OffsetAxis axis, const bool with_moments) {
    const LennardJones whole    = lennard_jones({}, axis, with_moments),
                       switched = lennard_jones({},
                                                axis,
                                                with_moments,
                                                {.02, .03, 1., 1.},
                                                factor_of_gap);
    EXPECT_DOUBLE_EQ(switched.reach(), .07);
    EXPECT_FALSE(switched.is_symmetric());
    for (const double gap : {4e-3, 6e-3, 1e-2, 1.9e-2})
      {
        // The first source and the second target are the only ones in reach.
        Configuration c = aligned_configuration(random, .1, .05 + gap, 1);
        c.target_sites.erase(c.target_sites.begin());
        const auto evaluate = [&](const CellPair &cells) {
          return by_hand(switched, c.with(cells));
        };
        const LocalSystem<24> local    = evaluate(c.cells),
                              unscaled = by_hand(whole, c);
        LocalSystem<24> expected = finite_differences(evaluate, c.cells, 1e-5);
        expected.energy          = unscaled.energy;
        for (unsigned int i = 0; i < 24; ++i)
          expected.residual[i] =
            factor_of_gap.value(gap) * unscaled.residual[i];
        expect_equal(local, expected, 1e-7);
        if (with_moments)
          expect_balance_of_momentum(c.cells, local, 1e-10);

        double asymmetry = 0.;
        for (unsigned int i = 0; i < 24; ++i)
          for (unsigned int j = 0; j < i; ++j)
            asymmetry =
              std::max(asymmetry,
                       std::abs(local.tangent[i][j] - local.tangent[j][i]));
        if (with_moments && gap > .005)
          {
            EXPECT_GT(asymmetry, 1e-4 * largest(local.tangent));
          }

        std::vector<SiteForce> on_source, on_target;
        switched.add_forces(
          c.source_sites, c.target_sites, factor, on_source, on_target);
        for (unsigned int e = 0; e < 3; ++e)
          EXPECT_NEAR(c.source_sites[0].weight * on_source[0].force[e],
                      -local.residual[e] - local.residual[6 + e],
                      1e-12 * largest(local.residual));
      }
  });
}



// An averaged axis knows no source and no target.
TEST(OffsetSections, AreTheSameWithFibersSwappedIfAveraged)
{
  std::mt19937      random(6);
  const SectionPair forward = {.02, .05, 2., .5}, backward = {.05, .02, .5, 2.};
  const GapRange    range{.001, .2, .3};
  for (unsigned int i = 0; i < 20; ++i)
    {
      const Configuration c = aligned_configuration(random, .1 * i, .09);
      Configuration       swapped({c.cells.target, c.cells.source});
      swapped.source_sites = c.target_sites;
      swapped.target_sites = c.source_sites;

      const LocalSystem<24> a =
        by_hand(lennard_jones(range, OffsetAxis::averaged, true, forward), c);
      const LocalSystem<24> b =
        by_hand(lennard_jones(range, OffsetAxis::averaged, true, backward),
                swapped);
      LocalSystem<24> c_of_b;
      c_of_b.energy = b.energy;
      for (unsigned int k = 0; k < 24; ++k)
        {
          c_of_b.residual[k] = b.residual[(k + 12) % 24];
          for (unsigned int l = 0; l < 24; ++l)
            c_of_b.tangent[k][l] = b.tangent[(k + 12) % 24][(l + 12) % 24];
        }
      expect_equal(a, c_of_b, 1e-10);
    }
}



// Two straight parallel cells, the target long enough for a steep potential:
// the energy per length of the section-beam law (ISSIP eq. 32), by the midpoint
// rule.
TEST(OffsetSections, AreSectionBeamInteractionOfParallelFibers)
{
  const Tensor<1, 3>  e({1., 0., 0.}), f({0., 1., 0.});
  constexpr double    gap = 1e-2, length = 4.;
  const HermiteCell<> target = {{{-.5 * length * e, e, .5 * length * e, e}},
                                length};
  const HermiteCell<> source = {
    {{-.1 * e + (.05 + gap) * f, e, .1 * e + (.05 + gap) * f, e}}, .2};
  std::vector<LineSite> sources, targets;
  evaluate_sites(dealii::QGauss<1>(1), source, source, sources);
  evaluate_sites(dealii::QIterated<1>(dealii::QMidpoint<1>(), 4000),
                 target,
                 target,
                 targets);

  const SectionPair    sections  = {.02, .03, 1., 1.};
  const PointPotential potential = {{12, 1.}};
  const LennardJones   interaction(OffsetDisks(potential, sections, {}),
                                 .05,
                                 OffsetAxis::averaged,
                                 true);
  LocalSystem<24>      local;
  SitePairSums         sums;
  sums.start(targets.size(), Request::energy);
  interaction.add(sources[0],
                  targets,
                  interaction.largest_spacing(targets),
                  1.,
                  Request::energy,
                  sums,
                  local);
  const double expected =
    sources[0].weight * DiskCylinder(potential, sections, {})(gap, 1.).value;
  EXPECT_NEAR(local.energy, expected, 1e-8 * std::abs(expected));
}



// Two straight cylinders that cross at any angle: Derjaguin's integral of the
// energy of two half-spaces, exact for small gaps. The section-beam law misses
// it by up to 41 %.
TEST(OffsetSections, AreExactForCrossingCylindersAtSmallGaps)
{
  const SectionPair  sections = {.5, 1.5, 1., 1.};
  const double       gap = 1e-5, radii = 2.;
  const Tensor<1, 3> e({1., 0., 0.}), f({0., 1., 0.}), g({0., 0., 1.});
  boost::math::quadrature::exp_sinh<double> half_line;
  for (const unsigned int m : {6, 12})
    for (const OffsetAxis axis : {OffsetAxis::averaged, OffsetAxis::source})
      for (const double angle : {.1, .8, 1.57, 2.5})
        {
          const LennardJones interaction(OffsetDisks({{m, 1.}}, sections, {}),
                                         radii,
                                         axis,
                                         true);
          const Tensor<1, 3> t    = std::cos(angle) * e + std::sin(angle) * f;
          const auto         pair = [&](const double s1, const double s2) {
            return interaction.energy(s1 * e + (radii + gap) * g, e, s2 * t, t);
          };

          // Sites whose connection is along an edge of the parallelogram of the
          // axes or its diagonal, depending on the axis: u along, v across.
          const auto at = [&](const double u, const double v) {
            if (axis == OffsetAxis::source)
              return pair(u + v / std::tan(angle), v / std::sin(angle));
            const double h =
              std::cos(angle) < 0. ? .5 * (angle - M_PI) : .5 * angle;
            const double a = .5 * u / std::cos(h), b = .5 * v / std::sin(h);
            return std::cos(angle) < 0. ? pair(b + a, b - a) :
                                          pair(a + b, b - a);
          };
          const double length = std::sqrt(2. * radii * gap);
          const double energy =
            2. * length / std::sin(angle) *
            half_line.integrate([&](const double v) {
              return gap * half_line.integrate([&](const double u) {
                return at(gap * u, length * v) + at(-gap * u, length * v);
              });
            });
          const double expected =
            4. * M_PI * M_PI *
            std::sqrt(sections.radius_1 * sections.radius_2) /
            (std::sin(angle) * (m - 2.) * (m - 3.) * (m - 4.) * (m - 5.)) *
            std::pow(gap, 5. - m);
          EXPECT_NEAR(energy / expected, 1., 1e-4) << m << ' ' << angle;
        }
}



TEST(OffsetSections, EvaluateNoMoreThanIsRequested)
{
  std::mt19937   random(7);
  const Balanced interaction(BalancedLaw(), .1, OffsetAxis::averaged, true);
  const Configuration   c        = random_configuration(random, .3, .3);
  const LocalSystem<24> full     = by_hand(interaction, c),
                        energy   = by_hand(interaction, c, Request::energy),
                        residual = by_hand(interaction, c, Request::residual);
  EXPECT_EQ(energy.energy, full.energy);
  EXPECT_EQ(largest(energy.residual), 0.);
  EXPECT_EQ(largest(energy.tangent), 0.);
  EXPECT_EQ(residual.energy, full.energy);
  EXPECT_EQ(residual.residual, full.residual);
  EXPECT_EQ(largest(residual.tangent), 0.);
}



// Jumping over distant targets leaves none out that is within reach.
TEST(OffsetSections, VisitAllTargetsWithinReach)
{
  std::mt19937       random(8);
  const LennardJones interaction = lennard_jones({1e-3, .02, .04});
  EXPECT_DOUBLE_EQ(interaction.reach(), .09);
  for (unsigned int i = 0; i < 50; ++i)
    {
      const Configuration c =
        aligned_configuration(random, .2 * i, .02 + .0013 * i, 60);
      double energy = 0.;
      for (const LineSite &s : c.source_sites)
        for (const LineSite &t : c.target_sites)
          energy += factor * s.weight * t.weight *
                    interaction.energy(s.r, s.r_x, t.r, t.r_x);
      ASSERT_NE(energy, 0.);
      EXPECT_NEAR(by_hand(interaction, c, Request::energy).energy,
                  energy,
                  1e-11 * std::abs(energy));
    }
}



TEST(OffsetSections, ReportGapsAndLeaveOutOverlapThatTheLawDoesNotAdmit)
{
  const Tensor<1, 3>  e({1., 0., 0.}), f({0., 1., 0.});
  const HermiteCell<> target = {{{Tensor<1, 3>(), e, e, e}}, 1.};
  const auto          add    = [&](const Tensor<1, 3> &shift,
                       const GapRange     &range,
                       LocalSystem<24>    &local) {
    const HermiteCell<> source = {{{shift, e, e + shift, e}}, 1.};
    SitePairSums        sums;
    sums.start(1, Request::tangent);
    const double gap = lennard_jones(range).add(site_at(source, .5),
                                                {site_at(target, .5)},
                                                0.,
                                                factor,
                                                Request::tangent,
                                                sums,
                                                local);
    sums.finish({site_at(target, .5)}, local);
    return gap;
  };

  // Beyond the cutoff, inside it with an offset, overlapping.
  LocalSystem<24> local;
  EXPECT_EQ(add(.2 * f, {0., .05, .1}, local), infinity);
  expect_zero(local);
  EXPECT_NEAR(add(.08 * f + .06 * e, {0., .05, .1}, local), .05, 1e-15);
  EXPECT_NE(local.energy, 0.);
  local = {};
  EXPECT_NEAR(add(.04 * f + .08 * e, {0., .05, .1}, local), -.01, 1e-15);
  expect_zero(local);
  EXPECT_NEAR(add(.04 * f + .03 * e, {1e-3, .05, .1}, local), 0., 1e-15);
  EXPECT_NE(local.energy, 0.);
}



TEST(OffsetSections, ReportForcesForOutput)
{
  std::mt19937 random(9);
  for_each_variant([&](const OffsetAxis axis, const bool with_moments) {
    const LennardJones interaction =
      lennard_jones({1e-3, .2, .3}, axis, with_moments);
    const Configuration   c     = aligned_configuration(random, .2, .06);
    const LocalSystem<24> local = by_hand(interaction, c);

    // Forces per length, integrated, are the sums of the nodal forces.
    std::vector<SiteForce> on_source, on_target;
    interaction.add_forces(
      c.source_sites, c.target_sites, factor, on_source, on_target);
    ASSERT_EQ(on_source.size(), c.source_sites.size());
    ASSERT_EQ(on_target.size(), c.target_sites.size());
    for (unsigned int e = 0; e < 3; ++e)
      {
        double source = 0., target = 0.;
        for (unsigned int i = 0; i < on_source.size(); ++i)
          source += c.source_sites[i].weight * on_source[i].force[e];
        for (unsigned int i = 0; i < on_target.size(); ++i)
          target += c.target_sites[i].weight * on_target[i].force[e];
        const double tolerance = 1e-12 * largest(local.residual);
        EXPECT_NEAR(source,
                    -local.residual[e] - local.residual[6 + e],
                    tolerance);
        EXPECT_NEAR(target, -source, tolerance);
      }
    EXPECT_NEAR(on_source[0].gap, .01, .005);
  });
}
