// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <setae/base/exceptions.h>
#include <setae/beams/all.h>
#include <setae/laws/all.h>
#include <setae/scene.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <set>
#include <sstream>

namespace Setae
{
  using namespace dealii;

  namespace
  {
    constexpr double infinity = std::numeric_limits<double>::max();

    const std::vector<std::string> coordinate_names = {"x", "y", "z"};

    /** A double that is not negative, or not zero either. */
    Patterns::Double
    non_negative()
    {
      return Patterns::Double(0., infinity);
    }

    Patterns::Integer
    positive_integer()
    {
      return Patterns::Integer(1);
    }

    Patterns::List
    names_pattern()
    {
      return Patterns::List(
        Patterns::Anything(), 0, std::numeric_limits<int>::max());
    }

    template <typename Number>
    void
    check(const bool         condition,
          const std::string &parameter,
          const Number &     value,
          const std::string &allowed)
    {
      std::ostringstream text;
      text << value;
      AssertThrow(condition, ExcParameter(parameter, text.str(), allowed));
    }

    /** The names that the sections of a scene list, read before the rest. */
    struct Names
    {
      std::vector<std::string> fibers, supports, loads, interactions;

      void
      add_parameters(ParameterHandler &prm)
      {
        const auto add = [&prm](const std::string &       section,
                                std::vector<std::string> &names,
                                const std::string &       what) {
          prm.enter_subsection(section);
          prm.add_parameter("names",
                            names,
                            "The names of " + what +
                              ", each a subsection of this one.",
                            names_pattern());
          prm.leave_subsection();
        };
        add("fibers", fibers, "the fibers, or arrays of equal fibers");
        add("supports", supports, "the supports");
        add("loads", loads, "the loads");
        add("interactions", interactions, "the interactions");
      }

      void
      check_unique() const
      {
        const std::pair<std::string, const std::vector<std::string> &> lists[] =
          {{"fibers/names", fibers},
           {"supports/names", supports},
           {"loads/names", loads},
           {"interactions/names", interactions}};
        for (const auto &[parameter, list] : lists)
          for (const std::string &name : list)
            check(std::count(list.begin(), list.end(), name) == 1 &&
                    name != "all" && name != "names" && !name.empty(),
                  parameter,
                  name,
                  "a list of different names, none of them 'all' or 'names'");
      }
    };

    void
    add_parameters(ParameterHandler &prm, Scene &scene, Names &names)
    {
      prm.add_parameter("title",
                        scene.title,
                        "One line on what the scene shows.",
                        Patterns::Anything());
      prm.add_parameter("coordinates",
                        scene.coordinates,
                        "The coordinates in which fibers may move. A "
                        "coordinate that is left out gets no degrees of "
                        "freedom: 'x, y' for a scene in a plane.",
                        Patterns::MultipleSelection("x|y|z"));
      prm.add_parameter("constants",
                        scene.constants_text,
                        "Names that may stand in every formula of the scene: "
                        "'l = 5, R = l/250'.",
                        Patterns::Anything());
      names.add_parameters(prm);

      const auto add_sections = [&prm](const std::string &section,
                                       auto &             list) {
        prm.enter_subsection(section);
        for (auto &entry : list)
          {
            prm.enter_subsection(entry.name);
            entry.add_parameters(prm);
            prm.leave_subsection();
          }
        prm.leave_subsection();
      };
      add_sections("fibers", scene.fibers);
      add_sections("supports", scene.supports);
      add_sections("loads", scene.loads);
      add_sections("interactions", scene.interactions);

      const auto add_section = [&prm](const std::string &section,
                                      auto &             parameters) {
        prm.enter_subsection(section);
        parameters.add_parameters(prm);
        prm.leave_subsection();
      };
      add_section("load stepping", scene.load_stepping);
      add_section("newton", scene.newton);
      add_section("output", scene.output);
    }

    template <typename Parameters>
    std::vector<Parameters>
    named(const std::vector<std::string> &names)
    {
      std::vector<Parameters> result(names.size());
      for (unsigned int i = 0; i < names.size(); ++i)
        result[i].name = names[i];
      return result;
    }

    /** A parameter given on the command line. */
    struct Override
    {
      std::vector<std::string> sections;
      std::string              name, value;

      explicit Override(const std::string &text)
      {
        const auto equal = text.find('=');
        AssertThrow(equal != std::string::npos,
                    ExcParameter("--set", text, "section/name=value"));
        sections = Utilities::split_string_list(text.substr(0, equal), '/');
        value    = Utilities::trim(text.substr(equal + 1));
        AssertThrow(!sections.empty(),
                    ExcParameter("--set", text, "section/name=value"));
        name = sections.back();
        sections.pop_back();
      }

