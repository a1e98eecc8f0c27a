// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

// The kernel with laws that know the tilt of a section, and at the ends of
// targets: residual and tangent matrix against automatic derivatives, balance
// laws, and a passage over an end without a jump.

#include <gtest/gtest.h>

#include <setae/laws/tabulated_disk_cylinder.h>

#include <cmath>
#include <random>

#include "section_beam.h"

using namespace Setae;
using namespace Setae::SectionBeamTests;

namespace
{
  constexpr SectionPair radii = {.02, .03, 1., 1.};

  template <typename Law>
  Law
  law_of(const PointPotential &potential, const GapRange &range)
  {
    if constexpr (std::is_same_v<Law, TabulatedDiskCylinder>)
      return Law(potential, radii, range, {4, 9, .01});
    else
      return Law(potential, radii, range);
  }

  enum class Target
  {
    clamped,
    ends,
    fades
  };

  template <typename Law>
  SectionBeam<Law>
  interaction_of(const GapRange &range, const Target target)
  {
    const PointPotential potential =
      lennard_jones_of_cylinders(gap_equilibrium, -1., radii);
    const Law    law = law_of<Law>(potential, range);
    const double sum = radii.radius_1 + radii.radius_2;

    std::vector<typename TargetEnd<Law>::Term>   ends;
    std::vector<typename FadedTarget<Law>::Term> faded;
    for (const InversePower &power : potential)
      {
        const Law alone = law_of<Law>({power}, range);
        ends.push_back({alone,
                        EndFraction(power.exponent, radii, range),
                        FlatEnd(power, radii, range)});
        faded.push_back({alone, FadingFraction(power.exponent, radii)});
      }
    switch (target)
      {
        case Target::ends:
          return {law, sum, TargetEnd<Law>(ends)};
        case Target::fades:
          return {law, sum, FadedTarget<Law>(sum, faded)};
        default:
          return {law, sum};
      }
  }

  template <typename Interaction>
  LocalSystem<24>
  by_sacado_with_ends(const Interaction &interaction, const Configuration &c)
  {
    const auto    q      = variables<24>(c.cells.coefficients());
    const auto    source = cell_of(q, 0, c.cells.source.h);
    const auto    target = cell_of(q, 12, c.cells.target.h);
    NestedFad<24> energy = 0.;
    for (const Projection &projection : closest_points(
           c.cells.target, c.cells.source.position(c.x), c.place.ends))
      energy += weight * interaction.energy(source.position(c.x),
                                            source.derivative(c.x),
                                            target,
                                            projection,
                                            c.place);
    return local_system<24>(energy);
  }

  template <typename Interaction>
  void
  expect_consistent(const Interaction   &interaction,
                    const Configuration &c,
                    const double         tolerance)
  {
    const LocalSystem<24> local = by_hand(interaction, c);
    ASSERT_NE(local.energy, 0.);
    expect_equal(local, by_sacado_with_ends(interaction, c), tolerance);
    expect_balance_of_momentum(c.cells, local, tolerance);
    expect_objective(
      [&](const CellPair &cells) {
        return by_hand(interaction, {cells, c.x, c.place});
      },
      c.cells,
      50. * tolerance);
  }

  template <typename Law>
  class SectionBeamOfLaw : public testing::Test
  {};

  using TestedLaws =
    testing::Types<DiskCylinder, OrientedDiskCylinder, TabulatedDiskCylinder>;
  TYPED_TEST_SUITE(SectionBeamOfLaw, TestedLaws);
} // namespace



TYPED_TEST(SectionBeamOfLaw, HasTheDerivativesOfTheEnergy)
{
  std::mt19937 random(1);
  const auto   interaction = interaction_of<TypeParam>({}, Target::clamped);
  for (const double gap : {1e-6, 1e-3, .03, .3})
    for (unsigned int i = 0; i < 8; ++i)
      expect_consistent(interaction,
                        random_configuration(random, .3, .4, .05 + gap),
                        1e-11 + 1e-14 / gap);
}



TYPED_TEST(SectionBeamOfLaw, HasThemBeforeAndBeyondTheEnd)
{
  std::mt19937 random(2);
  const auto   interaction = interaction_of<TypeParam>({}, Target::ends);
  for (const double gap : {1e-3, .02})
    for (const double end : {0., 1.})
      for (const double beyond : {-.1, -.01, -1e-3, 1e-4, 2e-3})
        {
          Configuration c =
            random_configuration(random, .1, end, .05 + gap, -.5);
          const Tensor<1, 3> tangent = c.cells.target.derivative(end);
          move_to(c.cells.source,
                  c.x,
                  c.cells.source.position(c.x) +
                    (2. * end - 1.) * beyond * tangent / tangent.norm());
          c.place.ends = {end == 0. || beyond > 0., end == 1.};
          expect_consistent(interaction, c, 1e-10);
        }
}



