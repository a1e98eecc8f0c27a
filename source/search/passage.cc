// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <deal.II/numerics/rtree.h>

#include <boost/iterator/function_output_iterator.hpp>

#include <setae/search/bounding_box.h>
#include <setae/search/hull_distance.h>
#include <setae/search/passage.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace Setae
{
  namespace
  {
    using ControlPoints = CubicPart::ControlPoints;

    ControlPoints
    between(const ControlPoints &from,
            const ControlPoints &to,
            const double         fraction)
    {
      ControlPoints result;
      for (unsigned int k = 0; k < 4; ++k)
        result[k] = from[k] + fraction * (to[k] - from[k]);
      return result;
    }

    /** A bound of how far points of two cells move with regard to each other.
     */
    double
    relative_motion(const ControlPoints &from_1,
                    const ControlPoints &to_1,
                    const ControlPoints &from_2,
                    const ControlPoints &to_2)
    {
      Tensor<1, 3> mean;
      for (unsigned int k = 0; k < 4; ++k)
        mean += (to_1[k] - from_1[k]) / 8. + (to_2[k] - from_2[k]) / 8.;
      double first = 0., second = 0.;
      for (unsigned int k = 0; k < 4; ++k)
        {
          first  = std::max(first, (to_1[k] - from_1[k] - mean).norm_square());
          second = std::max(second, (to_2[k] - from_2[k] - mean).norm_square());
        }
      return std::sqrt(first) + std::sqrt(second);
    }

    bool
    is_at_end(const CellEnds &ends, const double x)
    {
      return (ends.first && x <= 0.) || (ends.last && x >= 1.);
    }

    /** The box around a cell on its way. */
    BoundingBox<3>
    swept_box(const ControlPoints &from, const ControlPoints &to)
    {
      BoundingBox<3> box = bounding_box(from);
      box.merge_with(bounding_box(to));
      return box;
    }
  } // namespace



  bool
  Passage::is_before(const Passage &other) const
  {
    return std::tie(fraction, source, target) <
           std::tie(other.fraction, other.source, other.target);
  }



  std::optional<Passage>
  find_passage(const ControlPoints &from_1,
               const ControlPoints &to_1,
               const ControlPoints &from_2,
               const ControlPoints &to_2,
               const double         core,
               const CellEnds      &ends_1,
               const CellEnds      &ends_2)
  {
    // Close above the core it counts as reached: there is no end otherwise.
    constexpr double margin = 1.01;

    const double motion = relative_motion(from_1, to_1, from_2, to_2);
    if (hull_distance(from_1, from_2) - motion > core)
      return {};

    double fraction = 0.;
    for (bool is_first = true; fraction < 1.; is_first = false)
      {
        const ClosestApproach nearest =
          closest_approach(between(from_1, to_1, fraction),
                           between(from_2, to_2, fraction));
        if (nearest.distance <= margin * core)
          {
            if (is_first ||
                (is_at_end(ends_1, nearest.x) && is_at_end(ends_2, nearest.y)))
              return {};
            Passage passage;
            passage.x        = nearest.x;
            passage.fraction = fraction;
            return passage;
          }
        fraction += (nearest.distance - core) / motion;
      }
    return {};
  }



  std::optional<Passage>
  find_passage(const std::vector<ControlPoints> &from,
               const std::vector<ControlPoints> &to,
               const std::vector<unsigned int>  &sources,
               const std::vector<unsigned int>  &targets,
               const double                      largest_core,
               const std::function<double(const unsigned int source,
                                          const unsigned int target)> &core,
               const std::function<CellEnds(const unsigned int cell)> &ends)
  {
    std::vector<BoundingBox<3>> boxes;
    boxes.reserve(targets.size());
    for (const unsigned int target : targets)
      boxes.push_back(swept_box(from[target], to[target]));

    namespace bgi   = boost::geometry::index;
    const auto tree = dealii::pack_rtree_of_indices<bgi::linear<8>>(boxes);

    std::optional<Passage> first;
    for (const unsigned int source : sources)
      {
        BoundingBox<3> box = swept_box(from[source], to[source]);
        box.extend(largest_core);
        const auto examine = [&](const std::size_t i) {
          const unsigned int target   = targets[i];
          const double       distance = core(source, target);
          if (distance == 0.)
            return;
          std::optional<Passage> passage = find_passage(from[source],
                                                        to[source],
                                                        from[target],
                                                        to[target],
                                                        distance,
                                                        ends(source),
                                                        ends(target));
          if (!passage)
            return;
          passage->source = source;
          passage->target = target;
          if (!first || passage->is_before(*first))
            first = passage;
        };
        tree.query(bgi::intersects(box),
                   boost::make_function_output_iterator(examine));
      }
    return first;
  }
} // namespace Setae
