// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <gtest/gtest.h>

#include <setae/base/exceptions.h>
#include <setae/fibers/centerline.h>
#include <setae/fibers/line_mesh.h>

#include <cmath>

#include "mesh_file.h"

using namespace Setae;

namespace
{
  std::vector<Centerline>
  fibers_of(const std::string        &text,
            std::vector<std::string> &notices,
            const std::string        &extension = ".vtk",
            const double              kink      = 10.)
  {
    const TemporaryFile file(text, extension);
    FiberParameters     fiber;
    fiber.name         = "rod";
    fiber.mesh_file    = file.name;
    fiber.largest_kink = kink;
    return make_centerlines(fiber, {}, notices);
  }

  std::string
  refusal(const std::string &text,
          const std::string &extension = ".vtk",
          const double       kink      = 10.)
  {
    std::vector<std::string> notices;
    try
      {
        fibers_of(text, notices, extension, kink);
      }
    catch (const ExcParameter &exception)
      {
        return reason(exception);
      }
    return "";
  }

  void
  expect_part(const std::string &text, const std::string &part)
  {
    EXPECT_NE(text.find(part), std::string::npos) << "'" << text << "'";
  }

  /** Unit steps in a plane with the given changes of direction in degrees. */
  std::vector<Tensor<1, 3>>
  polygon(const std::vector<double> &turns)
  {
    std::vector<Tensor<1, 3>> points = {{}, Tensor<1, 3>({1., 0., 0.})};
    double                    angle  = 0.;
    for (const double turn : turns)
      {
        angle += turn * M_PI / 180.;
        points.push_back(points.back() +
                         Tensor<1, 3>({std::cos(angle), std::sin(angle), 0.}));
      }
    return points;
  }

  std::string
  refusal_of_turns(const std::vector<double> &turns, const double kink = 10.)
  {
    const auto points = polygon(turns);
    return refusal(vtk_lines(points, chain_of(points.size())), ".vtk", kink);
  }
} // namespace



TEST(MeshCurves, AreStraightWithinTheDigitsOfTheFile)
{
  for (const unsigned int n_digits : {6, 8, 12, 17})
    for (const double size : {1e-9, 1., 1e9})
      {
        std::vector<Tensor<1, 3>> points, bent;
        for (unsigned int i = 0; i <= 6; ++i)
          {
            const double s = size * i / 6.;
            points.push_back(Tensor<1, 3>({.7 * s, .43333333 * s, s / 7.}));
            bent.push_back(points.back());
            // Sagitta 1.25 units of the fifth digit.
            bent.back()[2] += 5e-5 * s * (1. - s / size);
          }
        std::vector<std::string> notices;
        const auto               straight =
          fibers_of(vtk_lines(points, chain_of(7), n_digits), notices);
        EXPECT_TRUE(straight.at(0).is_straight());
        EXPECT_EQ(notices.size(), n_digits < 17 ? 1u : 0u) << n_digits;
        for (const Tensor<1, 3> &t : straight[0].tangents)
          EXPECT_EQ(t, straight[0].tangents[0]);

        notices.clear();
        EXPECT_FALSE(fibers_of(vtk_lines(bent, chain_of(7), n_digits), notices)
                       .at(0)
                       .is_straight());
        EXPECT_TRUE(notices.empty());
      }
}



TEST(MeshCurves, JoinNodesAtTheSamePlace)
{
  std::vector<Tensor<1, 3>> points;
  for (const double x : {0., 1., 2., 2., 3., 4.})
    points.push_back(Tensor<1, 3>({x / 3., 0., 1.}));
  std::vector<std::string> notices;
  const auto               fibers =
    fibers_of(vtk_lines(points, {{0, 1}, {1, 2}, {3, 4}, {4, 5}}, 6), notices);
  ASSERT_EQ(fibers.size(), 1u);
  EXPECT_EQ(fibers[0].n_cells(), 4u);
  ASSERT_GE(notices.size(), 1u);
  expect_part(notices[0], "1 node(s)");
  expect_part(notices[0], "node 3 at (0.666667, 0, 1)");
}



TEST(MeshCurves, RefuseKinksWithNodePlaceAndAngle)
{
  expect_part(refusal_of_turns({0., 90., 0.}),
              "at node 2 at (2, 0, 0) it turns by 90 degrees");
  expect_part(refusal_of_turns({0., 12., 0.}), "turns by 12 degrees");
  expect_part(refusal_of_turns({30., -30., 30., -30.}), "turns by 30");
  expect_part(refusal_of_turns({70., 70., 70.}), "turns by 70");
  expect_part(refusal_of_turns({170.}), "turns by 170");
  EXPECT_EQ(refusal_of_turns({0., 90., 0.}, 90.), "");
}



