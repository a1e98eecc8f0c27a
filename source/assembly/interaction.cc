// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <setae/assembly/far_field.h>
#include <setae/assembly/interaction_kernel.h>
#include <setae/assembly/interaction_roles.h>
#include <setae/base/exceptions.h>
#include <setae/interactions/graded_segments.h>
#include <setae/laws/lennard_jones.h>
#include <setae/search/neighbor_list.h>

#include <map>
#include <type_traits>

namespace Setae
{
  using namespace dealii;

  namespace
  {
    template <typename Law>
    class Interaction : public EnergyTerm
    {
    public:
      Interaction(const FiberSystem           &fibers,
                  const InteractionParameters &parameters)
        : fibers(fibers)
        , parameters(parameters)
        , roles(fibers, parameters)
        , rule(integration_rule(parameters))
        , segment_rule(parameters.n_gauss_points)
        , strength("interactions/" + parameters.name + "/strength",
                   parameters.strength,
                   "t",
                   fibers.scene.constants)
        , reach(make_kernels())
        , neighbors(reach, skin())
      {
        for (const unsigned int cell : fibers.owned_cells)
          if (roles.may_be_source(fibers.fiber_of_cell[cell]))
            sources.push_back(cell);
        for (unsigned int cell = 0; cell < fibers.initial.size(); ++cell)
          if (roles.may_be_target(fibers.fiber_of_cell[cell]))
            targets.push_back(cell);
        if (parameters.far_field_tolerance > 0.)
          far_field =
            std::make_unique<FarField>(fibers, parameters, roles, rule);
        if (parameters.integration_tolerance > 0.)
          grading =
            std::make_unique<GradedSegments>(parameters.integration_tolerance,
                                             parameters.n_gauss_points,
                                             parameters.n_segments,
                                             parameters.regularization);
      }

      std::string
      name() const override
      {
        return "interaction";
      }

      bool
      has_search() const override
      {
        return true;
      }

      bool
      update_couplings(const State &state) override
      {
        if (far_field)
          {
            if (!far_field->needs_rebuild(state))
              return false;
            far_field->build(state, sources);
            return true;
          }
        std::vector<NeighborList::ControlPoints> cells;
        cells.reserve(state.current.size());
        for (const HermiteCell<> &cell : state.current)
          cells.push_back(cell.control_points());
        if (!neighbors.needs_rebuild(cells))
          return false;
        neighbors.build(cells,
                        sources,
                        targets,
                        [this](const unsigned int s, const unsigned int t) {
                          return roles.interact(s, t);
                        });
        return true;
      }

      void
      add_couplings(std::vector<std::pair<unsigned int, unsigned int>>
                      &cell_pairs) const override
      {
        for (unsigned int i = 0; i < sources.size(); ++i)
          for (const unsigned int target : partners(i))
            cell_pairs.emplace_back(sources[i], target);
      }

      double
      assemble(const State  &state,
               const Request request,
               GlobalSystem &system) override
      {
        report                = {};
        double       energy   = 0.;
        const double strength = this->strength(state.time);
        for_each_pair(state,
                      [&](const unsigned int           source,
                          const unsigned int           target,
                          const std::vector<LineSite> &source_sites,
                          const Segment               &of_target) {
                        if (add_pair(state,
                                     source,
                                     target,
                                     source_sites,
                                     of_target,
                                     strength,
                                     request))
                          {
                            if (has_potential())
                              local.symmetrize();
                            energy += local.energy;
                            system.add(source, target, local);
                          }
                      });
        if (far_field)
          energy += far_field->assemble(state, strength, request, system);
        return energy;
      }

      bool
      has_tangent_product() const override
      {
        return far_field != nullptr;
      }

      void
      add_tangent_product(const State  &direction,
                          GlobalVector &product) const override
      {
        far_field->add_tangent_product(direction, product);
      }

      bool
      has_potential() const override
      {
        return !has_offset || parameters.interaction_moments;
      }

      GapReport
      gaps() const override
      {
        return report;
      }

      double
      smallest_admissible_gap() const override
      {
        if (is_contact)
          return -smallest_radius;
        if (Law::is_long_range && fibers.scene.has_contact())
          return -std::numeric_limits<double>::infinity();
        return parameters.regularization;
      }

