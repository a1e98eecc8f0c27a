// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <setae/assembly/curve_gaps.h>
#include <setae/search/hull_distance.h>

#include <algorithm>

namespace Setae
{
  namespace
  {
    /** Gaps of parallel fibers differ by less without being different. */
    constexpr double round_off = 1e-14;

    std::vector<CubicPart::ControlPoints>
    control_points(const State &state)
    {
      std::vector<CubicPart::ControlPoints> result;
      result.reserve(state.current.size());
      for (const HermiteCell<> &cell : state.current)
        result.push_back(cell.control_points());
      return result;
    }
  } // namespace



  CurveGaps::CurveGaps(const FiberSystem      &fibers,
                       const InteractionRoles &roles,
                       const bool              ends_are_flat,
                       const double            cutoff)
    : fibers(fibers)
    , roles(roles)
    , ends_are_flat(ends_are_flat)
    , cutoff(cutoff)
  {
    for (const FiberParameters &fiber : fibers.parameters)
      twice_largest_radius = std::max(twice_largest_radius, 2. * fiber.radius);
  }



  double
  CurveGaps::radii(const unsigned int source, const unsigned int target) const
  {
    return fibers.parameters_of_cell(source).radius +
           fibers.parameters_of_cell(target).radius;
  }



  CellEnds
  CurveGaps::ends(const unsigned int cell) const
  {
    const FiberEnds ends = fibers.place_of_cell(cell).ends;
    return {ends.left, ends.right};
  }



  bool
  CurveGaps::may_be_smaller(const State       &state,
                            const unsigned int source,
                            const unsigned int target,
                            const GapReport   &report) const
  {
    const double bound =
      std::min(report.smallest, cutoff) + radii(source, target);
    return hull_distance(state.current[source].control_points(),
                         state.current[target].control_points()) <
           (1. - round_off) * bound;
  }



  void
  CurveGaps::see(const State       &state,
                 const unsigned int source,
                 const unsigned int target,
                 GapReport         &report) const
  {
    const double radii    = this->radii(source, target);
    const auto   left_out = [this](const unsigned int cell) {
      return ends_are_flat ? ends(cell) : CellEnds();
    };
    const ClosestApproach nearest =
      closest_approach(state.current[source].control_points(),
                       state.current[target].control_points(),
                       std::min(report.smallest, cutoff) + radii,
                       left_out(source),
                       left_out(target));
    report.see({nearest.distance - radii, source, target, nearest.x});
  }



  std::vector<LineSite>
  CurveGaps::sites_at_ends(const State &state, const unsigned int cell) const
  {
    std::vector<LineSite> sites;
    const CellEnds        ends = this->ends(cell);
    const auto            add  = [&](const double x) {
      append_sites(dealii::Quadrature<1>(dealii::Point<1>(x)),
                   0.,
                   1.,
                   fibers.initial[cell],
                   state.current[cell],
                   sites);
    };
    if (ends.first)
      add(0.);
    if (ends.last)
      add(1.);
    return sites;
  }



  std::optional<Passage>
  CurveGaps::find_passage(const State                     &from,
                          const State                     &to,
                          const std::vector<unsigned int> &sources,
                          const std::vector<unsigned int> &targets) const
  {
    const auto core = [this](const unsigned int source,
                             const unsigned int target) {
      return roles.interact(source, target) ?
               .5 * std::min(fibers.parameters_of_cell(source).radius,
                             fibers.parameters_of_cell(target).radius) :
               0.;
    };
    double largest_core = 0.;
    for (const unsigned int source : sources)
      largest_core =
        std::max(largest_core, .5 * fibers.parameters_of_cell(source).radius);
    return Setae::find_passage(control_points(from),
                               control_points(to),
                               sources,
                               targets,
                               largest_core,
                               core,
                               [this](const unsigned int cell) {
                                 return ends(cell);
                               });
  }
} // namespace Setae
