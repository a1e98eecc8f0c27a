// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <setae/assembly/far_field.h>

#include <utility>

// FarField, continued: the gaps between the curves of far pairs of cells.

namespace Setae
{
  double
  FarField::least_distance(const unsigned int A, const unsigned int B) const
  {
    const ClusterTree::Cluster &a = tree.clusters[A], &b = tree.clusters[B];
    return (a.center - b.center).norm() - a.radius - b.radius - skin;
  }



  void
  FarField::see_gaps(const State     &state,
                     const CurveGaps &curve_gaps,
                     GapReport       &report) const
  {
    for (const auto &[A, B] : pairs.far)
      see_gaps(A, B, state, curve_gaps, report);
  }



  /** Branch and bound: nearer parts of the clusters first. */
  void
  FarField::see_gaps(const unsigned int A,
                     const unsigned int B,
                     const State       &state,
                     const CurveGaps   &curve_gaps,
                     GapReport         &report) const
  {
    if (least_distance(A, B) >= report.smallest + curve_gaps.largest_radii())
      return;
    const ClusterTree::Cluster &a = tree.clusters[A], &b = tree.clusters[B];
    if (a.is_cell() && b.is_cell())
      {
        const unsigned int source =
          roles.interact(a.begin, b.begin) ? a.begin : b.begin;
        const unsigned int target = source == a.begin ? b.begin : a.begin;
        if (roles.interact(source, target) &&
            curve_gaps.may_be_smaller(state, source, target, report))
          curve_gaps.see(state, source, target, report);
        return;
      }
    const bool divide_first =
      b.is_cell() || (!a.is_cell() && a.radius >= b.radius);
    auto       children  = divide_first ? a.children : b.children;
    const auto pair_with = [&](const unsigned int child) {
      return divide_first ? std::make_pair(child, B) : std::make_pair(A, child);
    };
    const auto distance = [&](const unsigned int child) {
      const auto [first, second] = pair_with(child);
      return least_distance(first, second);
    };
    if (distance(children[1]) < distance(children[0]))
      std::swap(children[0], children[1]);
    for (const unsigned int child : children)
      {
        const auto [first, second] = pair_with(child);
        see_gaps(first, second, state, curve_gaps, report);
      }
  }
} // namespace Setae
