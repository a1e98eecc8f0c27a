// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <deal.II/base/quadrature_lib.h>

#include <setae/assembly/interaction.h>
#include <setae/base/exceptions.h>
#include <setae/interactions/section_beam.h>
#include <setae/interactions/section_section.h>
#include <setae/laws/all.h>
#include <setae/laws/lennard_jones.h>
#include <setae/search/neighbor_list.h>

#include <map>
#include <type_traits>

namespace Setae
{
  using namespace dealii;

  namespace
  {
    /** The loop over points that evaluates laws of the given invariants. */
    template <Invariants, typename Law>
    struct KernelOf;

    template <typename Law>
    struct KernelOf<Invariants::gap, Law>
    {
      using type = SectionSection<Law>;
    };

    template <typename Law>
    struct KernelOf<Invariants::gap_angle, Law>
    {
      using type = SectionBeam<Law>;
    };

    template <typename Law>
    struct KernelOf<Invariants::gap_angle_tilt, Law>
    {
      using type = SectionBeam<Law>;
    };

    template <typename Law>
    using Kernel = typename KernelOf<Law::depends_on, Law>::type;

    SectionPair
    section_pair(const FiberParameters &source, const FiberParameters &target)
    {
      return {source.radius,
              target.radius,
              source.number_density,
              target.number_density};
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
        potential.push_back(
          {parameters.exponents[i], parameters.prefactors[i]});
      return potential;
    }



    /** A law, with an accuracy if it is computed and not written. */
    template <typename Law>
    Law
    make_law(const PointPotential        &potential,
             const SectionPair           &sections,
             const GapRange              &range,
             const InteractionParameters &parameters)
    {
      if constexpr (std::is_constructible_v<Law,
                                            PointPotential,
                                            SectionPair,
                                            GapRange,
                                            LawAccuracy>)
        return Law(potential,
                   sections,
                   range,
                   {parameters.section_points[0],
                    parameters.section_points[1],
                    parameters.law_tolerance});
      else
        {
          (void)parameters;
          return Law(potential, sections, range);
        }
    }



    template <typename Law, typename = void>
    struct HasSinglePowers : std::false_type
    {};

    template <typename Law>
    struct HasSinglePowers<
      Law,
      std::void_t<decltype(std::declval<Law>().single_power(0))>>
      : std::true_type
    {};

    /** The law of the power number @p i alone, without tabulating it twice. */
    template <typename Law>
    Law
    single_power(const Law                   &law,
                 const unsigned int           i,
                 const PointPotential        &potential,
                 const SectionPair           &sections,
                 const GapRange              &range,
                 const InteractionParameters &parameters)
    {
      if constexpr (HasSinglePowers<Law>::value)
        {
          (void)potential, (void)sections, (void)range, (void)parameters;
          return law.single_power(i);
        }
      else
        {
          (void)law;
          return make_law<Law>({potential[i]}, sections, range, parameters);
        }
    }



    template <typename Law>
    Kernel<Law>
    make_kernel(const SectionPair           &sections,
                const GapRange              &range,
                const InteractionParameters &parameters)
    {
      const PointPotential potential = point_potential(parameters, sections);
      const Law    law = make_law<Law>(potential, sections, range, parameters);
      const double radii = sections.radius_1 + sections.radius_2;

      constexpr bool has_tilt = Law::depends_on == Invariants::gap_angle_tilt;
      if constexpr (has_tilt || Law::depends_on == Invariants::gap_angle)
        if (parameters.target_ends == "finite" ||
            (has_tilt && parameters.target_ends == "by law"))
          {
            std::vector<typename Kernel<Law>::EndTerm> terms;
            for (unsigned int i = 0; i < potential.size(); ++i)
              terms.push_back(
                {single_power(law, i, potential, sections, range, parameters),
                 EndFraction(potential[i].exponent, sections, range)});
            return Kernel<Law>(law, radii, terms);
          }
      return Kernel<Law>(law, radii);
    }