      double
      singular_gap() const override
      {
        return is_contact || Law::is_long_range ||
                   parameters.regularization > 0. ?
                 -std::numeric_limits<double>::infinity() :
                 0.;
      }

      FiberPairResultants
      pair_resultants(const State &state) override
      {
        Assert(!far_field, ExcNotImplemented("clusters mix fibers"));
        FiberPairResultants resultants;
        const double        strength = this->strength(state.time);
        for_each_pair(
          state,
          [&](const unsigned int           source,
              const unsigned int           target,
              const std::vector<LineSite> &source_sites,
              const Segment               &of_target) {
            const unsigned int s = fibers.fiber_of_cell[source],
                               t = fibers.fiber_of_cell[target];
            if (s == t || !add_pair(state,
                                    source,
                                    target,
                                    source_sites,
                                    of_target,
                                    strength,
                                    Request::residual))
              return;
            Resultant &resultant = resultants[{std::min(s, t), std::max(s, t)}];
            resultant.energy += local.energy;

            // To move both nodes of a cell is to move the cell.
            for (const unsigned int node : {0, 2})
              for (unsigned int c = 0; c < 3; ++c)
                resultant.force[c] +=
                  (s < t ? -1. : 1.) * local.residual[3 * node + c];
          });
        return resultants;
      }

      void
      add_site_forces(const State            &state,
                      std::vector<SiteForce> &forces) const override
      {
        // With a double integral, several cells act on a site.
        std::map<unsigned int, std::vector<SiteForce>> sums;
        const double strength = this->strength(state.time);

        for_each_pair_with_equal_segments(
          state,
          [&](const unsigned int           source,
              const unsigned int           target,
              const std::vector<LineSite> &source_sites,
              const Segment &) {
            const HermiteCell<> &cell   = state.current[target];
            const Kernel<Law>   &kernel = this->kernel(source, target);
            const double factor = strength * roles.factor(source, target);
            if constexpr (is_projected<Law>)
              for (const LineSite &site : source_sites)
                kernel.forces(
                  site, cell, fibers.ends_of_cell(target), factor, forces);
            else
              {
                evaluate_sites(rule,
                               fibers.initial[target],
                               cell,
                               target_sites);
                std::vector<SiteForce> &on_source = sums[source],
                                       &on_target = sums[target];
                if constexpr (has_offset)
                  kernel.add_forces(
                    source_sites, target_sites, factor, on_source, on_target);
                else
                  {
                    kernel.add_forces(source_sites,
                                      target_sites,
                                      factor,
                                      on_source);
                    kernel.add_forces(target_sites,
                                      source_sites,
                                      factor,
                                      on_target);
                  }
              }
          });
        if (far_field)
          add_far_site_forces(state, strength, sums);
        for (const auto &[cell, sites] : sums)
          forces.insert(forces.end(), sites.begin(), sites.end());
      }

    private:
      using Segment = GradedSegments::Segment;

      static constexpr Segment whole = {0., 1.};

      static constexpr bool has_offset =
        Law::depends_on == Invariants::gap_offset;

      static constexpr bool is_contact = std::is_same_v<Law, PenaltyContact>;

      /** The cells near the source of index @p i. */
      ArrayView<const unsigned int>
      partners(const unsigned int i) const
      {
        return far_field ? far_field->near_targets(i) : neighbors.targets(i);
      }

      void
      add_far_site_forces(
        const State                                    &state,
        const double                                    strength,
        std::map<unsigned int, std::vector<SiteForce>> &sums) const
      {
        std::vector<LineSite> sites;
        for (const unsigned int cell : fibers.owned_cells)
          if (far_field->knows(cell))
            {
              evaluate_sites(rule,
                             fibers.initial[cell],
                             state.current[cell],
                             sites);
              const auto far = far_field->site_forces(cell, sites, strength);
              std::vector<SiteForce> &forces = sums[cell];
              if (forces.empty())
                for (const LineSite &site : sites)
                  forces.push_back(
                    {site.r, {}, std::numeric_limits<double>::infinity()});
              for (unsigned int q = 0; q < sites.size(); ++q)
                forces[q].force += far[q];
            }
      }

