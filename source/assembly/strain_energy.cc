// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <setae/assembly/strain_energy.h>
#include <setae/fibers/cross_section.h>

#include <algorithm>

namespace Setae
{
  StrainEnergy::StrainEnergy(const FiberSystem &fibers)
    : fibers(fibers)
  {
    beams.reserve(fibers.owned_cells.size());
    for (const unsigned int cell : fibers.owned_cells)
      beams.emplace_back(fibers.initial[cell],
                         circular_section(fibers.parameters_of_cell(cell)));
  }



  double
  StrainEnergy::assemble(const State  &state,
                         const Request request,
                         GlobalSystem &system)
  {
    double          energy = 0.;
    LocalSystem<12> local;
    for (unsigned int i = 0; i < beams.size(); ++i)
      {
        const unsigned int cell = fibers.owned_cells[i];
        local.reset(request);
        beams[i].add(state.displacement[cell], request, local);
        energy += local.energy;
        system.add(cell, local);
      }
    return energy;
  }



  SectionForces
  StrainEnergy::section_forces(const State       &state,
                               const unsigned int cell,
                               const double       x) const
  {
    const auto owned = std::lower_bound(fibers.owned_cells.begin(),
                                        fibers.owned_cells.end(),
                                        cell);
    return beams[owned - fibers.owned_cells.begin()].section_forces(
      state.displacement[cell], x);
  }
} // namespace Setae
