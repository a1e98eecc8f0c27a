// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <setae/assembly/global_system.h>

namespace Setae
{
  using namespace dealii;

  GlobalSystem::GlobalSystem(const FiberSystem &fibers)
    : right_hand_side(fibers.owned_dofs, fibers.communicator)
    , residual(fibers.owned_dofs, fibers.communicator)
    , fibers(fibers)
  {}



  void
  GlobalSystem::reinit_matrix(const DynamicSparsityPattern &pattern)
  {
    tangent_matrix.reinit(
      fibers.owned_dofs, fibers.owned_dofs, pattern, fibers.communicator, true);
  }



  void
  GlobalSystem::start(const Request                    request,
                      const AffineConstraints<double> &constraints)
  {
    this->request     = request;
    this->constraints = &constraints;
    residual          = 0.;
    sum_of_squares    = 0.;
    if (request >= Request::tangent)
      {
        tangent_matrix  = 0.;
        right_hand_side = 0.;
      }
  }



  template <unsigned int n>
  void
  GlobalSystem::add(const std::array<types::global_dof_index, n> &dofs,
                    const LocalSystem<n>                         &local)
  {
    if (request < Request::residual)
      return;

    std::array<unsigned int, n> active;
    unsigned int                n_active = 0;
    for (unsigned int i = 0; i < n; ++i)
      if (dofs[i] != numbers::invalid_dof_index)
        active[n_active++] = i;

    cell_indices.resize(n_active);
    cell_vector.reinit(n_active, true);
    for (unsigned int i = 0; i < n_active; ++i)
      {
        cell_indices[i] = dofs[active[i]];
        cell_vector[i]  = local.residual[active[i]];
      }
    residual.add(cell_indices, cell_vector);
    if (request < Request::tangent)
      return;

    cell_matrix.reinit(n_active, n_active);
    for (unsigned int i = 0; i < n_active; ++i)
      for (unsigned int j = 0; j < n_active; ++j)
        cell_matrix(i, j) = local.tangent[active[i]][active[j]];
    cell_vector *= -1.;
    constraints->distribute_local_to_global(cell_matrix,
                                            cell_vector,
                                            cell_indices,
                                            tangent_matrix,
                                            right_hand_side,
                                            true);
  }



  template <unsigned int n>
  void
  GlobalSystem::count_forces(const unsigned int    cell,
                             const LocalSystem<n> &local,
                             const unsigned int    first)
  {
    const double *const r      = local.residual.data() + first;
    double              forces = 0., moments = 0.;
    for (unsigned int c = 0; c < 3; ++c)
      {
        forces += r[c] * r[c] + r[6 + c] * r[6 + c];
        moments += r[3 + c] * r[3 + c] + r[9 + c] * r[9 + c];
      }
    const double h = fibers.initial[cell].h;
    sum_of_squares += forces + moments / (h * h);
  }



  void
  GlobalSystem::add(const unsigned int cell, const LocalSystem<12> &local)
  {
    count_forces(cell, local, 0);
    add<12>(fibers.cell_dofs[cell], local);
  }



  void
  GlobalSystem::add(const unsigned int     source,
                    const unsigned int     target,
                    const LocalSystem<24> &local)
  {
    count_forces(source, local, 0);
    count_forces(target, local, 12);
    std::array<types::global_dof_index, 24> dofs;
    std::copy(fibers.cell_dofs[source].begin(),
              fibers.cell_dofs[source].end(),
              dofs.begin());
    std::copy(fibers.cell_dofs[target].begin(),
              fibers.cell_dofs[target].end(),
              dofs.begin() + 12);
    add<24>(dofs, local);
  }



  void
  GlobalSystem::finish()
  {
    residual.compress(VectorOperation::add);
    if (request >= Request::tangent)
      {
        tangent_matrix.compress(VectorOperation::add);
        right_hand_side.compress(VectorOperation::add);
      }
  }
} // namespace Setae