      /** What one would write into the file for it. */
      std::string
      as_text() const
      {
        std::string text = "\n";
        for (const std::string &section : sections)
          text += "subsection " + section + "\n";
        text += "set " + name + " = " + value + "\n";
        for (unsigned int i = 0; i < sections.size(); ++i)
          text += "end\n";
        return text;
      }

      void
      apply(ParameterHandler &prm) const
      {
        for (const std::string &section : sections)
          prm.enter_subsection(section);
        try
          {
            prm.set(name, value);
          }
        catch (const ParameterHandler::ExcEntryUndeclared &)
          {
            std::string path;
            for (const std::string &section : sections)
              path += section + "/";
            AssertThrow(false,
                        ExcInput("There is no parameter '" + path + name +
                                 "' to set to '" + value + "'."));
          }
        for (unsigned int i = 0; i < sections.size(); ++i)
          prm.leave_subsection();
      }
    };

    void
    check_reference(const std::string &             parameter,
                    const std::vector<std::string> &references,
                    const std::vector<FiberParameters> &fibers)
    {
      std::string allowed = "a list of names of fibers: all";
      for (const FiberParameters &fiber : fibers)
        allowed += ", " + fiber.name;
      check(!references.empty(), parameter, "", allowed);
      for (const std::string &reference : references)
        check(reference == "all" ||
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
    check_places(const std::string &             parameter,
                 const std::vector<std::string> &places)
    {
      check(!places.empty(), parameter, "", "start, end, all or an arc length");
      for (const std::string &place : places)
        if (place != "start" && place != "end" && place != "all")
          check(Patterns::Double(0.).match(place),
                parameter,
                place,
                "start, end, all or an arc length");
    }

    void
    check_fiber(const FiberParameters &fiber)
    {
      const std::string path = "fibers/" + fiber.name + "/";
      check(fiber.length > 0., path + "length", fiber.length, "positive");
      check(fiber.radius > 0., path + "radius", fiber.radius, "positive");
      check(fiber.youngs_modulus > 0.,
            path + "youngs modulus",
            fiber.youngs_modulus,
            "positive");
      check(fiber.poisson_ratio > -1. && fiber.poisson_ratio <= .5,
            path + "poisson ratio",
            fiber.poisson_ratio,
            "above -1 and at most 0.5");
      check(fiber.copies.size() <= 3,
            path + "copies",
            fiber.copies.size(),
            "at most three numbers");
      if (!fiber.mesh_file.empty())
        {
          check(std::filesystem::is_regular_file(fiber.mesh_file),
                path + "mesh file",
                fiber.mesh_file,
                "a file that exists");
          check(fiber.copies == std::vector<unsigned int>{1},
                path + "copies",
                fiber.copies[0],
                "1 if the centerlines come from a mesh file");
        }
    }

    void
    check_interaction(const InteractionParameters &interaction)
    {
      const std::string path       = "interactions/" + interaction.name + "/";
      const bool has_prefactors    = !interaction.prefactors.empty();
      const bool has_cylinder_data = interaction.equilibrium_gap != 0. ||
                                     interaction.force_minimum != 0.;
      check(has_prefactors != has_cylinder_data,
            path + "prefactors",
            has_prefactors ? "and an equilibrium gap as well" : "",
            "given, or else 'equilibrium gap' and 'force minimum'");
      if (has_prefactors)
        check(interaction.prefactors.size() == interaction.exponents.size(),
              path + "prefactors",
              interaction.prefactors.size(),
              "as many as there are exponents, " +
                std::to_string(interaction.exponents.size()));
      else
        {
          check(interaction.equilibrium_gap > 0.,
                path + "equilibrium gap",
                interaction.equilibrium_gap,
                "positive");
          check(interaction.force_minimum < 0.,
                path + "force minimum",
                interaction.force_minimum,
                "negative");
          check(interaction.exponents == std::vector<unsigned int>({6, 12}),
                path + "exponents",
                interaction.exponents[0],
                "6, 12 with an equilibrium gap");
        }
      Laws::dispatch(interaction.law, [&](auto tag) {
        constexpr unsigned int smallest =
          decltype(tag)::type::smallest_exponent;
        for (const unsigned int m : interaction.exponents)
          check(m >= smallest,
                path + "exponents",
                m,
                "at least " + std::to_string(smallest) + " for the law '" +
                  interaction.law + "'");
      });
      check(interaction.cutoff > 0.,
            path + "cutoff",
            interaction.cutoff,
            "positive");
      check(interaction.switch_width > 0. && interaction.switch_width <= 1.,
            path + "switch width",
            interaction.switch_width,
            "above 0 and at most 1");
      check(interaction.regularization <
              (1. - interaction.switch_width) * interaction.cutoff,
            path + "regularization gap",
            interaction.regularization,
            "below the gap from which on the cutoff acts");
    }

    void
    check_scene(const Scene &scene)
    {
      check(!scene.fibers.empty(), "fibers/names", "", "at least one name");
      for (const FiberParameters &fiber : scene.fibers)
        check_fiber(fiber);
      for (const SupportParameters &support : scene.supports)
        {
          const std::string path = "supports/" + support.name + "/";
          check_reference(path + "fibers", support.fibers, scene.fibers);
          check_places(path + "at", support.at);
        }
      for (const LoadParameters &load : scene.loads)
        {
          const std::string path = "loads/" + load.name + "/";
          check_reference(path + "fibers", load.fibers, scene.fibers);
          check_places(path + "at", load.at);
        }
      for (const InteractionParameters &interaction : scene.interactions)
        {
          const std::string path = "interactions/" + interaction.name + "/";
          check_reference(path + "source", interaction.source, scene.fibers);
          check_reference(path + "target", interaction.target, scene.fibers);
          check_interaction(interaction);
        }

      const LoadSteppingParameters &steps = scene.load_stepping;
      check(steps.end_time > 0.,
            "load stepping/end time",
            steps.end_time,
            "positive");
      check(steps.smallest_step > 0.,
            "load stepping/smallest step",
            steps.smallest_step,
            "positive");
      check(steps.first_step > 0.,
            "load stepping/first step",
            steps.first_step,
            "positive");
      check(steps.growth >= 1.,
            "load stepping/growth",
            steps.growth,
            "at least 1");
      check(scene.newton.residual_tolerance > 0.,
            "newton/residual tolerance",
            scene.newton.residual_tolerance,
            "positive");
      check(scene.newton.increment_tolerance > 0.,
            "newton/increment tolerance",
            scene.newton.increment_tolerance,
            "positive");
    }
  } // namespace



  void
  FiberParameters::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("centerline",
                      centerline,
                      "The initial centerline x; y; z [length] as formulas of "
                      "s in [0, length] and of the numbers i, j, k of the copy "
                      "(from 0). Any regular parameter s will do; derivatives "
                      "are taken numerically.",
                      Patterns::Anything());
    prm.add_parameter("mesh file",
                      mesh_file,
                      "A mesh of lines in space to read the centerlines from, "
                      "in a format that deal.II's GridIn knows by its "
                      "extension (msh, vtk, inp, ...). Each connected chain of "
                      "lines becomes a fiber; 'centerline', 'length', 'cells' "
                      "and 'copies' are then not used.",
                      Patterns::Anything());
    prm.add_parameter("copies",
                      copies,
                      "The size of an array of equal fibers, up to three "
                      "numbers: '4, 5' makes 20 fibers with i = 0..3 and "
                      "j = 0..4 in their centerlines.",
                      Patterns::List(positive_integer(), 1, 3));
    prm.add_parameter("length",
                      length,
                      "The end of the range of s [length], positive.",
                      non_negative());
    prm.add_parameter("radius",
                      radius,
                      "Radius of the circular section [length], positive.",
                      non_negative());
    prm.add_parameter("youngs modulus",
                      youngs_modulus,
                      "Young's modulus [force/length^2], positive.",
                      non_negative());
    prm.add_parameter("poisson ratio",
                      poisson_ratio,
                      "Poisson's ratio. A shear-rigid fiber without torsion "
                      "does not depend on it.",
                      Patterns::Double());
    prm.add_parameter("cells",
                      n_cells,
                      "The number of equal cells along s.",
                      positive_integer());
    prm.add_parameter("number density",
                      number_density,
                      "Points of the interaction potential per volume "
                      "[1/length^3].",
                      non_negative());
    beam = TorsionFreeKirchhoff::name;
    prm.add_parameter("beam",
                      beam,
                      "The beam formulation. " + Beams::descriptions() + ".",
                      Patterns::Selection(Beams::names()));
  }



