// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

// The interactions as the solver sees them: one energy of all degrees of freedom
// of a scene in space, with its gradient and its Hessian.

#include <setae/assembly/interaction.h>
#include <setae/laws/all.h>

#include <deal.II/base/quadrature_lib.h>

#include "assembled.h"

using namespace Setae;

namespace
{
  // Two fibers that cross at an angle and at a gap of half their radius, where
  // attraction and repulsion are equally strong.
  const char *const crossing = R"(
subsection fibers
  set names = a, b
  subsection a
    set centerline = s - 0.5; 0.1*s; 0
    set radius     = 0.1
    set cells      = 3
  end
  subsection b
    set centerline = 0.4 - 0.7*s; 0.9*s - 0.4; 0.25
    set radius     = 0.1
    set cells      = 2
  end
end
subsection interactions
  set names = lj
  subsection lj
    set source       = a
    set target       = b
    set exponents    = 6, 12
    set prefactors   = -1, 1e-7
    set cutoff       = 0.3
    set switch width = 0.5
    set gauss points = 5
  end
end
)";

  const std::string law       = "interactions/lj/law=";
  const std::string half      = "interactions/lj/two half passes=true";
  const std::string swapped_1 = "interactions/lj/source=b";
  const std::string swapped_2 = "interactions/lj/target=a";
  const std::string wider     = "fibers/b/radius=0.13";

  std::unique_ptr<EnergyTerm>
  first_interaction(const FiberSystem &fibers)
  {
    return make_interaction(fibers, fibers.scene.interactions[0]);
  }

  struct Case
  {
    std::string              name;
    std::vector<std::string> overrides;
  };

  class AssembledInteraction : public testing::TestWithParam<Case>
  {
  protected:
    Assembled         system{crossing, GetParam().overrides, first_interaction};
    Assembled::Vector q = system.random_displacements(.02, 1);
  };

  INSTANTIATE_TEST_SUITE_P(
    ,
    AssembledInteraction,
    testing::Values(
      Case{"DiskDisk", {law + "disk-disk"}},
      Case{"DiskDiskOfDifferentRadii", {law + "disk-disk", wider}},
      Case{"DiskDiskInTwoHalfPasses", {law + "disk-disk", half}},
      Case{"DiskCylinder", {law + "disk-cylinder"}},
      Case{"DiskCylinderOfDifferentRadii", {law + "disk-cylinder", wider}},
      Case{"DiskCylinderInTwoHalfPasses", {law + "disk-cylinder", half}},
      Case{"DiskCylinderInTwoHalfPassesOfDifferentRadii",
           {law + "disk-cylinder", half, wider}}),
    [](const auto &info) { return info.param.name; });
} // namespace



TEST_P(AssembledInteraction, HasTheGradientOfItsEnergy)
{
  expect_gradient(system, q, 1e-4, 1e-8);
}



TEST_P(AssembledInteraction, HasTheHessianOfItsEnergy)
{
  expect_linearization(system, q, 1e-4, 1e-7);
}



TEST_P(AssembledInteraction, ExertsNoForceAndNoMomentInTotal)
{
  const Resultant total = resultant(system, q, system.residual(q));
  EXPECT_LT(total.force.norm(), 1e-14 * total.force_scale);
  EXPECT_LT(total.moment.norm(), 1e-13 * total.moment_scale);
}



TEST_P(AssembledInteraction, VanishesBeyondTheCutoff)
{
  Assembled::Vector apart(q);
  for (unsigned int node = 0; node <= 2; ++node)
    apart(system.fibers.node_dof(1, node, false, 2)) += .5;
  EXPECT_EQ(system.energy(apart), 0.);
  EXPECT_EQ(system.residual(apart).linfty_norm(), 0.);
  EXPECT_EQ(system.smallest_gap(), std::numeric_limits<double>::infinity());
}



TEST(TwoHalfPasses, AreOnePassOfALawOfTheDistance)
{
  Assembled  one(crossing, {law + "disk-disk", wider}, first_interaction);
  Assembled  two(crossing, {law + "disk-disk", wider, half}, first_interaction);
  const auto q        = one.random_displacements(.02, 2);
  const auto residual = one.residual(q);
  auto       difference = two.residual(q);
  difference -= residual;
  EXPECT_NEAR(two.energy(q) / one.energy(q), 1., 1e-14);
  EXPECT_LT(difference.linfty_norm(), 1e-13 * residual.linfty_norm());
}



TEST(TwoHalfPasses, AreTheMeanOfBothDirections)
{
  const std::string disk_cylinder = law + "disk-cylinder";
  Assembled forward(crossing, {disk_cylinder, wider}, first_interaction);
  Assembled backward(crossing,
                     {disk_cylinder, wider, swapped_1, swapped_2},
                     first_interaction);
  Assembled both(crossing, {disk_cylinder, wider, half}, first_interaction);

  const auto q    = both.random_displacements(.02, 3);
  auto       mean = forward.residual(q);
  mean += backward.residual(q);
  mean *= .5;
  auto difference = both.residual(q);
  difference -= mean;
  EXPECT_NEAR(both.energy(q) / (.5 * (forward.energy(q) + backward.energy(q))),
              1.,
              1e-14);
  EXPECT_LT(difference.linfty_norm(), 1e-13 * mean.linfty_norm());

  // Otherwise this would not show anything.
  EXPECT_GT(std::abs(forward.energy(q) / backward.energy(q) - 1.), 1e-3);
}



TEST(Groups, ThatOverlapLetEveryPairOfFibersInteractOnce)
{
  const std::string disk_disk = law + "disk-disk";
  Assembled pair(crossing, {disk_disk}, first_interaction);
  Assembled all(crossing,
                {disk_disk,
                 "interactions/lj/source=all",
                 "interactions/lj/target=all"},
                first_interaction);
  const auto q = pair.random_displacements(.02, 4);
  EXPECT_NEAR(all.energy(q) / pair.energy(q), 1., 1e-14);
}
