// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <gtest/gtest.h>

#include <setae/base/exceptions.h>
#include <setae/fibers/centerline.h>

#include <cmath>

#include "mesh_file.h"

using namespace Setae;

namespace
{
  struct MeshFile : public TemporaryFile
  {
    MeshFile(const std::vector<Tensor<1, 3>>                  &points,
             const std::vector<std::pair<unsigned, unsigned>> &lines)
      : TemporaryFile(vtk_lines(points, lines), ".vtk")
    {}
  };

  Tensor<1, 3>
  on_circle(const double angle)
  {
    Tensor<1, 3> p;
    p[0] = std::cos(angle);
    p[1] = std::sin(angle);
    return p;
  }
} // namespace



TEST(Centerline, OfAFormulaHasTheTangentsOfTheCurve)
{
  FiberParameters fiber;
  fiber.centerline = "r*cos(s); r*sin(s); 2*s";
  fiber.length     = 3.;
  fiber.n_cells    = 7;
  const auto lines = make_centerlines(fiber, {{"r", 3.}});
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_FALSE(lines[0].is_straight());
  for (unsigned int i = 0; i <= 7; ++i)
    {
      const double s = 3. * i / 7.;
      EXPECT_NEAR(lines[0].positions[i][0], 3. * std::cos(s), 1e-14);
      EXPECT_NEAR(lines[0].tangents[i][0],
                  -3. * std::sin(s) / std::sqrt(13.),
                  1e-9);
      EXPECT_NEAR(lines[0].tangents[i].norm(), 1., 1e-15);
    }
}



TEST(Centerline, OfAStraightFormulaIsStraightToTheLastBit)
{
  FiberParameters fiber;
  fiber.centerline = "0.3; s; -2";
  fiber.length     = 5.;
  for (const Centerline &line : make_centerlines(fiber, {}))
    for (const Tensor<1, 3> &t : line.tangents)
      EXPECT_EQ(t, (Tensor<1, 3>({0., 1., 0.})));
}



TEST(Centerline, OfAnArrayKnowsItsPlace)
{
  FiberParameters fiber;
  fiber.centerline = "s; i; 10*j";
  fiber.copies     = {2, 3};
  const auto lines = make_centerlines(fiber, {});
  ASSERT_EQ(lines.size(), 6u);
  for (unsigned int i = 0; i < 2; ++i)
    for (unsigned int j = 0; j < 3; ++j)
      {
        const Tensor<1, 3> start = lines[3 * i + j].positions[0];
        EXPECT_EQ(start[1], i);
        EXPECT_EQ(start[2], 10. * j);
      }
}



TEST(Centerline, IsReadFromAMeshFileInTheOrderOfTheChain)
{
  // A quarter of a circle in an order of its own, and a straight line.
  std::vector<Tensor<1, 3>> points;
  for (const unsigned int i : {3, 0, 2, 4, 1})
    points.push_back(on_circle(i * M_PI / 8.));
  for (unsigned int i = 0; i < 3; ++i)
    points.push_back(Tensor<1, 3>({2. + i, 0., 1.}));
  const MeshFile mesh(points, {{1, 4}, {2, 0}, {2, 4}, {0, 3}, {5, 6}, {7, 6}});

  FiberParameters fiber;
  fiber.mesh_file  = mesh.name;
  const auto lines = make_centerlines(fiber, {});
  ASSERT_EQ(lines.size(), 2u);

  const Centerline &arc = lines[0];
  ASSERT_EQ(arc.n_cells(), 4u);
  const double direction =
    (arc.positions[1] - arc.positions[0]) * arc.tangents[0];
  EXPECT_GT(direction, 0.);
  for (unsigned int i = 0; i < 5; ++i)
    {
      // On a circle, the tangents of the circle through three nodes are exact.
      EXPECT_NEAR(arc.tangents[i] * arc.positions[i], 0., 1e-14);
      EXPECT_NEAR(arc.tangents[i].norm(), 1., 1e-14);
    }
  EXPECT_TRUE(lines[1].is_straight());
  EXPECT_EQ(lines[1].n_cells(), 2u);
}



TEST(Centerline, OfARingIsClosed)
{
  constexpr unsigned int                     n = 12;
  std::vector<Tensor<1, 3>>                  points;
  std::vector<std::pair<unsigned, unsigned>> lines;
  for (unsigned int i = 0; i < n; ++i)
    {
      points.push_back(on_circle(2. * M_PI * i / n));
      lines.emplace_back(i, (i + 1) % n);
    }
  const MeshFile  mesh(points, lines);
  FiberParameters fiber;
  fiber.mesh_file  = mesh.name;
  const auto rings = make_centerlines(fiber, {});
  ASSERT_EQ(rings.size(), 1u);
  EXPECT_TRUE(rings[0].closed);
  EXPECT_EQ(rings[0].n_cells(), n);
  EXPECT_EQ(rings[0].cell(n - 1).coefficients[2], rings[0].positions[0]);
}
