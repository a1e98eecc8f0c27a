// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

// Every local minimum of the distance is found, once, in exactly one cell.

#include <gtest/gtest.h>

#include <setae/kinematics/closest_point.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "../random_vectors.h"

using namespace Setae;

namespace
{
  HermiteCell<>
  random_cell(std::mt19937 &random)
  {
    HermiteCell<> cell;
    for (Tensor<1, 3> &coefficient : cell.coefficients)
      coefficient = random_vector(random);
    cell.h = std::exp(random_vector(random)[0]);
    return cell;
  }

  HermiteCell<>
  straight_cell(const double length)
  {
    const Tensor<1, 3> e({1., 0., 0.});
    return {{{Tensor<1, 3>(), e, length * e, e}}, length};
  }

  double
  distance_square(const HermiteCell<> &cell,
                  const Tensor<1, 3>  &point,
                  const double         x)
  {
    return (cell.position(x) - point).norm_square();
  }

  double
  golden_section(const HermiteCell<> &cell,
                 const Tensor<1, 3>  &point,
                 double               a,
                 double               b)
  {
    const double ratio = (std::sqrt(5.) - 1.) / 2.;
    while (b - a > 1e-9)
      {
        const double c = b - ratio * (b - a), d = a + ratio * (b - a);
        if (distance_square(cell, point, c) < distance_square(cell, point, d))
          b = d;
        else
          a = c;
      }
    return .5 * (a + b);
  }

  /**
   * The minima in (0, 1] by comparing values of the distance, on the cubic
   * continued a little beyond the cell, and those at the ends of the fiber.
   */
  std::vector<double>
  sampled_minima(const HermiteCell<> &cell,
                 const Tensor<1, 3>  &point,
                 const FiberEnds     &ends)
  {
    constexpr int       n  = 4000;
    constexpr double    dx = 1. / n;
    std::vector<double> result;
    const auto          f = [&](const int i) {
      return distance_square(cell, point, i * dx);
    };
    if (ends.left && distance_square(cell, point, 1e-6) > f(0))
      result.push_back(0.);
    double before = f(-2), here = f(-1);
    for (int i = -1; i <= n + 1; ++i)
      {
        const double after = f(i + 1);
        if (here < before && here <= after)
          {
            const double x =
              golden_section(cell, point, (i - 1) * dx, (i + 1) * dx);
            if (x > 0. && x <= 1.)
              result.push_back(x);
          }
        before = here;
        here   = after;
      }
    if (ends.right && distance_square(cell, point, 1. - 1e-6) > f(n))
      result.push_back(1.);
    return result;
  }

  /** A node of a fiber. */
  struct Node
  {
    Tensor<1, 3> position, tangent;
  };

  /** The C1 curve through some nodes, on cells of the given lengths. */
  std::vector<HermiteCell<>>
  fiber(const std::vector<Node> &nodes, const std::vector<double> &lengths)
  {
    std::vector<HermiteCell<>> cells;
    for (unsigned int i = 0; i < lengths.size(); ++i)
      cells.push_back({{{nodes[i].position,
                         nodes[i].tangent,
                         nodes[i + 1].position,
                         nodes[i + 1].tangent}},
                       lengths[i]});
    return cells;
  }

  Node
  helix(const double s)
  {
    const double c = 1. / std::sqrt(1.25);
    return {Tensor<1, 3>({std::cos(c * s), std::sin(c * s), .5 * c * s}),
            Tensor<1, 3>({-c * std::sin(c * s), c * std::cos(c * s), .5 * c})};
  }

  const std::vector<double> lengths = {.1, .45, .2};

  std::vector<HermiteCell<>>
  helical_fiber()
  {
    std::vector<Node> nodes = {helix(0.)};
    double            s     = 0.;
    for (const double length : lengths)
      nodes.push_back(helix(s += length));
    return fiber(nodes, lengths);
  }

  struct Found
  {
    unsigned int cell;
    Projection   projection;
  };

  /** The projections on all cells of a fiber without ends. */
  std::vector<Found>
  closest_points_of_fiber(const std::vector<HermiteCell<>> &cells,
                          const Tensor<1, 3>               &point)
  {
    std::vector<Found> result;
    for (unsigned int c = 0; c < cells.size(); ++c)
      for (const Projection &projection : closest_points(cells[c], point, {}))
        result.push_back({c, projection});
    return result;
  }
} // namespace