      /** @return The largest reach of all pairs of sections [length]. */
      double
      make_kernels()
      {
        double reach = 0.;
        for (unsigned int s = 0; s < fibers.fibers.size(); ++s)
          for (unsigned int t = 0; t < fibers.fibers.size(); ++t)
            {
              const auto key = std::make_pair(fibers.fibers[s].parameters,
                                              fibers.fibers[t].parameters);
              if (!roles.may_be_source(s) || !roles.may_be_target(t) ||
                  kernels.count(key) > 0)
                continue;
              const SectionPair sections =
                section_pair(parameters,
                             fibers.scene.fibers[key.first],
                             fibers.scene.fibers[key.second]);
              check_equal(sections);
              const Kernel<Law> kernel = make_kernel<Law>(parameters, sections);
              kernels.emplace(key, kernel);
              reach           = std::max(reach, kernel.reach());
              smallest_radius = std::min(
                {smallest_radius, sections.radius_1, sections.radius_2});
            }
        return reach;
      }

      void
      check_equal(const SectionPair &sections) const
      {
        AssertThrow(parameters.force_minimum == 0. ||
                      (sections.radius_1 == sections.radius_2 &&
                       sections.density_1 == sections.density_2),
                    ExcParameter("interactions/" + parameters.name +
                                   "/force minimum",
                                 std::to_string(parameters.force_minimum),
                                 "replaced by 'prefactors' for fibers that "
                                 "differ in radius or number density"));
      }

      const Kernel<Law> &
      kernel(const unsigned int source, const unsigned int target) const
      {
        return kernels
          .find({fibers.fibers[fibers.fiber_of_cell[source]].parameters,
                 fibers.fibers[fibers.fiber_of_cell[target]].parameters})
          ->second;
      }

      /** How far beyond the reach to search, if the scene does not say
       * [length]. */
      double
      skin() const
      {
        if (parameters.skin > 0.)
          return parameters.skin;
        if (is_contact)
          return smallest_radius;
        return parameters.cutoff > 0. ? .5 * parameters.cutoff :
                                        std::numeric_limits<double>::infinity();
      }

      /** Call @p function with source, its sites, target and a part of that. */
      template <typename Function>
      void
      for_each_pair(const State &state, const Function &function) const
      {
        if (!grading)
          for_each_pair_with_equal_segments(state, function);
        else if constexpr (is_projected<Law>)
          for_each_pair_with_graded_source(state, function);
        else
          for_each_pair_of_graded_segments(state, function);
      }

      template <typename Function>
      void
      for_each_pair_with_equal_segments(const State    &state,
                                        const Function &function) const
      {
        std::vector<LineSite> sites;
        for (unsigned int i = 0; i < sources.size(); ++i)
          {
            const auto partners = this->partners(i);
            if (partners.size() == 0)
              continue;
            evaluate_sites(rule,
                           fibers.initial[sources[i]],
                           state.current[sources[i]],
                           sites);
            for (const unsigned int target : partners)
              function(sources[i], target, sites, whole);
          }
      }

      /** All targets see the same sites: these pass from one to the next. */
      template <typename Function>
      void
      for_each_pair_with_graded_source(const State    &state,
                                       const Function &function) const
      {
        std::vector<GradedSegments::Neighbor> targets;
        std::vector<Segment>                  segments;
        std::vector<LineSite>                 sites;
        for (unsigned int i = 0; i < sources.size(); ++i)
          {
            const unsigned int source = sources[i];
            targets.clear();
            for (const unsigned int target : partners(i))
              targets.push_back(neighbor(state, source, target));
            if (targets.empty())
              continue;
            grading->divide(state.current[source].control_points(),
                            targets,
                            segments);
            sites.clear();
            for (const auto &[begin, end] : segments)
              append_sites(segment_rule,
                           begin,
                           end,
                           fibers.initial[source],
                           state.current[source],
                           sites);
            for (const unsigned int target : partners(i))
              function(source, target, sites, whole);
          }
      }

      template <typename Function>
      void
      for_each_pair_of_graded_segments(const State    &state,
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
                  append_sites(segment_rule,
                               of_source.begin,
                               of_source.end,
                               fibers.initial[source],
                               state.current[source],
                               sites);
                  function(source, target, sites, of_target);
                }
            }
      }

      GradedSegments::Neighbor
      neighbor(const State       &state,
               const unsigned int source,
               const unsigned int target) const
      {
        const double radii = fibers.parameters_of_cell(source).radius +
                             fibers.parameters_of_cell(target).radius;
        return {state.current[target].control_points(),
                Law::is_long_range ? 0. : radii,
                kernel(source, target).reach()};
      }

