// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <setae/assembly/unresolved_segment.h>
#include <setae/interactions/graded_segments.h>
#include <setae/search/closest_approach.h>

#include <cmath>
#include <sstream>

namespace Setae
{
  std::string
  unresolved_segment(const FiberSystem           &fibers,
                     const InteractionParameters &parameters,
                     const State                 &state,
                     const GapReport             &gaps,
                     const bool                   is_projected,
                     const bool                   is_long_range,
                     const bool                   is_contact)
  {
    constexpr double unresolved = .1; // relative error

    const HermiteCell<> &source = state.current[gaps.source],
                        &target = state.current[gaps.target];
    const double radii = fibers.parameters_of_cell(gaps.source).radius +
                         fibers.parameters_of_cell(gaps.target).radius;
    const CubicPart       part{0., 1., source.control_points()};
    const ClosestApproach nearest =
      closest_approach(part.points, target.control_points());

    // A double integral sees the relative position of two points, also of
    // parallel fibers; the gap to a closest point changes with angle and
    // curvature only.
    double slope = 1.;
    if (is_projected)
      {
        const Tensor<1, 3> a = source.derivative(nearest.x),
                           b = target.derivative(nearest.y);
        const double cc      = (a * b) * (a * b) / (a * a) / (b * b);
        const double curvature =
          source.second_derivative(nearest.x).norm() / (a * a) +
          target.second_derivative(nearest.y).norm() / (b * b);
        slope = std::sqrt(std::max(0., 1. - cc) + nearest.distance * curvature);
      }

    const bool is_midpoint = parameters.integration_rule == "midpoint";
    const GradedSegments resolution(unresolved,
                                    is_midpoint ? 1 : parameters.n_gauss_points,
                                    parameters.n_segments,
                                    parameters.regularization,
                                    is_contact);
    const double         length = part.length() / parameters.n_segments;
    const double allowed = resolution.largest_length(gaps.smallest + radii,
                                                     is_long_range ? 0. : radii,
                                                     slope);
    if (length <= allowed)
      return {};
    std::ostringstream text;
    text << "the integration segments of '" << parameters.name << "' are "
         << length << " long, more than the " << allowed
         << " that resolve its law at the gap " << gaps.smallest
         << ": 'interactions/" << parameters.name
         << "/integration segments' should be at least "
         << std::ceil(part.length() / allowed);
    if (!is_midpoint)
      text << ", or 'integration tolerance' positive";
    return text.str();
  }
} // namespace Setae
