// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <setae/assembly/interaction_term.h>

#include <algorithm>
#include <limits>

namespace Setae
{
  using namespace dealii;

  template <typename Law>
  FiberPairResultants
  Interaction<Law>::pair_resultants(const State &state)
  {
    Assert(!far_field, ExcNotImplemented("clusters mix fibers"));
    FiberPairResultants resultants;
    const double        strength = this->strength(state.time);
    for_each_pair(
      state,
      [&](const InteractionPass       &pass,
          const unsigned int           source,
          const unsigned int           target,
          const std::vector<LineSite> &source_sites,
          const Segment               &of_target) {
        const unsigned int s = fibers.fiber_of_cell[source],
                           t = fibers.fiber_of_cell[target];
        if (s == t || !add_pair(state,
                                pass,
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



  template <typename Law>
  void
  Interaction<Law>::add_site_forces(const State            &state,
                                    std::vector<SiteForce> &forces) const
  {
    // With a double integral, several cells act on a site.
    std::map<unsigned int, std::vector<SiteForce>> sums;
    const double strength = this->strength(state.time);

    for (const InteractionPass &pass : passes)
      points.for_each_pair_with_equal_segments(
        state,
        pass.sources,
        partners(pass),
        [&](const unsigned int           source,
            const unsigned int           target,
            const std::vector<LineSite> &source_sites,
            const Segment &) {
          const HermiteCell<> &cell = state.current[target];
          const Kernel<Law>   &kernel =
            kernels.between(source, target, pass.of_zones);
          const double factor = strength * roles.factor(source, target);
          if constexpr (is_projected<Law>)
            for (const LineSite &site : source_sites)
              kernel.forces(site,
                            cell,
                            fibers.place_of_cell(target),
                            factor * share(pass, kernel, source, site),
                            forces);
          else
            {
              evaluate_sites(rule, fibers.initial[target], cell, target_sites);
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



  template <typename Law>
  void
  Interaction<Law>::add_far_site_forces(
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



  template <typename Law>
  double
  Interaction<Law>::add_pairs(const State  &state,
                              const double  strength,
                              const Request request,
                              GlobalSystem &system)
  {
    double energy = 0.;
    for_each_pair(state,
                  [&](const InteractionPass       &pass,
                      const unsigned int           source,
                      const unsigned int           target,
                      const std::vector<LineSite> &source_sites,
                      const Segment               &of_target) {
                    if (add_pair(state,
                                 pass,
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
                        if (request >= Request::residual)
                          system.add(source, target, local);
                      }
                  });
    if (far_field)
      energy += far_field->assemble(state, strength, request, system);
    return energy;
  }



  template <typename Law>
  void
  Interaction<Law>::see_curves(const State &state)
  {
    for (const InteractionPass &pass : passes)
      for (unsigned int i = 0; i < pass.sources.size(); ++i)
        for (const unsigned int target : partners(pass)(i))
          {
            const unsigned int source = pass.sources[i];
            if (!curve_gaps.may_be_smaller(state, source, target, report))
              continue;
            // Zones are parts of the curves that the first pass has seen.
            if (!pass.of_zones)
              curve_gaps.see(state, source, target, report);
            if constexpr (is_projected<Law>)
              if (has_finite_targets<Law>(parameters))
                for (const LineSite &site :
                     curve_gaps.sites_at_ends(state, source))
                  report.see({kernels.between(source, target, pass.of_zones)
                                .gap(site,
                                     state.current[target],
                                     fibers.place_of_cell(target)),
                              source,
                              target,
                              site.x});
          }
    if (far_field)
      far_field->see_gaps(state, curve_gaps, report);
  }



  template <typename Law>
  bool
  Interaction<Law>::add_pair(const State                 &state,
                             const InteractionPass       &pass,
                             const unsigned int           source,
                             const unsigned int           target,
                             const std::vector<LineSite> &source_sites,
                             const Segment               &of_target,
                             const double                 strength,
                             const Request                request)
  {
    const HermiteCell<> &cell = state.current[target];
    const Kernel<Law> &kernel = kernels.between(source, target, pass.of_zones);
    const double       factor = strength * roles.factor(source, target);
    const double       reach_square = kernel.reach() * kernel.reach();
    const BoundingBox<3> box        = bounding_box(cell.control_points());

    const CellPlace place   = fibers.place_of_cell(target);
    bool            is_near = false;
    double          spacing = 0.;
    for (const LineSite &site : source_sites)
      {
        if (distance_square(box, site.r) >= reach_square)
          continue;
        const double share = this->share(pass, kernel, source, site);
        if (share == 0.)
          continue;
        if (!is_near)
          {
            is_near = true;
            local.reset(request);
            if constexpr (!is_projected<Law>)
              points.evaluate_target(state, target, of_target, target_sites);
            if constexpr (has_offset)
              {
                spacing = kernel.largest_spacing(target_sites);
                sums.start(target_sites.size(), request);
              }
          }
        double gap;
        if constexpr (is_projected<Law>)
          gap = kernel.add(
            site, cell, place, factor * share * site.weight, request, local);
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
