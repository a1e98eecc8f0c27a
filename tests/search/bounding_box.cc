// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <gtest/gtest.h>

#include <setae/search/bounding_box.h>

#include "random_cells.h"

using namespace Setae;
using namespace RandomCells;



TEST(BoundingBox, ContainsTheCurve)
{
  std::mt19937 random(1);
  for (const auto &cell : random_curved_cells(100, 10., random))
    {
      const BoundingBox<3> box = bounding_box(cell);
      for (const auto &point : sample(cell, 50))
        EXPECT_LT(distance_square(box,
                                  Tensor<1, 3>({point[0], point[1], point[2]})),
                  1e-26);
    }
}



TEST(BoundingBox, DistanceIsEuclideanAndZeroInside)
{
  const BoundingBox<3> box({{0., 0., 0.}, {1., 2., 3.}});
  EXPECT_EQ(distance_square(box, Tensor<1, 3>({0.5, 2., 1.})), 0.);
  EXPECT_EQ(distance_square(box, Tensor<1, 3>({-2., 1., 1.})), 4.);
  EXPECT_EQ(distance_square(box, Tensor<1, 3>({3., 5., -4.})), 4. + 9. + 16.);

  EXPECT_EQ(distance_square(box, BoundingBox<3>({{.5, 1., 1.}, {9., 9., 9.}})),
            0.);
  const BoundingBox<3> far({{3., 5., -9.}, {4., 6., -4.}});
  EXPECT_EQ(distance_square(box, far), 4. + 9. + 16.);
  EXPECT_EQ(distance_square(far, box), 4. + 9. + 16.);
}
