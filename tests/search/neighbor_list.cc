// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <gtest/gtest.h>

#include <setae/search/neighbor_list.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include "random_cells.h"

using namespace Setae;
using namespace RandomCells;

namespace
{
  using Pairs = std::set<std::pair<unsigned int, unsigned int>>;

  const NeighborList::Admissible different = [](const unsigned int source,
                                                const unsigned int target) {
    return source != target;
  };

  std::vector<unsigned int>
  all_indices(const unsigned int n)
  {
    std::vector<unsigned int> result(n);
    std::iota(result.begin(), result.end(), 0);
    return result;
  }

  /**
   * All pairs of different cells with two of their sampled points closer than
   * @p distance: pairs that are certainly within that distance.
   */
  Pairs
  pairs_within(const Cells       &cells,
               const double       distance,
               const unsigned int n_samples)
  {
    std::vector<std::vector<std::array<double, 3>>> points;
    for (const auto &cell : cells)
      points.push_back(sample(cell, n_samples));

    const auto are_within = [&](const unsigned int i, const unsigned int j) {
      for (const auto &p : points[i])
        for (const auto &q : points[j])
          {
            const double x = p[0] - q[0], y = p[1] - q[1], z = p[2] - q[2];
            if (x * x + y * y + z * z < distance * distance)
              return true;
          }
      return false;
    };

    Pairs pairs;
    for (unsigned int i = 0; i < cells.size(); ++i)
      for (unsigned int j = 0; j < i; ++j)
        if (are_within(i, j))
          {
            pairs.emplace(i, j);
            pairs.emplace(j, i);
          }
    return pairs;
  }

  Pairs
  listed_pairs(const NeighborList &list)
  {
    Pairs pairs;
    for (unsigned int i = 0; i < list.sources().size(); ++i)
      for (const unsigned int target : list.targets(i))
        pairs.emplace(list.sources()[i], target);
    return pairs;
  }

  Pairs
  missed_pairs(const NeighborList &list, const Pairs &pairs)
  {
    const Pairs listed = listed_pairs(list);
    Pairs       missed;
    std::set_difference(pairs.begin(),
                        pairs.end(),
                        listed.begin(),
                        listed.end(),
                        std::inserter(missed, missed.end()));
    return missed;
  }

  /** A list of all cells against all others. */
  NeighborList
  list_of_all(const double reach, const double skin, const Cells &cells)
  {
    NeighborList list(reach, skin);
    list.build(cells,
               all_indices(cells.size()),
               all_indices(cells.size()),
               different);
    return list;
  }
} // namespace



TEST(NeighborList, MissesNoPairOfRandomCurves)
{
  for (unsigned int seed = 0; seed < 5; ++seed)
    {
      std::mt19937 random(seed);
      const Cells  cells = random_curved_cells(80, 4., random);
      const double reach = 0.3 + 0.3 * seed;
      const auto   pairs = pairs_within(cells, reach, 40);
      ASSERT_GT(pairs.size(), 50u);

      // with a skin so thin that it cannot make up for an error
      const NeighborList list = list_of_all(reach, 1e-9, cells);
      EXPECT_EQ(missed_pairs(list, pairs), Pairs());
      EXPECT_LT(list.n_pairs(), 80u * 79u);
    }
}



TEST(NeighborList, MissesNoPairAfterRandomMovesOfHalfASkin)
{
  for (unsigned int seed = 0; seed < 5; ++seed)
    {
      std::mt19937 random(seed);
      Cells        cells = random_curved_cells(80, 4., random);
      const double reach = 0.2, skin = 0.8;
      const Pairs  pairs_before = pairs_within(cells, reach, 40);

      const NeighborList list = list_of_all(reach, skin, cells);

      // half of the cells move as a whole, so that pairs do approach each
      // other; the control points of the others move on their own
      for (unsigned int i = 0; i < cells.size(); ++i)
        {
          Tensor<1, 3> move = random_direction(random);
          for (auto &point : cells[i])
            {
              if (i % 2 == 1)
                move = random_direction(random);
              point += (1. - 1e-10) * skin / 2. * move;
            }
        }
      ASSERT_FALSE(list.needs_rebuild(cells));

      const Pairs pairs = pairs_within(cells, reach, 40);
      ASSERT_NE(pairs, pairs_before);
      EXPECT_EQ(missed_pairs(list, pairs), Pairs());
    }
}



