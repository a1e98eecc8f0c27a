// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_assembly_interaction_kernel_h
#define setae_assembly_interaction_kernel_h

#include <deal.II/base/quadrature_lib.h>

#include <setae/assembly/interaction.h>
#include <setae/interactions/offset_sections.h>
#include <setae/interactions/section_beam.h>
#include <setae/interactions/section_section.h>
#include <setae/laws/all.h>

#include <type_traits>
#include <utility>

namespace Setae
{
  namespace internal
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
    struct KernelOf<Invariants::gap_offset, Law>
    {
      using type = OffsetSections<Law>;
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
  } // namespace internal

  /** What evaluates a law between two cells. */
  template <typename Law>
  using Kernel = typename internal::KernelOf<Law::depends_on, Law>::type;

  /** Whether the kernel projects onto the target instead of integrating it. */
  template <typename Law>
  inline constexpr bool is_projected =
    Law::depends_on == Invariants::gap_angle ||
    Law::depends_on == Invariants::gap_angle_tilt;



  namespace internal
  {
    /** Regularization and cutoff; no cutoff if that is zero. */
    inline GapRange
    gap_range(const InteractionParameters &parameters)
    {
      GapRange range;
      range.regularization = parameters.regularization;
      if (parameters.cutoff > 0.)
        {
          range.cutoff_begin =
            (1. - parameters.switch_width) * parameters.cutoff;
          range.cutoff = parameters.cutoff;
        }
      return range;
    }

    inline LawAccuracy
    law_accuracy(const InteractionParameters &parameters)
    {
      return {parameters.section_points[0],
              parameters.section_points[1],
              parameters.law_tolerance};
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

    /** The law of each power of the potential before the end of a target. */
    template <typename Law>
    std::vector<typename SectionBeam<Law>::EndTerm>
    end_terms(const InteractionParameters &parameters,
              const PointPotential        &potential,
              const SectionPair           &sections,
              const Law                   &law)
    {
      const GapRange range = gap_range(parameters);
      std::vector<typename SectionBeam<Law>::EndTerm> terms;
      for (unsigned int i = 0; i < potential.size(); ++i)
        {
          const EndFraction fraction(potential[i].exponent, sections, range);
          const FlatEnd     flat_end(potential[i], sections, range);
          // No table is made twice.
          if constexpr (HasSinglePowers<Law>::value)
            terms.push_back({law.single_power(i), fraction, flat_end});
          else
            terms.push_back({make_law<Law>({potential[i]},
                                           sections,
                                           range,
                                           law_accuracy(parameters)),
                             fraction,
                             flat_end});
        }
      (void)law;
      return terms;
    }
  } // namespace internal



  /** The points of a cell that interact. */
  inline dealii::Quadrature<1>
  integration_rule(const InteractionParameters &parameters)
  {
    if (parameters.integration_rule == "midpoint")
      return dealii::QIterated<1>(dealii::QMidpoint<1>(),
                                  parameters.n_segments);
    return dealii::QIterated<1>(dealii::QGauss<1>(parameters.n_gauss_points),
                                parameters.n_segments);
  }



  /** The kernel that @p parameters ask for between two sections. */
  template <typename Law>
  Kernel<Law>
  make_kernel(const InteractionParameters &parameters,
              const SectionPair           &sections)
  {
    const double radii = sections.radius_1 + sections.radius_2;
    if constexpr (std::is_same_v<Law, PenaltyContact>)
      return {PenaltyContact(parameters.penalty), radii};
    else
      {
        const PointPotential potential = point_potential(parameters, sections);
        GapRange             range     = internal::gap_range(parameters);
        CutoffSwitch         force_switch;
        if (parameters.cutoff_of == "forces")
          {
            std::swap(range.cutoff_begin, force_switch.begin);
            std::swap(range.cutoff, force_switch.end);
          }
        const Law law = make_law<Law>(potential,
                                      sections,
                                      range,
                                      internal::law_accuracy(parameters));
        if constexpr (Law::depends_on == Invariants::gap_offset)
          return {law,
                  radii,
                  parameters.frame == "source" ? OffsetAxis::source :
                                                 OffsetAxis::averaged,
                  parameters.interaction_moments,
                  force_switch};
        else if constexpr (is_projected<Law>)
          {
            const bool by_law = Law::depends_on == Invariants::gap_angle_tilt;
            if (parameters.target_ends == "finite" ||
                (by_law && parameters.target_ends == "by law"))
              return {
                law,
                radii,
                internal::end_terms(parameters, potential, sections, law)};
            return {law, radii};
          }
        else
          return {law, radii};
      }
  }
} // namespace Setae

#endif
