// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

// The assembled interaction of whole fibers: its residual and its tangent
// matrix are the differences of its energy and its residual, whatever the roles
// of the fibers, their radii and the law.

#include <gtest/gtest.h>

#include <setae/assembly/interaction.h>
#include <setae/scene.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

using namespace Setae;

namespace
{
  using Vector = dealii::TrilinosWrappers::MPI::Vector;

  /** Two fibers that cross in space, thick and thin, @p gap apart. */
  std::string
  crossing_fibers(const std::string &interaction)
  {
    return R"(
set constants = gap = 0.02
subsection fibers
  set names = thick, thin
  subsection thick
    set centerline = s - 0.5; 0; 0
    set radius     = 0.06
    set cells      = 2
    set number density = 2
  end
  subsection thin
    set centerline = 0.8*(s - 0.45); 0.6*(s - 0.4); 0.08 + gap
    set radius     = 0.02
    set cells      = 3
  end
end
subsection interactions
  set names = law
  subsection law
    set cutoff               = 0.4
    set switch width         = 0.5
    set integration segments = 1
    set prefactors           = -1e-2, 1e-13
)" + interaction +
           R"(
  end
end)";
  }

  /** A fiber bent to most of a circle, of which the ends interact. */
  std::string
  open_ring(const std::string &interaction)
  {
    return R"(
set coordinates = x, y
subsection fibers
  set names = ring
  subsection ring
    set centerline = cos(6*s); sin(6*s); 0
    set radius     = 0.05
    set cells      = 6
  end
end
subsection interactions
  set names = law
  subsection law
    set self interaction     = true
    set cutoff               = 0.8
    set switch width         = 0.9
    set integration segments = 2
    set prefactors           = -1, 1e-9
)" + interaction +
           R"(
  end
end)";
  }



  /** The interaction of a scene with displacements that are free to choose. */
  class Assembled
  {
  public:
    Assembled(const std::string &text)
      : scene(Scene::read(text, "test.prm"))
      , fibers(scene, MPI_COMM_SELF)
      , term(make_interaction(fibers, scene.interactions[0]))
      , system(fibers)
      , solution(fibers.owned_dofs, MPI_COMM_SELF)
    {
      unconstrained.close();
    }

    /** Displace the fibers at random, by much less than they are long. */
    void
    perturb(const unsigned int seed)
    {
      std::mt19937                           random(seed);
      std::uniform_real_distribution<double> uniform(-1e-2, 1e-2);
      for (const auto i : fibers.owned_dofs)
        solution(i) = uniform(random);
    }

    /** Energy; leaves residual and tangent matrix in the system. */
    double
    assemble(const Request request)
    {
      const State state = fibers.state(solution, 0.);
      term->update_couplings(state);
      if (request == Request::tangent)
        system.reinit_matrix(pattern());
      system.start(request, unconstrained);
      const double energy = term->assemble(state, request, system);
      system.finish();
      return energy;
    }

    const Scene                       scene;
    const FiberSystem                 fibers;
    const std::unique_ptr<EnergyTerm> term;
    GlobalSystem                      system;
    Vector                            solution;

  private:
    dealii::DynamicSparsityPattern
    pattern() const
    {
      std::vector<std::pair<unsigned int, unsigned int>> pairs;
      term->add_couplings(pairs);
      dealii::DynamicSparsityPattern result(fibers.dof_handler.n_dofs());
      for (const auto &[first, second] : pairs)
        for (const unsigned int row_cell : {first, second})
          for (const auto row : fibers.cell_dofs[row_cell])
            for (const unsigned int column_cell : {first, second})
              for (const auto column : fibers.cell_dofs[column_cell])
                if (row != dealii::numbers::invalid_dof_index &&
                    column != dealii::numbers::invalid_dof_index)
                  result.add(row, column);
      return result;
    }

    dealii::AffineConstraints<double> unconstrained;
  };



  /** Compare with central differences of fourth order. */
  void
  expect_differences(Assembled &problem)
  {
    constexpr double step = 1e-5; // the gaps are about 1e-2

    problem.assemble(Request::tangent);
    const Vector               residual(problem.system.residual);
    const unsigned int         n = problem.solution.size();
    dealii::FullMatrix<double> tangent(n, n);
    double                     largest = 0.;
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
        {
          tangent(i, j) = problem.system.tangent_matrix.el(i, j);
          largest       = std::max(largest, std::abs(tangent(i, j)));
        }
    ASSERT_GT(largest, 0.);
    ASSERT_GT(residual.linfty_norm(), 0.);

    const std::vector<std::pair<double, double>> stencil = {{1., 8. / 12.},
                                                            {-1., -8. / 12.},
                                                            {2., -1. / 12.},
                                                            {-2., 1. / 12.}};
    double worst_residual = 0., worst_tangent = 0.;
    for (unsigned int j = 0; j < n; ++j)
      {
        const double value = problem.solution(j);
        double       first = 0.;
        Vector       column(residual);
        column = 0.;
        for (const auto &[shift, weight] : stencil)
          {
            problem.solution(j) = value + shift * step;
            first += weight / step * problem.assemble(Request::residual);
            column.add(weight / step, problem.system.residual);
          }
        problem.solution(j) = value;
        worst_residual =
          std::max(worst_residual, std::abs(first - residual(j)));
        for (unsigned int i = 0; i < n; ++i)
          worst_tangent =
            std::max(worst_tangent, std::abs(column(i) - tangent(i, j)));
      }
    EXPECT_LT(worst_residual, 1e-7 * residual.linfty_norm());
    EXPECT_LT(worst_tangent, 1e-7 * largest);
  }



  /** The same in some random states of the scene @p text. */
  void
  expect_differences_of(const std::string &text)
  {
    for (unsigned int seed = 0; seed < 5; ++seed)
      {
        Assembled problem(text);
        problem.perturb(seed);
        expect_differences(problem);
      }
  }

  double
  energy_of(const std::string &text)
  {
    Assembled problem(text);
    problem.perturb(1);
    return problem.assemble(Request::energy);
  }

  const std::string thick_on_thin = "set source = thick \n set target = thin";
  const std::string thin_on_thick = "set source = thin \n set target = thick";
} // namespace



