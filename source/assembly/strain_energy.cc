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
    for (const unsigned int cell : fibers.owned_cells)
      if (!fibers.is_rigid(cell))
        {
          cells.push_back(cell);
          beams.emplace_back(fibers.initial[cell],
                             circular_section(fibers.parameters_of_cell(cell)));
        }
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
        local.reset(request);
        beams[i].add(state.displacement[cells[i]], request, local);
        energy += local.energy;
        system.add(cells[i], local);
      }
    return energy;
  }



  SectionForces
  StrainEnergy::section_forces(const State       &state,
                               const unsigned int cell,
                               const double       x) const
  {
    if (fibers.is_rigid(cell))
      return {};
    const auto found = std::lower_bound(cells.begin(), cells.end(), cell);
    return beams[found - cells.begin()].section_forces(state.displacement[cell],
                                                       x);
  }
} // namespace Setae