// Over the end cap and its edge, on the axis as well, with and without a gap
// that is small beside the radii.
TYPED_TEST(SectionBeamOfLaw, HasThemInFrontOfTheEnd)
{
  std::mt19937 random(5);
  const auto   interaction = interaction_of<TypeParam>({}, Target::ends);
  for (const double gap : {1e-3, .01, .1})
    for (const double lateral : {0., .013, .03, .045})
      {
        Configuration      c  = random_configuration(random, .1, 1., .05, -.5);
        const Tensor<1, 3> a1 = c.cells.source.derivative(c.x),
                           a2 = c.cells.target.derivative(1.);
        const Tensor<1, 3> t1 = a1 / a1.norm(), t2 = a2 / a2.norm();
        const double sine = std::sqrt(std::max(0., 1. - (t1 * t2) * (t1 * t2)));
        move_to(c.cells.source,
                c.x,
                c.cells.target.position(1.) +
                  (gap + radii.radius_1 * sine) * t2 +
                  lateral * random_normal_to(t2, random));
        c.place.ends = {false, true};
        expect_consistent(interaction, c, 1e-9);
      }
}



// Both ends of a target of one cell, where it begins to fade, half-way, where
// nothing is left but what is farther along, and beyond the end.
TYPED_TEST(SectionBeamOfLaw, HasThemWhereTheTargetFades)
{
  std::mt19937 random(6);
  const auto   interaction = interaction_of<TypeParam>({}, Target::fades);

  constexpr double cell_length = .6;
  for (const double gap : {1e-3, .02, .1})
    for (const double end : {0., 1.})
      for (const double inside : {.27, .22, .15, .08, .03, -.02})
        {
          // Beyond the end on the axis, if the gap is small
          const double  lateral = inside < 0. && gap < .01 ? .002 : .05 + gap;
          const double  s       = std::max(inside, 0.) / cell_length;
          Configuration c       = random_configuration(
            random, .1, end == 0. ? s : 1. - s, lateral, -.5);
          const Tensor<1, 3> tangent = c.cells.target.derivative(end);
          if (inside < 0.)
            move_to(c.cells.source,
                    c.x,
                    c.cells.source.position(c.x) +
                      (1. - 2. * end) * inside * tangent / tangent.norm());
          c.place = {{true, true}, 0., 0., cell_length, cell_length};
          if (inside > .1 || (gap > .01 && inside > 0.))
            expect_consistent(interaction, c, 1e-10);
          else
            expect_equal(by_hand(interaction, c),
                         by_sacado_with_ends(interaction, c),
                         1e-10);
        }
}



TYPED_TEST(SectionBeamOfLaw, HasThemWhereItIsRegularizedOrSwitchedOff)
{
  std::mt19937 random(3);
  const auto   interaction =
    interaction_of<TypeParam>({1e-3, .05, .1}, Target::ends);
  for (const double gap : {8e-4, 2e-4, -2e-3, .075})
    for (unsigned int i = 0; i < 5; ++i)
      {
        Configuration c = random_configuration(random, .2, .9, .05 + gap);
        c.place.ends    = {false, true};
        expect_consistent(interaction, c, 1e-10);
      }
}



// A section that passes over the end of a straight target: the energy falls
// from all of it to nothing, and neither force nor stiffness jumps.
TYPED_TEST(SectionBeamOfLaw, PassesTheEndWithoutAJump)
{
  const auto          interaction = interaction_of<TypeParam>({}, Target::ends);
  const Tensor<1, 3>  e({1., 0., 0.}), f({.5, .052, .003});
  const HermiteCell<> target = {{{Tensor<1, 3>(), e, e, e}}, 1.};
  const Tensor<1, 3>  direction({1., .1, .2});

  const auto at = [&](const double place) {
    Configuration c;
    c.cells.target = target;
    c.cells.source = {{{f, direction, f + direction, direction}}, 1.};
    move_to(c.cells.source, c.x, Tensor<1, 3>({place, f[1], f[2]}));
    c.place.ends = {false, true};
    return by_hand(interaction, c);
  };
  const LocalSystem<24> inside = at(1. - 1e-9), outside = at(1. + 1e-9);
  EXPECT_NEAR(outside.energy / inside.energy, 1., 1e-5);
  for (unsigned int i = 0; i < 24; ++i)
    {
      EXPECT_NEAR(inside.residual[i],
                  outside.residual[i],
                  1e-5 * largest(inside.residual));
      for (unsigned int j = 0; j < 24; ++j)
        EXPECT_NEAR(inside.tangent[i][j],
                    outside.tangent[i][j],
                    1e-3 * largest(inside.tangent));
    }
  const double full = at(.6).energy;
  EXPECT_LT(std::abs(at(1.5).energy), 1e-3 * std::abs(full));
}
