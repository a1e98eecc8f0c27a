// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <gtest/gtest.h>

#include <setae/kinematics/closest_point.h>
#include <setae/search/closest_approach.h>

#include <limits>

#include "random_cells.h"

using namespace Setae;
using namespace RandomCells;

namespace
{
  Tensor<1, 3>
  vector(const double x, const double y, const double z)
  {
    return Tensor<1, 3>({x, y, z});
  }

  HermiteCell<>
  cell_of(const ControlPoints &P)
  {
    HermiteCell<> cell;
    cell.coefficients = {{P[0], 3. * (P[1] - P[0]), P[3], 3. * (P[3] - P[2])}};
    return cell;
  }

  /** The exact distance of a point of the first cell from the second one. */
  double
  distance_from(const HermiteCell<> &first,
                const HermiteCell<> &second,
                const double         x)
  {
    const Tensor<1, 3> point  = first.position(x);
    double             result = std::numeric_limits<double>::infinity();
    for (const Projection &p : closest_points(second, point, {true, true}))
      result = std::min(result, (second.position(p.x) - point).norm());
    return std::min({result,
                     (second.position(0.) - point).norm(),
                     (second.position(1.) - point).norm()});
  }

  /** Minimize over many points of the first cell, then around each minimum. */
  double
  brute_force(const ControlPoints &P, const ControlPoints &Q)
  {
    constexpr unsigned int n     = 600;
    const HermiteCell<>    first = cell_of(P), second = cell_of(Q);
    std::vector<double>    f(n + 1);
    for (unsigned int i = 0; i <= n; ++i)
      f[i] = distance_from(first, second, double(i) / n);
    double result = std::min(f.front(), f.back());
    for (unsigned int i = 0; i <= n; ++i)
      {
        if ((i > 0 && f[i] > f[i - 1]) || (i < n && f[i] > f[i + 1]))
          continue;
        double a = std::max(0., (i - 1.) / n), b = std::min(1., (i + 1.) / n);
        for (unsigned int k = 0; k < 100 && b - a > 1e-15; ++k)
          {
            const double third = (b - a) / 3.;
            if (distance_from(first, second, a + third) <
                distance_from(first, second, b - third))
              b -= third;
            else
              a += third;
          }
        result = std::min(result, distance_from(first, second, .5 * (a + b)));
      }
    return result;
  }

  double
  size_of(const ControlPoints &P, const ControlPoints &Q)
  {
    double result = 0.;
    for (unsigned int k = 0; k < 4; ++k)
      result = std::max({result, (P[k] - P[0]).norm(), (Q[k] - P[0]).norm()});
    return result;
  }

  ControlPoints
  moved(const ControlPoints &P, const double scale, const Tensor<1, 3> &offset)
  {
    ControlPoints result;
    for (unsigned int k = 0; k < 4; ++k)
      result[k] = scale * P[k] + offset;
    return result;
  }

  /** A slightly curved cell of length one through the origin. */
  ControlPoints
  bent_cell(const Tensor<1, 3> &direction,
            const double        bend,
            std::mt19937       &random)
  {
    ControlPoints P;
    for (unsigned int k = 0; k < 4; ++k)
      P[k] = (k / 3. - .5) * direction + bend * random_direction(random);
    return P;
  }

  void
  expect_as_brute_force(const ControlPoints &P, const ControlPoints &Q)
  {
    const ClosestApproach found = closest_approach(P, Q);
    const double          exact = brute_force(P, Q);
    const double          error = found.distance - exact;
    EXPECT_LE(std::abs(error), 1e-13 * size_of(P, Q)) << "exact " << exact;
    EXPECT_NEAR(
      found.distance,
      (cell_of(P).position(found.x) - cell_of(Q).position(found.y)).norm(),
      1e-14 * size_of(P, Q));
  }
} // namespace



TEST(ClosestApproach, OfCurvesWithLoopsIsThatOfBruteForce)
{
  std::mt19937 random(1);
  const Cells  cells = random_curved_cells(60, 3., random);
  for (unsigned int i = 0; i < cells.size(); i += 2)
    for (unsigned int j = 1; j < cells.size(); j += 2)
      expect_as_brute_force(cells[i], cells[j]);
}



TEST(ClosestApproach, OfSlenderCellsAtAnyAngleIsThatOfBruteForce)
{
  std::mt19937                           random(2);
  std::uniform_real_distribution<double> exponent(-6., 0.);
  for (unsigned int i = 0; i < 1000; ++i)
    {
      const double        angle     = std::pow(10., exponent(random));
      const double        bend      = .2 * std::pow(10., exponent(random));
      const double        gap       = std::pow(10., exponent(random));
      const Tensor<1, 3>  direction = random_direction(random);
      const ControlPoints P         = bent_cell(direction, bend, random);
      const ControlPoints Q         = moved(
        bent_cell(direction + angle * random_direction(random), bend, random),
        1.,
        gap * random_direction(random));
      expect_as_brute_force(P, Q);
    }
}