TEST(ClosestPoint, FindsEveryMinimumOnceOnRandomCells)
{
  std::mt19937                random(1);
  std::array<unsigned int, 5> n_with = {};
  for (unsigned int i = 0; i < 2000; ++i)
    {
      const HermiteCell<> cell  = random_cell(random);
      const Tensor<1, 3>  point = random_vector(random);
      const FiberEnds     ends  = {i % 4 >= 2, i % 2 == 1};

      std::vector<double> expected = sampled_minima(cell, point, ends);
      std::vector<double> actual;
      for (const Projection &projection : closest_points(cell, point, ends))
        {
          actual.push_back(projection.x);
          EXPECT_EQ(projection.moves, projection.x > 0. && projection.x < 1.);
        }
      std::sort(actual.begin(), actual.end());

      ASSERT_EQ(actual.size(), expected.size()) << "cell " << i;
      for (unsigned int j = 0; j < actual.size(); ++j)
        EXPECT_NEAR(actual[j], expected[j], 1e-6) << "cell " << i;
      ++n_with[actual.size()];
    }
  for (unsigned int n = 0; n < 4; ++n)
    EXPECT_GT(n_with[n], 5u) << n << " minima";
}



TEST(ClosestPoint, IsPerpendicularToRoundOff)
{
  std::mt19937 random(2);
  for (unsigned int i = 0; i < 10000; ++i)
    {
      const HermiteCell<> cell  = random_cell(random);
      const Tensor<1, 3>  point = 3. * random_vector(random);
      for (const Projection &projection : closest_points(cell, point, {}))
        {
          const Tensor<1, 3> d   = cell.position(projection.x) - point;
          const Tensor<1, 3> r_x = cell.derivative(projection.x);
          const double       p_x =
            r_x * r_x + d * cell.second_derivative(projection.x);
          EXPECT_GT(p_x, 0.);
          // The position of the minimum, or else the round-off of its slope.
          EXPECT_LT(std::abs(d * r_x),
                    1e-15 * p_x +
                      1e-15 * (1. + cell.h) * (3. + d.norm()) * (1. + cell.h));
        }
    }
}



// A point that travels beside a fiber with cells of different lengths.
TEST(ClosestPoint, PassesFromCellToCell)
{
  const std::vector<HermiteCell<>> cells = helical_fiber();
  std::mt19937                     random(3);
  for (unsigned int c = 0; c < cells.size(); ++c)
    for (unsigned int i = 0; i <= 1000; ++i)
      {
        if ((c == 0 && i == 0) || (c + 1 == cells.size() && i == 1000))
          continue; // the ends, on one side of which there is no cell
        const double       x       = i / 1000.;
        const Tensor<1, 3> tangent = cells[c].derivative(x);
        const Tensor<1, 3> normal =
          cross_product_3d(tangent, random_vector(random));
        for (const double distance : {0., 1e-9, .01, .3, .6})
          {
            const Tensor<1, 3> point =
              cells[c].position(x) + distance * normal / normal.norm();
            const auto found = closest_points_of_fiber(cells, point);
            ASSERT_EQ(found.size(), 1u) << "cell " << c << ", x = " << x;
            EXPECT_TRUE(found[0].projection.moves);
            EXPECT_NEAR(found[0].cell + found[0].projection.x, c + x, 1e-12);
          }
      }
}



// In the plane through a node nothing but round-off decides for a cell.
TEST(ClosestPoint, BelongsToOneOfTwoCellsAtANode)
{
  const std::vector<HermiteCell<>> cells = helical_fiber();
  const Node   node = {cells[1].coefficients[0], cells[1].coefficients[1]};
  std::mt19937 random(4);
  std::array<unsigned int, 2> n_in_cell = {};
  for (unsigned int i = 0; i < 20000; ++i)
    {
      const Tensor<1, 3> normal =
        cross_product_3d(node.tangent, random_vector(random));
      Tensor<1, 3> point = node.position + .3 * normal / normal.norm();
      for (unsigned int c = 0; c < 3; ++c)
        point[c] = std::nextafter(point[c], (random() % 3) - 1.);
      const auto found = closest_points_of_fiber(cells, point);
      ASSERT_EQ(found.size(), 1u);
      ASSERT_LT(found[0].cell, 2u);
      EXPECT_NEAR(found[0].projection.x, found[0].cell == 0 ? 1. : 0., 1e-14);
      ++n_in_cell[found[0].cell];
    }
  EXPECT_GT(n_in_cell[0], 1000u);
  EXPECT_GT(n_in_cell[1], 1000u);

  const auto found = closest_points_of_fiber(cells, node.position);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].cell, 0u);
  EXPECT_EQ(found[0].projection.x, 1.);
}



