// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <setae/assembly/interaction.h>
#include <setae/laws/all.h>
#include <setae/laws/lennard_jones.h>

#include <type_traits>

namespace Setae
{
  namespace
  {
    /** Lennard-Jones' potential from what the scene says of parallel fibers. */
    template <typename Law>
    PointPotential
    lennard_jones(const InteractionParameters &parameters,
                  const SectionPair           &sections)
    {
      // Its formula is exact for this law.
      if (std::is_same_v<Law, DiskCylinder> && parameters.force_minimum != 0.)
        return lennard_jones_of_cylinders(parameters.equilibrium_gap,
                                          parameters.force_minimum,
                                          sections);
      const auto law_of = [&](const InversePower &power) {
        return make_law<Law>({power},
                             sections,
                             GapRange(),
                             {parameters.section_points[0],
                              parameters.section_points[1],
                              parameters.law_tolerance});
      };
      const LennardJonesOfLaw<Law> fibers(law_of({6, -1.}),
                                          law_of({12, 1.}),
                                          sections);
      if (parameters.force_minimum != 0.)
        return fibers.potential(parameters.equilibrium_gap,
                                parameters.force_minimum);
      const InversePower attraction =
        attraction_of_hamaker_constant(parameters.hamaker_constant, sections);
      return {attraction,
              {12,
               -attraction.prefactor *
                 fibers.repulsion_over_attraction(parameters.equilibrium_gap)}};
    }
  } // namespace



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
    PointPotential potential;
    if (parameters.equilibrium_gap > 0.)
      {
        PotentialLaws::dispatch(parameters.law, [&](auto tag) {
          using Law = typename decltype(tag)::type;
          if constexpr (!Law::is_long_range)
            potential = lennard_jones<Law>(parameters, sections);
        });
        return potential;
      }
    if (parameters.hamaker_constant != 0.)
      return {
        attraction_of_hamaker_constant(parameters.hamaker_constant, sections)};
    for (unsigned int i = 0; i < parameters.exponents.size(); ++i)
      potential.push_back({parameters.exponents[i], parameters.prefactors[i]});
    return potential;
  }
} // namespace Setae
