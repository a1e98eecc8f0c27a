// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_assembly_section_kernels_h
#define setae_assembly_section_kernels_h

#include <setae/assembly/interaction_kernel.h>
#include <setae/assembly/interaction_roles.h>
#include <setae/base/exceptions.h>

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <tuple>

namespace Setae
{
  /**
   * The kernels of an interaction, one for each pair of different sections
   * (fibers with the same radius and densities share one); if targets
   * are finite, a second one with the roles exchanged for the sections in the
   * EndZone of a target.
   */
  template <typename Law>
  class SectionKernels
  {
  public:
    /** @throws ExcParameter if the parameters do not fit two sections. */
    SectionKernels(const FiberSystem           &fibers,
                   const InteractionParameters &parameters,
                   const InteractionRoles      &roles)
      : fibers(fibers)
    {
      std::set<unsigned int>                        sources, targets;
      std::map<std::array<double, 3>, unsigned int> first_with;
      for (unsigned int f = 0; f < fibers.fibers.size(); ++f)
        {
          const FiberParameters &fiber = fibers.parameters[f];
          section_of_fiber.push_back(
            first_with
              .insert(
                {{{fiber.radius, fiber.number_density, fiber.surface_density}},
                 f})
              .first->second);
          if (roles.may_be_source(f))
            sources.insert(section_of_fiber[f]);
          if (roles.may_be_target(f))
            targets.insert(section_of_fiber[f]);
        }
      for (const unsigned int s : sources)
        for (const unsigned int t : targets)
          {
            make(parameters, s, t, false);
            if (has_finite_targets<Law>(parameters))
              make(parameters, t, s, true);
          }
    }

    /**
     * The kernel between two cells.
     *
     * @param source_is_zone Whether the source is a target of the interaction.
     */
    const Kernel<Law> &
    between(const unsigned int source,
            const unsigned int target,
            const bool         source_is_zone = false) const
    {
      return kernels
        .find({section_of_fiber[fibers.fiber_of_cell[source]],
               section_of_fiber[fibers.fiber_of_cell[target]],
               source_is_zone})
        ->second;
    }

    double largest_reach  = 0.; ///< [length]
    double largest_cutoff = 0.; ///< a gap [length]
    double largest_radius = 0.; ///< [length]
    double smallest_radius =
      std::numeric_limits<double>::infinity(); ///< [length]

  private:
    void
    make(const InteractionParameters &parameters,
         const unsigned int           source,
         const unsigned int           target,
         const bool                   source_is_zone)
    {
      const SectionPair sections = section_pair(parameters,
                                                fibers.parameters[source],
                                                fibers.parameters[target]);
      check_equal(parameters, sections);
      const PotentialAndLaw &pair   = law_between(parameters, sections);
      const Kernel<Law>      kernel = make_kernel(
        parameters, pair.potential, sections, pair.law, source_is_zone);
      kernels.emplace(std::make_tuple(source, target, source_is_zone), kernel);
      largest_reach = std::max(largest_reach, kernel.reach());
      largest_cutoff =
        std::max(largest_cutoff,
                 kernel.reach() - sections.radius_1 - sections.radius_2);
      for (const double radius : {sections.radius_1, sections.radius_2})
        {
          largest_radius  = std::max(largest_radius, radius);
          smallest_radius = std::min(smallest_radius, radius);
        }
    }

    struct PotentialAndLaw
    {
      PointPotential potential; ///< none for contact
      Law            law;
    };

    /** No potential is looked for and no table is made twice. */
    const PotentialAndLaw &
    law_between(const InteractionParameters &parameters,
                const SectionPair           &sections)
    {
      const std::array<double, 4> key = {{sections.radius_1,
                                          sections.radius_2,
                                          sections.density_1,
                                          sections.density_2}};
      const auto                  law = laws.find(key);
      if (law != laws.end())
        return law->second;
      const PointPotential potential = std::is_same_v<Law, PenaltyContact> ?
                                         PointPotential() :
                                         point_potential(parameters, sections);
      return laws
        .emplace(key,
                 PotentialAndLaw{
                   potential,
                   make_law_between<Law>(parameters, potential, sections)})
        .first->second;
    }

    static void
    check_equal(const InteractionParameters &parameters,
                const SectionPair           &sections)
    {
      const bool has_force = parameters.force_minimum != 0.;
      require(parameters.equilibrium_gap == 0. ||
                (sections.radius_1 == sections.radius_2 &&
                 sections.density_1 == sections.density_2),
              "interactions/" + parameters.name +
                (has_force ? "/force minimum" : "/equilibrium gap"),
              has_force ? parameters.force_minimum : parameters.equilibrium_gap,
              "replaced by 'prefactors' for fibers that differ in radius or "
              "number density");
      require(parameters.hamaker_constant == 0. ||
                (sections.density_1 > 0. && sections.density_2 > 0.),
              "interactions/" + parameters.name + "/hamaker constant",
              parameters.hamaker_constant,
              "left out for fibers without a number density");
    }

    const FiberSystem &fibers;

    /** The first fiber with the section of each fiber. */
    std::vector<unsigned int> section_of_fiber;

    std::map<std::array<double, 4>, PotentialAndLaw>                    laws;
    std::map<std::tuple<unsigned int, unsigned int, bool>, Kernel<Law>> kernels;
  };
} // namespace Setae

#endif
