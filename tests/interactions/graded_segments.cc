// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <deal.II/base/quadrature_lib.h>

#include <gtest/gtest.h>

#include <setae/interactions/graded_segments.h>

#include <algorithm>
#include <cmath>

using namespace Setae;

namespace
{
  using ControlPoints = GradedSegments::ControlPoints;
  using Segment       = GradedSegments::Segment;

  constexpr double       c        = .1; // two radii
  constexpr double       infinity = std::numeric_limits<double>::infinity();
  constexpr unsigned int n_points = 6;

  /** A straight cell of length 1 along x. */
  ControlPoints
  along_x(const double begin)
  {
    ControlPoints result;
    for (unsigned int k = 0; k < 4; ++k)
      result[k] = Tensor<1, 3>({begin + k / 3., 0., 0.});
    return result;
  }

  /** A straight cell of length 1 beside the middle of the former one. */
  ControlPoints
  crossing(const double distance)
  {
    ControlPoints result;
    for (unsigned int k = 0; k < 4; ++k)
      result[k] = Tensor<1, 3>({.4, k / 3. - .5, distance});
    return result;
  }

  ControlPoints
  parallel(const double distance)
  {
    ControlPoints result = along_x(.2);
    for (auto &point : result)
      point[2] = distance;
    return result;
  }

  void
  expect_partition(const std::vector<Segment> &segments)
  {
    ASSERT_FALSE(segments.empty());
    EXPECT_EQ(segments.front().begin, 0.);
    EXPECT_EQ(segments.back().end, 1.);
    for (unsigned int i = 0; i < segments.size(); ++i)
      {
        EXPECT_LT(segments[i].begin, segments[i].end);
        EXPECT_EQ(segments[i].begin, i > 0 ? segments[i - 1].end : 0.);
      }
  }

  /** The integral of gap^(-7/2) of the point (x, 0, 0) to the axis x = .4. */
  double
  integral(const std::vector<Segment> &segments,
           const unsigned int          n,
           const double                distance)
  {
    const dealii::QGauss<1> rule(n);
    double                  sum = 0.;
    for (const auto &[begin, end] : segments)
      for (unsigned int q = 0; q < n; ++q)
        {
          const double s   = begin + (end - begin) * rule.point(q)[0] - .4;
          const double gap = std::sqrt(distance * distance + s * s) - c;
          sum += (end - begin) * rule.weight(q) * std::pow(gap, -3.5);
        }
    return sum;
  }

  std::vector<Segment>
  equal(const unsigned int n)
  {
    std::vector<Segment> result;
    for (unsigned int i = 0; i < n; ++i)
      result.push_back({double(i) / n, (i + 1.) / n});
    return result;
  }
} // namespace



TEST(GradedSegments, ReachTheToleranceWithPointsWhereTheyAreNeeded)
{
  for (const double gap : {1e-3, 1e-2, 1e-1})
    {
      const double exact = integral(equal(4000), 8, c + gap);
      for (const double tolerance : {1e-2, 1e-4, 1e-6, 1e-8})
        {
          const GradedSegments grading(tolerance, n_points, 1, 0.);
          std::vector<Segment> segments;
          grading.divide(along_x(0.),
                         {{crossing(c + gap), c, infinity}},
                         segments);
          expect_partition(segments);
          EXPECT_NEAR(integral(segments, n_points, c + gap),
                      exact,
                      tolerance * exact)
            << gap << ' ' << tolerance;

          // Equal segments as short as the shortest are more.
          double shortest = 1.;
          for (const auto &[begin, end] : segments)
            shortest = std::min(shortest, end - begin);
          EXPECT_LE(segments.size(), 1. / shortest);
          EXPECT_TRUE(gap > 1e-2 || segments.size() < .7 / shortest);
        }
    }
}

TEST(GradedSegments, LeaveAloneWhatIsFarOrOutOfReach)
{
  const GradedSegments grading(1e-6, n_points, 3, 0.);
  std::vector<Segment> segments;
  grading.divide(along_x(0.), {{crossing(5.), c, infinity}}, segments);
  EXPECT_EQ(segments.size(), 3u);
  grading.divide(along_x(0.), {{crossing(.2), c, .15}}, segments);
  EXPECT_EQ(segments.size(), 3u);
  grading.divide(along_x(0.), {}, segments);
  EXPECT_EQ(segments.size(), 3u);
}

TEST(GradedSegments, AreEqualBesideAParallelFiber)
{
  const GradedSegments grading(1e-4, n_points, 1, 0.);
  std::vector<Segment> segments;
  ControlPoints        beside = along_x(0.);
  for (auto &point : beside)
    point[2] = c + 1e-2;
  grading.divide(along_x(0.), {{beside, c, infinity}}, segments);
  expect_partition(segments);
  for (const auto &[begin, end] : segments)
    EXPECT_EQ(end - begin, 1. / segments.size());
}

// Pairs of segments cover the square of both cells once.
TEST(GradedSegments, OfBothCellsCoverEveryPairOfPointsOnce)
{
  const GradedSegments                     grading(1e-4, n_points, 2, 0.);
  std::vector<std::pair<Segment, Segment>> pairs;
  for (const ControlPoints &other : {crossing(c + .01), parallel(c + .01)})
    {
      grading.divide_both(along_x(0.), {other, c, infinity}, pairs);
      double area = 0.;
      for (const auto &[first, second] : pairs)
        area += (first.end - first.begin) * (second.end - second.begin);
      EXPECT_NEAR(area, 1., 1e-14);
      for (unsigned int i = 0; i < pairs.size(); ++i)
        for (unsigned int j = 0; j < i; ++j)
          EXPECT_TRUE(pairs[i].first.end <= pairs[j].first.begin ||
                      pairs[j].first.end <= pairs[i].first.begin ||
                      pairs[i].second.end <= pairs[j].second.begin ||
                      pairs[j].second.end <= pairs[i].second.begin);
    }
  grading.divide_both(along_x(0.), {crossing(c + .01), c, c + .02}, pairs);
  double area = 0.;
  for (const auto &[first, second] : pairs)
    area += (first.end - first.begin) * (second.end - second.begin);
  EXPECT_LT(area, .5);
  EXPECT_GT(area, 0.);
}

TEST(GradedSegments, EndWhereCenterlinesMeet)
{
  const GradedSegments grading(1e-6, n_points, 1, 0.);
  std::vector<Segment> segments;
  grading.divide(along_x(0.), {{crossing(0.), c, infinity}}, segments);
  expect_partition(segments);
  EXPECT_LT(segments.size(), 5000u);

  // A law that is regularized is smooth on its own scale.
  const GradedSegments regularized(1e-6, n_points, 1, 1e-2);
  std::vector<Segment> few;
  regularized.divide(along_x(0.), {{crossing(0.), c, infinity}}, few);
  EXPECT_LT(few.size(), 50u);
}
