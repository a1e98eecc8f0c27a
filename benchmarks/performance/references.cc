// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

// The time that one reference takes, over gap (arguments: exponent m and the
// negative decimal logarithm of gap over radius). Published six-dimensional
// quadrature took hours at a two-hundredth of the radius.

#include <benchmark/benchmark.h>

#include <setae/verification/charged_surfaces.h>
#include <setae/verification/disk_cylinder.h>

#include <cmath>
#include <limits>

using namespace Setae;
using namespace Setae::References;
using dealii::Tensor;

namespace
{
  constexpr SectionPair sections = {1., .7, 1., 1.};
  constexpr double      infinity = std::numeric_limits<double>::infinity();

  const Disk         first = {Tensor<1, 3>(), Tensor<1, 3>({0., 0., 1.})};
  const Tensor<1, 3> leaning({.6, 0., .8});

  Tensor<1, 3>
  beside(const double gap, const double z = 0.)
  {
    return Tensor<1, 3>({1.7 + gap, 0., z});
  }

  template <typename Reference>
  void
  add(const std::string &name, const Reference &reference)
  {
    auto *entry = benchmark::RegisterBenchmark(
      name.c_str(), [reference](benchmark::State &state) {
        const InversePower power = {static_cast<unsigned int>(state.range(0)),
                                    1.};
        const double       gap   = std::pow(10., -state.range(1));
        for (auto _ : state)
          benchmark::DoNotOptimize(reference(power, gap));
      });
    for (const int m : {6, 12})
      for (const int digits : {0, 3, 6})
        entry->Args({m, digits});
    entry->Unit(benchmark::kMillisecond)->MinTime(.01);
  }
} // namespace



int
main(int argc, char *argv[])
{
  using Power = InversePower;
  add("coplanar_disks", [](const Power &power, const double gap) {
    return coplanar_disks(power, sections, gap);
  });
  add("offset_disks", [](const Power &power, const double gap) {
    return offset_disks(power, sections, gap, .1);
  });
  add("disks/parallel", [](const Power &power, const double gap) {
    return disks(power,
                 sections,
                 first,
                 {beside(gap), first.normal},
                 Tensor<1, 3>({-1., 0., 0.}));
  });
  add("disks/rolled", [](const Power &power, const double gap) {
    return disks(power,
                 sections,
                 first,
                 {beside(gap), Tensor<1, 3>({0., .6, .8})},
                 Tensor<1, 3>({-1., 0., 0.}));
  });
  // Their planes are turned by 1e-4, face to face or partly so.
  for (const double displacement : {0., .5})
    add(displacement == 0. ? "disks/almost_facing" : "disks/partly_facing",
        [=](const Power &power, const double gap) {
          const double turn = 1e-4;
          return disks(
            power,
            sections,
            first,
            {Tensor<1, 3>(
               {displacement, 0., gap + sections.radius_2 * std::sin(turn)}),
             Tensor<1, 3>({std::sin(turn), 0., std::cos(turn)})},
            Tensor<1, 3>({0., .6, -.8}));
        });
  add("disk_and_cylinder/tilted", [](const Power &power, const double gap) {
    return disk_and_cylinder(power, sections, {gap, .6, .48});
  });
  add("disk_and_half_cylinder/beside",
      [](const Power &power, const double gap) {
        return energy_of_disk_and_cylinder(power,
                                           sections,
                                           Disk{beside(gap, -.1), first.normal},
                                           Interval{-infinity, 0.});
      });
  add("disk_and_half_cylinder/leaning",
      [](const Power &power, const double gap) {
        return energy_of_disk_and_cylinder(power,
                                           sections,
                                           Disk{beside(gap, -.1), leaning},
                                           Interval{-infinity, 0.});
      });
  add("disk_and_half_cylinder/facing",
      [](const Power &power, const double gap) {
        return energy_of_disk_and_cylinder(power,
                                           sections,
                                           Disk{Tensor<1, 3>({0., 0., gap}),
                                                first.normal},
                                           Interval{-infinity, 0.});
      });
  add("parallel_cylinders", [](const Power &power, const double gap) {
    return parallel_cylinders(power, sections, gap);
  });
  add("crossing_cylinders", [](const Power &power, const double gap) {
    return crossing_cylinders(power, sections, gap, 1.);
  });
  add("crossing_half_cylinder", [](const Power &power, const double gap) {
    return crossing_half_cylinder(power, sections, gap, 1., .1);
  });
  add("pointing_half_cylinder", [](const Power &power, const double gap) {
    return pointing_half_cylinder(power, sections, gap);
  });
  add("finite_parallel_cylinders", [](const Power &power, const double gap) {
    return finite_parallel_cylinders(power, sections, gap, {50., 40., 20.})
      .energy.value;
  });
  add("parallel_surfaces/coulomb", [](const Power &, const double gap) {
    return energy_of_parallel_surfaces({1, 1.}, sections, gap, {50., 40., 20.});
  });
  add("crossing_surfaces/coulomb", [](const Power &, const double gap) {
    return energy_of_crossing_surfaces({1, 1.}, sections, gap, 1., 50., 50.);
  });

  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