// The common node of two cells of any length and shape is a minimum of the
// fiber, but for the sides of a kink, exactly if it is one of the two cells.
TEST(ClosestPoint, CountsEveryMinimumOfTwoRandomCellsOnce)
{
  std::mt19937 random(5);
  for (unsigned int i = 0; i < 20000; ++i)
    {
      std::array<HermiteCell<>, 2> cells = {
        {random_cell(random), random_cell(random)}};
      cells[1].coefficients[0]   = cells[0].coefficients[2];
      cells[1].coefficients[1]   = cells[0].coefficients[3];
      const Tensor<1, 3> node    = cells[0].coefficients[2];
      const Tensor<1, 3> tangent = cells[0].coefficients[3];
      const Tensor<1, 3> point =
        node + cross_product_3d(tangent, random_vector(random));

      // The curvature of the distance on both sides of the node, where its
      // slope is zero to round-off.
      const double left = cells[0].derivative(1.).norm_square() +
                          (node - point) * cells[0].second_derivative(1.);
      const double right = cells[1].derivative(0.).norm_square() +
                           (node - point) * cells[1].second_derivative(0.);
      if (left * right < 0.)
        continue; // an inflection, or nothing
      unsigned int n_at_node = 0;
      for (const Projection &projection : closest_points(cells[0], point, {}))
        n_at_node += projection.x > 1. - 1e-9;
      for (const Projection &projection : closest_points(cells[1], point, {}))
        n_at_node += projection.x < 1e-9;
      EXPECT_EQ(n_at_node, left > 0. ? 1u : 0u);
    }
}



TEST(ClosestPoint, StaysAtTheEndOfAFiber)
{
  const HermiteCell<> cell = straight_cell(2.);
  const Tensor<1, 3>  before({-.5, 1., 0.}), beside({.5, 1., 0.}),
    behind({2.5, 1., 0.});

  for (const FiberEnds &ends : {FiberEnds{false, false}, FiberEnds{true, true}})
    {
      const Projections found = closest_points(cell, beside, ends);
      ASSERT_EQ(found.size(), 1u);
      EXPECT_NEAR(found[0].x, .25, 1e-15);
      EXPECT_TRUE(found[0].moves);
    }

  EXPECT_EQ(closest_points(cell, before, {}).size(), 0u);
  EXPECT_EQ(closest_points(cell, behind, {}).size(), 0u);
  EXPECT_EQ(closest_points(cell, before, {false, true}).size(), 0u);
  EXPECT_EQ(closest_points(cell, behind, {true, false}).size(), 0u);

  const Projections at_begin = closest_points(cell, before, {true, true});
  ASSERT_EQ(at_begin.size(), 1u);
  EXPECT_EQ(at_begin[0].x, 0.);
  EXPECT_FALSE(at_begin[0].moves);

  const Projections at_end = closest_points(cell, behind, {true, true});
  ASSERT_EQ(at_end.size(), 1u);
  EXPECT_EQ(at_end[0].x, 1.);
  EXPECT_FALSE(at_end[0].moves);
}



TEST(ClosestPoint, IsOneInThePlaneThroughTheEnds)
{
  const HermiteCell<> cell = straight_cell(2.);
  for (const double x : {0., 1.})
    {
      const Tensor<1, 3> point = cell.position(x) + Tensor<1, 3>({0., 1., 0.});
      const Projections  found = closest_points(cell, point, {true, true});
      ASSERT_EQ(found.size(), 1u);
      EXPECT_EQ(found[0].x, x);
    }
}



// An arc that bends towards a point behind its center of curvature: both ends
// are minima, and the middle, or an end in whose normal plane the point lies,
// is not.
TEST(ClosestPoint, IsNotAMaximum)
{
  const Tensor<1, 3>  t1({0., 1., 0.}), t2({-1., 0., 0.});
  const HermiteCell<> arc = {
    {{Tensor<1, 3>({1., 0., 0.}), t1, Tensor<1, 3>({0., 1., 0.}), t2}},
    M_PI / 2.};
  const Projections both =
    closest_points(arc, Tensor<1, 3>({-1., -1., 0.}), {true, true});
  ASSERT_EQ(both.size(), 2u);
  EXPECT_EQ(both[0].x, 0.);
  EXPECT_EQ(both[1].x, 1.);

  const Projections right =
    closest_points(arc, Tensor<1, 3>({-1., 0., 0.}), {true, true});
  ASSERT_EQ(right.size(), 1u);
  EXPECT_EQ(right[0].x, 1.);

  const Projections left =
    closest_points(arc, Tensor<1, 3>({0., -1., 0.}), {true, true});
  ASSERT_EQ(left.size(), 1u);
  EXPECT_EQ(left[0].x, 0.);
}



