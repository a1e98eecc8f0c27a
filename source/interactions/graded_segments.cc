// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <setae/interactions/graded_segments.h>
#include <setae/search/hull_distance.h>

#include <algorithm>
#include <cmath>

namespace Setae
{
  namespace
  {
    /**
     * Halving ends at this part of a cell, wherever two centerlines meet, but
     * in cells much longer than their radii at this part of the core.
     */
    constexpr double shortest = 1. / 4096, shortest_of_core = 1. / 1024;

    /** The penetration over the core at which contact has its error. */
    constexpr double penetration = 1. / 200;

    /** The error of a kink, see the class. */
    constexpr double kink = .6;

    /** High powers of the gap err by more than the asymptotic estimate. */
    constexpr double safety = 20.;

    /** The polar form of a cubic with the given control points. */
    Tensor<1, 3>
    polar_form(const GradedSegments::ControlPoints &P,
               const double                         x,
               const double                         y,
               const double                         z)
    {
      Tensor<1, 3> b[3];
      for (unsigned int k = 0; k < 3; ++k)
        b[k] = (1. - x) * P[k] + x * P[k + 1];
      for (unsigned int k = 0; k < 2; ++k)
        b[k] = (1. - y) * b[k] + y * b[k + 1];
      return (1. - z) * b[0] + z * b[1];
    }
  } // namespace



  GradedSegments::GradedSegments(const double       tolerance,
                                 const unsigned int n_points,
                                 const unsigned int n_parts,
                                 const double       smallest_gap,
                                 const bool         is_contact)
    : is_contact(is_contact)
    , length_factor(is_contact ? n_points * std::sqrt(tolerance / kink) :
                                 2. / std::sinh(std::log(safety / tolerance) /
                                                (2. * n_points)))
    , n_parts(n_parts)
    , smallest_gap(smallest_gap)
  {}



  GradedSegments::Part::Part(const ControlPoints &cell, const Segment &segment)
    : segment(segment)
    , length(0.)
  {
    const auto [a, b] = segment;
    points            = {{polar_form(cell, a, a, a),
                          polar_form(cell, a, a, b),
                          polar_form(cell, a, b, b),
                          polar_form(cell, b, b, b)}};
    for (unsigned int k = 0; k < 3; ++k)
      length += (points[k + 1] - points[k]).norm();
  }



  bool
  GradedSegments::Part::may_be_halved(const double core) const
  {
    return segment.end - segment.begin > shortest ||
           (core > 0. && length > shortest_of_core * core);
  }



  double
  GradedSegments::Part::turn() const
  {
    const Tensor<1, 3> mean   = (points[3] - points[0]) / 3.;
    double             square = 0.;
    for (unsigned int k = 0; k < 3; ++k)
      square =
        std::max(square, (points[k + 1] - points[k] - mean).norm_square());
    return std::sqrt(square / mean.norm_square());
  }



  std::array<GradedSegments::Part, 2>
  GradedSegments::halves(const ControlPoints &cell, const Part &part)
  {
    const auto [begin, end] = part.segment;
    const double middle     = .5 * (begin + end);
    return {{Part(cell, {begin, middle}), Part(cell, {middle, end})}};
  }



  double
  GradedSegments::largest_length(const double distance,
                                 const double core,
                                 const double slope) const
  {
    if (is_contact)
      return length_factor * core *
             std::sqrt(penetration * (2. - penetration)) / slope;
    const double gap = std::max(smallest_gap, distance - core);
    return length_factor * std::sqrt(gap * (gap + 2. * core)) / slope;
  }



  double
  GradedSegments::slope(const Part  &part,
                        const Part  &of_neighbor,
                        const double core)
  {
    const Tensor<1, 3> u = part.points[3] - part.points[0];
    const Tensor<1, 3> v = of_neighbor.points[3] - of_neighbor.points[0];
    const double sine   = cross_product_3d(u, v).norm() / (u.norm() * v.norm());
    const double turn_1 = part.turn(), turn_2 = of_neighbor.turn();
    const double bound = sine + turn_1 + turn_2;
    return std::sqrt(bound * bound +
                     2. * core *
                       (turn_1 / part.length + turn_2 / of_neighbor.length));
  }



