// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <gtest/gtest.h>

#include "solids.h"

using namespace Setae;

namespace
{
  constexpr double radius = .3;

  /** Refine twice towards the positive x-axis. */
  void
  refine_to_one_side(SolidBody &body)
  {
    for (unsigned int i = 0; i < 2; ++i)
      {
        std::vector<bool> marked(body.nodes().size());
        for (unsigned int n = 0; n < marked.size(); ++n)
          marked[n] = body.nodes()[n].center[0] > 1.;
        body.refine(marked);
      }
  }

  template <typename Function>
  double
  integral(const SolidBody   &body,
           const unsigned int n,
           const Function    &function)
  {
    double sum = 0.;
    for (const SolidBody::Node &node : body.nodes())
      if (node.is_active() && body.is_populated(node))
        for (const SolidSites &block : body.sites(node, n))
          for (unsigned int i = 0; i < n_lanes; ++i)
            sum += block.weight[i] *
                   function(Tensor<1, 3>({block.x[i], block.y[i], block.z[i]}));
    return sum;
  }
} // namespace

TEST(SolidBody, BentFiberHasItsVolumeAndSurface)
{
  // Curved from the beginning on, and straight but bent.
  const auto bent     = arc(2., 1.5, 4);
  const auto straight = straight_line({}, Tensor<1, 3>({1., 0., 0.}), 3.);
  const auto curved   = arc(2., 1.5, 1);
  const std::pair<std::vector<HermiteCell<>>, std::vector<HermiteCell<>>>
    fibers[] = {{bent, bent}, {straight, curved}};
  for (const auto &[initial, current] : fibers)
    {
      const double length = arc_length(initial);
      const auto   one    = [](const Tensor<1, 3> &) { return 1.; };

      SolidBody body(FiberChart(initial, current, radius),
                     Distribution::volume,
                     MPI_COMM_SELF);
      refine_to_one_side(body);
      EXPECT_GT(body.mesh().n_levels(), 2u);
      EXPECT_NEAR(integral(body, 6, one),
                  M_PI * radius * radius * length,
                  1e-10 * length);

      SolidBody surface(FiberChart(initial, current, radius),
                        Distribution::surface,
                        MPI_COMM_SELF);
      refine_to_one_side(surface);
      EXPECT_NEAR(integral(surface, 6, one),
                  2. * M_PI * radius * length,
                  1e-10 * length);
    }
}

TEST(SolidBody, SectionsAreDisksNormalToTheCurrentCenterline)
{
  // The mean of the squared distance from the axis of the arc is radius^2 / 2
  // only if all sections are disks of that radius about the centerline.
  const auto current = arc(2., 1.5, 8);
  const auto initial = straight_line({}, Tensor<1, 3>({1., 0., 0.}), 3.);
  std::vector<HermiteCell<>> cells;
  for (unsigned int i = 0; i < 8; ++i)
    {
      const Tensor<1, 3> t({1., 0., 0.});
      cells.push_back({{{.375 * i * t, t, .375 * (i + 1.) * t, t}}, .375});
    }
  SolidBody    body(FiberChart(cells, current, radius),
                 Distribution::volume,
                 MPI_COMM_SELF);
  const double volume = M_PI * radius * radius * 3.;
  EXPECT_NEAR(integral(body,
                       6,
                       [](const Tensor<1, 3> &r) {
                         const double in_plane = std::hypot(r[0], r[1]) - 2.;
                         return in_plane * in_plane + r[2] * r[2];
                       }) /
                volume,
              radius * radius / 2.,
              1e-6 * radius);
  // Symmetric about the plane of the arc.
  EXPECT_NEAR(integral(body, 6, [](const Tensor<1, 3> &r) { return r[2]; }),
              0.,
              1e-14);
}

TEST(SolidBody, TreeContainsTheActiveCellsOfTheMesh)
{
  const auto line = straight_line({}, Tensor<1, 3>({1., 0., 0.}), 3.);
  SolidBody  body(FiberChart(line, line, radius),
                 Distribution::volume,
                 MPI_COMM_SELF);
  refine_to_one_side(body);
  unsigned int n_active = 0;
  for (const SolidBody::Node &node : body.nodes())
    if (node.is_active())
      ++n_active;
  EXPECT_EQ(n_active, body.mesh().n_active_cells());
}

TEST(SolidBody, SeparationIsNeverMoreThanTheDistance)
{
  const auto line = arc(1., 1.5, 2);
  const auto other =
    straight_line(Tensor<1, 3>({2., 0., .2}), Tensor<1, 3>({0., .6, .8}), 2.);
  SolidBody first(FiberChart(line, line, radius),
                  Distribution::volume,
                  MPI_COMM_SELF);
  SolidBody second(FiberChart(other, other, radius),
                   Distribution::volume,
                   MPI_COMM_SELF);
  for (unsigned int a = 0; a < first.n_roots(); ++a)
    for (unsigned int b = 0; b < second.n_roots(); ++b)
      {
        double smallest = std::numeric_limits<double>::infinity();
        for (unsigned int i = 0; i < 27; ++i)
          for (unsigned int j = 0; j < 27; ++j)
            {
              const auto corner = [](const unsigned int k) {
                return dealii::Point<3>(k % 4 / 3.,
                                        k / 4 % 4 / 3.,
                                        k / 16 / 3.);
              };
              smallest = std::min(smallest,
                                  (first.chart.position(a, corner(i)) -
                                   second.chart.position(b, corner(j)))
                                    .norm());
            }
        EXPECT_LE(separation(first.nodes()[a], second.nodes()[b]),
                  smallest + 1e-12);
      }
}
