// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <deal.II/base/utilities.h>

#include <setae/base/entries.h>
#include <setae/base/exceptions.h>
#include <setae/scene.h>

#include <algorithm>
#include <filesystem>
#include <sstream>

namespace Setae
{
  using namespace dealii;

  namespace
  {
    const std::vector<std::string> coordinate_names = {"x", "y", "z"};

    /** The byte order mark of UTF-8. */
    const std::string utf8_mark = "\xEF\xBB\xBF";

    /** What the rest is declared and read with, read before it. */
    struct Names
    {
      std::vector<std::string> fibers, supports, loads, interactions;
      std::string              constants;

      void
      add_parameters(Entries &prm)
      {
        const auto add = [&prm](const std::string        &section,
                                std::vector<std::string> &names,
                                const std::string        &what) {
          prm.enter_subsection(section);
          prm.add_parameter("names",
                            names,
                            "The names of " + what +
                              ", each a subsection of this one.",
                            Patterns::List(Patterns::Anything()));
          prm.leave_subsection();
        };
        prm.add_parameter("constants",
                          constants,
                          "Names that may stand in every formula and number of "
                          "the scene: 'l = 5, R = l/250'.",
                          Patterns::Anything());
        add("fibers", fibers, "the fibers, or arrays of fibers");
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
            require(std::count(list.begin(), list.end(), name) == 1 &&
                      name != "all" && name != "names" && !name.empty(),
                    parameter,
                    name,
                    "a list of different names, none of them 'all' or 'names'");
      }
    };

    void
    add_parameters(Entries &prm, Scene &scene, Names &names)
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
      prm.add_parameter("verification",
                        scene.verification,
                        "What the interactions of the last state are compared "
                        "with: the sum over all pairs of points of two fibers "
                        "as solid bodies, which takes seconds to minutes a "
                        "pair.",
                        Patterns::Selection("none|full 6D quadrature"));
      names.add_parameters(prm);

      const auto add_sections = [&prm](const std::string &section, auto &list) {
        prm.enter_subsection(section);
        for (auto &entry : list)
          {
            prm.enter_subsection(entry.name);
            if constexpr (std::is_same_v<decltype(entry), FiberParameters &>)
              prm.texts = &entry.texts;
            entry.add_parameters(prm);
            prm.leave_subsection();
          }
        prm.texts = nullptr;
        prm.leave_subsection();
      };

      // Numbers of a fiber are read for its first copy here.
      const Constants constants = prm.constants;
      prm.constants = with_copy(constants, {{"i", 0.}, {"j", 0.}, {"k", 0.}});
      add_sections("fibers", scene.fibers);
      prm.constants = constants;
      add_sections("supports", scene.supports);
      add_sections("loads", scene.loads);
      add_sections("interactions", scene.interactions);

      const auto add_section = [&prm](const std::string &section,
                                      auto              &parameters) {
        prm.enter_subsection(section);
        parameters.add_parameters(prm);
        prm.leave_subsection();
      };
      add_section("load stepping", scene.load_stepping);
      add_section("dynamics", scene.dynamics);
      add_section("newton", scene.newton);
      add_section("output", scene.output);
      add_section("full 6D quadrature", scene.full_quadrature);
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

    /** Where to find what may stand in a scene. */
    const std::string hint =
      "allowed is what 'setae --print-parameters' prints, with the sections of "
      "fibers, supports, loads and interactions that their 'names' list.";



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
      apply(Entries &prm) const
      {
        for (const std::string &section : sections)
          prm.enter_subsection(section);
        try
          {
            prm.set(name, value);
          }
        catch (const ParameterHandler::ExcEntryUndeclared &)
          {
            AssertThrow(false,
                        ExcInput("There is no parameter '" + path() +
                                 "' to set to '" + value + "'; " + hint));
          }
        catch (const ParameterHandler::ExcValueDoesNotMatchPattern &exception)
          {
            const std::string text    = reason(exception);
            const std::size_t pattern = text.find('[');
            AssertThrow(false,
                        ExcParameter(
                          path(),
                          value,
                          text.substr(pattern, text.rfind(']') + 1 - pattern)));
          }
        for (unsigned int i = 0; i < sections.size(); ++i)
          prm.leave_subsection();
      }

      std::string
      path() const
      {
        std::string result;
        for (const std::string &section : sections)
          result += section + "/";
        return result + name;
      }
    };