      /** @return Whether any site of the source is within reach. */
      bool
      add_pair(const State                 &state,
               const unsigned int           source,
               const unsigned int           target,
               const std::vector<LineSite> &source_sites,
               const Segment               &of_target,
               const double                 strength,
               const Request                request)
      {
        const HermiteCell<> &cell   = state.current[target];
        const Kernel<Law>   &kernel = this->kernel(source, target);
        const double         factor = strength * roles.factor(source, target);
        const double         reach_square = kernel.reach() * kernel.reach();
        const BoundingBox<3> box          = bounding_box(cell.control_points());

        bool   is_near = false;
        double spacing = 0.;
        for (const LineSite &site : source_sites)
          {
            if (distance_square(box, site.r) >= reach_square)
              continue;
            if (!is_near)
              {
                is_near = true;
                local.reset(request);
                if constexpr (!is_projected<Law>)
                  {
                    target_sites.clear();
                    append_sites(grading ? segment_rule : rule,
                                 of_target.begin,
                                 of_target.end,
                                 fibers.initial[target],
                                 cell,
                                 target_sites);
                  }
                if constexpr (has_offset)
                  {
                    spacing = kernel.largest_spacing(target_sites);
                    sums.start(target_sites.size(), request);
                  }
              }
            double gap;
            if constexpr (is_projected<Law>)
              gap = kernel.add(site,
                               cell,
                               fibers.ends_of_cell(target),
                               factor * site.weight,
                               request,
                               local);
            else if constexpr (has_offset)
              gap = kernel.add(
                site, target_sites, spacing, factor, request, sums, local);
            else
              gap = kernel.add(site, target_sites, factor, request, local);
            report.see({gap, source, target, site.x});
          }
        if constexpr (has_offset)
          if (is_near)
            sums.finish(target_sites, local);
        return is_near;
      }

      const FiberSystem           &fibers;
      const InteractionParameters &parameters;
      const InteractionRoles       roles;
      const Quadrature<1>          rule;         ///< of a cell
      const QGauss<1>              segment_rule; ///< of a graded segment

      /** One for each pair of sections of the scene. */
      std::map<std::pair<unsigned int, unsigned int>, Kernel<Law>> kernels;

      double smallest_radius = std::numeric_limits<double>::infinity();
      const Expression strength;
      const double     reach; ///< largest of all kernels [length]
      NeighborList     neighbors;
      std::unique_ptr<GradedSegments> grading; ///< none if segments are equal
      std::unique_ptr<FarField> far_field;     ///< none if all pairs are summed
      std::vector<unsigned int> sources;       ///< owned
      std::vector<unsigned int> targets;       ///< of all ranks
      GapReport                 report;

      // Scratch, to save allocations.
      LocalSystem<24>               local;
      SitePairSums                  sums;
      mutable std::vector<LineSite> target_sites;
    };
  } // namespace



  SectionPair
  section_pair(const InteractionParameters &parameters,
               const FiberParameters       &source,
               const FiberParameters       &target)
  {
    if (parameters.distribution == "surface")
      return {source.radius,
              target.radius,
              source.surface_density,
              target.surface_density,
              Distribution::surface};
    return {source.radius,
            target.radius,
            source.number_density,
            target.number_density,
            Distribution::volume};
  }

  PointPotential
  point_potential(const InteractionParameters &parameters,
                  const SectionPair           &sections)
  {
    if (parameters.prefactors.empty())
      return lennard_jones_of_cylinders(parameters.equilibrium_gap,
                                        parameters.force_minimum,
                                        sections);
    PointPotential potential;
    for (unsigned int i = 0; i < parameters.exponents.size(); ++i)
      potential.push_back({parameters.exponents[i], parameters.prefactors[i]});
    return potential;
  }



  std::unique_ptr<EnergyTerm>
  make_interaction(const FiberSystem           &fibers,
                   const InteractionParameters &parameters)
  {
    std::unique_ptr<EnergyTerm> result;
    Laws::dispatch(parameters.law, [&](auto tag) {
      using Law = typename decltype(tag)::type;
      result    = std::make_unique<Interaction<Law>>(fibers, parameters);
    });
    return result;
  }
} // namespace Setae
