// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <deal.II/base/patterns.h>

#include <setae/base/entries.h>
#include <setae/base/exceptions.h>
#include <setae/laws/all.h>
#include <setae/scene.h>

#include <algorithm>
#include <filesystem>
#include <sstream>
#include <type_traits>

namespace Setae
{
  using namespace dealii;

  namespace
  {
    template <typename Number>
    std::string
    list(const std::vector<Number> &numbers)
    {
      std::ostringstream text;
      for (unsigned int i = 0; i < numbers.size(); ++i)
        text << (i == 0 ? "" : ", ") << numbers[i];
      return text.str();
    }



    void
    check_reference(const std::string                  &parameter,
                    const std::vector<std::string>     &references,
                    const std::vector<FiberParameters> &fibers)
    {
      std::string allowed = "a list of names of fibers: all";
      for (const FiberParameters &fiber : fibers)
        allowed += ", " + fiber.name;
      require(!references.empty(), parameter, "", allowed);
      for (const std::string &reference : references)
        require(reference == "all" ||
                  std::any_of(fibers.begin(),
                              fibers.end(),
                              [&](const FiberParameters &fiber) {
                                return fiber.name == reference;
                              }),
                parameter,
                reference,
                allowed);
    }

    void
    check_places(const std::string              &parameter,
                 const std::vector<std::string> &places,
                 const Constants                &constants)
    {
      require(!places.empty(),
              parameter,
              "",
              "start, end, all or an arc length");
      for (const std::string &place : places)
        if (place != "start" && place != "end" && place != "all")
          require(NumberPattern(Patterns::Double(0.), constants).match(place),
                  parameter,
                  place,
                  "start, end, all or an arc length");
    }

    void
    check_fiber(const FiberParameters &fiber)
    {
      const std::string path = "fibers/" + fiber.name + "/";
      require(fiber.length > 0., path + "length", fiber.length, "positive");
      require(fiber.radius > 0., path + "radius", fiber.radius, "positive");
      require(fiber.youngs_modulus > 0.,
              path + "youngs modulus",
              fiber.youngs_modulus,
              "positive");
      require(fiber.poisson_ratio > -1. && fiber.poisson_ratio <= .5,
              path + "poisson ratio",
              fiber.poisson_ratio,
              "above -1 and at most 0.5");
      require(fiber.copies.size() <= 3,
              path + "copies",
              list(fiber.copies),
              "at most three numbers");
      for (const auto &[entry, text] : fiber.texts)
        require(!depends_on_copy(text) ||
                  (entry != "copies" && fiber.mesh_file.empty()),
                path + entry,
                text,
                "the same for all fibers of an array or a mesh file");
      if (!fiber.mesh_file.empty())
        {
          require(std::filesystem::is_regular_file(fiber.mesh_file),
                  path + "mesh file",
                  fiber.mesh_file,
                  "a file that exists");
          require(fiber.copies == std::vector<unsigned int>{1},
                  path + "copies",
                  list(fiber.copies),
                  "1 if the centerlines come from a mesh file");
        }
    }

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
              list(interaction.prefactors),
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
                  list(interaction.prefactors),
                  "left out with 'equilibrium gap' and 'force minimum', or "
                  "'hamaker constant'");
          require(interaction.prefactors.size() == interaction.exponents.size(),
                  path + "prefactors",
                  list(interaction.prefactors),
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
              list(interaction.exponents),
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

    void
    check_interaction(const InteractionParameters &interaction)
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
            check_range(interaction,
                        Law::smallest_exponent,
                        Law::is_long_range);
          }
      });
    }
  } // namespace



  std::vector<FiberParameters>
  Scene::parameters_of_copies() const
  {
    std::vector<FiberParameters> result;
    for (const FiberParameters &fiber : fibers)
      if (std::any_of(fiber.texts.begin(),
                      fiber.texts.end(),
                      [](const auto &number) {
                        return depends_on_copy(number.second);
                      }))
        for (const Constants &copy : fiber.copy_indices())
          result.push_back(fiber.of_copy(constants, copy));
      else
        result.push_back(fiber);
    return result;
  }



  bool
  Scene::has_contact() const
  {
    return std::any_of(interactions.begin(),
                       interactions.end(),
                       [](const InteractionParameters &interaction) {
                         return interaction.law == PenaltyContact::name;
                       });
  }



  void
  Scene::check() const
  {
    require(!fibers.empty(), "fibers/names", "", "at least one name");
    const std::vector<FiberParameters> copies = parameters_of_copies();
    for (const FiberParameters &fiber : copies)
      check_fiber(fiber);
    for (const SupportParameters &support : supports)
      {
        const std::string path = "supports/" + support.name + "/";
        check_reference(path + "fibers", support.fibers, fibers);
        check_places(path + "at", support.at, constants);
      }
    for (const LoadParameters &load : loads)
      {
        const std::string path = "loads/" + load.name + "/";
        check_reference(path + "fibers", load.fibers, fibers);
        check_places(path + "at", load.at, constants);
      }
    for (const InteractionParameters &interaction : interactions)
      {
        const std::string path = "interactions/" + interaction.name + "/";
        check_reference(path + "source", interaction.source, fibers);
        check_reference(path + "target", interaction.target, fibers);
        check_interaction(interaction);
        check_far_field(interaction);
        check_energy(interaction, dynamics);
      }

    dynamics.check(copies);

    const LoadSteppingParameters &steps = load_stepping;
    require(steps.end_time > 0.,
            "load stepping/end time",
            steps.end_time,
            "positive");
    require(steps.first_step > 0.,
            "load stepping/first step",
            steps.first_step,
            "positive");
    require(steps.smallest_step <= steps.first_step,
            "load stepping/smallest step",
            steps.smallest_step,
            "at most the first step; how finely an instability is located is "
            "'instability resolution'");
    require(steps.instability_resolution > 0. &&
              steps.instability_resolution >= steps.smallest_step,
            "load stepping/instability resolution",
            steps.instability_resolution,
            "positive and at least the smallest step");
    require(steps.growth >= 1.,
            "load stepping/growth",
            steps.growth,
            "at least 1");
    require(newton.relative_residual_tolerance > 0.,
            "newton/relative residual tolerance",
            newton.relative_residual_tolerance,
            "positive");
    require(newton.relative_increment_tolerance > 0.,
            "newton/relative increment tolerance",
            newton.relative_increment_tolerance,
            "positive");
    require(full_quadrature.tolerance > 0.,
            "full 6D quadrature/tolerance",
            full_quadrature.tolerance,
            "positive");
    require(full_quadrature.separation > 0.,
            "full 6D quadrature/separation",
            full_quadrature.separation,
            "positive");
  }
} // namespace Setae
