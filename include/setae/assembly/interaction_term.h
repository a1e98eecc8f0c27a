// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_assembly_interaction_term_h
#define setae_assembly_interaction_term_h

#include <setae/assembly/curve_gaps.h>
#include <setae/assembly/far_field.h>
#include <setae/assembly/interaction.h>
#include <setae/assembly/interaction_pass.h>
#include <setae/assembly/interaction_points.h>
#include <setae/assembly/section_kernels.h>
#include <setae/assembly/unresolved_segment.h>

#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace Setae
{
  /**
   * The energy term of an interaction by one law, as make_interaction() makes
   * it: which cells interact, and what it tells the other parts of a run. The
   * sums over points are in interaction.cc.
   */
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
      , strength("interactions/" + parameters.name + "/strength",
                 parameters.strength,
                 "t",
                 fibers.scene.constants)
      , kernels(fibers, parameters, roles)
      , points(fibers,
               parameters,
               rule,
               is_projected<Law>,
               Law::is_long_range,
               is_contact,
               !has_offset,
               kernels.largest_reach)
      , passes(fibers,
               roles,
               has_finite_targets<Law>(parameters),
               kernels.largest_radius,
               kernels.largest_reach,
               skin())
      , curve_gaps(fibers,
                   roles,
                   has_finite_targets<Law>(parameters),
                   kernels.largest_cutoff)
    {
      if (parameters.far_field_tolerance > 0.)
        far_field = std::make_unique<FarField>(fibers, parameters, roles, rule);
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
          far_field->build(state, passes.first().sources);
          return true;
        }
      return passes.update(state);
    }

    void
    add_couplings(std::vector<std::pair<unsigned int, unsigned int>>
                    &cell_pairs) const override
    {
      for (const InteractionPass &pass : passes)
        for (unsigned int i = 0; i < pass.sources.size(); ++i)
          for (const unsigned int target : partners(pass)(i))
            cell_pairs.emplace_back(pass.sources[i], target);
    }

    double
    assemble(const State  &state,
             const Request request,
             GlobalSystem &system) override
    {
      report                = {};
      const double strength = this->strength(state.time);
      const double energy   = add_pairs(state, strength, request, system);
      see_curves(state);

      // Also what does not act yet works as soon as it grows.
      energy_of_unit_strength = strength != 0. ?
                                  energy / strength :
                                  add_pairs(state, 1., Request::energy, system);
      return energy;
    }

    void
    add_external_work(const State               &state,
                      std::vector<ExternalWork> &work) const override
    {
      work.push_back({energy_of_unit_strength, strength(state.time)});
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
      return !has_offset || (parameters.interaction_moments &&
                             parameters.cutoff_of == "energy");
    }

    GapReport
    gaps() const override
    {
      return report;
    }

    std::string
    unresolved_points(const State &state) const override
    {
      if (points.are_graded() || !(report.smallest < kernels.largest_cutoff))
        return {};
      return unresolved_segment(fibers,
                                parameters,
                                state,
                                report,
                                is_projected<Law>,
                                Law::is_long_range,
                                is_contact);
    }

    std::optional<Passage>
    find_passage(const State &from, const State &to) const override
    {
      return curve_gaps.find_passage(from,
                                     to,
                                     passes.first().sources,
                                     passes.first().targets);
    }

    double
    smallest_admissible_gap() const override
    {
      if (is_contact)
        return -kernels.smallest_radius;
      if (Law::is_long_range && fibers.scene.has_contact())
        return -std::numeric_limits<double>::infinity();
      return parameters.regularization;
    }

    std::string
    small_gap_advice() const override
    {
      const std::string section = "'interactions/" + parameters.name + "/";
      if (is_contact)
        return ", minus the smallest radius: raise " + section +
               "penalty' or take shorter steps";
      if (parameters.regularization > 0.)
        return ": lower " + section +
               "regularization gap' (0.3 of the equilibrium gap lets fibers "
               "press on each other) or take shorter steps";
      return ", where they overlap: take shorter steps";
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
    pair_resultants(const State &state) override;

    void
    add_site_forces(const State            &state,
                    std::vector<SiteForce> &forces) const override;

  private:
    using Segment = InteractionPoints::Segment;

    static constexpr bool has_offset =
      Law::depends_on == Invariants::gap_offset;

    static constexpr bool is_contact = std::is_same_v<Law, PenaltyContact>;

    /** A function of the index of a source: the cells near that. */
    auto
    partners(const InteractionPass &pass) const
    {
      return [this, &pass](const unsigned int i) {
        return far_field ? far_field->near_targets(i) : pass.partners(i);
      };
    }

    /** InteractionPoints::for_each_pair() in all passes. */
    template <typename Function>
    void
    for_each_pair(const State &state, const Function &function) const
    {
      for (const InteractionPass &pass : passes)
        points.for_each_pair(state,
                             pass.sources,
                             partners(pass),
                             [&](const auto &...arguments) {
                               function(pass, arguments...);
                             });
    }

    /** The share of a site that counts in a pass. */
    double
    share(const InteractionPass &pass,
          const Kernel<Law>     &kernel,
          const unsigned int     source,
          const LineSite        &site) const
    {
      if constexpr (is_projected<Law>)
        if (pass.of_zones)
          return kernel.share_of_zone(fibers.place_of_cell(source), site.x);
      (void)pass, (void)kernel, (void)source, (void)site;
      return 1.;
    }

    void
    add_far_site_forces(
      const State                                    &state,
      const double                                    strength,
      std::map<unsigned int, std::vector<SiteForce>> &sums) const;

    /** How far beyond the reach to search, if the scene does not say
     * [length]. */
    double
    skin() const
    {
      if (parameters.skin > 0.)
        return parameters.skin;
      if (is_contact)
        return kernels.smallest_radius;
      return parameters.cutoff > 0. ? .5 * parameters.cutoff :
                                      std::numeric_limits<double>::infinity();
    }

    /** @return The energy of this rank. */
    double
    add_pairs(const State  &state,
              const double  strength,
              const Request request,
              GlobalSystem &system);

    /** Gaps between the points, after those at the points have been seen. */
    void
    see_curves(const State &state);

    /** @return Whether any site of the source is within reach. */
    bool
    add_pair(const State                 &state,
             const InteractionPass       &pass,
             const unsigned int           source,
             const unsigned int           target,
             const std::vector<LineSite> &source_sites,
             const Segment               &of_target,
             const double                 strength,
             const Request                request);

    const FiberSystem           &fibers;
    const InteractionParameters &parameters;
    const InteractionRoles       roles;
    const dealii::Quadrature<1>  rule; ///< of a cell

    const Expression          strength;
    double                    energy_of_unit_strength = 0.; ///< of this rank
    const SectionKernels<Law> kernels;
    const InteractionPoints   points;
    InteractionPasses         passes;
    const CurveGaps           curve_gaps;
    std::unique_ptr<FarField> far_field; ///< none if all pairs are summed
    GapReport                 report;

    // Scratch, to save allocations.
    LocalSystem<24>               local;
    SitePairSums                  sums;
    mutable std::vector<LineSite> target_sites;
  };
} // namespace Setae

#endif