// Two cells that lie such that the bound R + s is attained, and beyond it by
// a little, in directions along and across the axes.
TEST(NeighborList, FindsExactlyThePairsWithinReachPlusSkin)
{
  const double reach = 1., skin = 0.5;
  std::mt19937 random(7);
  for (unsigned int trial = 0; trial < 100; ++trial)
    {
      Tensor<1, 3> n = random_direction(random);
      if (trial < 3)
        {
          n        = Tensor<1, 3>();
          n[trial] = 1.;
        }
      Tensor<1, 3> u = dealii::cross_product_3d(n, random_direction(random));
      Tensor<1, 3> v = dealii::cross_product_3d(n, random_direction(random));
      u *= 5. / u.norm();
      v *= 0.5 / v.norm();

      const auto cells_at = [&](const double distance) -> Cells {
        return {straight_cell(-u, u),
                straight_cell(distance * n - v, distance * n + v)};
      };
      const double bound = reach + skin;
      EXPECT_EQ(
        list_of_all(reach, skin, cells_at(bound * (1. - 1e-12))).n_pairs(), 2u);
      EXPECT_EQ(
        list_of_all(reach, skin, cells_at(bound * (1. + 1e-12))).n_pairs(), 0u);
    }
}



TEST(NeighborList, MissesNoPairOfDegenerateCells)
{
  // points, closed loops, doubled and crossing cells, without a direction
  // that connects the chords
  const Tensor<1, 3> o, x({1., 0., 0.}), y({0., 1., 0.}), z({0., 0., 1.});
  const Cells        cells{{{o, o, o, o}},
                    {{o, x, y, o}},
                    {{o, 3. * x, 3. * z, o}},
                    straight_cell(o, x),
                    straight_cell(o, x),
                    straight_cell(-1. * x, x),
                    straight_cell(-1. * y, y),
                    {{0.3 * z, 0.3 * z, 0.3 * z, 0.3 * z}},
                    straight_cell(2. * x, 4. * x),
                    straight_cell(1.2 * x, 1e6 * x)};
  for (const double reach : {1e-6, 0.25, 1.5})
    EXPECT_EQ(missed_pairs(list_of_all(reach, 1e-9, cells),
                           pairs_within(cells, reach, 100)),
              Pairs());
}



TEST(NeighborList, NeedsRebuildOnlyBeyondHalfOfTheSkin)
{
  std::mt19937       random(3);
  const Cells        cells = random_curved_cells(10, 5., random);
  const double       skin  = 0.4;
  const NeighborList list  = list_of_all(1., skin, cells);
  EXPECT_FALSE(list.needs_rebuild(cells));

  for (unsigned int i = 0; i < cells.size(); ++i)
    for (unsigned int k = 0; k < 4; ++k)
      {
        const Tensor<1, 3> direction = random_direction(random);
        Cells              moved     = cells;
        moved[i][k] = cells[i][k] + (1. - 1e-12) * skin / 2. * direction;
        EXPECT_FALSE(list.needs_rebuild(moved));
        moved[i][k] = cells[i][k] + (1. + 1e-12) * skin / 2. * direction;
        EXPECT_TRUE(list.needs_rebuild(moved));
      }
}



