// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_assembly_interaction_pass_h
#define setae_assembly_interaction_pass_h

#include <setae/assembly/interaction_roles.h>
#include <setae/interactions/end_zone.h>
#include <setae/search/neighbor_list.h>

#include <utility>
#include <vector>

namespace Setae
{
  /**
   * The cells that are integrated over and those near them: sources and
   * targets, or the EndZone of every target and the sources near it.
   */
  class InteractionPass
  {
  public:
    /**
     * @param of_zones Whether the targets are integrated over.
     * @param largest_radius Of all sections [length].
     * @param reach, skin See NeighborList.
     */
    InteractionPass(const FiberSystem      &fibers,
                    const InteractionRoles &roles,
                    const bool              of_zones,
                    const double            largest_radius,
                    const double            reach,
                    const double            skin)
      : of_zones(of_zones)
      , roles(roles)
      , neighbors(reach, skin)
    {
      const auto may_be = [&](const unsigned int cell, const bool source) {
        const unsigned int fiber = fibers.fiber_of_cell[cell];
        return source ? roles.may_be_source(fiber) : roles.may_be_target(fiber);
      };
      const auto is_integrated = [&](const unsigned int cell) {
        if (!of_zones)
          return may_be(cell, true);
        const CellPlace place = fibers.place_of_cell(cell);
        return may_be(cell, false) &&
               EndZone(2. * largest_radius, place.fiber_length).touches(place);
      };
      for (const unsigned int cell : fibers.owned_cells)
        if (is_integrated(cell))
          sources.push_back(cell);
      for (unsigned int cell = 0; cell < fibers.initial.size(); ++cell)
        if (may_be(cell, of_zones))
          targets.push_back(cell);
    }

    bool
    needs_rebuild(
      const std::vector<NeighborList::ControlPoints> &control_points) const
    {
      return neighbors.needs_rebuild(control_points);
    }

    void
    build(const std::vector<NeighborList::ControlPoints> &control_points)
    {
      neighbors.build(control_points,
                      sources,
                      targets,
                      [this](const unsigned int s, const unsigned int t) {
                        return of_zones ? roles.interact(t, s) :
                                          roles.interact(s, t);
                      });
    }

    /** The targets near the source number @p i. */
    auto
    partners(const unsigned int i) const
    {
      return neighbors.targets(i);
    }

    const bool                of_zones;
    std::vector<unsigned int> sources; ///< owned
    std::vector<unsigned int> targets; ///< of all ranks

  private:
    const InteractionRoles &roles;
    NeighborList            neighbors;
  };



  /** All passes of an interaction. */
  class InteractionPasses
  {
  public:
    /** @param with_zones Whether targets have an EndZone. */
    InteractionPasses(const FiberSystem      &fibers,
                      const InteractionRoles &roles,
                      const bool              with_zones,
                      const double            largest_radius,
                      const double            reach,
                      const double            skin)
    {
      for (const bool of_zones : {false, true})
        if (!of_zones || with_zones)
          passes.emplace_back(
            fibers, roles, of_zones, largest_radius, reach, skin);
    }

    /** @return Whether any list of neighbors is new. */
    bool
    update(const State &state)
    {
      std::vector<NeighborList::ControlPoints> cells;
      cells.reserve(state.current.size());
      for (const HermiteCell<> &cell : state.current)
        cells.push_back(cell.control_points());
      bool is_new = false;
      for (InteractionPass &pass : passes)
        if (pass.needs_rebuild(cells))
          {
            pass.build(cells);
            is_new = true;
          }
      return is_new;
    }

    const InteractionPass &
    first() const
    {
      return passes.front();
    }

    auto
    begin() const
    {
      return passes.begin();
    }

    auto
    end() const
    {
      return passes.end();
    }

  private:
    std::vector<InteractionPass> passes;
  };
} // namespace Setae

#endif
