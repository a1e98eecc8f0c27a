// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <gtest/gtest.h>

#include <setae/far_field/cluster_tree.h>

#include <algorithm>
#include <map>
#include <random>

using namespace Setae;

namespace
{
  /** Straight chains of one to five cells at random, and their tree. */
  struct Scene
  {
    explicit Scene(const unsigned int n_chains)
    {
      std::mt19937                           random(n_chains);
      std::uniform_real_distribution<double> uniform(0., 10.);
      for (unsigned int f = 0; f < n_chains; ++f)
        {
          Tensor<1, 3> start;
          for (unsigned int c = 0; c < 3; ++c)
            start[c] = uniform(random);
          const unsigned int n_cells = 1 + f % 5;
          chains.push_back({static_cast<unsigned int>(cells.size()), n_cells});
          for (unsigned int i = 0; i < n_cells; ++i)
            {
              ClusterTree::ControlPoints points;
              for (unsigned int k = 0; k < 4; ++k)
                {
                  points[k] = start;
                  points[k][f % 3] += i + k / 3.;
                }
              cells.push_back(points);
              chain_of_cell.push_back(f);
            }
        }
      tree.clear(cells.size());
    }

    unsigned int
    add(const std::vector<unsigned int> &members)
    {
      return tree.add_tree(cells, chains, members);
    }

    /** How often each two cells meet, far or near. */
    std::map<std::pair<unsigned int, unsigned int>, unsigned int>
    count(const ClusterTree::Pairs &pairs) const
    {
      std::map<std::pair<unsigned int, unsigned int>, unsigned int> result;
      for (const auto *list : {&pairs.far, &pairs.near})
        for (const auto &[A, B] : *list)
          for (const unsigned int a : cells_of(A))
            for (const unsigned int b : cells_of(B))
              ++result[{std::min(a, b), std::max(a, b)}];
      return result;
    }

    std::vector<unsigned int>
    cells_of(const unsigned int cluster) const
    {
      std::vector<unsigned int> result;
      for (unsigned int cell = 0; cell < cells.size(); ++cell)
        for (unsigned int i = tree.cluster_of_cell[cell];
             i != ClusterTree::none;
             i = tree.clusters[i].parent)
          if (i == cluster)
            result.push_back(cell);
      return result;
    }

    ClusterTree::Predicate
    separated() const
    {
      return [this](const unsigned int A, const unsigned int B) {
        const auto &a = tree.clusters[A], &b = tree.clusters[B];
        return (a.center - b.center).norm() > 2. * (a.radius + b.radius);
      };
    }

    std::vector<ClusterTree::ControlPoints> cells;
    std::vector<ClusterTree::Chain>         chains;
    std::vector<unsigned int>               chain_of_cell;
    ClusterTree                             tree;
  };

  std::vector<unsigned int>
  range(const unsigned int begin, const unsigned int end)
  {
    std::vector<unsigned int> result;
    for (unsigned int i = begin; i < end; ++i)
      result.push_back(i);
    return result;
  }
} // namespace



TEST(ClusterTree, LetsEachTwoCellsOfDifferentChainsMeetOnce)
{
  Scene              scene(40);
  const unsigned int root = scene.add(range(0, 40));
  ClusterTree::Pairs pairs;
  scene.tree.find_pairs(root, root, false, scene.separated(), pairs);
  EXPECT_GT(pairs.far.size(), 10u);
  EXPECT_GT(pairs.near.size(), 10u);

  const auto   met      = scene.count(pairs);
  unsigned int expected = 0;
  for (unsigned int a = 0; a < scene.cells.size(); ++a)
    for (unsigned int b = 0; b < a; ++b)
      if (scene.chain_of_cell[a] != scene.chain_of_cell[b])
        {
          ++expected;
          const auto it = met.find({b, a});
          ASSERT_NE(it, met.end());
          EXPECT_EQ(it->second, 1u);
        }
  EXPECT_EQ(met.size(), expected);
}

TEST(ClusterTree, LetsTheCellsOfAChainMeetIfAsked)
{
  Scene              scene(5); // the last has five cells
  const unsigned int root = scene.add({4});
  ClusterTree::Pairs pairs;
  scene.tree.find_pairs(root, root, true, scene.separated(), pairs);
  const auto met = scene.count(pairs);
  EXPECT_EQ(met.size(), 10u);
  for (const auto &[cells, times] : met)
    EXPECT_EQ(times, 1u);
}

TEST(ClusterTree, LetsTwoGroupsMeetButNotTheirOwnMembers)
{
  Scene              scene(20);
  const unsigned int first  = scene.add(range(0, 12)),
                     second = scene.add(range(12, 20));
  ClusterTree::Pairs pairs;
  scene.tree.find_pairs(first, second, true, scene.separated(), pairs);
  unsigned int n_first = 0, n_second = 0;
  for (const unsigned int chain : scene.chain_of_cell)
    ++(chain < 12 ? n_first : n_second);
  const auto met = scene.count(pairs);
  EXPECT_EQ(met.size(), n_first * n_second);
  for (const auto &[cells, times] : met)
    {
      EXPECT_EQ(times, 1u);
      EXPECT_NE(scene.chain_of_cell[cells.first] < 12,
                scene.chain_of_cell[cells.second] < 12);
    }
}

TEST(ClusterTree, EnclosesItsCellsAndPutsParentsFirst)
{
  Scene scene(30);
  scene.add(range(0, 30));
  for (unsigned int i = 0; i < scene.tree.clusters.size(); ++i)
    {
      const auto &cluster = scene.tree.clusters[i];
      EXPECT_TRUE(cluster.parent == ClusterTree::none || cluster.parent < i);
      for (const unsigned int cell : scene.cells_of(i))
        for (const auto &point : scene.cells[cell])
          EXPECT_LE((point - cluster.center).norm(),
                    cluster.radius * (1. + 1e-14));
    }
}
