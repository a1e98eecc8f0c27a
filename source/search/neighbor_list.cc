// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <deal.II/base/numbers.h>

#include <deal.II/numerics/rtree.h>

#include <boost/iterator/function_output_iterator.hpp>

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



    /**
     * The place in [0,1] where a quadratic function is smallest that descends
     * with slope @p descent at zero and has the given curvature.
     */
    double
    minimizer(const double descent, const double curvature)
    {
      return curvature > 0. ? std::clamp(descent / curvature, 0., 1.) : 0.;
    }



    /**
     * The vector [length] from the chord of the first to the chord of the
     * second cell where these are closest (Ericson, Real-Time Collision
     * Detection, 2005, section 5.1.9).
     */
    Tensor<1, 3>
    connecting_vector(const ControlPoints &first, const ControlPoints &second)
    {
      const Tensor<1, 3> u = first[3] - first[0];
      const Tensor<1, 3> v = second[3] - second[0];
      const Tensor<1, 3> r = second[0] - first[0];

      const double uu = u * u, uv = u * v, vv = v * v;
      const double ur = u * r, vr = v * r;

      // The first value is best if the second chord were a whole line. Then
      // each in turn is best for the other; after two steps both are.
      double       s = minimizer(ur * vv - vr * uv, uu * vv - uv * uv);
      const double t = minimizer(uv * s - vr, vv);
      s              = minimizer(uv * t + ur, uu);

      return r + t * v - s * u;
    }



    /**
     * True only if the convex hulls of the control points are more than
     * @p distance apart.
     */
    bool
    are_separated(const ControlPoints &first,
                  const ControlPoints &second,
                  const double         distance)
    {
      const Tensor<1, 3> w = connecting_vector(first, second);

      double end_of_first    = std::numeric_limits<double>::lowest();
      double begin_of_second = std::numeric_limits<double>::max();
      for (unsigned int k = 0; k < 4; ++k)
        {
          end_of_first    = std::max(end_of_first, w * first[k]);
          begin_of_second = std::min(begin_of_second, w * second[k]);
        }
      return begin_of_second - end_of_first > distance * w.norm();
    }
  } // namespace



  NeighborList::NeighborList(const double reach, const double skin)
    : reach(reach)
    , skin(skin)
  {
    AssertThrow(reach >= 0. && skin > 0.,
                ExcInvalidRange(reach, skin));
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
              !are_separated(cells[source], cells[targets[i]], distance))
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