    /** Which cells may interact, and how strongly. */
    class Roles
    {
    public:
      Roles(const FiberSystem &fibers, const InteractionParameters &parameters)
        : fibers(fibers)
        , parameters(parameters)
        , is_source(fibers.fibers.size(), false)
        , is_target(fibers.fibers.size(), false)
      {
        for (const unsigned int f : fibers.select(parameters.source))
          is_source[f] = true;
        for (const unsigned int f : fibers.select(parameters.target))
          is_target[f] = true;
      }

      bool
      may_be_source(const unsigned int fiber) const
      {
        return is_source[fiber] ||
               (parameters.two_half_passes && is_target[fiber]);
      }

      bool
      may_be_target(const unsigned int fiber) const
      {
        return is_target[fiber] ||
               (parameters.two_half_passes && is_source[fiber]);
      }

      bool
      interact(const unsigned int source, const unsigned int target) const
      {
        const unsigned int s = fibers.fiber_of_cell[source],
                           t = fibers.fiber_of_cell[target];
        if (s == t)
          return parameters.self_interaction && is_source[s] && is_target[s] &&
                 fibers.distance_along_fiber(source, target) >
                   parameters.n_excluded_neighbors;
        const bool forward  = is_source[s] && is_target[t];
        const bool backward = is_source[t] && is_target[s];
        if (parameters.two_half_passes)
          return forward || backward;
        return forward && (!backward || s < t);
      }

      /** One half where each pair of cells meets twice. */
      double
      factor(const unsigned int source, const unsigned int target) const
      {
        const bool twice =
          parameters.two_half_passes ||
          fibers.fiber_of_cell[source] == fibers.fiber_of_cell[target];
        return twice ? .5 : 1.;
      }

    private:
      const FiberSystem           &fibers;
      const InteractionParameters &parameters;
      std::vector<bool>            is_source, is_target;
    };



    template <typename Law>
    class Interaction : public EnergyTerm
    {
    public:
      Interaction(const FiberSystem           &fibers,
                  const InteractionParameters &parameters)
        : fibers(fibers)
        , parameters(parameters)
        , roles(fibers, parameters)
        , rule(QIterated<1>(QGauss<1>(parameters.n_gauss_points),
                            parameters.n_segments))
        , neighbors(make_kernels(),
                    parameters.skin > 0. ? parameters.skin :
                                           .5 * parameters.cutoff)
      {
        for (const unsigned int cell : fibers.owned_cells)
          if (roles.may_be_source(fibers.fiber_of_cell[cell]))
            sources.push_back(cell);
        for (unsigned int cell = 0; cell < fibers.initial.size(); ++cell)
          if (roles.may_be_target(fibers.fiber_of_cell[cell]))
            targets.push_back(cell);
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
          for (const unsigned int target : neighbors.targets(i))
            cell_pairs.emplace_back(sources[i], target);
      }

      double
      assemble(const State  &state,
               const Request request,
               GlobalSystem &system) override
      {
        report        = {};
        double energy = 0.;
        for_each_pair(
          state,
          [&](const unsigned int           source,
              const unsigned int           target,
              const std::vector<LineSite> &source_sites) {
            if (add_pair(state, source, target, source_sites, request))
              {
                local.symmetrize();
                energy += local.energy;
                system.add(source, target, local);
              }
          });
        return energy;
      }

      GapReport
      gaps() const override
      {
        return report;
      }

      double
      smallest_admissible_gap() const override
      {
        return parameters.regularization;
      }

      void
      add_site_forces(const State            &state,
                      std::vector<SiteForce> &forces) const override
      {
        // With a double integral, several cells act on a site.
        std::map<unsigned int, std::vector<SiteForce>> sums;

        for_each_pair(
          state,
          [&](const unsigned int           source,
              const unsigned int           target,
              const std::vector<LineSite> &source_sites) {
            const HermiteCell<> &cell   = state.current[target];
            const double         factor = roles.factor(source, target);
            if constexpr (is_projected)
              for (const LineSite &site : source_sites)
                kernel(source, target)
                  .forces(
                    site, cell, fibers.ends_of_cell(target), factor, forces);
            else
              {
                evaluate_sites(rule,
                               fibers.initial[target],
                               cell,
                               target_sites);
                kernel(source, target)
                  .add_forces(source_sites, target_sites, factor, sums[source]);
                kernel(source, target)
                  .add_forces(target_sites, source_sites, factor, sums[target]);
              }
          });
        for (const auto &[cell, sites] : sums)
          forces.insert(forces.end(), sites.begin(), sites.end());
      }

