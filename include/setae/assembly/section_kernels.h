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
   * The kernels of an interaction, one for each pair of sections; if targets
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
      std::set<unsigned int> sources, targets;
      for (unsigned int f = 0; f < fibers.fibers.size(); ++f)
        {
          if (roles.may_be_source(f))
            sources.insert(fibers.fibers[f].parameters);
          if (roles.may_be_target(f))
            targets.insert(fibers.fibers[f].parameters);
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
        .find({fibers.fibers[fibers.fiber_of_cell[source]].parameters,
               fibers.fibers[fibers.fiber_of_cell[target]].parameters,
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
                                                fibers.scene.fibers[source],
                                                fibers.scene.fibers[target]);
      check_equal(parameters, sections);
      const Kernel<Law> kernel = make_kernel(parameters,
                                             sections,
                                             law_between(parameters, sections),
                                             source_is_zone);
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

    /** No table is made twice. */
    const Law &
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
      return laws.emplace(key, make_law_between<Law>(parameters, sections))
        .first->second;
    }

    static void
    check_equal(const InteractionParameters &parameters,
                const SectionPair           &sections)
    {
      AssertThrow(parameters.force_minimum == 0. ||
                    (sections.radius_1 == sections.radius_2 &&
                     sections.density_1 == sections.density_2),
                  ExcParameter("interactions/" + parameters.name +
                                 "/force minimum",
                               std::to_string(parameters.force_minimum),
                               "replaced by 'prefactors' for fibers that "
                               "differ in radius or number density"));
    }

    const FiberSystem                                                  &fibers;
    std::map<std::array<double, 4>, Law>                                laws;
    std::map<std::tuple<unsigned int, unsigned int, bool>, Kernel<Law>> kernels;
  };
} // namespace Setae

#endif
