// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

// Step 4: charged fibers, statics. Two fibers with opposite charges bend
// towards each other; print how far they come over the strength of the
// attraction.

#include <deal.II/base/mpi.h>

#include <setae/fiber_problem.h>

#include <fstream>
#include <iomanip>
#include <iostream>
#include <sstream>

using namespace Setae;

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const bool                               is_first =
    dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
  if (argc < 2)
    {
      if (is_first)
        std::cout
          << "Usage: step-4 charged_pair.prm [section/name=value ...]\n";
      return 1;
    }

  try
    {
      std::ifstream     file(argv[1]);
      std::stringstream text;
      text << file.rdbuf();
      AssertThrow(file, dealii::ExcFileNotOpen(argv[1]));
      const Scene scene =
        Scene::read(text.str(), argv[1], {argv + 2, argv + argc});

      // The log of the driver is not wanted here: the table says it all.
      std::ostringstream log;
      FiberProblem       problem(scene, MPI_COMM_WORLD, log);
      if (is_first)
        std::cout << "  k      midpoint      iterations\n";

      // The load step at time t has the prefactor k = t. The load `midpoint`
      // has no force: it is there for its displacement.
      const RunSummary summary = problem.run([&](const StepRecord &record) {
        if (is_first && record.time > 0.)
          std::cout << std::fixed << "  " << std::setprecision(2) << record.time
                    << "   " << std::setprecision(6)
                    << record.loads.at(0).displacement[0] << "      "
                    << record.n_iterations << '\n';
      });

      if (is_first)
        std::cout << summary.n_iterations << " iterations, "
                  << summary.n_rejected_steps << " steps rejected\n";
    }
  catch (const std::exception &exception)
    {
      std::cerr << exception.what() << '\n';
      return 1;
    }
  return 0;
}
