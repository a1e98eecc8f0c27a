// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_output_files_h
#define setae_output_files_h

#include <deal.II/base/mpi.h>

#include <filesystem>
#include <functional>
#include <string>

/** Files that are whole at any time: a run may end whenever it is killed. */
namespace Setae::Files
{
  /**
   * Give a file the contents @p text. Whoever reads it meanwhile, or after the
   * run was killed meanwhile, finds the old contents or the new ones.
   *
   * @throws ExcRun with the reason of the system; the old contents are left.
   */
  void
  replace(const std::filesystem::path &name, const std::string &text);

  /**
   * Append @p text to a file, all of it or nothing.
   *
   * @throws ExcRun with the reason of the system.
   */
  void
  append(const std::filesystem::path &name, const std::string &text);

  /**
   * Write files from the first rank; collective. If that fails, every rank
   * throws: none is left waiting for the others.
   *
   * @throws ExcOtherRank on all ranks but the first.
   */
  void
  on_first_rank(const MPI_Comm               communicator,
                const std::function<void()> &write);
} // namespace Setae::Files

#endif