    /** ParameterHandler's own messages name file, line, entry and pattern. */
    void
    parse(Entries           &prm,
          const std::string &text,
          const std::string &file_name,
          const bool         skip_undefined = false)
    {
      std::istringstream stream(text);
      try
        {
          prm.parse_input(stream, file_name, "", skip_undefined);
        }
      catch (const ParameterHandler::ExcInvalidEntryForPattern &)
        {
          throw;
        }
      catch (const ExceptionBase &exception)
        {
          // An editor shows nothing of a mark at the start of an included file.
          const std::string text = reason(exception);
          AssertThrow(false,
                      ExcInput(
                        text + "; " +
                        (text.find(utf8_mark) == std::string::npos ?
                           hint :
                           "an included file must be saved without the "
                           "UTF-8 byte order mark that it begins with.")));
        }
    }



    /** Only the scene itself may begin with a mark, as some editors write it.
     */
    std::string
    without_mark(const std::string &text)
    {
      return text.compare(0, utf8_mark.size(), utf8_mark) == 0 ?
               text.substr(utf8_mark.size()) :
               text;
    }



    /**
     * A relative path starts from the folder of the scene, or from the working
     * directory if there is no such file. The parameters that are saved have
     * absolute paths, so that they can be read from elsewhere.
     */
    void
    find_mesh_files(std::vector<FiberParameters> &fibers,
                    const std::string            &file_name,
                    ParameterHandler             &prm)
    {
      const auto folder = std::filesystem::path(file_name).parent_path();
      for (FiberParameters &fiber : fibers)
        {
          const auto beside_scene = folder / fiber.mesh_file;
          if (fiber.mesh_file.empty())
            continue;
          if (std::filesystem::is_regular_file(beside_scene))
            fiber.mesh_file = beside_scene.string();
          if (!std::filesystem::is_regular_file(fiber.mesh_file))
            continue;
          const std::string used = fiber.mesh_file;
          prm.enter_subsection("fibers");
          prm.enter_subsection(fiber.name);
          prm.set("mesh file",
                  std::filesystem::absolute(used).lexically_normal().string());
          prm.leave_subsection();
          prm.leave_subsection();
          fiber.mesh_file = used; // as the user knows it, for messages
        }
    }

  } // namespace



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
  Scene::read(const std::string              &file_text,
              const std::string              &file_name,
              const std::vector<std::string> &override_texts)
  {
    std::vector<Override> overrides(override_texts.begin(),
                                    override_texts.end());
    const std::string     text            = without_mark(file_text);
    std::string           overridden_text = text;
    for (const Override &entry : overrides)
      overridden_text += entry.as_text();

    // The names of the subsections have to be known before these can be
    // declared, and the constants before numbers can be read; everything is
    // read, strictly, in a second pass.
    Names names;
    {
      Entries prm;
      names.add_parameters(prm);
      parse(prm, overridden_text, file_name, true);
      names.check_unique();
    }

    Scene scene;
    scene.fibers       = named<FiberParameters>(names.fibers);
    scene.supports     = named<SupportParameters>(names.supports);
    scene.loads        = named<LoadParameters>(names.loads);
    scene.interactions = named<InteractionParameters>(names.interactions);
    scene.constants    = parse_constants("constants", names.constants);

    Entries prm;
    prm.constants = scene.constants;
    add_parameters(prm, scene, names);
    parse(prm, text, file_name);
    for (const Override &entry : overrides)
      entry.apply(prm);

    require(!scene.active_coordinates().empty(),
            "coordinates",
            scene.coordinates,
            "at least one of x, y, z");
    find_mesh_files(scene.fibers, file_name, prm);
    scene.check();
    if (scene.output.directory.empty())
      scene.output.directory =
        "output-" + std::filesystem::path(file_name).stem().string();

    // The saved parameters repeat the run into another folder.
    const std::string directory = scene.output.directory;
    prm.enter_subsection("output");
    prm.set("directory", "");
    prm.leave_subsection();
    scene.output.directory = directory;

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

    Names   names = {{"NAME"}, {"NAME"}, {"NAME"}, {"NAME"}, ""};
    Entries prm;
    add_parameters(prm, scene, names);
    std::ostringstream text;
    prm.print_parameters(text, ParameterHandler::Text);
    return text.str();
  }
} // namespace Setae
