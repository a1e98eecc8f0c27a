// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_output_output_directory_h
#define setae_output_output_directory_h

#include <filesystem>
#include <string>

namespace Setae
{
  /** Stands in every file of fields, and tells that Setae may replace it. */
  std::string
  mark_of_origin();



  /**
   * The folder that one run writes to: `parameters.prm`, `statistics.txt`, and
   * the collections `fibers.pvd` and `interaction.pvd` with the files that they
   * name. It may hold other files, which stay as they are. It belongs to one
   * run at a time, by a lock on `statistics.txt` that the system frees when the
   * run ends, however that happens.
   *
   * To be used by one rank.
   */
  class OutputDirectory
  {
  public:
    /**
     * Make the folder, if there is none, and lock it; nothing in it changes.
     *
     * @p scene_file: the scene that is read, which is not overwritten.
     *
     * @throws ExcParameter if it cannot be written, if another run writes to
     * it, or if files would be lost that no run of Setae has left there.
     */
    OutputDirectory(const std::string &name, const std::string &scene_file);

    ~OutputDirectory();

    OutputDirectory(const OutputDirectory &) = delete;
    OutputDirectory &
    operator=(const OutputDirectory &) = delete;

    /**
     * Remove what an earlier run has left there, and write the parameters of
     * this one.
     */
    void
    begin(const std::string &parameters);

  private:
    void
    check_foreign_files(const std::string &scene_file) const;

    void
    lock();

    [[noreturn]] void
    refuse(const std::string &allowed) const;

    const std::string           name; ///< as the scene gives it
    const std::filesystem::path directory;
    int                         locked_file = -1;
  };
} // namespace Setae

#endif
