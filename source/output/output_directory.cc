// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <setae/base/exceptions.h>
#include <setae/output/files.h>
#include <setae/output/output_directory.h>
#include <setae/revision.h>

#include <cerrno>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>
#include <system_error>

namespace Setae
{
  namespace fs = std::filesystem;

  namespace
  {
    const char *const collections[] = {"fibers.pvd", "interaction.pvd"};

    /** The names of files of fields, as this and earlier versions give them. */
    const std::regex
      field_file(R"((fibers|interaction)_\d{5,}(\.\d+)?\.p?vtu)");

    std::string
    contents(const fs::path &name)
    {
      std::ifstream      stream(name);
      std::ostringstream text;
      text << stream.rdbuf();
      return text.str();
    }

    std::string
    first_lines(const fs::path &name)
    {
      std::ifstream stream(name);
      std::string   text(512, '\0');
      stream.read(text.data(), text.size());
      text.resize(stream.gcount());
      return text;
    }

    /** Whether a file of fields, or a collection of them, is one of Setae. */
    bool
    is_own(const fs::path &name)
    {
      const std::string text = first_lines(name);
      return text.empty() || text.find("Setae") != std::string::npos ||
             text.find("deal.II") != std::string::npos;
    }

    /** The files that a collection names, and those that they name. */
    std::set<std::string>
    listed_files(const fs::path &directory, const std::string &collection)
    {
      static const std::regex reference("(file|Source)=\"([^\"]*)\"");

      std::set<std::string>    result;
      std::vector<std::string> open = {collection};
      while (!open.empty())
        {
          const std::string text = contents(directory / open.back());
          open.pop_back();
          for (std::sregex_iterator match(text.begin(), text.end(), reference);
               match != std::sregex_iterator();
               ++match)
            {
              const std::string name = (*match)[2];
              if (!std::regex_match(name, field_file) ||
                  !result.insert(name).second)
                continue;
              // Only records of the pieces of several ranks, which earlier
              // versions wrote, name further files.
              if (fs::path(name).extension() == ".pvtu")
                open.push_back(name);
            }
        }
      return result;
    }
  } // namespace



  std::string
  mark_of_origin()
  {
    return std::string("Setae ") + version + " (" + git_revision + ")";
  }



  OutputDirectory::OutputDirectory(const std::string &name,
                                   const std::string &scene_file)
    : name(name)
    , directory(name)
  {
    std::error_code error;
    fs::create_directories(directory, error);
    if (!fs::is_directory(directory))
      refuse("a directory that can be written");
    check_foreign_files(scene_file);
    lock();
  }



  OutputDirectory::~OutputDirectory()
  {
    if (locked_file >= 0)
      close(locked_file);
  }



  void
  OutputDirectory::check_foreign_files(const std::string &scene_file) const
  {
    const fs::path parameters = directory / "parameters.prm",
                   statistics = directory / "statistics.txt";
    std::error_code error;
    if (fs::equivalent(parameters, scene_file, error))
      refuse("another directory than that of the scene '" + scene_file +
             "', which the saved parameters would overwrite");

    const auto check = [&](const bool is_fine, const fs::path &file) {
      if (!is_fine)
        refuse("a directory without a foreign '" + file.filename().string() +
               "': no run of Setae has left the one there, and it would be "
               "overwritten");
    };

    // Saved parameters look like any scene, but lie beside the statistics.
    check(!fs::exists(parameters) || fs::exists(statistics), parameters);
    const std::string columns = first_lines(statistics);
    check(columns.empty() || columns.rfind("# 1: step\n", 0) == 0, statistics);

    std::set<std::string> own;
    for (const char *const collection : collections)
      {
        check(is_own(directory / collection), directory / collection);
        own.merge(listed_files(directory, collection));
      }
    for (const auto &entry : fs::directory_iterator(directory))
      {
        const std::string file = entry.path().filename().string();
        check(!std::regex_match(file, field_file) || own.count(file) > 0 ||
                first_lines(entry.path()).find("Setae") != std::string::npos,
              entry.path());
      }
  }



  void
  OutputDirectory::lock()
  {
    const fs::path statistics = directory / "statistics.txt";
    locked_file = open(statistics.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (locked_file < 0)
      refuse("a directory that can be written (" +
             std::generic_category().message(errno) + ")");

    // A file system without locks cannot protect a run from another one.
    if (flock(locked_file, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK)
      {
        close(locked_file);
        locked_file = -1;
        refuse("a directory that no other run is writing to");
      }
  }



  void
  OutputDirectory::begin(const std::string &parameters)
  {
    Files::replace(directory / "parameters.prm", parameters);
    for (const char *const collection : collections)
      {
        for (const std::string &file : listed_files(directory, collection))
          fs::remove(directory / file);
        fs::remove(directory / collection);
      }

    // The lock is on the file: it stays, and becomes empty.
    fs::resize_file(directory / "statistics.txt", 0);
  }



  void
  OutputDirectory::refuse(const std::string &allowed) const
  {
    throw ExcParameter("output/directory", name, allowed);
  }
} // namespace Setae
