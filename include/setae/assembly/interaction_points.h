// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_assembly_interaction_points_h
#define setae_assembly_interaction_points_h

#include <deal.II/base/quadrature_lib.h>

#include <setae/fibers/fiber_system.h>
#include <setae/interactions/graded_segments.h>
#include <setae/interactions/line_sites.h>

#include <memory>
#include <utility>
#include <vector>

namespace Setae
{
  /**
   * The points of cells that interact: on equal segments of every cell, or on
   * segments that are graded by the distance of partners.
   */
  class InteractionPoints
  {
  public:
    using Segment = GradedSegments::Segment;

    /**
     * @param rule points of a cell with equal segments
     * @param is_projected whether the target has no points of its own
     * @param is_long_range whether the law is regular where surfaces touch
     * @param is_contact whether the law begins where surfaces touch
     * @param can_be_graded whether segments need not be equal
     * @param reach largest distance of points that interact [length]
     */
    InteractionPoints(const FiberSystem           &fibers,
                      const InteractionParameters &parameters,
                      const dealii::Quadrature<1> &rule,
                      const bool                   is_projected,
                      const bool                   is_long_range,
                      const bool                   is_contact,
                      const bool                   can_be_graded,
                      const double                 reach)
      : fibers(fibers)
      , rule(rule)
      , segment_rule(parameters.n_gauss_points)
      , is_projected(is_projected)
      , is_long_range(is_long_range)
      , reach(reach)
    {
      if (parameters.integration_tolerance > 0. && can_be_graded &&
          parameters.integration_rule == "gauss")
        grading =
          std::make_unique<GradedSegments>(parameters.integration_tolerance,
                                           parameters.n_gauss_points,
                                           parameters.n_segments,
                                           parameters.regularization,
                                           is_contact);
    }

    /**
     * Call `function(source, target, sites of the source, part of the target)`
     * for every source and all of its `partners(i)`, i being its index among
     * @p sources; several times if pairs of segments are graded.
     */
    template <typename Partners, typename Function>
    void
    for_each_pair(const State                     &state,
                  const std::vector<unsigned int> &sources,
                  const Partners                  &partners,
                  const Function                  &function) const
    {
      if (!grading)
        for_each_pair_with_equal_segments(state, sources, partners, function);
      else if (is_projected)
        for_each_pair_with_graded_source(state, sources, partners, function);
      else
        for_each_pair_of_graded_segments(state, sources, partners, function);
    }

    /** The same once for each pair, always with the same points of a cell. */
    template <typename Partners, typename Function>
    void
    for_each_pair_with_equal_segments(const State                     &state,
                                      const std::vector<unsigned int> &sources,
                                      const Partners                  &partners,
                                      const Function &function) const
    {
      std::vector<LineSite> sites;
      for (unsigned int i = 0; i < sources.size(); ++i)
        {
          const auto targets = partners(i);
          if (targets.size() == 0)
            continue;
          evaluate_sites(rule,
                         fibers.initial[sources[i]],
                         state.current[sources[i]],
                         sites);
          for (const unsigned int target : targets)
            function(sources[i], target, sites, whole);
        }
    }

    /** Whether segments are not equal. */
    bool
    are_graded() const
    {
      return grading != nullptr;
    }

    /** The sites on a part of a target. */
    void
    evaluate_target(const State           &state,
                    const unsigned int     target,
                    const Segment         &part,
                    std::vector<LineSite> &sites) const
    {
      sites.clear();
      append(grading ? segment_rule : rule, state, target, part, sites);
    }

  private:
    static constexpr Segment whole = {0., 1.};

    /** All targets see the same sites: these pass from one to the next. */
    template <typename Partners, typename Function>
    void
    for_each_pair_with_graded_source(const State                     &state,
                                     const std::vector<unsigned int> &sources,
                                     const Partners                  &partners,
                                     const Function &function) const
    {
      std::vector<GradedSegments::Neighbor> neighbors;
      std::vector<Segment>                  segments;
      std::vector<LineSite>                 sites;
      for (unsigned int i = 0; i < sources.size(); ++i)
        {
          const unsigned int source  = sources[i];
          const auto         targets = partners(i);
          if (targets.size() == 0)
            continue;
          neighbors.clear();
          for (const unsigned int target : targets)
            neighbors.push_back(neighbor(state, source, target));
          grading->divide(state.current[source].control_points(),
                          neighbors,
                          segments);
          sites.clear();
          for (const Segment &segment : segments)
            append(segment_rule, state, source, segment, sites);
          for (const unsigned int target : targets)
            function(source, target, sites, whole);
        }
    }

    template <typename Partners, typename Function>
    void
    for_each_pair_of_graded_segments(const State                     &state,
                                     const std::vector<unsigned int> &sources,
                                     const Partners                  &partners,
                                     const Function &function) const
    {
      std::vector<std::pair<Segment, Segment>> pairs;
      std::vector<LineSite>                    sites;
      for (unsigned int i = 0; i < sources.size(); ++i)
        for (const unsigned int target : partners(i))
          {
            const unsigned int source = sources[i];
            grading->divide_both(state.current[source].control_points(),
                                 neighbor(state, source, target),
                                 pairs);
            for (const auto &[of_source, of_target] : pairs)
              {
                sites.clear();
                append(segment_rule, state, source, of_source, sites);
                function(source, target, sites, of_target);
              }
          }
    }

    void
    append(const dealii::Quadrature<1> &rule,
           const State                 &state,
           const unsigned int           cell,
           const Segment               &part,
           std::vector<LineSite>       &sites) const
    {
      append_sites(rule,
                   part.begin,
                   part.end,
                   fibers.initial[cell],
                   state.current[cell],
                   sites);
    }

    GradedSegments::Neighbor
    neighbor(const State       &state,
             const unsigned int source,
             const unsigned int target) const
    {
      const double radii = fibers.parameters_of_cell(source).radius +
                           fibers.parameters_of_cell(target).radius;
      return {state.current[target].control_points(),
              is_long_range ? 0. : radii,
              reach};
    }

    const FiberSystem              &fibers;
    const dealii::Quadrature<1>     rule;
    const dealii::QGauss<1>         segment_rule;
    const bool                      is_projected, is_long_range;
    const double                    reach;
    std::unique_ptr<GradedSegments> grading; ///< none if segments are equal
  };
} // namespace Setae

#endif
