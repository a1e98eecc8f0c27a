// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

// The cost of energy, residual and tangent matrix of one pair of cells as in
// the peeling of two adhesive fibers: 20 sites on each cell, Lennard-Jones,
// nearly parallel at the equilibrium gap. The derivatives by hand must be at
// least ten times faster than those of nested Sacado numbers, which the
// benchmarks `speedup` measure side by side.

#include <deal.II/base/quadrature_lib.h>

#include <benchmark/benchmark.h>

#include <setae/interactions/section_beam.h>
#include <setae/interactions/section_section.h>
#include <setae/laws/disk_cylinder.h>
#include <setae/laws/disk_disk.h>
#include <setae/laws/lennard_jones.h>
#include <setae/laws/tabulated_disk_cylinder.h>

#include <ctime>
#include <type_traits>
#include <vector>

#include "../../tests/nested_sacado.h"

using namespace Setae;

namespace
{
  constexpr double       radius       = 0.02;
  constexpr double       gap          = 1e-3;
  constexpr double       length       = 5. / 64.;
  constexpr unsigned int n_sites      = 20;
  constexpr double       sum_of_radii = 2. * radius;

  constexpr SectionPair sections = {radius, radius, 1., 1.};
  constexpr GapRange    range    = {0., 0.08, 0.1};

  using Fad = NestedFad<24>;

  /** A cell beside the x-axis, longer at both ends by @p excess. */
  HermiteCell<>
  slightly_bent_cell(const double y, const double bend, const double excess)
  {
    const Tensor<1, 3> begin({-excess, y, 0.}), end({length + excess, y, 0.});
    const Tensor<1, 3> t1({1., bend, 0.}), t2({1., -bend, .5 * bend});
    return {{{begin, t1, end, t2}}, length + 2. * excess};
  }

  struct CellPair
  {
    /** The target is long enough for every site of the source to project on. */
    CellPair()
      : source(slightly_bent_cell(sum_of_radii + gap, .02, 0.))
      , target(slightly_bent_cell(0., .01, .05 * length))
    {
      const dealii::QGauss<1> rule(n_sites);
      evaluate_sites(rule, source, source, source_sites);
      evaluate_sites(rule, target, target, target_sites);
    }

    HermiteCell<>         source, target;
    std::vector<LineSite> source_sites, target_sites;

    /** Source or target with its 12 of the 24 coefficients as variables. */
    static HermiteCell<Fad>
    on_fad(const HermiteCell<> &cell, const unsigned int first)
    {
      HermiteCell<Fad> result;
      result.h = cell.h;
      for (unsigned int a = 0; a < 4; ++a)
        for (unsigned int c = 0; c < 3; ++c)
          result.coefficients[a][c] =
            variable<24>(first + 3 * a + c, cell.coefficients[a][c]);
      return result;
    }
  };



  /** All sites of the source with the target at a place of its fiber. */
  template <typename Law>
  void
  add_sites(const SectionBeam<Law> &interaction,
            const CellPair         &cells,
            const CellPlace        &place,
            const Request           request,
            LocalSystem<24>        &local)
  {
    local.reset(request);
    for (const LineSite &site : cells.source_sites)
      interaction.add(site, cells.target, place, site.weight, request, local);
    if (request >= Request::tangent)
      local.symmetrize();
  }



  /** One integral over the source. */
  template <typename Law>
  struct SectionsOf
  {
    static constexpr unsigned int n_points = n_sites;

    static Law
    law()
    {
      const PointPotential potential =
        lennard_jones_of_cylinders(gap, -0.1, sections);
      if constexpr (std::is_same_v<Law, TabulatedDiskCylinder>)
        return Law(potential, sections, range, {});
      else
        return Law(potential, sections, range);
    }

    SectionBeam<Law> interaction{law(), sum_of_radii};

    void
    by_hand(const CellPair  &cells,
            const Request    request,
            LocalSystem<24> &local) const
    {
      add_sites(interaction, cells, {}, request, local);
    }

    LocalSystem<24>
    by_sacado(const CellPair &cells) const
    {
      const auto source = CellPair::on_fad(cells.source, 0);
      const auto target = CellPair::on_fad(cells.target, 12);
      Fad        energy = 0.;
      for (const LineSite &site : cells.source_sites)
        for (const Projection &projection :
             closest_points(cells.target, site.r, {}))
          energy += site.weight * interaction.energy(source.combine(site.N),
                                                     source.combine(site.N_x),
                                                     target,
                                                     projection);
      return local_system<24>(energy);
    }
  };



