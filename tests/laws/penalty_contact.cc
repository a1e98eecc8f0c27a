// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <gtest/gtest.h>

#include <setae/laws/penalty_contact.h>

#include "../nested_sacado.h"

using namespace Setae;

TEST(PenaltyContact, HasTheDerivativesOfItsEnergy)
{
  const PenaltyContact law(1e3);
  for (const double gap : {-1., -1e-3, -1e-12, 1e-12, 1.})
    {
      const NestedFad<2> energy =
        law.energy(variable<2>(0, gap), variable<2>(1, .3));
      const LocalSystem<2>      sacado  = local_system<2>(energy);
      const GapAngleDerivatives by_hand = law(gap, .3);
      EXPECT_DOUBLE_EQ(by_hand.value, sacado.energy);
      EXPECT_DOUBLE_EQ(by_hand.g, sacado.residual[0]);
      EXPECT_DOUBLE_EQ(by_hand.gg, sacado.tangent[0][0]);
      EXPECT_EQ(by_hand.c, 0.);
      EXPECT_EQ(by_hand.gc, 0.);
      EXPECT_EQ(by_hand.cc, 0.);
    }
}

TEST(PenaltyContact, OnlyPushes)
{
  const PenaltyContact law(1e3);
  EXPECT_EQ(law(1e-9, 0.).value, 0.);
  EXPECT_EQ(law(1e-9, 0.).g, 0.);
  EXPECT_EQ(-law(-2e-3, 0.).g, 2.);
  EXPECT_EQ(law(-2e-3, 0.).value, 2e-3);
}
