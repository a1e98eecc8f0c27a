// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <deal.II/base/patterns.h>

#include <setae/base/comma_separated.h>
#include <setae/base/entries.h>
#include <setae/base/exceptions.h>
#include <setae/interaction_checks.h>
#include <setae/laws/all.h>

#include <algorithm>
#include <filesystem>

namespace Setae
{
  using namespace dealii;

  namespace
  {
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
      const NumberPattern pattern(Patterns::Double(0.),
                                  with_copy(constants,
                                            {{"i", 0.}, {"j", 0.}, {"k", 0.}}));
      for (const std::string &place : places)
        if (place != "start" && place != "end" && place != "all")
          require(pattern.match(place),
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
              comma_separated(fiber.copies),
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
                  comma_separated(fiber.copies),
                  "1 if the centerlines come from a mesh file");
        }
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
        check_interaction(interaction, dynamics);
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
