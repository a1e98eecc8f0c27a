// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_tests_assembly_assembled_h
#define setae_tests_assembly_assembled_h

#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/full_matrix.h>

#include <setae/assembly/energy_term.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <memory>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace Setae
{
  /**
   * One energy term of a scene as a function of all degrees of freedom, on one
   * rank and without supports.
   */
  class Assembled
  {
  public:
    using Vector = dealii::TrilinosWrappers::MPI::Vector;
    using Factory =
      std::function<std::unique_ptr<EnergyTerm>(const FiberSystem &)>;

    Assembled(const std::string              &text,
              const std::vector<std::string> &overrides,
              const Factory                  &make_term)
      : scene(Scene::read(text, "test.prm", overrides))
      , fibers(scene, MPI_COMM_SELF)
      , term(make_term(fibers))
      , system(fibers)
    {
      none.close();
    }

    /** Displacements that deform every fiber at random. */
    Vector
    random_displacements(const double amplitude, const unsigned int seed) const
    {
      std::mt19937                           random(seed);
      std::uniform_real_distribution<double> uniform(-amplitude, amplitude);

      Vector q(fibers.owned_dofs, MPI_COMM_SELF);
      for (const auto i : fibers.owned_dofs)
        q(i) = uniform(random);
      q.compress(dealii::VectorOperation::insert);
      return q;
    }

    double
    energy(const Vector &q)
    {
      return assemble(q, Request::energy);
    }

    Vector
    residual(const Vector &q)
    {
      assemble(q, Request::residual);
      return system.residual;
    }

    dealii::FullMatrix<double>
    tangent(const Vector &q)
    {
      assemble(q, Request::tangent);
      dealii::FullMatrix<double> result(q.size(), q.size());
      for (const auto &entry : system.tangent_matrix)
        result(entry.row(), entry.column()) = entry.value();
      return result;
    }

    double
    smallest_gap() const
    {
      return term->gaps().smallest;
    }

  private:
    double
    assemble(const Vector &q, const Request request)
    {
      const State state = fibers.state(q, time);
      if (term->update_couplings(state) || system.tangent_matrix.m() == 0)
        setup_matrix();
      system.start(request, none);
      const double energy = term->assemble(state, request, system);
      system.finish();
      return energy;
    }

    void
    setup_matrix()
    {
      std::vector<std::pair<unsigned int, unsigned int>> pairs;
      for (const unsigned int cell : fibers.owned_cells)
        pairs.emplace_back(cell, cell);
      term->add_couplings(pairs);

      dealii::DynamicSparsityPattern pattern(fibers.owned_dofs);
      for (const auto &[first, second] : pairs)
        {
          std::vector<dealii::types::global_dof_index> dofs;
          for (const unsigned int cell : {first, second})
            for (const auto dof : fibers.cell_dofs[cell])
              if (dof != dealii::numbers::invalid_dof_index)
                dofs.push_back(dof);
          none.add_entries_local_to_global(dofs, pattern, true);
        }
      system.reinit_matrix(pattern);
    }

  public:
    double                            time = 1.;
    const Scene                       scene;
    const FiberSystem                 fibers;
    const std::unique_ptr<EnergyTerm> term;

  private:
    dealii::AffineConstraints<double> none;
    GlobalSystem                      system;
  };



  /** The derivative at 0 of a function, with an error of fourth order. */
  template <typename Function>
  auto
  difference(const Function &function, const double h)
  {
    auto result = function(h);
    result -= function(-h);
    result *= 8.;
    result -= function(2. * h);
    result += function(-2. * h);
    result *= 1. / (12. * h);
    return result;
  }



  /** The residual is the gradient of the energy, up to @p tolerance. */
  inline void
  expect_gradient(Assembled               &system,
                  const Assembled::Vector &q,
                  const double             h,
                  const double             tolerance)
  {
    const Assembled::Vector residual = system.residual(q);
    ASSERT_GT(residual.linfty_norm(), 0.);
    for (const auto i : system.fibers.owned_dofs)
      {
        const auto energy = [&](const double x) {
          Assembled::Vector moved(q);
          moved(i) += x;
          return system.energy(moved);
        };
        EXPECT_NEAR(residual(i),
                    difference(energy, h),
                    tolerance * residual.linfty_norm())
          << "degree of freedom " << i;
      }
  }



  /** The tangent matrix is the derivative of the residual. */
  inline void
  expect_linearization(Assembled               &system,
                       const Assembled::Vector &q,
                       const double             h,
                       const double             tolerance)
  {
    const dealii::FullMatrix<double> tangent = system.tangent(q);
    double                           largest = 0.;
    for (unsigned int i = 0; i < tangent.m(); ++i)
      for (unsigned int j = 0; j < tangent.n(); ++j)
        largest = std::max(largest, std::abs(tangent(i, j)));
    ASSERT_GT(largest, 0.);
    for (const auto j : system.fibers.owned_dofs)
      {
        const auto residual = [&](const double x) {
          Assembled::Vector moved(q);
          moved(j) += x;
          return system.residual(moved);
        };
        const Assembled::Vector column = difference(residual, h);
        for (const auto i : system.fibers.owned_dofs)
          EXPECT_NEAR(tangent(i, j), column(i), tolerance * largest)
            << "row " << i << ", column " << j;
      }
  }



  /** Force and moment about the origin of a residual, and their scales. */
  struct Resultant
  {
    Tensor<1, 3> force, moment;
    double       force_scale = 0., moment_scale = 0.;
  };

  inline Resultant
  resultant(const Assembled         &system,
            const Assembled::Vector &q,
            const Assembled::Vector &residual)
  {
    const FiberSystem &fibers = system.fibers;
    const State        state  = fibers.state(q, 0.);
    Resultant          result;
    for (unsigned int f = 0; f < fibers.fibers.size(); ++f)
      for (unsigned int node = 0;
           node < fibers.fibers[f].n_cells + (fibers.fibers[f].closed ? 0 : 1);
           ++node)
        for (const bool tangent : {false, true})
          {
            const bool         is_left = node < fibers.fibers[f].n_cells;
            const unsigned int cell =
              fibers.fibers[f].first_cell + node - (is_left ? 0 : 1);
            const Tensor<1, 3> place =
              state.current[cell]
                .coefficients[(is_left ? 0 : 2) + (tangent ? 1 : 0)];

            Tensor<1, 3> force;
            for (unsigned int c = 0; c < 3; ++c)
              {
                const auto dof = fibers.node_dof(f, node, tangent, c);
                if (dof != dealii::numbers::invalid_dof_index)
                  force[c] = residual(dof);
              }
            const Tensor<1, 3> moment = cross_product_3d(place, force);
            result.moment += moment;
            result.moment_scale += moment.norm();
            if (!tangent)
              {
                result.force += force;
                result.force_scale += force.norm();
              }
          }
    return result;
  }
} // namespace Setae

#endif