  using Sections          = SectionsOf<DiskCylinder>;
  using TabulatedSections = SectionsOf<TabulatedDiskCylinder>;



  /** One integral over the source next to an end of the target. */
  template <typename End>
  struct SectionsNear
  {
    using Law = TabulatedDiskCylinder;

    static constexpr unsigned int n_points = n_sites;

    static SectionBeam<Law>
    make_interaction()
    {
      const Law                       law = TabulatedSections::law();
      std::vector<typename End::Term> terms;
      const PointPotential            potential =
        lennard_jones_of_cylinders(gap, -0.1, sections);
      for (unsigned int i = 0; i < potential.size(); ++i)
        {
          if constexpr (std::is_same_v<End, FadedTarget<Law>>)
            terms.push_back({law.single_power(i),
                             FadingFraction(potential[i].exponent, sections)});
          else
            terms.push_back(
              {law.single_power(i),
               EndFraction(potential[i].exponent, sections, range),
               FlatEnd(potential[i], sections, range)});
        }
      if constexpr (std::is_same_v<End, FadedTarget<Law>>)
        return {law, sum_of_radii, End(sum_of_radii, terms)};
      else
        return {law, sum_of_radii, End(terms)};
    }

    SectionBeam<Law> interaction = make_interaction();
    CellPlace place = {{true, false}, sum_of_radii, 1., length, 1. + length};

    void
    by_hand(const CellPair  &cells,
            const Request    request,
            LocalSystem<24> &local) const
    {
      add_sites(interaction, cells, place, request, local);
    }
  };

  using SectionsBeforeAnEnd = SectionsNear<TargetEnd<TabulatedDiskCylinder>>;
  using SectionsBeforeAFadingTarget =
    SectionsNear<FadedTarget<TabulatedDiskCylinder>>;



  /** A double integral. */
  struct PairsOfSections
  {
    static constexpr unsigned int n_points = n_sites * n_sites;

    SectionSection<DiskDisk> interaction{
      DiskDisk(lennard_jones_of_cylinders(gap, -0.1, sections),
               sections,
               range),
      sum_of_radii};

    void
    by_hand(const CellPair  &cells,
            const Request    request,
            LocalSystem<24> &local) const
    {
      local.reset(request);
      for (const LineSite &site : cells.source_sites)
        interaction.add(site, cells.target_sites, 1., request, local);
      if (request >= Request::tangent)
        local.symmetrize();
    }

    LocalSystem<24>
    by_sacado(const CellPair &cells) const
    {
      const auto source = CellPair::on_fad(cells.source, 0);
      const auto target = CellPair::on_fad(cells.target, 12);

      std::vector<Tensor<1, 3, Fad>> targets;
      for (const LineSite &site : cells.target_sites)
        targets.push_back(target.combine(site.N));

      Fad energy = 0.;
      for (const LineSite &site : cells.source_sites)
        {
          const Tensor<1, 3, Fad> r1 = source.combine(site.N);
          for (unsigned int q = 0; q < targets.size(); ++q)
            energy += (site.weight * cells.target_sites[q].weight) *
                      interaction.energy(r1, targets[q]);
        }
      return local_system<24>(energy);
    }
  };



  /** Processor time, which other programs do not disturb. */
  double
  seconds()
  {
    return double(std::clock()) / CLOCKS_PER_SEC;
  }



  template <typename Interaction>
  void
  by_hand(benchmark::State &state)
  {
    const Interaction interaction;
    const CellPair    cells;
    const Request     request = static_cast<Request>(state.range(0));
    LocalSystem<24>   local;
    for (auto _ : state)
      {
        interaction.by_hand(cells, request, local);
        benchmark::DoNotOptimize(local);
      }
    state.counters["per_point"] =
      benchmark::Counter(double(state.iterations()) * Interaction::n_points,
                         benchmark::Counter::kIsRate |
                           benchmark::Counter::kInvert);
  }



  /** The time of the table of a Lennard-Jones potential, in seconds. */
  void
  build_table(benchmark::State &state)
  {
    for (auto _ : state)
      benchmark::DoNotOptimize(TabulatedSections::law());
  }