TEST(ClosestApproach, OfCellsWithSeveralMinimaSideBySideIsTheSmallest)
{
  // Gap and angle are not larger than the waves of the cells. These seeds have
  // pairs with a minimum between two samples at which the distance falls (or
  // grows) alike, and one beside the end of a part of the second cell.
  std::uniform_real_distribution<double> number(0., 1.);
  for (const unsigned int seed : {5, 6})
    {
      std::mt19937 random(seed);
      for (unsigned int i = 0; i < 1400; ++i)
        {
          const double        bend      = .1 * std::pow(10., -number(random));
          const double        angle     = bend * std::pow(10., -number(random));
          const double        gap       = bend * (.5 + 2. * number(random));
          const Tensor<1, 3>  direction = random_direction(random);
          const ControlPoints P         = bent_cell(direction, bend, random);
          const Tensor<1, 3>  turned =
            direction + angle * random_direction(random);
          const Tensor<1, 3> offset = gap * random_direction(random);
          expect_as_brute_force(
            P, moved(bent_cell(turned, bend, random), 1., offset));
        }
    }
}



TEST(ClosestApproach, OfParallelArcsIsTheirDistance)
{
  // The same curve twice, a distance along the normal of its plane apart.
  std::mt19937 random(3);
  for (const double bend : {0., 1e-8, 1e-3, .1, 1.})
    for (const double distance : {0., 1e-9, 1e-3, 1.})
      {
        ControlPoints P = bent_cell(vector(1., 0., 0.), bend, random);
        for (Tensor<1, 3> &point : P)
          point[2] = 0.;
        const ControlPoints Q = moved(P, 1., vector(0., 0., distance));
        EXPECT_NEAR(closest_approach(P, Q).distance, distance, 1e-15);
      }
}



TEST(ClosestApproach, KnowsNoUnitAndNoOrigin)
{
  std::mt19937 random(4);
  const Cells  cells = random_curved_cells(20, 2., random);
  for (unsigned int i = 0; i + 1 < cells.size(); ++i)
    {
      const auto  &P = cells[i], &Q = cells[i + 1];
      const double expected = closest_approach(P, Q).distance;
      for (const double scale : {1e-9, 1., 1e9})
        for (const double offset : {0., 1e3})
          {
            const Tensor<1, 3> shift =
              offset * scale * random_direction(random);
            EXPECT_NEAR(closest_approach(moved(P, scale, shift),
                                         moved(Q, scale, shift))
                            .distance /
                          scale,
                        expected,
                        1e-14 * size_of(P, Q) + 1e-15 * offset);
          }
    }
}



TEST(ClosestApproach, CrossingCurvesTouch)
{
  const ControlPoints   P     = {{vector(-1., 0., 0.),
                                  vector(-.3, 0., 0.),
                                  vector(.3, 0., 0.),
                                  vector(1., 0., 0.)}};
  const ControlPoints   Q     = {{vector(.2, -1., 0.),
                                  vector(.2, -.2, 0.),
                                  vector(.2, .1, 0.),
                                  vector(.2, 1.3, 0.)}};
  const ClosestApproach found = closest_approach(P, Q);
  EXPECT_LT(found.distance, 1e-15);
  EXPECT_NEAR(cell_of(P).position(found.x)[0], .2, 1e-14);
}



TEST(ClosestApproach, LooksNoFartherThanTheBound)
{
  std::mt19937 random(5);
  const Cells  cells = random_curved_cells(40, 3., random);
  for (unsigned int i = 0; i + 1 < cells.size(); ++i)
    {
      const auto  &P = cells[i], &Q = cells[i + 1];
      const double distance = closest_approach(P, Q).distance;
      EXPECT_EQ(closest_approach(P, Q, .999 * distance).distance,
                std::numeric_limits<double>::infinity());
      EXPECT_NEAR(closest_approach(P, Q, 1.001 * distance).distance,
                  distance,
                  1e-14 * size_of(P, Q));
    }
}



TEST(ClosestApproach, AnEndThatIsLeftOutHidesNoMinimumInside)
{
  // The first cell begins near the second one, turns away and comes back.
  const ControlPoints   P      = {{vector(0., .1, 0.),
                                   vector(.2, 3., 0.),
                                   vector(.8, -1.6, 0.),
                                   vector(1., 1., 0.)}};
  const ControlPoints   Q      = {{vector(-1., 0., 0.),
                                   vector(0., 0., 0.),
                                   vector(1., 0., 0.),
                                   vector(2., 0., 0.)}};
  const ClosestApproach whole  = closest_approach(P, Q);
  const ClosestApproach inside = closest_approach(
    P, Q, std::numeric_limits<double>::infinity(), {true, false});
  EXPECT_EQ(whole.x, 0.);
  EXPECT_NEAR(whole.distance, .1, 1e-15);
  EXPECT_GT(inside.x, .5);
  EXPECT_GT(inside.distance, .1);
  EXPECT_LT(inside.distance, 1.);
}
