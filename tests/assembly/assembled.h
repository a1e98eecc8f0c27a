// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_tests_assembly_assembled_h
#define setae_tests_assembly_assembled_h

#include <gtest/gtest.h>

#include <setae/assembly/interaction.h>
#include <setae/scene.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <string>

namespace Setae
{
  using Vector = dealii::TrilinosWrappers::MPI::Vector;

  /** The interaction of a scene with displacements that are free to choose. */
  class Assembled
  {
  public:
    explicit Assembled(const std::string &text)
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

    /** All entries of the tangent matrix of the last assemble(). */
    dealii::FullMatrix<double>
    tangent() const
    {
      const unsigned int         n = solution.size();
      dealii::FullMatrix<double> result(n, n);
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = 0; j < n; ++j)
          result(i, j) = system.tangent_matrix.el(i, j);
      if (term->has_tangent_product())
        for (unsigned int j = 0; j < n; ++j)
          {
            Vector unit(fibers.owned_dofs, MPI_COMM_SELF), column(unit);
            unit(j) = 1.;
            term->add_tangent_product(fibers.state(unit, 0.), column);
            column.compress(dealii::VectorOperation::add);
            for (unsigned int i = 0; i < n; ++i)
              result(i, j) += column(i);
          }
      return result;
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
  inline void
  expect_differences(Assembled &problem)
  {
    constexpr double step = 1e-5; // the gaps are about 1e-2

    problem.assemble(Request::tangent);
    const Vector                     residual(problem.system.residual);
    const unsigned int               n       = problem.solution.size();
    const dealii::FullMatrix<double> tangent = problem.tangent();
    double                           largest = 0.;
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
        largest = std::max(largest, std::abs(tangent(i, j)));
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
} // namespace Setae

#endif
