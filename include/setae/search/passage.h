// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_search_passage_h
#define setae_search_passage_h

#include <setae/search/closest_approach.h>

#include <functional>
#include <optional>
#include <vector>

namespace Setae
{
  /** Two cells that come too near to each other on their way. */
  struct Passage
  {
    unsigned int source = 0, target = 0;
    double       x        = 0.; ///< reference coordinate on the source
    double       fraction = 0.; ///< of the way

    /** What comes first on the way, and of the same the lower index. */
    bool
    is_before(const Passage &other) const;
  };

  /**
   * Whether two cells, whose control points [length] move on straight lines
   * from one place to another, come nearer to each other than @p core on the
   * way, and where.
   *
   * Conservative advancement: no point moves faster than the control points,
   * so that the distance d at one place says how long it stays above the core;
   * it is found by closest_approach(). Cells that are nearer than the core at
   * the beginning are not judged, neither is the end of one fiber before that
   * of another: there, fibers may be as near as they like without overlapping.
   *
   * @param ends_1, ends_2 Which nodes are ends of fibers.
   */
  std::optional<Passage>
  find_passage(const CubicPart::ControlPoints &from_1,
               const CubicPart::ControlPoints &to_1,
               const CubicPart::ControlPoints &from_2,
               const CubicPart::ControlPoints &to_2,
               const double                    core,
               const CellEnds                 &ends_1 = {},
               const CellEnds                 &ends_2 = {});

  /**
   * The first passage of all pairs of @p sources and @p targets.
   *
   * @param from, to Control points of all cells [length].
   * @param largest_core Of all pairs [length].
   * @param core The distance of two cells that is too near, or zero if they may
   * pass through each other.
   */
  std::optional<Passage>
  find_passage(const std::vector<CubicPart::ControlPoints> &from,
               const std::vector<CubicPart::ControlPoints> &to,
               const std::vector<unsigned int>             &sources,
               const std::vector<unsigned int>             &targets,
               const double                                 largest_core,
               const std::function<double(const unsigned int source,
                                          const unsigned int target)> &core,
               const std::function<CellEnds(const unsigned int cell)> &ends);
} // namespace Setae

#endif
