// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <setae/base/comma_separated.h>
#include <setae/base/entries.h>
#include <setae/base/exceptions.h>
#include <setae/interaction_checks.h>
#include <setae/laws/all.h>

#include <type_traits>

namespace Setae
{
  namespace
  {
    void
    check_contact(const InteractionParameters &interaction)
    {
      const std::string path = "interactions/" + interaction.name + "/";
      require(interaction.penalty > 0.,
              path + "penalty",
              interaction.penalty,
              "positive for the law '" + interaction.law + "'");
      require(interaction.prefactors.empty(),
              path + "prefactors",
              comma_separated(interaction.prefactors),
              "empty for the law '" + interaction.law + "'");
      require(interaction.cutoff == 0.,
              path + "cutoff",
              interaction.cutoff,
              "0 for the law '" + interaction.law + "'");
      require(interaction.target_ends == "by law",
              path + "target ends",
              interaction.target_ends,
              "by law for the law '" + interaction.law +
                "', whose ends are round; those of a potential are flat");
    }

    /** The prefactors, or what stands for them, see point_potential(). */
    void
    check_strength(const InteractionParameters &interaction)
    {
      const std::string path    = "interactions/" + interaction.name + "/";
      const double      gap     = interaction.equilibrium_gap;
      const double      force   = interaction.force_minimum;
      const double      hamaker = interaction.hamaker_constant;
      if (!interaction.prefactors.empty())
        {
          require(gap == 0. && force == 0. && hamaker == 0.,
                  path + "prefactors",
                  comma_separated(interaction.prefactors),
                  "left out with 'equilibrium gap' and 'force minimum', or "
                  "'hamaker constant'");
          require(interaction.prefactors.size() == interaction.exponents.size(),
                  path + "prefactors",
                  comma_separated(interaction.prefactors),
                  "as many as there are exponents, " +
                    std::to_string(interaction.exponents.size()));
          return;
        }
      require(gap != 0. || force != 0. || hamaker != 0.,
              path + "prefactors",
              "",
              "a list of numbers, or else empty and 'equilibrium gap' and "
              "'force minimum', or 'hamaker constant', given");
      require(force == 0. || hamaker == 0.,
              path + "force minimum",
              force,
              "0 with 'hamaker constant', which already says how much fibers "
              "attract each other");
      if (hamaker == 0.)
        {
          require(gap > 0., path + "equilibrium gap", gap, "positive");
          require(force < 0., path + "force minimum", force, "negative");
        }
      require(gap == 0. || force != 0. || hamaker > 0.,
              path + "hamaker constant",
              hamaker,
              "positive, an attraction, with an equilibrium gap");
      const std::vector<unsigned int> exponents =
        gap > 0. ? std::vector<unsigned int>{6, 12} :
                   std::vector<unsigned int>{6};
      require(interaction.exponents == exponents,
              path + "exponents",
              comma_separated(interaction.exponents),
              gap > 0. ? "6, 12 with an equilibrium gap" :
                         "6 with 'hamaker constant' and no equilibrium gap");
    }

    /** A long-range law knows no gap at which parallel fibers touch. */
    void
    check_no_gap(const InteractionParameters &interaction)
    {
      const std::string path = "interactions/" + interaction.name + "/";
      const std::string allowed =
        "left out for the law '" + interaction.law + "'";
      require(interaction.equilibrium_gap == 0.,
              path + "equilibrium gap",
              interaction.equilibrium_gap,
              allowed);
      require(interaction.force_minimum == 0.,
              path + "force minimum",
              interaction.force_minimum,
              allowed);
      require(interaction.hamaker_constant == 0.,
              path + "hamaker constant",
              interaction.hamaker_constant,
              allowed);
    }

    void
    check_potential(const InteractionParameters &interaction)
    {
      const std::string path = "interactions/" + interaction.name + "/";
      require(interaction.penalty == 0.,
              path + "penalty",
              interaction.penalty,
              "0 but for the law '" + std::string(PenaltyContact::name) + "'");
      check_strength(interaction);
    }

    void
    check_range(const InteractionParameters &interaction,
                const unsigned int           smallest_exponent,
                const bool                   is_long_range)
    {
      const std::string path    = "interactions/" + interaction.name + "/";
      const std::string for_law = " for the law '" + interaction.law + "'";
      for (const unsigned int m : interaction.exponents)
        require(m >= smallest_exponent,
                path + "exponents",
                m,
                "at least " + std::to_string(smallest_exponent) + for_law);
      require(is_long_range || interaction.distribution == "volume",
              path + "distribution",
              interaction.distribution,
              "volume" + for_law);
      require(is_long_range || interaction.cutoff > 0.,
              path + "cutoff",
              interaction.cutoff,
              "positive" + for_law);
      require(!is_long_range || interaction.regularization == 0.,
              path + "regularization gap",
              interaction.regularization,
              "0" + for_law + ", which needs none");
      require(interaction.switch_width > 0. && interaction.switch_width <= 1.,
              path + "switch width",
              interaction.switch_width,
              "above 0 and at most 1");
      require(is_long_range ||
                interaction.regularization <
                  (1. - interaction.switch_width) * interaction.cutoff,
              path + "regularization gap",
              interaction.regularization,
              "below the gap from which on the cutoff acts");
    }