TEST(Interaction, OfSectionsHasTheDerivativesOfItsEnergy)
{
  expect_differences_of(crossing_fibers("set law = disk-disk"));
}

TEST(Interaction, OfSectionAndBeamHasTheDerivativesOfItsEnergy)
{
  expect_differences_of(crossing_fibers(thick_on_thin));
  expect_differences_of(crossing_fibers(thin_on_thick));
}

TEST(Interaction, InTwoHalfPassesHasTheDerivativesOfItsEnergy)
{
  expect_differences_of(crossing_fibers("set two half passes = true"));
}

TEST(Interaction, OfAFiberWithItselfHasTheDerivativesOfItsEnergy)
{
  expect_differences_of(open_ring("set law = disk-cylinder"));
  expect_differences_of(open_ring("set law = disk-disk"));
}

TEST(Interaction, InTwoHalfPassesIsTheMeanOfBothSides)
{
  const double thick = energy_of(crossing_fibers(thick_on_thin)),
               thin  = energy_of(crossing_fibers(thin_on_thick));
  const double both  = energy_of(crossing_fibers("set two half passes = true"));
  EXPECT_GT(std::abs(thick - thin), 1e-3 * std::abs(both));
  EXPECT_NEAR(both, .5 * (thick + thin), 1e-12 * std::abs(both));
}

// The integral over both sections of a pair of points does not ask which one
// comes first.
TEST(Interaction, OfSectionsIsTheSameFromBothSides)
{
  const std::string law   = "set law = disk-disk \n";
  const double      thick = energy_of(crossing_fibers(law + thick_on_thin)),
               thin       = energy_of(crossing_fibers(law + thin_on_thick));
  EXPECT_NE(thick, 0.);
  EXPECT_NEAR(thick, thin, 1e-12 * std::abs(thick));
}
