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

    /** The law of each power of the potential alone. */
    template <typename Law>
    std::vector<Law>
    laws_of_powers(const InteractionParameters &parameters,
                   const PointPotential        &potential,
                   const SectionPair           &sections,
                   const Law                   &law)
    {
      std::vector<Law> result;
      for (unsigned int i = 0; i < potential.size(); ++i)
        // No table is made twice.
        if constexpr (HasSinglePowers<Law>::value)
          result.push_back(law.single_power(i));
        else
          result.push_back(make_law<Law>({potential[i]},
                                         sections,
                                         gap_range(parameters),
                                         law_accuracy(parameters)));
      (void)law;
      return result;
    }

    /** The kernel before targets that fade or, in their zone, end. */
    template <typename Law>
    SectionBeam<Law>
    make_finite(const InteractionParameters &parameters,
                const PointPotential        &potential,
                const SectionPair           &sections,
                const Law                   &law,
                const bool                   fades)
    {
      const double   radii = sections.radius_1 + sections.radius_2;
      const GapRange range = gap_range(parameters);
      const auto laws = laws_of_powers(parameters, potential, sections, law);
      std::vector<typename TargetEnd<Law>::Term>   ends;
      std::vector<typename FadedTarget<Law>::Term> faded;
      for (unsigned int i = 0; i < potential.size(); ++i)
        {
          if (fades)
            faded.push_back(
              {laws[i], FadingFraction(potential[i].exponent, sections)});
          else
            ends.push_back({laws[i],
                            EndFraction(potential[i].exponent, sections, range),
                            FlatEnd(potential[i], sections, range)});
        }
      if (fades)
        return {law, radii, FadedTarget<Law>(radii, std::move(faded))};
      return {law, radii, TargetEnd<Law>(std::move(ends))};
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



  /** Whether the ends of targets are no ends of infinite cylinders. */
  template <typename Law>
  bool
  has_finite_targets(const InteractionParameters &parameters)
  {
    if constexpr (is_projected<Law> && !std::is_same_v<Law, PenaltyContact>)
      return parameters.target_ends == "finite" ||
             (Law::depends_on == Invariants::gap_angle_tilt &&
              parameters.target_ends == "by law");
    else
      return false;
  }



  /**
   * The law that @p parameters ask for between two sections.
   *
   * @param potential From point_potential(); none for contact.
   */
  template <typename Law>
  Law
  make_law_between(const InteractionParameters &parameters,
                   const PointPotential        &potential,
                   const SectionPair           &sections)
  {
    if constexpr (std::is_same_v<Law, PenaltyContact>)
      return PenaltyContact(parameters.penalty);
    else
      {
        GapRange range = internal::gap_range(parameters);
        if (parameters.cutoff_of == "forces")
          range.cutoff_begin = range.cutoff = GapRange().cutoff;
        return make_law<Law>(potential,
                             sections,
                             range,
                             internal::law_accuracy(parameters));
      }
  }



  /**
   * The kernel that @p parameters ask for between two sections.
   *
   * @param potential From point_potential(); none for contact.
   * @param law From make_law_between().
   * @param source_is_zone Whether the sites of the source are those of its
   * EndZone, before targets that do not fade.
   */
  template <typename Law>
  Kernel<Law>
  make_kernel(const InteractionParameters &parameters,
              const PointPotential        &potential,
              const SectionPair           &sections,
              const Law                   &law,
              const bool                   source_is_zone = false)
  {
    const double radii = sections.radius_1 + sections.radius_2;
    if constexpr (Law::depends_on == Invariants::gap_offset)
      {
        const GapRange range = internal::gap_range(parameters);
        return {law,
                radii,
                parameters.frame == "source" ? OffsetAxis::source :
                                               OffsetAxis::averaged,
                parameters.interaction_moments,
                parameters.cutoff_of == "forces" ?
                  CutoffSwitch(range.cutoff_begin, range.cutoff) :
                  CutoffSwitch()};
      }
    else
      {
        if constexpr (is_projected<Law> && !std::is_same_v<Law, PenaltyContact>)
          if (has_finite_targets<Law>(parameters))
            return internal::make_finite(
              parameters, potential, sections, law, !source_is_zone);
        (void)potential;
        return {law, radii};
      }
  }
} // namespace Setae

#endif