    /** What conserves or bounds the energy needs forces that have one. */
    void
    check_energy(const InteractionParameters &interaction,
                 const DynamicsParameters    &dynamics)
    {
      const std::string without_potential =
        " with the interaction '" + interaction.name +
        "', which has no potential ('interaction moments', 'cutoff of')";
      const bool has_potential = interaction.has_potential();
      require(has_potential || dynamics.integrator != "energy-conserving",
              "dynamics/integrator",
              dynamics.integrator,
              "another one" + without_potential);
      require(has_potential || dynamics.energy_tolerance == 0.,
              "dynamics/energy tolerance",
              dynamics.energy_tolerance,
              "0" + without_potential);
    }

    void
    check_grading(const InteractionParameters &interaction,
                  const bool                   can_be_graded)
    {
      const std::string path =
        "interactions/" + interaction.name + "/integration tolerance";
      const double tolerance = interaction.integration_tolerance;
      const bool   is_default =
        tolerance == InteractionParameters().integration_tolerance;
      require(tolerance == 0. || is_default || can_be_graded,
              path,
              tolerance,
              "0 for the law '" + interaction.law +
                "', whose segments are equal");
      require(tolerance == 0. || is_default ||
                interaction.integration_rule == "gauss",
              path,
              tolerance,
              "0 with the integration rule '" + interaction.integration_rule +
                "'");
      require(tolerance == 0. || tolerance >= 1e-14,
              path,
              tolerance,
              "0, or from 1e-14 to 0.1");
    }

    void
    check_far_field(const InteractionParameters &interaction)
    {
      const std::string path = "interactions/" + interaction.name + "/";
      if (interaction.far_field_tolerance == 0.)
        return;
      require(interaction.law == Multipole<1>::name,
              path + "far field tolerance",
              interaction.far_field_tolerance,
              "0 for the law '" + interaction.law +
                "'; only 'monopole' has a far field");
      require(interaction.cutoff == 0.,
              path + "far field tolerance",
              interaction.far_field_tolerance,
              "0 with a cutoff");
      require(interaction.far_field_tolerance >= 1e-10,
              path + "far field tolerance",
              interaction.far_field_tolerance,
              "0, or from 1e-10 to 0.1");
    }

    void
    check_offset(const InteractionParameters &interaction,
                 const bool                   has_offset)
    {
      const std::string path    = "interactions/" + interaction.name + "/";
      const std::string allowed = "left out with the law '" + interaction.law +
                                  "', which knows no offset";
      require(has_offset || interaction.frame == "averaged",
              path + "frame",
              interaction.frame,
              allowed);
      require(has_offset || interaction.cutoff_of == "energy",
              path + "cutoff of",
              interaction.cutoff_of,
              allowed);
      require(has_offset || interaction.interaction_moments,
              path + "interaction moments",
              "false",
              allowed);
    }

    void
    check_target_ends(const InteractionParameters &interaction,
                      const Invariants             depends_on)
    {
      const std::string path    = "interactions/" + interaction.name + "/";
      const std::string for_law = " for the law '" + interaction.law + "'";
      require(depends_on != Invariants::gap_angle_tilt ||
                interaction.target_ends != "clamped",
              path + "target ends",
              interaction.target_ends,
              "finite" + for_law);
      require(depends_on == Invariants::gap_angle ||
                depends_on == Invariants::gap_angle_tilt ||
                interaction.target_ends == "by law",
              path + "target ends",
              interaction.target_ends,
              "by law" + for_law + ", whose target is integrated over");
    }
  } // namespace



  void
  check_interaction(const InteractionParameters &interaction,
                    const DynamicsParameters    &dynamics)
  {
    Laws::dispatch(interaction.law, [&](auto tag) {
      using Law = typename decltype(tag)::type;
      check_offset(interaction, Law::depends_on == Invariants::gap_offset);
      check_grading(interaction, Law::depends_on != Invariants::gap_offset);
      if (Law::is_long_range || std::is_same_v<Law, PenaltyContact>)
        check_no_gap(interaction);
      if constexpr (std::is_same_v<Law, PenaltyContact>)
        check_contact(interaction);
      else
        {
          check_potential(interaction);
          check_target_ends(interaction, Law::depends_on);
          check_range(interaction, Law::smallest_exponent, Law::is_long_range);
        }
    });
    check_far_field(interaction);
    check_energy(interaction, dynamics);
  }
} // namespace Setae
