// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <deal.II/base/mpi.h>

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

namespace
{
  /**
   * A folder for the session of Open MPI. All its processes share one by
   * default, and two that start at the same time, as with `ctest --parallel`,
   * may both want to create it, of which one fails.
   */
  class SessionFolder
  {
  public:
    SessionFolder()
    {
      std::string name =
        (std::filesystem::temp_directory_path() / "setae-XXXXXX").string();
      if (mkdtemp(name.data()) == nullptr)
        return;
      folder = name;
      setenv("OMPI_MCA_orte_tmpdir_base", name.c_str(), 1);
    }

    ~SessionFolder()
    {
      std::error_code ignored;
      if (!folder.empty())
        std::filesystem::remove_all(folder, ignored);
    }

  private:
    std::filesystem::path folder;
  };
} // namespace



/**
 * GoogleTest's own main() does not initialize MPI, which the tests that touch
 * Trilinos need.
 */
int
main(int argc, char **argv)
{
  const SessionFolder session;
  testing::InitGoogleTest(&argc, argv);
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  return RUN_ALL_TESTS();
}