TEST(MeshCurves, TakeCoarseArcsAsSmooth)
{
  EXPECT_EQ(refusal_of_turns({60., 60., 60., 60.}), "");
  // Straight parts that go over into an arc and back.
  EXPECT_EQ(refusal_of_turns({0., 15., 30., 30., 15., 0.}), "");
  EXPECT_EQ(refusal_of_turns({2., 4., 9., 4., 2.}), "");
}



TEST(MeshCurves, RefuseBranchesAndLinesWithoutLength)
{
  std::vector<Tensor<1, 3>> points = polygon({0., 0.});
  points.push_back(Tensor<1, 3>({1., 1., 0.}));
  expect_part(refusal(vtk_lines(points, {{0, 1}, {1, 2}, {1, 4}})),
              "3 lines meet at node 1 at (1, 0, 0)");
  points[4] = points[1];
  expect_part(refusal(vtk_lines(points, {{0, 1}, {1, 4}, {4, 2}})),
              "from node 1 at (1, 0, 0) to node 4 at (1, 0, 0) has none");
  expect_part(refusal(vtk_lines(points, {{0, 1}, {1, 0}})), "two lead from");
}



TEST(MeshCurves, AreReadFromPolylinesAndPoints)
{
  const std::string head  = "# vtk DataFile Version 3.0\nlines\nASCII\n";
  const std::string nodes = "POINTS 5 float\n0 0 0 1 0 0 2 0 0 0 1 0 1 1 0\n";
  const std::string grid  = head + "DATASET UNSTRUCTURED_GRID\n" + nodes +
                           "CELLS 4 10\n3 0 1 2\n1 0\n2 3 4\n1 4\n" +
                           "CELL_TYPES 4\n4\n1\n3\n1\n" +
                           "POINT_DATA 5\nSCALARS CELLS float\n1 2 3 4 5\n";
  const std::string poly = head + "DATASET POLYDATA\n" + nodes +
                           "VERTICES 1 2\n1 0\nLINES 2 7\n3 0 1 2\n2 3 4\n";
  const std::string version_5 =
    head + "DATASET UNSTRUCTURED_GRID\n" + nodes +
    "CELLS 4 6\nOFFSETS vtktypeint64\n0 3 4 6\nCONNECTIVITY vtktypeint64\n"
    "0 1 2 0 3 4\nCELL_TYPES 3\n4\n1\n3\n";
  for (const std::string &text : {grid, poly, version_5})
    {
      std::vector<std::string> notices;
      const auto               fibers = fibers_of(text, notices);
      ASSERT_EQ(fibers.size(), 2u);
      EXPECT_EQ(fibers[0].n_cells(), 2u);
      EXPECT_EQ(fibers[1].n_cells(), 1u);
      EXPECT_EQ(fibers[1].copy.at("i"), 1.);
    }
}



TEST(MeshCurves, AreReadFromAGmshFile)
{
  // Two lines, and a point as gmsh writes it for a corner.
  const std::string gmsh =
    "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n3\n1 0 0 0\n2 1 0 0\n"
    "3 2 0 0\n$EndNodes\n$Elements\n3\n1 15 2 0 1 1\n2 1 2 0 1 1 2\n"
    "3 1 2 0 1 2 3\n$EndElements\n";
  std::vector<std::string> notices;
  const auto               fibers = fibers_of(gmsh, notices, ".msh");
  ASSERT_EQ(fibers.size(), 1u);
  EXPECT_EQ(fibers[0].n_cells(), 2u);
}



TEST(MeshCurves, SayWhyAFileCannotBeRead)
{
  const std::string head = "# vtk DataFile Version 3.0\nlines\n";
  expect_part(refusal("no mesh\n"), "its first line has no '# vtk DataFile'");
  expect_part(refusal(head + "BINARY\n"), "it is 'BINARY', not ASCII");
  expect_part(refusal(head + "ASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 2 "
                             "float\n0 0 0 1 0 x\n"),
              "'x' is no number");
  expect_part(refusal(head + "ASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 2 "
                             "float\n0 0 0 1 0\n"),
              "it ends too early");
  expect_part(refusal(vtk_lines(polygon({}), {{0, 7}})),
              "a line to the point 7, but only 2 points");
  expect_part(refusal("no mesh\n", ".msh"), "that can be read: ");
}
