// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <setae/base/exceptions.h>
#include <setae/output/result_files.h>

#include <exception>
#include <filesystem>
#include <fstream>

namespace Setae
{
  using namespace dealii;

  namespace
  {
    /**
     * Write files from the first rank. If that fails, every rank throws: none
     * is left waiting for the others.
     */
    template <typename Function>
    void
    on_first_rank(const MPI_Comm communicator, const Function &function)
    {
      std::exception_ptr problem;
      if (Utilities::MPI::this_mpi_process(communicator) == 0)
        try
          {
            function();
          }
        catch (...)
          {
            problem = std::current_exception();
          }
      const bool failed =
        Utilities::MPI::max(problem ? 1 : 0, communicator) == 1;
      if (problem)
        std::rethrow_exception(problem);
      AssertThrow(!failed, ExcRun("The first rank cannot write its files."));
    }
  } // namespace



  ResultFiles::ResultFiles(const FiberSystem              &fibers,
                           const std::vector<std::string> &term_names)
    : fibers(fibers)
    , scene(fibers.scene)
    , statistics(term_names)
    , visualization(fibers, scene.output.directory)
    , last_field_output(-std::numeric_limits<double>::infinity())
  {}



  void
  ResultFiles::prepare() const
  {
    on_first_rank(fibers.communicator, [this]() {
      const std::filesystem::path directory(scene.output.directory);
      std::error_code             error;
      std::filesystem::create_directories(directory, error);
      std::ofstream parameters(directory / "parameters.prm");
      parameters << scene.used_parameters;
      parameters.close();
      AssertThrow(parameters.good(),
                  ExcParameter("output/directory",
                               scene.output.directory,
                               "a directory that can be written"));

      for (const auto &entry : std::filesystem::directory_iterator(directory))
        {
          const std::string name      = entry.path().filename().string();
          const std::string extension = entry.path().extension().string();
          if (name == "statistics.txt" || extension == ".pvd" ||
              extension == ".vtu" || extension == ".pvtu")
            std::filesystem::remove(entry.path());
        }
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
    on_first_rank(fibers.communicator,
                  [this]() { statistics.write(scene.output.directory); });
    if (!scene.output.fields || !is_due(record))
      return;
    last_field_output = record.time;
    visualization.write(state, strain, terms);
  }
} // namespace Setae