    private:
      static constexpr bool is_projected =
        Law::depends_on == Invariants::gap_angle ||
        Law::depends_on == Invariants::gap_angle_tilt;

      /** @return The largest reach of all pairs of sections [length]. */
      double
      make_kernels()
      {
        const GapRange range{parameters.regularization,
                             (1. - parameters.switch_width) * parameters.cutoff,
                             parameters.cutoff};
        double         reach = 0.;
        for (unsigned int s = 0; s < fibers.fibers.size(); ++s)
          for (unsigned int t = 0; t < fibers.fibers.size(); ++t)
            {
              const auto key = std::make_pair(fibers.fibers[s].parameters,
                                              fibers.fibers[t].parameters);
              if (!roles.may_be_source(s) || !roles.may_be_target(t) ||
                  kernels.count(key) > 0)
                continue;
              const SectionPair sections =
                section_pair(fibers.scene.fibers[key.first],
                             fibers.scene.fibers[key.second]);
              check_equal(sections);
              const Kernel<Law> kernel =
                make_kernel<Law>(sections, range, parameters);
              kernels.emplace(key, kernel);
              reach = std::max(reach, kernel.reach());
            }
        return reach;
      }

      void
      check_equal(const SectionPair &sections) const
      {
        AssertThrow(!parameters.prefactors.empty() ||
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

      template <typename Function>
      void
      for_each_pair(const State &state, const Function &function) const
      {
        std::vector<LineSite> sites;
        for (unsigned int i = 0; i < sources.size(); ++i)
          {
            const auto partners = neighbors.targets(i);
            if (partners.size() == 0)
              continue;
            evaluate_sites(rule,
                           fibers.initial[sources[i]],
                           state.current[sources[i]],
                           sites);
            for (const unsigned int target : partners)
              function(sources[i], target, sites);
          }
      }

      /** @return Whether any site of the source is within reach. */
      bool
      add_pair(const State                 &state,
               const unsigned int           source,
               const unsigned int           target,
               const std::vector<LineSite> &source_sites,
               const Request                request)
      {
        const HermiteCell<> &cell         = state.current[target];
        const Kernel<Law>   &kernel       = this->kernel(source, target);
        const double         factor       = roles.factor(source, target);
        const double         reach_square = kernel.reach() * kernel.reach();
        const BoundingBox<3> box          = bounding_box(cell.control_points());

        bool is_near = false;
        for (const LineSite &site : source_sites)
          {
            if (distance_square(box, site.r) >= reach_square)
              continue;
            if (!is_near)
              {
                is_near = true;
                local.reset(request);
                if constexpr (!is_projected)
                  evaluate_sites(rule,
                                 fibers.initial[target],
                                 cell,
                                 target_sites);
              }
            double gap;
            if constexpr (is_projected)
              gap = kernel.add(site,
                               cell,
                               fibers.ends_of_cell(target),
                               factor * site.weight,
                               request,
                               local);
            else
              gap = kernel.add(site, target_sites, factor, request, local);
            report.see({gap, source, target, site.x});
          }
        return is_near;
      }

      const FiberSystem           &fibers;
      const InteractionParameters &parameters;
      const Roles                  roles;
      const Quadrature<1>          rule;

      /** One for each pair of sections of the scene. */
      std::map<std::pair<unsigned int, unsigned int>, Kernel<Law>> kernels;

      NeighborList              neighbors;
      std::vector<unsigned int> sources; ///< owned
      std::vector<unsigned int> targets; ///< of all ranks
      GapReport                 report;

      // Scratch, to save allocations.
      LocalSystem<24>               local;
      mutable std::vector<LineSite> target_sites;
    };
  } // namespace



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