  void
  GradedSegments::divide(const ControlPoints         &cell,
                         const std::vector<Neighbor> &neighbors,
                         std::vector<Segment>        &segments) const
  {
    segments.clear();
    for (unsigned int i = 0; i < n_parts; ++i)
      divide(cell,
             neighbors,
             Part(cell, {double(i) / n_parts, (i + 1.) / n_parts}),
             segments);
  }



  void
  GradedSegments::divide(const ControlPoints         &cell,
                         const std::vector<Neighbor> &neighbors,
                         const Part                  &part,
                         std::vector<Segment>        &segments) const
  {
    bool is_good = true;
    for (const Neighbor &neighbor : neighbors)
      is_good = is_good &&
                (!part.may_be_halved(neighbor.core) ||
                 !is_too_long(part, neighbor, Part(neighbor.points, {0., 1.})));
    if (is_good)
      segments.push_back(part.segment);
    else
      for (const Part &half : halves(cell, part))
        divide(cell, neighbors, half, segments);
  }



  /**
   * Whether the surfaces overlap for certain, so that there is no law to
   * resolve: the state is none, and points would be wasted.
   */
  bool
  GradedSegments::overlaps(const Part     &part,
                           const Neighbor &neighbor,
                           const Part     &of_neighbor) const
  {
    if (is_contact || smallest_gap > 0. || neighbor.core == 0.)
      return false;
    for (const unsigned int i : {0, 3})
      for (const unsigned int j : {0, 3})
        if ((part.points[i] - of_neighbor.points[j]).norm_square() <
            neighbor.core * neighbor.core)
          return true;
    return false;
  }



  /** The distance from a long neighbor is that from one of its parts. */
  bool
  GradedSegments::is_too_long(const Part     &part,
                              const Neighbor &neighbor,
                              const Part     &of_neighbor) const
  {
    const double distance = hull_distance(part.points, of_neighbor.points);
    if (distance >= (is_contact ? neighbor.core : neighbor.reach) ||
        part.length <=
          largest_length(distance,
                         neighbor.core,
                         is_contact ? slope(part, of_neighbor, neighbor.core) :
                                      1.) ||
        overlaps(part, neighbor, of_neighbor))
      return false;
    if (of_neighbor.length <= part.length ||
        !of_neighbor.may_be_halved(neighbor.core))
      return true;
    for (const Part &half : halves(neighbor.points, of_neighbor))
      if (is_too_long(part, neighbor, half))
        return true;
    return false;
  }



  void
  GradedSegments::divide_both(
    const ControlPoints                      &cell,
    const Neighbor                           &neighbor,
    std::vector<std::pair<Segment, Segment>> &pairs) const
  {
    pairs.clear();
    const auto part = [this](const ControlPoints &points, unsigned int i) {
      return Part(points, {double(i) / n_parts, (i + 1.) / n_parts});
    };
    for (unsigned int i = 0; i < n_parts; ++i)
      for (unsigned int j = 0; j < n_parts; ++j)
        divide_both(
          cell, neighbor, part(cell, i), part(neighbor.points, j), pairs);
  }



  void
  GradedSegments::divide_both(
    const ControlPoints                      &cell,
    const Neighbor                           &neighbor,
    const Part                               &part,
    const Part                               &of_neighbor,
    std::vector<std::pair<Segment, Segment>> &pairs) const
  {
    const double distance = hull_distance(part.points, of_neighbor.points);
    if (distance >= neighbor.reach)
      return;
    const double limit       = largest_length(distance, neighbor.core);
    const bool   halve_first = part.length >= of_neighbor.length;
    if (std::max(part.length, of_neighbor.length) <= limit ||
        overlaps(part, neighbor, of_neighbor) ||
        !(halve_first ? part : of_neighbor).may_be_halved(neighbor.core))
      pairs.emplace_back(part.segment, of_neighbor.segment);
    else if (halve_first)
      for (const Part &half : halves(cell, part))
        divide_both(cell, neighbor, half, of_neighbor, pairs);
    else
      for (const Part &half : halves(neighbor.points, of_neighbor))
        divide_both(cell, neighbor, part, half, pairs);
  }
} // namespace Setae
