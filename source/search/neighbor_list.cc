// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <deal.II/base/numbers.h>

#include <deal.II/numerics/rtree.h>

#include <boost/iterator/function_output_iterator.hpp>

#include <setae/search/hull_distance.h>
#include <setae/search/neighbor_list.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Setae
{
  namespace
  {
    using ControlPoints = NeighborList::ControlPoints;

    bool
    is_finite(const ControlPoints &cell)
    {
      for (const auto &point : cell)
        for (unsigned int c = 0; c < 3; ++c)
          if (!dealii::numbers::is_finite(point[c]))
            return false;
      return true;
    }
  } // namespace



  NeighborList::NeighborList(const double reach, const double skin)
    : reach(reach)
    , skin(skin)
  {
    AssertThrow(reach >= 0. && skin > 0., ExcInvalidRange(reach, skin));
  }



  bool
  NeighborList::needs_rebuild(const std::vector<ControlPoints> &cells) const
  {
    if (build_counter == 0 || cells.size() != reference.size())
      return true;

    const double limit = skin * skin / 4.;
    for (std::size_t i = 0; i < cells.size(); ++i)
      for (unsigned int k = 0; k < 4; ++k)
        // written such that a number that is not finite is not overlooked
        if (!((cells[i][k] - reference[i][k]).norm_square() <= limit))
          return true;
    return false;
  }



  void
  NeighborList::build(const std::vector<ControlPoints> &cells,
                      const std::vector<unsigned int>  &sources,
                      const std::vector<unsigned int>  &targets,
                      const Admissible                 &admissible)
  {
    // not a number would break the order that the tree sorts by
    for (unsigned int i = 0; i < cells.size(); ++i)
      AssertThrow(is_finite(cells[i]), ExcNotFinite(i));

    std::vector<BoundingBox<3>> boxes;
    boxes.reserve(targets.size());
    for (const unsigned int target : targets)
      {
        AssertIndexRange(target, cells.size());
        boxes.push_back(bounding_box(cells[target]));
      }

    namespace bgi   = boost::geometry::index;
    const auto tree = dealii::pack_rtree_of_indices<bgi::linear<8>>(boxes);

    reference    = cells;
    source_cells = sources;
    offsets.assign(1, 0);
    offsets.reserve(sources.size() + 1);
    candidates.clear();

    const double distance = reach + skin;
    for (const unsigned int source : sources)
      {
        AssertIndexRange(source, cells.size());
        const BoundingBox<3> box      = bounding_box(cells[source]);
        BoundingBox<3>       enlarged = box;
        enlarged.extend(distance);

        const auto examine = [&](const std::size_t i) {
          if (distance_square(box, boxes[i]) <= distance * distance &&
              admissible(source, targets[i]) &&
              hull_distance(cells[source], cells[targets[i]]) <= distance)
            candidates.push_back(targets[i]);
        };
        tree.query(bgi::intersects(enlarged),
                   boost::make_function_output_iterator(examine));

        std::sort(candidates.begin() + offsets.back(), candidates.end());
        offsets.push_back(candidates.size());
      }
    ++build_counter;
  }



  const std::vector<unsigned int> &
  NeighborList::sources() const
  {
    return source_cells;
  }



  dealii::ArrayView<const unsigned int>
  NeighborList::targets(const unsigned int i) const
  {
    AssertIndexRange(i, source_cells.size());
    return {candidates.data() + offsets[i], offsets[i + 1] - offsets[i]};
  }



  std::size_t
  NeighborList::n_pairs() const
  {
    return candidates.size();
  }



  unsigned int
  NeighborList::n_builds() const
  {
    return build_counter;
  }
} // namespace Setae
