// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_assembly_curve_gaps_h
#define setae_assembly_curve_gaps_h

#include <setae/assembly/interaction_roles.h>
#include <setae/interactions/line_sites.h>
#include <setae/search/passage.h>

#include <optional>
#include <vector>

namespace Setae
{
  /**
   * Gaps between the curves of pairs of cells: the distance of the centerlines
   * where they are closest, less the radii. Sites see this gap only by chance.
   *
   * The ends of fibers are flat for laws that let a fiber end. Before one, that
   * distance is less than the gap, and such minima do not count: the sections
   * at the ends of fibers are sites of their own (at_end()), and the law says
   * what their gap is. For the other laws ends are round, and the distance less
   * the radii is their gap everywhere.
   */
  class CurveGaps
  {
  public:
    /** @param cutoff The gap beyond which none is reported [length]. */
    CurveGaps(const FiberSystem      &fibers,
              const InteractionRoles &roles,
              const bool              ends_are_flat,
              const double            cutoff);

    /** Twice the largest radius [length]. */
    double
    largest_radii() const
    {
      return twice_largest_radius;
    }

    /** Whether some points of two cells may have a gap below those reported. */
    bool
    may_be_smaller(const State       &state,
                   const unsigned int source,
                   const unsigned int target,
                   const GapReport   &report) const;

    /** Let a report see the curves of two cells. */
    void
    see(const State       &state,
        const unsigned int source,
        const unsigned int target,
        GapReport         &report) const;

    /** The sites at the ends of a fiber on a cell: none, one or two. */
    std::vector<LineSite>
    sites_at_ends(const State &state, const unsigned int cell) const;

    /**
     * The first place on the straight way between two states where fibers that
     * interact come nearer than half of the smaller radius to each other: they
     * pass through each other, whatever their gaps are before and after.
     *
     * @param sources, targets Those of this rank, those of all ranks.
     */
    std::optional<Passage>
    find_passage(const State                     &from,
                 const State                     &to,
                 const std::vector<unsigned int> &sources,
                 const std::vector<unsigned int> &targets) const;

  private:
    double
    radii(const unsigned int source, const unsigned int target) const;

    /** Which nodes of a cell are flat ends. */
    CellEnds
    ends(const unsigned int cell) const;

    const FiberSystem      &fibers;
    const InteractionRoles &roles;
    const bool              ends_are_flat;
    const double            cutoff;
    double                  twice_largest_radius = 0.;
  };
} // namespace Setae

#endif