  /** Becomes the exit status: Google Benchmark itself only prints an error. */
  bool is_fast_enough = true;

  /** Both in turn, so that a machine that slows down slows down both. */
  template <typename Interaction>
  void
  speedup(benchmark::State &state)
  {
    constexpr unsigned int n_by_hand      = 100;
    constexpr double       smallest_ratio = 10.;

    const Interaction interaction;
    const CellPair    cells;
    LocalSystem<24>   local;
    double            time_by_hand = 0., time_by_sacado = 0.;
    for (auto _ : state)
      {
        const double start = seconds();
        for (unsigned int i = 0; i < n_by_hand; ++i)
          {
            interaction.by_hand(cells, Request::tangent, local);
            benchmark::DoNotOptimize(local);
          }
        const double middle = seconds();
        benchmark::DoNotOptimize(interaction.by_sacado(cells));
        time_by_hand += (middle - start) / n_by_hand;
        time_by_sacado += seconds() - middle;
      }

    const double n = double(state.iterations()) * Interaction::n_points;
    state.counters["by_hand_ns"]   = 1e9 * time_by_hand / n;
    state.counters["by_sacado_ns"] = 1e9 * time_by_sacado / n;
    state.counters["ratio"]        = time_by_sacado / time_by_hand;
    if (time_by_sacado < smallest_ratio * time_by_hand)
      {
        is_fast_enough = false;
        state.SkipWithError("By hand must be ten times faster than Sacado.");
      }
  }

  /** The law that is right at every angle against the one of the paper. */
  void
  cost_of_tilt(benchmark::State &state)
  {
    constexpr unsigned int n_times       = 100;
    constexpr double       largest_ratio = 2.;

    const Sections          sections;
    const TabulatedSections tabulated;
    const CellPair          cells;
    LocalSystem<24>         local;
    double                  time = 0., time_tabulated = 0.;
    for (auto _ : state)
      {
        const double start = seconds();
        for (unsigned int i = 0; i < n_times; ++i)
          {
            sections.by_hand(cells, Request::tangent, local);
            benchmark::DoNotOptimize(local);
          }
        const double middle = seconds();
        for (unsigned int i = 0; i < n_times; ++i)
          {
            tabulated.by_hand(cells, Request::tangent, local);
            benchmark::DoNotOptimize(local);
          }
        time += middle - start;
        time_tabulated += seconds() - middle;
      }
    state.counters["ratio"] = time_tabulated / time;
    if (time_tabulated > largest_ratio * time)
      {
        is_fast_enough = false;
        state.SkipWithError("A tabulated law may cost twice as much at most.");
      }
  }
} // namespace

// request: 0 energy, 1 with residual, 2 with tangent matrix

BENCHMARK_TEMPLATE(by_hand, Sections)
  ->Name("SectionBeam/by_hand")
  ->ArgName("request")
  ->DenseRange(0, 2);

BENCHMARK_TEMPLATE(by_hand, TabulatedSections)
  ->Name("SectionBeam/tabulated")
  ->ArgName("request")
  ->DenseRange(0, 2);

BENCHMARK_TEMPLATE(by_hand, SectionsBeforeAFadingTarget)
  ->Name("SectionBeam/fading_target")
  ->ArgName("request")
  ->DenseRange(0, 2);

BENCHMARK_TEMPLATE(by_hand, SectionsBeforeAnEnd)
  ->Name("SectionBeam/end_of_target")
  ->ArgName("request")
  ->DenseRange(0, 2);

BENCHMARK(cost_of_tilt)
  ->Name("SectionBeam/cost_of_tilt")
  ->Unit(benchmark::kMillisecond);

BENCHMARK(build_table)
  ->Name("TabulatedDiskCylinder/build")
  ->Unit(benchmark::kMillisecond);

BENCHMARK_TEMPLATE(by_hand, PairsOfSections)
  ->Name("SectionSection/by_hand")
  ->ArgName("request")
  ->DenseRange(0, 2);

BENCHMARK_TEMPLATE(speedup, Sections)
  ->Name("SectionBeam/speedup")
  ->Unit(benchmark::kMillisecond);

BENCHMARK_TEMPLATE(speedup, PairsOfSections)
  ->Name("SectionSection/speedup")
  ->Unit(benchmark::kMillisecond);

int
main(int argc, char **argv)
{
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  return is_fast_enough ? 0 : 1;
}
