// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

// Clusters of cells instead of all pairs: energy and forces within the bound of
// the error, for all roles of the fibers; exact derivatives of that energy.

#include <setae/assembly/far_field.h>
#include <setae/assembly/interaction_kernel.h>

#include <array>

#include "assembled.h"

using namespace Setae;

namespace
{
  std::string
  coulomb(const double tolerance, const std::string &roles)
  {
    return R"(
subsection interactions
  set names = coulomb
  subsection coulomb
    set law                  = monopole
    set distribution         = surface
    set exponents            = 1, 3
    set prefactors           = 1, 0.2
    set integration segments = 1
    set integration tolerance = 0
    set gauss points         = 3
    set skin                 = 0.05
    set far field tolerance  = )" +
           std::to_string(tolerance) + "\n" + roles + R"(
  end
end)";
  }

  /** Some fibers of either charge in all directions, of two to three cells. */
  std::string
  fibers_in_space(const double tolerance, const std::string &roles)
  {
    return R"(
subsection fibers
  set names = positive, negative
  subsection positive
    set copies     = 2, 2, 2
    set centerline = 2*i + s*sin(7*i+3*j+5*k)*cos(2*i+8*j+k); \
                     2*j + s*sin(7*i+3*j+5*k)*sin(2*i+8*j+k); \
                     2*k + s*cos(7*i+3*j+5*k)
    set radius     = 0.05
    set cells      = 3
  end
  subsection negative
    set copies          = 2, 2
    set centerline      = 1+2*i + s*cos(3*i+j); 1+2*j + s*sin(3*i+j); 1
    set radius          = 0.02
    set cells           = 2
    set surface density = -3
  end
end)" + coulomb(tolerance, roles);
  }

  /** One fiber bent to most of a circle. */
  std::string
  open_ring(const double tolerance, const unsigned int n_excluded)
  {
    return R"(
set coordinates = x, y
subsection fibers
  set names = ring
  subsection ring
    set centerline = cos(6*s); sin(6*s); 0
    set radius     = 0.05
    set cells      = 24
  end
end)" + coulomb(tolerance,
                "set self interaction = true\n set excluded neighbors = " +
                  std::to_string(n_excluded));
  }

  const std::vector<std::string> all_roles = {
    "",
    "set source = positive\n set target = negative",
    "set source = all\n set target = negative",
    "set source = positive\n set target = all\n set two half passes = true"};

  /** Differences from all pairs, relative to a sum of magnitudes. */
  struct Difference
  {
    double energy, residual;
  };

  Difference
  difference(const std::string &clusters, const std::string &all_pairs)
  {
    Assembled    approximate(clusters), exact(all_pairs);
    const double energy       = approximate.assemble(Request::residual),
                 exact_energy = exact.assemble(Request::residual);
    Vector residual(approximate.system.residual);
    residual -= exact.system.residual;
    return {std::abs(energy - exact_energy) / std::abs(exact_energy),
            residual.l2_norm() / exact.system.residual.l2_norm()};
  }
} // namespace



TEST(FarField, IsAsAccurateAsAskedForWhateverTheRoles)
{
  for (const std::string &roles : all_roles)
    for (const double tolerance : {1e-1, 1e-3, 1e-5})
      {
        const Difference d = difference(fibers_in_space(tolerance, roles),
                                        fibers_in_space(0., roles));
        EXPECT_LT(d.energy, tolerance) << roles;
        EXPECT_LT(d.residual, tolerance) << roles;
        // That something is approximated at all
        EXPECT_GT(d.residual, 1e-14) << roles;
      }
}

TEST(FarField, KnowsExcludedNeighborsOnAFiber)
{
  for (const unsigned int n_excluded : {1, 9})
    {
      const Difference d =
        difference(open_ring(1e-2, n_excluded), open_ring(0., n_excluded));
      EXPECT_LT(d.energy, 1e-2);
      EXPECT_LT(d.residual, 1e-2);
      EXPECT_GT(d.residual, 1e-14);
    }
}

TEST(FarField, HasTheDerivativesOfItsEnergy)
{
  for (const std::string &text :
       {fibers_in_space(1e-2, ""), open_ring(1e-2, 2)})
    {
      Assembled problem(text);
      problem.perturb(1);
      expect_differences(problem);
    }
}

TEST(FarField, LetsActionBeReaction)
{
  Assembled problem(fibers_in_space(1e-1, ""));
  problem.perturb(2);
  problem.assemble(Request::residual);

  Tensor<1, 3> sum;
  double       magnitudes = 0.;
  for (unsigned int f = 0; f < problem.fibers.fibers.size(); ++f)
    for (unsigned int node = 0; node <= problem.fibers.fibers[f].n_cells;
         ++node)
      for (unsigned int c = 0; c < 3; ++c)
        {
          const double force =
            problem.system.residual(problem.fibers.node_dof(f, node, false, c));
          sum[c] += force;
          magnitudes += std::abs(force);
        }
  EXPECT_LT(sum.norm(), 1e-14 * magnitudes);
}

// A cell that approaches has to leave the clusters: the bound holds after any
// motion that the skin notices.
TEST(FarField, NoticesMotionsBeyondTheSkin)
{
  const std::string text = fibers_in_space(1e-3, "");
  Assembled         problem(text), all_pairs(fibers_in_space(0., ""));
  problem.assemble(Request::residual);
  for (Assembled *p : {&problem, &all_pairs})
    for (unsigned int node = 0; node <= 3; ++node)
      p->solution(p->fibers.node_dof(0, node, false, 0)) = 1.5;
  EXPECT_TRUE(
    problem.term->update_couplings(problem.fibers.state(problem.solution, 0.)));
  const double energy = problem.assemble(Request::residual),
               exact  = all_pairs.assemble(Request::residual);
  EXPECT_NEAR(energy, exact, 1e-3 * std::abs(exact));
}

TEST(FarField, LeavesFewPairsOfCells)
{
  const Scene                  scene = Scene::read(R"(
subsection fibers
  set names = grid
  subsection grid
    set copies     = 6, 6, 6
    set centerline = 2*i + s; 2*j; 2*k
    set cells      = 2
    set radius     = 0.01
  end
end)" + coulomb(1e-2, ""),
                                  "grid.prm");
  const FiberSystem            fibers(scene, MPI_COMM_SELF);
  const InteractionParameters &parameters = scene.interactions.front();
  const InteractionRoles       roles(fibers, parameters);
  FarField far_field(fibers, parameters, roles, integration_rule(parameters));
  State    state;
  state.current = fibers.initial;
  far_field.build(state, fibers.owned_cells);

  const std::size_t n = fibers.initial.size(), n_all = n * (n - 2) / 2;
  EXPECT_LT(far_field.n_near_pairs() + far_field.n_far_pairs(), .5 * n_all);
  EXPECT_FALSE(far_field.needs_rebuild(state));
}
