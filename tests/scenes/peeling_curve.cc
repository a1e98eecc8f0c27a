// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

// The beginning of the peeling curve, through the force peak, digit by digit
// and the same on any number of ranks.

#include <deal.II/base/conditional_ostream.h>
#include <deal.II/base/mpi.h>

#include <setae/fiber_problem.h>

#include <fstream>
#include <iomanip>
#include <iostream>
#include <sstream>

using namespace Setae;

int
main(int argc, char *argv[])
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const dealii::ConditionalOStream pcout(
    std::cout, dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0);

  const std::string  scene = SETAE_SCENES "/peeling.prm";
  std::ostringstream text, screen;
  text << std::ifstream(scene).rdbuf();
  FiberProblem problem(Scene::read(text.str(),
                                   scene,
                                   {"load stepping/end time=4e-4"}),
                       MPI_COMM_WORLD,
                       screen);

  pcout << "opening/1e-4 force strain_energy/1e-6 interaction/1e-4 gap/1e-3\n"
        << std::setprecision(9);
  problem.run([&pcout](const StepRecord &step) {
    pcout << step.time / 1e-4 << ' ' << step.supports[1].reaction[0] << ' '
          << step.evaluation.energies[0] / 1e-6 << ' '
          << step.evaluation.energies[1] / 1e-4 << ' '
          << step.evaluation.gaps.smallest / 1e-3 << '\n';
  });
  return 0;
}
