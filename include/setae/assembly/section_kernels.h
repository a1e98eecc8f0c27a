// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_assembly_section_kernels_h
#define setae_assembly_section_kernels_h

#include <setae/assembly/interaction_kernel.h>
#include <setae/assembly/interaction_roles.h>
#include <setae/base/exceptions.h>

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <utility>

namespace Setae
{
  /** The kernels of an interaction, one for each pair of sections. */
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
            const SectionPair sections = section_pair(parameters,
                                                      fibers.scene.fibers[s],
                                                      fibers.scene.fibers[t]);
            check_equal(parameters, sections);
            const Kernel<Law> kernel = make_kernel<Law>(parameters, sections);
            kernels.emplace(std::make_pair(s, t), kernel);
            largest_reach = std::max(largest_reach, kernel.reach());
            smallest_radius =
              std::min({smallest_radius, sections.radius_1, sections.radius_2});
          }
    }

    /** The kernel between two cells. */
    const Kernel<Law> &
    between(const unsigned int source, const unsigned int target) const
    {
      return kernels
        .find({fibers.fibers[fibers.fiber_of_cell[source]].parameters,
               fibers.fibers[fibers.fiber_of_cell[target]].parameters})
        ->second;
    }

    double largest_reach = 0.; ///< [length]
    double smallest_radius =
      std::numeric_limits<double>::infinity(); ///< [length]

  private:
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

    const FiberSystem                                           &fibers;
    std::map<std::pair<unsigned int, unsigned int>, Kernel<Law>> kernels;
  };
} // namespace Setae

#endif
