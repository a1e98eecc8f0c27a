// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_interactions_double_sum_h
#define setae_interactions_double_sum_h

#include <deal.II/base/config.h>

namespace Setae
{
  /**
   * The sum over all pairs of sites of two bodies: the one loop behind
   * section-section interactions (sites on lines, a law of the gap of two
   * sections) and behind the full integral over two solid bodies (sites in
   * volumes or on surfaces, the law of two points).
   *
   * What the two have in common is that the law depends on the distance of the
   * sites only. A site has a weight and is connected() to another one by the
   * vector d from target to source; @p law turns that into the quantity it
   * depends on (`law.coordinate(d)`) and this into energy and derivatives; @p sum
   * collects what is wanted of them:
   * @code
   * sum.begin(source);
   * sum.accepts(coordinate)   // whether the pair interacts
   * sum.add(source, target, d, coordinate, law(coordinate));
   * sum.end(source);
   * @endcode
   * A target may stand for several sites at once, on Lanes.
   */
  template <typename Sources, typename Targets, typename Law, typename Sum>
  DEAL_II_ALWAYS_INLINE inline void
  double_sum(const Sources &sources,
             const Targets &targets,
             const Law     &law,
             Sum           &sum)
  {
    for (const auto &source : sources)
      {
        sum.begin(source);
        for (const auto &target : targets)
          {
            const auto d = connect(source, target);
            const auto x = law.coordinate(d);
            if (sum.accepts(x))
              sum.add(source, target, d, x, law(x));
          }
        sum.end(source);
      }
  }
} // namespace Setae

#endif