  void
  SupportParameters::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("fibers",
                      fibers,
                      "The fibers that are supported, by name, or 'all'.",
                      names_pattern());
    prm.add_parameter("at",
                      at,
                      "Where: 'start', 'end', 'all' (every node) or an arc "
                      "length s at which there is a node [length].",
                      names_pattern());
    prm.add_parameter("displacement",
                      displacement,
                      "The displacement of the points from where they were "
                      "initially, x; y; z, each 'free' or a formula of the "
                      "time t and of the numbers i, j, k of the copy [length].",
                      Patterns::Anything());
    prm.add_parameter("tangent",
                      tangent,
                      "The change of the unit tangents from what they were "
                      "initially, x; y; z, each 'free' or a formula of t and "
                      "of i, j, k.",
                      Patterns::Anything());
  }



  void
  LoadParameters::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("fibers",
                      fibers,
                      "The fibers that are loaded, by name, or 'all'.",
                      names_pattern());
    prm.add_parameter("at",
                      at,
                      "Where: 'start', 'end' or an arc length s for a point "
                      "load, 'all' for a line load.",
                      names_pattern());
    prm.add_parameter("force",
                      force,
                      "A dead load x; y; z as formulas of s and t: a force at a "
                      "point [force], or per initial length [force/length].",
                      Patterns::Anything());
    prm.add_parameter("moment",
                      moment,
                      "A moment x; y; z about axes fixed in space, as formulas "
                      "of s and t, at a point [force length] or per initial "
                      "length [force]. Its part along the tangent does no work "
                      "on a fiber without torsion.",
                      Patterns::Anything());
  }



  void
  InteractionParameters::add_parameters(ParameterHandler &prm)
  {
    law = DiskCylinder::name;
    prm.add_parameter("law",
                      law,
                      "The reduced law. " + Laws::descriptions() + ".",
                      Patterns::Selection(Laws::names()));
    prm.add_parameter("source",
                      source,
                      "The fibers that are integrated over (the papers' slave "
                      "side), by name, or 'all'. Two fibers that are both in "
                      "source and target interact once, the one listed first "
                      "being the source.",
                      names_pattern());
    prm.add_parameter("target",
                      target,
                      "The fibers that are projected onto (the papers' master "
                      "side), by name, or 'all'.",
                      names_pattern());
    prm.add_parameter("two half passes",
                      two_half_passes,
                      "Let every pair interact twice at half strength, each "
                      "fiber once being the source.");
    prm.add_parameter("self interaction",
                      self_interaction,
                      "Let the cells of one fiber interact with each other, in "
                      "two half passes.");
    prm.add_parameter("excluded neighbors",
                      n_excluded_neighbors,
                      "In the self-interaction, how many cells on either side "
                      "of a cell do not interact with it.",
                      positive_integer());
    prm.add_parameter("exponents",
                      exponents,
                      "The exponents m of the point potential sum k_m r^-m.",
                      Patterns::List(positive_integer(), 1));
    prm.add_parameter("prefactors",
                      prefactors,
                      "The prefactors k_m [energy length^m]; negative attracts.",
                      Patterns::List(Patterns::Double(), 0));
    prm.add_parameter("equilibrium gap",
                      equilibrium_gap,
                      "Instead of prefactors, for Lennard-Jones: the gap at "
                      "which two parallel cylinders feel no force [length].",
                      non_negative());
    prm.add_parameter("force minimum",
                      force_minimum,
                      "Instead of prefactors, for Lennard-Jones: the most "
                      "attractive force per length of two parallel cylinders "
                      "[force/length], negative.",
                      Patterns::Double(-infinity, 0.));
    prm.add_parameter("cutoff",
                      cutoff,
                      "The gap beyond which there is no interaction [length].",
                      non_negative());
    prm.add_parameter("switch width",
                      switch_width,
                      "The part of the cutoff over which the interaction is "
                      "switched off smoothly.",
                      Patterns::Double(0., 1.));
    prm.add_parameter("regularization gap",
                      regularization,
                      "Below this gap the law goes on with a force linear in "
                      "the gap (SBIP app. C). A state with a smaller gap is "
                      "never accepted. 0 switches it off [length].",
                      non_negative());
    prm.add_parameter("skin",
                      skin,
                      "How far beyond the cutoff partners are searched, so "
                      "that the search is repeated only when points have moved "
                      "by half of it [length]; 0 takes half of the cutoff.",
                      non_negative());
    prm.add_parameter("integration segments",
                      n_segments,
                      "Equal parts of a cell, each with its own Gauss points.",
                      positive_integer());
    prm.add_parameter("gauss points",
                      n_gauss_points,
                      "Gauss points per integration segment.",
                      positive_integer());
  }



  void
  LoadSteppingParameters::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("end time",
                      end_time,
                      "The load goes from time 0 to this one.",
                      non_negative());
    prm.add_parameter("first step",
                      first_step,
                      "The first load step [time].",
                      non_negative());
    prm.add_parameter("largest step",
                      largest_step,
                      "The largest load step [time], a formula of t: small "
                      "where a peak of the curve has to be resolved.",
                      Patterns::Anything());
    prm.add_parameter("smallest step",
                      smallest_step,
                      "A step that cannot be solved is repeated with smaller "
                      "size down to this one [time].",
                      non_negative());
    prm.add_parameter("growth",
                      growth,
                      "Largest factor from one step to the next.",
                      Patterns::Double(1.));
    prm.add_parameter("target iterations",
                      target_n_iterations,
                      "A step that takes more iterations than this one is "
                      "followed by a smaller one.",
                      positive_integer());
    prm.add_parameter("pass instabilities",
                      pass_instabilities,
                      "Where no equilibrium is found with the smallest step, "
                      "follow the overdamped motion to the next stable state "
                      "instead of stopping.");
  }



  void
  NewtonParameters::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("residual tolerance",
                      residual_tolerance,
                      "Largest Euclidean norm of the residual.",
                      non_negative());
    prm.add_parameter("increment tolerance",
                      increment_tolerance,
                      "Largest Euclidean norm of the last increment.",
                      non_negative());
    prm.add_parameter("iterations",
                      max_n_iterations,
                      "Largest number of iterations of one load step.",
                      positive_integer());
    prm.add_parameter("largest increment",
                      largest_increment,
                      "Largest displacement of a node by one correction "
                      "[length]; 0 means no bound.",
                      non_negative());
    prm.add_parameter("linear solver",
                      linear_solver,
                      "The direct solver of Trilinos' Amesos.",
                      Patterns::Selection("Amesos_Klu|Amesos_Mumps"));
    prm.add_parameter("log iterations",
                      log_iterations,
                      "Print a line for every iteration.");
  }



  void
  OutputParameters::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("directory",
                      directory,
                      "Where results are written; empty takes output/ and the "
                      "name of the .prm file.",
                      Patterns::Anything());
    prm.add_parameter("fields",
                      fields,
                      "Write fibers and interaction forces for ParaView.");
    prm.add_parameter("interval",
                      interval,
                      "Time between two outputs of fields; 0 writes every load "
                      "step.",
                      non_negative());
    prm.add_parameter("subdivisions",
                      n_subdivisions,
                      "Lines that a cell is drawn with.",
                      positive_integer());
  }



  std::vector<unsigned int>
  Scene::active_coordinates() const
  {
    std::vector<unsigned int> result;
    for (unsigned int c = 0; c < 3; ++c)
      if (coordinates.find(coordinate_names[c]) != std::string::npos)
        result.push_back(c);
    return result;
  }



  Scene
  Scene::read(const std::string &             text,
              const std::string &             file_name,
              const std::vector<std::string> &override_texts)
  {
    std::vector<Override> overrides(override_texts.begin(),
                                    override_texts.end());
    std::string           overridden_text = text;
    for (const Override &entry : overrides)
      overridden_text += entry.as_text();

    // The names of the subsections have to be known before these can be
    // declared; everything else is read, strictly, in a second pass.
    Names names;
    {
      ParameterHandler prm;
      names.add_parameters(prm);
      std::istringstream stream(overridden_text);
      prm.parse_input(stream, file_name, "", true);
      names.check_unique();
    }

    Scene scene;
    scene.fibers       = named<FiberParameters>(names.fibers);
    scene.supports     = named<SupportParameters>(names.supports);
    scene.loads        = named<LoadParameters>(names.loads);
    scene.interactions = named<InteractionParameters>(names.interactions);

    ParameterHandler prm;
    add_parameters(prm, scene, names);
    std::istringstream stream(text);
    prm.parse_input(stream, file_name);
    for (const Override &entry : overrides)
      entry.apply(prm);

    scene.constants = parse_constants("constants", scene.constants_text);
    check(!scene.active_coordinates().empty(),
          "coordinates",
          scene.coordinates,
          "at least one of x, y, z");
    check_scene(scene);
    if (scene.output.directory.empty())
      scene.output.directory =
        (std::filesystem::path("output") /
         std::filesystem::path(file_name).stem())
          .string();

    std::ostringstream used;
    prm.print_parameters(used, ParameterHandler::ShortText);
    scene.used_parameters = used.str();
    return scene;
  }



  std::string
  Scene::documentation()
  {
    Scene scene;
    scene.fibers       = named<FiberParameters>({"NAME"});
    scene.supports     = named<SupportParameters>({"NAME"});
    scene.loads        = named<LoadParameters>({"NAME"});
    scene.interactions = named<InteractionParameters>({"NAME"});

    Names            names;
    ParameterHandler prm;
    add_parameters(prm, scene, names);
    std::ostringstream text;
    prm.print_parameters(text, ParameterHandler::Text);
    return text.str();
  }
} // namespace Setae
