// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_output_result_files_h
#define setae_output_result_files_h

#include <setae/output/output_directory.h>
#include <setae/output/statistics.h>
#include <setae/output/visualization.h>

#include <memory>
#include <string>
#include <vector>

namespace Setae
{
  /** Where a run comes from. */
  struct RunOrigin
  {
    std::string command_line; ///< to be told in the saved parameters
    std::string scene_file;   ///< never overwritten
  };



  /**
   * The output directory of a run: the parameters as they were used, the
   * statistics and, if the scene wants them, the fields. What add() has
   * returned from is on disk.
   */
  class ResultFiles
  {
  public:
    ResultFiles(const FiberSystem              &fibers,
                const std::vector<std::string> &term_names);

    /**
     * Make the directory and take hold of it until the end of this object,
     * remove what an earlier run left there, and save the parameters;
     * collective.
     *
     * @throws ExcParameter if it cannot be written, is in use, or if foreign
     * files would be lost.
     */
    void
    prepare(const RunOrigin &origin);

    /** Add a load step; collective. */
    void
    add(const StepRecord                               &record,
        const State                                    &state,
        const StrainEnergy                             &strain,
        const std::vector<std::unique_ptr<EnergyTerm>> &terms);

  private:
    bool
    is_due(const StepRecord &record) const;

    const FiberSystem &fibers;
    const Scene       &scene;
    Statistics         statistics;
    Visualization      visualization;
    double             last_field_output;

    std::unique_ptr<OutputDirectory> directory; ///< on the first rank
  };
} // namespace Setae

#endif