TEST(ClosestPoint, FindsPointsOfTheCurveItself)
{
  std::mt19937 random(6);
  for (unsigned int i = 0; i < 1000; ++i)
    {
      const HermiteCell<> cell  = random_cell(random);
      const double        x     = (i + .5) / 1000.;
      double              error = std::numeric_limits<double>::infinity();
      for (const Projection &projection :
           closest_points(cell, cell.position(x), {}))
        error = std::min(error, std::abs(projection.x - x));
      EXPECT_LT(error, 1e-12);
    }
}



TEST(ClosestPoint, FindsBothLegsOfAHairpin)
{
  const Tensor<1, 3>  e({1., 0., 0.}), f({0., 1., 0.});
  const HermiteCell<> hairpin = {{{Tensor<1, 3>(), 6. * e, f, -6. * e}}, 1.};
  for (const double shift : {0., .01, -.2}) // 0: exactly equidistant
    {
      const Projections found =
        closest_points(hairpin, .5 * e + (.5 + shift) * f, {});
      ASSERT_EQ(found.size(), 2u);
      EXPECT_LT(found[0].x, .5);
      EXPECT_GT(found[1].x, .5);
      if (shift == 0.)
        {
          EXPECT_NEAR(found[0].x + found[1].x, 1., 1e-14);
        }
    }
}



// All points of a circle are equally close to its center. On cubic cells the
// middles are closest, by 1.5% to 4e-8 of the radius.
TEST(ClosestPoint, SurvivesTheCenterOfARing)
{
  for (const unsigned int n : {4, 7, 16, 100})
    {
      const double      length = 2. * M_PI / n;
      std::vector<Node> nodes;
      for (unsigned int i = 0; i <= n; ++i)
        {
          const double angle = (i % n) * length;
          nodes.push_back(
            {Tensor<1, 3>({std::cos(angle), std::sin(angle), 0.}),
             Tensor<1, 3>({-std::sin(angle), std::cos(angle), 0.})});
        }
      const auto cells = fiber(nodes, std::vector<double>(n, length));
      const auto found = closest_points_of_fiber(cells, Tensor<1, 3>());
      EXPECT_EQ(found.size(), n);
      for (const Found &f : found)
        EXPECT_NEAR(f.projection.x, .5, 1e-6);

      // From any other place one point is closest and none is lost.
      const Tensor<1, 3> point({.3, .2, .1});
      const auto         beside = closest_points_of_fiber(cells, point);
      ASSERT_EQ(beside.size(), 1u);
      for (unsigned int c = 0; c < n; ++c)
        for (const double x : sampled_minima(cells[c], point, {}))
          EXPECT_NEAR(beside[0].cell + beside[0].projection.x, c + x, 1e-6);
    }
}



TEST(ClosestPoint, WorksOnCellsThatAreDegenerate)
{
  const Tensor<1, 3> e({1., 0., 0.}), f({0., 1., 0.}), zero;

  // straight, seen from a point of its axis
  const HermiteCell<> straight = straight_cell(1.);
  ASSERT_EQ(closest_points(straight, .3 * e, {}).size(), 1u);
  EXPECT_NEAR(closest_points(straight, .3 * e, {})[0].x, .3, 1e-15);
  ASSERT_EQ(closest_points(straight, 7. * e, {true, true}).size(), 1u);
  EXPECT_EQ(closest_points(straight, 7. * e, {true, true})[0].x, 1.);

  // without tangents at the nodes: x^2 (3 - 2 x) = 0.5 at the middle
  const HermiteCell<> cusps = {{{zero, zero, e, zero}}, 1.};
  const Projections   found = closest_points(cusps, .5 * e + f, {});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0].x, .5, 1e-15);

  // collapsed to a point: no place of it is closer than another
  const HermiteCell<> point = {{{e, zero, e, zero}}, 1.};
  EXPECT_EQ(closest_points(point, f, {}).size(), 0u);
  EXPECT_EQ(closest_points(point, f, {true, false}).size(), 1u);

  // folded on itself
  const HermiteCell<> folded = {{{zero, e, zero, -1. * e}}, 1.};
  for (const Projection &projection : closest_points(folded, .1 * e, {}))
    EXPECT_NEAR(folded.position(projection.x)[0], .1, 1e-12);
  EXPECT_EQ(closest_points(folded, .1 * e, {}).size(), 2u);
}
