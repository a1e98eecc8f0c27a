// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <setae/assembly/interaction.h>
#include <setae/laws/lennard_jones.h>

namespace Setae
{
  SectionPair
  section_pair(const InteractionParameters &parameters,
               const FiberParameters       &source,
               const FiberParameters       &target)
  {
    if (parameters.distribution == "surface")
      return {source.radius,
              target.radius,
              source.surface_density,
              target.surface_density,
              Distribution::surface};
    return {source.radius,
            target.radius,
            source.number_density,
            target.number_density,
            Distribution::volume};
  }

  PointPotential
  point_potential(const InteractionParameters &parameters,
                  const SectionPair           &sections)
  {
    if (parameters.prefactors.empty())
      return lennard_jones_of_cylinders(parameters.equilibrium_gap,
                                        parameters.force_minimum,
                                        sections);
    PointPotential potential;
    for (unsigned int i = 0; i < parameters.exponents.size(); ++i)
      potential.push_back({parameters.exponents[i], parameters.prefactors[i]});
    return potential;
  }
} // namespace Setae
