// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <setae/base/exceptions.h>
#include <setae/base/shared_exit.h>
#include <setae/fiber_problem.h>
#include <setae/revision.h>
#include <setae/verification/calibration.h>

#include <fstream>
#include <iostream>
#include <sstream>

namespace
{
  const char *const usage =
    "Usage: setae [options] SCENE.prm\n"
    "       mpirun -np N setae [options] SCENE.prm\n"
    "\n"
    "Simulates molecular interactions between slender elastic fibers.\n"
    "\n"
    "Options:\n"
    "  --set \"SECTION/NAME=VALUE\"  override a parameter of the scene; may be\n"
    "                              given more than once\n"
    "  --output DIR                write results to DIR\n"
    "  --calibrate GAP[,ANGLE]     print the prefactors with which the laws of\n"
    "                              the scene give the exact force of two straight\n"
    "                              fibers at this gap, parallel or crossing at an\n"
    "                              angle in degrees, and the error that remains\n"
    "                              at other gaps\n"
    "  --print-parameters          print all parameters with their defaults,\n"
    "                              allowed values and documentation\n"
    "  --version                   print the version\n"
    "  --help                      print this text\n";

  struct CommandLine
  {
    enum class Action
    {
      run,
      calibrate,
      help,
      version,
      print_parameters
    };

    Action                   action = Action::run;
    std::string              scene;
    std::vector<std::string> overrides;
    double                   gap   = 0.; ///< of the calibration [length]
    double                   angle = 0.; ///< in radians
  };



  /** Of the text 'GAP' or 'GAP,ANGLE', the angle in degrees. */
  void
  parse_calibration(const std::string &text, CommandLine &command)
  {
    std::vector<double> numbers;
    try
      {
        numbers = dealii::Utilities::string_to_double(
          dealii::Utilities::split_string_list(text));
      }
    catch (const dealii::ExceptionBase &)
      {}
    AssertThrow((numbers.size() == 1 || numbers.size() == 2) &&
                  numbers[0] > 0. &&
                  (numbers.size() == 1 ||
                   (numbers[1] >= 0. && numbers[1] <= 90.)),
                Setae::ExcInput("The option '--calibrate' takes a positive gap "
                                "and maybe an angle from 0 to 90 degrees, "
                                "separated by a comma, not '" +
                                text + "'."));
    command.action = CommandLine::Action::calibrate;
    command.gap    = numbers[0];
    if (numbers.size() == 2)
      command.angle = numbers[1] * M_PI / 180.;
  }



  CommandLine
  parse(const std::vector<std::string> &arguments)
  {
    using Setae::ExcInput;

    CommandLine result;
    for (unsigned int i = 0; i < arguments.size(); ++i)
      {
        const std::string &argument = arguments[i];
        const auto         value    = [&]() {
          AssertThrow(i + 1 < arguments.size(),
                      ExcInput("The option '" + argument + "' needs a value."));
          return arguments[++i];
        };
        if (argument == "--help" || argument == "-h")
          result.action = CommandLine::Action::help;
        else if (argument == "--version")
          result.action = CommandLine::Action::version;
        else if (argument == "--print-parameters")
          result.action = CommandLine::Action::print_parameters;
        else if (argument == "--calibrate")
          parse_calibration(value(), result);
        else if (argument == "--set")
          result.overrides.push_back(value());
        else if (argument == "--output")
          result.overrides.push_back("output/directory=" + value());
        else
          {
            AssertThrow(
              argument.empty() || argument[0] != '-',
              ExcInput("There is no option '" + argument +
                       "'; allowed are --set, --output, "
                       "--calibrate, --print-parameters, --version, --help."));
            AssertThrow(result.scene.empty(),
                        ExcInput("There is more than one scene: '" +
                                 result.scene + "' and '" + argument + "'."));
            result.scene = argument;
          }
      }
    AssertThrow((result.action != CommandLine::Action::run &&
                 result.action != CommandLine::Action::calibrate) ||
                  !result.scene.empty(),
                ExcInput("There is no scene to run; try --help."));
    return result;
  }



  std::string
  read_file(const std::string &name)
  {
    std::ifstream      stream(name);
    std::ostringstream text;
    text << stream.rdbuf();
    AssertThrow(stream.good() && !text.str().empty(),
                Setae::ExcInput("The scene '" + name + "' cannot be read."));
    return text.str();
  }



  /** The arguments as a shell takes them, in one line. */
  std::string
  as_typed(const std::vector<std::string> &arguments)
  {
    const std::string plain = "abcdefghijklmnopqrstuvwxyz"
                              "ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_./,=:+-@%";
    std::string       line  = "setae";
    for (const std::string &argument : arguments)
      {
        line += ' ';
        if (!argument.empty() &&
            argument.find_first_not_of(plain) == std::string::npos)
          {
            line += argument;
            continue;
          }
        line += '\'';
        for (const char c : argument)
          if (c == '\'')
            line += "'\\''";
          else
            line += c == '\n' || c == '\r' ? ' ' : c;
        line += '\'';
      }
    return line;
  }



  void
  run(const std::vector<std::string> &arguments)
  {
    const CommandLine command = parse(arguments);
    const bool        is_root =
      dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
    const auto scene = [&command]() {
      return Setae::Scene::read(read_file(command.scene),
                                command.scene,
                                command.overrides);
    };
    switch (command.action)
      {
        case CommandLine::Action::help:
          if (is_root)
            std::cout << usage;
          break;
        case CommandLine::Action::version:
          if (is_root)
            std::cout << "setae " << Setae::version << " ("
                      << Setae::git_revision << "), deal.II "
                      << DEAL_II_PACKAGE_VERSION << '\n';
          break;
        case CommandLine::Action::print_parameters:
          if (is_root)
            std::cout << Setae::Scene::documentation();
          break;
        case CommandLine::Action::calibrate:
          if (is_root)
            Setae::References::calibrate(scene(),
                                         command.gap,
                                         command.angle,
                                         std::cout);
          break;
        case CommandLine::Action::run:
          Setae::FiberProblem(scene(), MPI_COMM_WORLD, std::cout)
            .run({as_typed(arguments), command.scene});
          break;
      }
  }
} // namespace



int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  Setae::SharedExit                        exit(MPI_COMM_WORLD);
  try
    {
      run({argv + 1, argv + argc});
    }
  catch (const Setae::ExcOtherRank &)
    {
      return exit.failure("");
    }
  catch (const std::exception &exception)
    {
      return exit.failure(Setae::one_line(exception));
    }
  catch (const int code)
    {
      return exit.failure("Trilinos has failed with the error " +
                          std::to_string(code) + ".");
    }
  return exit.success();
}