TEST(NeighborList, MeasuresMotionFromTheLastBuild)
{
  Cells        cells{straight_cell({}, Tensor<1, 3>({1., 0., 0.}))};
  NeighborList list(1., 1.);
  EXPECT_TRUE(list.needs_rebuild(cells));
  EXPECT_EQ(list.n_builds(), 0u);
  list.build(cells, {0}, {0}, different);
  EXPECT_EQ(list.n_builds(), 1u);

  // steps that are small one by one add up
  for (unsigned int step = 1; step <= 3; ++step)
    {
      for (auto &point : cells[0])
        point[1] += 0.2;
      EXPECT_EQ(list.needs_rebuild(cells), step == 3);
    }
  list.build(cells, {0}, {0}, different);
  EXPECT_FALSE(list.needs_rebuild(cells));
  EXPECT_EQ(list.n_builds(), 2u);

  cells.push_back(cells[0]);
  EXPECT_TRUE(list.needs_rebuild(cells));
}



TEST(NeighborList, ListsOnlySourcesTargetsAndAdmissiblePairs)
{
  std::mt19937                    random(11);
  const Cells                     cells = random_curved_cells(60, 3., random);
  const std::vector<unsigned int> sources{41, 3, 7, 59, 20};
  const std::vector<unsigned int> targets{50, 3, 8, 9, 30, 20, 0};
  const auto odd_sum = [](const unsigned int s, const unsigned int t) {
    return (s + t) % 2 == 1;
  };

  // everything is within reach, so the list is known
  NeighborList list(100., 1.);
  list.build(cells, sources, targets, odd_sum);
  Pairs expected;
  for (const unsigned int s : sources)
    for (const unsigned int t : targets)
      if (odd_sum(s, t))
        expected.emplace(s, t);
  EXPECT_EQ(list.sources(), sources);
  EXPECT_EQ(listed_pairs(list), expected);
  EXPECT_EQ(list.n_pairs(), expected.size());
}



TEST(NeighborList, IsReplacedByARebuild)
{
  std::mt19937                    random(13);
  const Cells                     before = random_curved_cells(70, 4., random);
  const Cells                     after  = random_curved_cells(60, 4., random);
  const std::vector<unsigned int> sources{41, 3, 7, 59, 20};

  NeighborList fresh(0.5, 0.1), rebuilt(0.5, 0.1);
  fresh.build(after, sources, all_indices(60), different);
  rebuilt.build(before, all_indices(70), all_indices(70), different);
  rebuilt.build(after, sources, all_indices(60), different);

  ASSERT_GT(fresh.n_pairs(), 20u);
  EXPECT_EQ(rebuilt.n_pairs(), fresh.n_pairs());
  EXPECT_EQ(rebuilt.sources(), fresh.sources());
  EXPECT_EQ(listed_pairs(rebuilt), listed_pairs(fresh));
}



TEST(NeighborList, ListsTheCellItselfIfAdmissible)
{
  const Cells  cells{straight_cell({}, Tensor<1, 3>({1., 0., 0.}))};
  NeighborList list(1., 1.);
  list.build(cells, {0}, {0}, [](unsigned int, unsigned int) { return true; });
  EXPECT_EQ(listed_pairs(list), (Pairs{{0, 0}}));
}



TEST(NeighborList, IsSortedAndIndependentOfTheOrderOfTargets)
{
  std::mt19937              random(5);
  const Cells               cells   = random_curved_cells(200, 10., random);
  const auto                sources = all_indices(200);
  std::vector<unsigned int> targets = all_indices(200);

  NeighborList first(0.5, 0.1), second(0.5, 0.1);
  first.build(cells, sources, targets, different);
  std::shuffle(targets.begin(), targets.end(), random);
  second.build(cells, sources, targets, different);
  second.build(cells, sources, targets, different);

  ASSERT_GT(first.n_pairs(), 400u);
  for (unsigned int i = 0; i < sources.size(); ++i)
    {
      const auto a = first.targets(i), b = second.targets(i);
      EXPECT_TRUE(std::is_sorted(a.begin(), a.end()));
      EXPECT_TRUE(std::equal(a.begin(), a.end(), b.begin(), b.end()));
    }
}



