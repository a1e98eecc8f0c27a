// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <gtest/gtest.h>

#include <setae/search/passage.h>

#include <cmath>

#include "random_cells.h"

using namespace Setae;
using namespace RandomCells;

namespace
{
  constexpr double core = .01;

  /** A straight cell of length 2 along a direction in the plane z. */
  ControlPoints
  straight(const double angle, const double z, const double shift = 0.)
  {
    ControlPoints result;
    for (unsigned int k = 0; k < 4; ++k)
      result[k] = Tensor<1, 3>({(k / 1.5 - 1.) * std::cos(angle),
                                (k / 1.5 - 1.) * std::sin(angle) + shift,
                                z});
    return result;
  }

  std::optional<Passage>
  passage_of(const ControlPoints &from,
             const ControlPoints &to,
             const CellEnds      &ends_1 = {},
             const CellEnds      &ends_2 = {})
  {
    return find_passage(
      straight(0., 0.), straight(0., 0.), from, to, core, ends_1, ends_2);
  }
} // namespace



TEST(Passage, OfACellThatCrossesAnotherOneIsFoundHoweverFarItGoes)
{
  for (const double far : {.05, 1., 100.})
    for (const double angle : {.01, .3, 1.5})
      {
        const auto passage =
          passage_of(straight(angle, .05), straight(angle, .05 - 2. * far));
        ASSERT_TRUE(passage) << far << ' ' << angle;
        EXPECT_NEAR(.05 - 2. * far * passage->fraction, core, .02 * core);
      }
}

TEST(Passage, OfACellThatPressesOrGoesAwayIsNone)
{
  EXPECT_FALSE(passage_of(straight(1., .05), straight(1., .02)));
  EXPECT_FALSE(passage_of(straight(1., .05), straight(1., 5.)));
  EXPECT_FALSE(passage_of(straight(1., .05), straight(2., .05)));
}

TEST(Passage, OfACellThatGoesAroundTheEndOfAnotherOneIsNone)
{
  EXPECT_FALSE(passage_of(straight(0., .05, 1.5), straight(0., -.05, 1.5)));
  EXPECT_TRUE(passage_of(straight(1.57, .05, .9), straight(1.57, -.05, .9)));
  EXPECT_FALSE(passage_of(straight(1.57, .05, 1.1), straight(1.57, -.05, 1.1)));
}

TEST(Passage, OfCellsThatAreTooNearFromTheBeginningIsNotJudged)
{
  EXPECT_FALSE(passage_of(straight(1., .5 * core), straight(1., -.05)));
}

TEST(Passage, OfAnEndBeforeAnEndIsNotJudged)
{
  ControlPoints from, to;
  for (unsigned int k = 0; k < 4; ++k)
    {
      from[k] = Tensor<1, 3>({1.05 + k, 0., 0.});
      to[k]   = Tensor<1, 3>({1.001 + k, 0., 0.});
    }
  EXPECT_TRUE(passage_of(from, to));
  EXPECT_FALSE(passage_of(from, to, {false, true}, {true, false}));
}

TEST(Passage, OfCellsThatMoveTogetherIsNone)
{
  const auto moved = [](ControlPoints P) {
    for (auto &point : P)
      point += Tensor<1, 3>({3., 5., 7.});
    return P;
  };
  EXPECT_FALSE(find_passage(straight(0., 0.),
                            moved(straight(0., 0.)),
                            straight(1., .05),
                            moved(straight(1., .05)),
                            core));
}

TEST(Passage, OfManyCellsIsTheFirstOne)
{
  // The third and the fourth cell fall through the first, the latter faster.
  const Cells from   = {straight(0., 0.),
                        straight(1., 1.),
                        straight(1., .05),
                        straight(2., .05)},
              to     = {straight(0., 0.),
                        straight(1., 1.),
                        straight(1., -.05),
                        straight(2., -.5)};
  const auto core_of = [](const unsigned int, const unsigned int) {
    return core;
  };
  const auto no_ends = [](const unsigned int) { return CellEnds(); };
  const auto passage =
    find_passage(from, to, {0}, {1, 2, 3}, core, core_of, no_ends);
  ASSERT_TRUE(passage);
  EXPECT_EQ(passage->target, 3u);

  // Those that do not interact may pass.
  EXPECT_FALSE(find_passage(
    from,
    to,
    {0},
    {1, 2, 3},
    core,
    [](const unsigned int, const unsigned int) { return 0.; },
    no_ends));
}
