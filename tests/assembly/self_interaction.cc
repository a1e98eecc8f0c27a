// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

// One fiber bent to a hairpin, whose legs feel each other.

#include <setae/assembly/interaction.h>
#include <setae/laws/all.h>

#include <deal.II/base/quadrature_lib.h>

#include "assembled.h"

using namespace Setae;

namespace
{
  constexpr unsigned int n_cells = 10;

  const char *const straight = R"(
subsection fibers
  set names = hair
  subsection hair
    set centerline = s; 0; 0
    set length     = 3
    set radius     = 0.1
    set cells      = 10
  end
end
subsection interactions
  set names = lj
  subsection lj
    set exponents            = 6, 12
    set prefactors           = -1, 1e-7
    set self interaction     = true
    set excluded neighbors   = 3
    set cutoff               = 0.6
    set switch width         = 0.5
    set integration segments = 1
    set gauss points         = 4
  end
end
)";

  std::unique_ptr<EnergyTerm>
  first_interaction(const FiberSystem &fibers)
  {
    return make_interaction(fibers, fibers.scene.interactions[0]);
  }

  /** A half circle of length 1 between two legs of length 1, not quite plane. */
  Assembled::Vector
  hairpin(const Assembled &system)
  {
    Assembled::Vector q = system.random_displacements(.01, 5);
    for (unsigned int node = 0; node <= n_cells; ++node)
      {
        const double s = 3. * node / n_cells, r = 1. / M_PI;
        const double angle = std::min(std::max(s - 1., 0.) / r, M_PI);
        Tensor<1, 3> position, tangent;
        position[0] = (s < 1. ? s : s > 2. ? 3. - s : 1.) + r * std::sin(angle);
        position[1] = r * (1. - std::cos(angle));
        tangent[0]  = std::cos(angle);
        tangent[1]  = std::sin(angle);

        position[0] -= s;
        tangent[0] -= 1.;
        for (unsigned int c = 0; c < 3; ++c)
          {
            q(system.fibers.node_dof(0, node, false, c)) += position[c];
            q(system.fibers.node_dof(0, node, true, c)) += tangent[c];
          }
      }
    return q;
  }

  class SelfInteraction : public testing::TestWithParam<std::string>
  {
  protected:
    Assembled         system{straight,
                     {"interactions/lj/law=" + GetParam()},
                     first_interaction};
    Assembled::Vector q = hairpin(system);
  };

  INSTANTIATE_TEST_SUITE_P(
    ,
    SelfInteraction,
    testing::Values("disk-disk", "disk-cylinder"),
    [](const auto &info) {
      return info.param == "disk-disk" ? "DiskDisk" : "DiskCylinder";
    });
} // namespace



TEST_P(SelfInteraction, HasTheGradientOfItsEnergy)
{
  expect_gradient(system, q, 1e-4, 1e-8);
}



TEST_P(SelfInteraction, HasTheHessianOfItsEnergy)
{
  expect_linearization(system, q, 1e-4, 1e-7);
}



TEST_P(SelfInteraction, ExertsNoForceAndNoMomentInTotal)
{
  const Resultant total = resultant(system, q, system.residual(q));
  EXPECT_LT(total.force.norm(), 1e-13 * total.force_scale);
  EXPECT_LT(total.moment.norm(), 1e-13 * total.moment_scale);
}



TEST_P(SelfInteraction, IsOffUnlessTheSceneAsksForIt)
{
  Assembled without(straight,
                    {"interactions/lj/law=" + GetParam(),
                     "interactions/lj/self interaction=false"},
                    first_interaction);
  EXPECT_EQ(without.energy(q), 0.);
  EXPECT_NE(system.energy(q), 0.);
}



TEST_P(SelfInteraction, DoesNotActInAStraightFiber)
{
  Assembled::Vector zero(q);
  zero = 0.;
  EXPECT_EQ(system.energy(zero), 0.);
}



TEST(SelfInteractionOfDisks, CountsEveryPairOfDistantSitesOnce)
{
  Assembled system(straight,
                   {"interactions/lj/law=disk-disk"},
                   first_interaction);
  const auto  q     = hairpin(system);
  const State state = system.fibers.state(q, 0.);

  const DiskDisk law({{6, -1.}, {12, 1e-7}}, {.1, .1, 1., 1.}, {0., .3, .6});
  const dealii::QGauss<1>            rule(4);
  std::vector<std::vector<LineSite>> sites(n_cells);
  for (unsigned int i = 0; i < n_cells; ++i)
    evaluate_sites(rule, system.fibers.initial[i], state.current[i], sites[i]);

  double energy = 0.;
  for (unsigned int i = 0; i < n_cells; ++i)
    for (unsigned int j = i + 4; j < n_cells; ++j)
      for (const LineSite &a : sites[i])
        for (const LineSite &b : sites[j])
          energy += a.weight * b.weight * law((a.r - b.r).norm() - .2).value;
  EXPECT_NEAR(system.energy(q) / energy, 1., 1e-13);
}