TEST(NeighborList, WithoutEndOfTheReachHasAllPairsForever)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::mt19937     random(6);
  const Cells      cells = random_curved_cells(20, 1e6, random);

  NeighborList list(infinity, infinity);
  list.build(cells, all_indices(20), all_indices(20), different);
  EXPECT_EQ(list.n_pairs(), 20u * 19u);
  EXPECT_FALSE(list.needs_rebuild(random_curved_cells(20, 1., random)));
}



TEST(NeighborList, TakesEmptyInput)
{
  NeighborList list(1., 1.);
  EXPECT_EQ(list.n_pairs(), 0u);
  EXPECT_TRUE(list.needs_rebuild({}));
  list.build({}, {}, {}, different);
  EXPECT_FALSE(list.needs_rebuild({}));
  EXPECT_EQ(list.n_pairs(), 0u);
  EXPECT_TRUE(list.sources().empty());

  const Cells cells{straight_cell({}, Tensor<1, 3>({1., 0., 0.})),
                    straight_cell({}, Tensor<1, 3>({0., 1., 0.}))};
  list.build(cells, {0, 1}, {}, different);
  EXPECT_EQ(list.targets(0).size(), 0u);
  EXPECT_EQ(list.targets(1).size(), 0u);
  list.build(cells, {}, {0, 1}, different);
  EXPECT_EQ(list.n_pairs(), 0u);
  list.build(cells, {0, 1}, {0, 1}, different);
  EXPECT_EQ(list.n_pairs(), 2u);
}



TEST(NeighborList, RejectsInvalidInput)
{
  EXPECT_THROW(NeighborList(-1., 1.), NeighborList::ExcInvalidRange);
  EXPECT_THROW(NeighborList(1., 0.), NeighborList::ExcInvalidRange);
  EXPECT_THROW(NeighborList(std::nan(""), 1.), NeighborList::ExcInvalidRange);

  Cells        cells{straight_cell({}, Tensor<1, 3>({1., 0., 0.}))};
  NeighborList list(1., 1.);
  list.build(cells, {0}, {0}, different);
  cells[0][2][1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(list.needs_rebuild(cells));
  EXPECT_THROW(list.build(cells, {0}, {0}, different),
               NeighborList::ExcNotFinite);
}



// Long cells across the axes, for which boxes alone would list many more.
TEST(NeighborList, ListsExactlyThePairsOfStraightCells)
{
  std::mt19937 random(2);
  const double reach = 0.3, skin = 0.1;
  const Cells  cells = random_straight_cells(200, 10., 15., random);

  Pairs        pairs;
  unsigned int n_pairs_of_boxes = 0;
  for (unsigned int i = 0; i < cells.size(); ++i)
    for (unsigned int j = 0; j < i; ++j)
      {
        if (distance_of_straight_cells(cells[i], cells[j]) <= reach + skin)
          {
            pairs.emplace(i, j);
            pairs.emplace(j, i);
          }
        if (distance_square(bounding_box(cells[i]), bounding_box(cells[j])) <=
            (reach + skin) * (reach + skin))
          n_pairs_of_boxes += 2;
      }
  ASSERT_GT(pairs.size(), 100u);
  ASSERT_GT(n_pairs_of_boxes, 5 * pairs.size());

  EXPECT_EQ(listed_pairs(list_of_all(reach, skin, cells)), pairs);
}



TEST(NeighborList, ListsFewMoreThanTheExactPairsOfBentCells)
{
  std::mt19937 random(4);
  const double reach = 0.3, skin = 0.1;
  Cells        cells = random_straight_cells(150, 2., 5., random);
  for (auto &cell : cells)
    for (const unsigned int k : {1, 2})
      cell[k] += 0.2 * random_direction(random);
  const Pairs pairs = pairs_within(cells, reach + skin, 50);
  ASSERT_GT(pairs.size(), 100u);

  EXPECT_LE(list_of_all(reach, skin, cells).n_pairs(), 2 * pairs.size());
}
