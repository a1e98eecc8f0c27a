// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <setae/output/files.h>
#include <setae/output/result_files.h>

#include <limits>

namespace Setae
{
  using namespace dealii;

  ResultFiles::ResultFiles(const FiberSystem              &fibers,
                           const std::vector<std::string> &term_names)
    : fibers(fibers)
    , scene(fibers.scene)
    , statistics(term_names)
    , visualization(fibers, scene.output.directory)
    , last_field_output(-std::numeric_limits<double>::infinity())
  {}



  void
  ResultFiles::prepare(const RunOrigin &origin)
  {
    const unsigned int n_ranks =
      Utilities::MPI::n_mpi_processes(fibers.communicator);
    Files::on_first_rank(fibers.communicator, [&]() {
      directory = std::make_unique<OutputDirectory>(scene.output.directory,
                                                    origin.scene_file);
      std::string text =
        "# " + mark_of_origin() + ", " + std::to_string(n_ranks) + " rank(s)\n";
      if (!origin.command_line.empty())
        text += "# " + origin.command_line + "\n";
      directory->begin(text + scene.used_parameters);
    });
  }



  bool
  ResultFiles::is_due(const StepRecord &record) const
  {
    return record.is_snap || record.time >= scene.end_time() ||
           record.time >=
             last_field_output + scene.output.interval * (1. - 1e-10);
  }



  void
  ResultFiles::add(const StepRecord                               &record,
                   const State                                    &state,
                   const StrainEnergy                             &strain,
                   const std::vector<std::unique_ptr<EnergyTerm>> &terms)
  {
    statistics.add(record);
    Files::on_first_rank(fibers.communicator, [this]() {
      statistics.write(scene.output.directory);
    });
    if (!scene.output.fields || !is_due(record))
      return;
    last_field_output = record.time;
    visualization.write(state, strain, terms);
  }
} // namespace Setae
