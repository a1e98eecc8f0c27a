// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

// The cost of the pair search over the number of cells at constant density:
// building the list must cost n log n, asking whether it is still valid n.

#include <benchmark/benchmark.h>

#include <setae/search/neighbor_list.h>

#include <array>
#include <cmath>
#include <numeric>
#include <random>
#include <vector>

using namespace Setae;

namespace
{
  constexpr unsigned int cells_per_fiber = 10;
  constexpr double       reach           = 0.8;
  constexpr double       skin            = 0.2;

  /**
   * Wavy fibers in a column with walls that turn them back, so that the density
   * is the same everywhere: one cell of length 1 per unit of volume. The column
   * grows in length only, because in a cube the cells at the surface, which
   * have fewer partners, would become fewer and blur the complexity.
   */
  std::vector<NeighborList::ControlPoints>
  wavy_fibers(const unsigned int n_cells)
  {
    const std::array<double, 3>            edges{{5., 5., n_cells / 25.}};
    std::mt19937                           random(1);
    std::uniform_real_distribution<double> coordinate(0., 1.);
    std::normal_distribution<double>       normal;

    std::vector<NeighborList::ControlPoints> cells;
    cells.reserve(n_cells);
    Tensor<1, 3> position, tangent;
    while (cells.size() < n_cells)
      {
        if (cells.size() % cells_per_fiber == 0)
          for (unsigned int c = 0; c < 3; ++c)
            {
              position[c] = edges[c] * coordinate(random);
              tangent[c]  = normal(random);
            }
        tangent /= tangent.norm();

        const Tensor<1, 3> begin = position, tangent_at_begin = tangent;
        for (unsigned int c = 0; c < 3; ++c)
          {
            tangent[c] += 0.1 * normal(random);
            if (position[c] < 0.)
              tangent[c] = std::abs(tangent[c]);
            else if (position[c] > edges[c])
              tangent[c] = -std::abs(tangent[c]);
          }
        tangent /= tangent.norm();
        position += 0.5 * (tangent_at_begin + tangent);
        cells.push_back({{begin,
                          begin + (1. / 3.) * tangent_at_begin,
                          position - (1. / 3.) * tangent,
                          position}});
      }
    return cells;
  }

  std::vector<unsigned int>
  all_indices(const unsigned int n)
  {
    std::vector<unsigned int> indices(n);
    std::iota(indices.begin(), indices.end(), 0);
    return indices;
  }

  /** Every pair of cells of different fibers once. */
  bool
  different_fibers(const unsigned int source, const unsigned int target)
  {
    return source / cells_per_fiber < target / cells_per_fiber;
  }

  /** The time of one iteration divided by @p work. */
  benchmark::Counter
  time_per(const double work)
  {
    using benchmark::Counter;
    return Counter(work, Counter::kIsIterationInvariantRate | Counter::kInvert);
  }

  void
  build(benchmark::State &state)
  {
    const double n       = state.range(0);
    const auto   cells   = wavy_fibers(state.range(0));
    const auto   indices = all_indices(state.range(0));
    NeighborList list(reach, skin);
    for (auto _ : state)
      {
        list.build(cells, indices, indices, different_fibers);
        benchmark::DoNotOptimize(list.n_pairs());
      }
    state.SetComplexityN(state.range(0));
    state.counters["pairs_per_cell"]    = list.n_pairs() / n;
    state.counters["time_per_cell"]     = time_per(n);
    state.counters["time_per_n_log2_n"] = time_per(n * std::log2(n));
  }

  void
  needs_rebuild(benchmark::State &state)
  {
    const auto   cells   = wavy_fibers(state.range(0));
    const auto   indices = all_indices(state.range(0));
    NeighborList list(reach, skin);
    list.build(cells, indices, indices, different_fibers);
    for (auto _ : state)
      benchmark::DoNotOptimize(list.needs_rebuild(cells));
    state.SetComplexityN(state.range(0));
    state.counters["time_per_cell"] = time_per(state.range(0));
  }
} // namespace

BENCHMARK(build)
  ->Name("NeighborList/build")
  ->RangeMultiplier(10)
  ->Range(100, 100000)
  ->Unit(benchmark::kMillisecond)
  ->Complexity(benchmark::oNLogN);

BENCHMARK(needs_rebuild)
  ->Name("NeighborList/needs_rebuild")
  ->RangeMultiplier(10)
  ->Range(100, 100000)
  ->Unit(benchmark::kMillisecond)
  ->Complexity(benchmark::oN);

BENCHMARK_MAIN();
