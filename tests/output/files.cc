// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <setae/base/exceptions.h>
#include <setae/output/files.h>

#include <csignal>
#include <fstream>
#include <sstream>

namespace
{
  using namespace Setae;
  namespace fs = std::filesystem;

  std::string
  contents(const fs::path &name)
  {
    std::ifstream      stream(name);
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
  }

  /** A folder on a disk that takes files of at most 8 bytes. */
  class FullDisk : public ::testing::Test
  {
  protected:
    void
    SetUp() override
    {
      folder = fs::temp_directory_path() /
               ("setae_full_disk_" + std::to_string(getpid()));
      fs::create_directory(folder);
      file = folder / "file";
      Files::replace(file, "old");

      last_handler = std::signal(SIGXFSZ, SIG_IGN);
      getrlimit(RLIMIT_FSIZE, &last_limit);
      rlimit limit   = last_limit;
      limit.rlim_cur = 8;
      setrlimit(RLIMIT_FSIZE, &limit);
    }

    void
    TearDown() override
    {
      setrlimit(RLIMIT_FSIZE, &last_limit);
      std::signal(SIGXFSZ, last_handler);
      fs::remove_all(folder);
    }

    std::size_t
    n_files() const
    {
      return std::distance(fs::directory_iterator(folder),
                           fs::directory_iterator());
    }

    /** What is told of a failure. */
    template <typename Function>
    std::string
    message(const Function &write)
    {
      try
        {
          write();
        }
      catch (const ExcRun &exception)
        {
          return one_line(exception);
        }
      return "no failure";
    }

    fs::path folder, file;
    rlimit   last_limit;
    void (*last_handler)(int);
  };
} // namespace



TEST_F(FullDisk, WhatFitsIsWritten)
{
  Files::append(file, "+");
  EXPECT_EQ(contents(file), "old+");
  Files::replace(file, "new");
  EXPECT_EQ(contents(file), "new");
}



TEST_F(FullDisk, ReplacingLeavesTheOldContents)
{
  EXPECT_EQ(message([&]() { Files::replace(file, "much too long"); }),
            "The file '" + file.string() +
              "' cannot be written: File too large.");
  EXPECT_EQ(contents(file), "old");
  EXPECT_EQ(n_files(), 1u);
}



TEST_F(FullDisk, AppendingLeavesNoPartOfALine)
{
  EXPECT_EQ(message([&]() { Files::append(file, " and much too long"); }),
            "The file '" + file.string() +
              "' cannot be written: File too large.");
  EXPECT_EQ(contents(file), "old");
}



TEST(Files, AFolderThatIsNotThereIsNamedWithTheReason)
{
  try
    {
      Files::replace("/nowhere/file", "text");
      FAIL();
    }
  catch (const ExcRun &exception)
    {
      EXPECT_EQ(one_line(exception),
                "The file '/nowhere/file' cannot be written: No such file or "
                "directory.");
    }
}



TEST(OneLine, TellsOfMissingMemoryAndLeavesOutLineBreaks)
{
  EXPECT_EQ(one_line(std::bad_alloc()),
            "There is not enough memory (std::bad_alloc).");
  EXPECT_EQ(one_line(std::runtime_error("two\n   lines\n")), "two lines");
}
