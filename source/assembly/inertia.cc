// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>

#include <setae/assembly/inertia.h>
#include <setae/base/derivative.h>
#include <setae/fibers/cross_section.h>

namespace Setae
{
  using namespace dealii;

  Inertia::Inertia(const FiberSystem &fibers)
    : fibers(fibers)
    , masses(fibers.owned_cells.size())
    , everywhere(fibers.owned_dofs,
                 complete_index_set(fibers.dof_handler.n_dofs()),
                 fibers.communicator)
  {
    // Exact for straight cells, whose products are of degree six.
    const QGauss<1> rule(6);
    for (unsigned int i = 0; i < masses.size(); ++i)
      {
        const unsigned int     cell       = fibers.owned_cells[i];
        const FiberParameters &parameters = fibers.parameters_of_cell(cell);
        const HermiteCell<>   &initial    = fibers.initial[cell];
        const double           density =
          parameters.density * area_of_circular_section(parameters);
        for (unsigned int q = 0; q < rule.size(); ++q)
          {
            const double x = rule.point(q)[0];
            const auto   N = Hermite::shape_values(x, initial.h);
            const double dm =
              density * initial.derivative(x).norm() * rule.weight(q);
            for (unsigned int a = 0; a < 4; ++a)
              for (unsigned int b = 0; b < 4; ++b)
                masses[i][a][b] += dm * N[a] * N[b];
          }
      }
  }



  std::array<Tensor<1, 3>, 4>
  Inertia::coefficients(const Vector &vector, const unsigned int cell) const
  {
    std::array<Tensor<1, 3>, 4> result;
    for (unsigned int a = 0; a < 4; ++a)
      for (unsigned int c = 0; c < 3; ++c)
        {
          const auto dof = fibers.cell_dofs[cell][3 * a + c];
          if (dof != numbers::invalid_dof_index)
            result[a][c] = vector(dof);
        }
    return result;
  }



  void
  Inertia::add(const Vector &rate, const double factor, GlobalSystem &system)
  {
    everywhere = rate;
    for (unsigned int i = 0; i < masses.size(); ++i)
      {
        const unsigned int cell       = fibers.owned_cells[i];
        const auto         cell_rates = coefficients(everywhere, cell);
        LocalSystem<12>    local;
        for (unsigned int a = 0; a < 4; ++a)
          for (unsigned int b = 0; b < 4; ++b)
            for (unsigned int c = 0; c < 3; ++c)
              {
                const double m = masses[i][a][b];
                local.residual[3 * a + c] += m * cell_rates[b][c];
                local.tangent[3 * a + c][3 * b + c] = factor * m;
              }
        system.add(cell, local);
      }
  }



  Inertia::Vector
  Inertia::multiply(const Vector &vector)
  {
    everywhere = vector;
    Vector result(fibers.owned_dofs, fibers.communicator);
    for (unsigned int i = 0; i < masses.size(); ++i)
      {
        const unsigned int cell   = fibers.owned_cells[i];
        const auto         values = coefficients(everywhere, cell);
        for (unsigned int a = 0; a < 4; ++a)
          {
            Tensor<1, 3> product;
            for (unsigned int b = 0; b < 4; ++b)
              product += masses[i][a][b] * values[b];
            for (unsigned int c = 0; c < 3; ++c)
              {
                const auto dof = fibers.cell_dofs[cell][3 * a + c];
                if (dof != numbers::invalid_dof_index)
                  result(dof) += product[c];
              }
          }
      }
    result.compress(VectorOperation::add);
    return result;
  }



  Momenta
  Inertia::momenta(const State &state, const Vector &velocity)
  {
    everywhere = velocity;
    Momenta result;
    for (unsigned int i = 0; i < masses.size(); ++i)
      {
        const unsigned int cell = fibers.owned_cells[i];
        const auto         v    = coefficients(everywhere, cell);
        for (unsigned int a = 0; a < 4; ++a)
          for (unsigned int b = 0; b < 4; ++b)
            {
              const Tensor<1, 3> p = masses[i][a][b] * v[b];
              result.kinetic_energy += .5 * v[a] * p;
              // A translation is the sum of the shape functions 0 and 2.
              if (a == 0 || a == 2)
                result.linear += p;
              result.angular +=
                cross_product_3d(state.current[cell].coefficients[a], p);
            }
      }
    result.kinetic_energy =
      Utilities::MPI::sum(result.kinetic_energy, fibers.communicator);
    result.linear  = Utilities::MPI::sum(result.linear, fibers.communicator);
    result.angular = Utilities::MPI::sum(result.angular, fibers.communicator);
    return result;
  }



  Inertia::Vector
  Inertia::initial_velocity() const
  {
    Vector result(fibers.owned_dofs, fibers.communicator);
    for (unsigned int f = 0; f < fibers.fibers.size(); ++f)
      {
        const Fiber           &fiber      = fibers.fibers[f];
        const FiberParameters &parameters = fibers.parameters[f];
        const VectorExpression velocity("fibers/" + parameters.name +
                                          "/initial velocity",
                                        parameters.initial_velocity,
                                        "s",
                                        with_copy(fibers.scene.constants,
                                                  fiber.copy));
        const unsigned int     n_nodes = fiber.n_cells + (fiber.closed ? 0 : 1);
        const std::vector<double> &s   = fiber.arc_length;
        for (unsigned int node = 0; node < n_nodes; ++node)
          {
            const Tensor<1, 3> values[] = {
              velocity(s[node]),
              differentiate_within([&](const double x) { return velocity(x); },
                                   s[node],
                                   0.,
                                   s.back(),
                                   s.back() / fiber.n_cells)
                .mean()};
            for (const unsigned int order : {0, 1})
              for (unsigned int c = 0; c < 3; ++c)
                {
                  const auto dof = fibers.node_dof(f, node, order == 1, c);
                  if (dof != numbers::invalid_dof_index &&
                      fibers.owned_dofs.is_element(dof))
                    result(dof) = values[order][c];
                }
          }
      }
    result.compress(VectorOperation::insert);
    return result;
  }
} // namespace Setae
