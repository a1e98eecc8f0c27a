// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

// The full quadrature over two bent fibers is the same on any number of ranks,
// and the same as that of one rank alone.

#include <deal.II/base/conditional_ostream.h>
#include <deal.II/base/mpi.h>

#include <iomanip>
#include <iostream>

#include "../verification/solids.h"

using namespace Setae;

namespace
{
  FullQuadrature
  integrate(const MPI_Comm communicator)
  {
    const auto line_1 = arc(8., 1., 4);
    const auto line_2 = straight_line(Tensor<1, 3>({8., 3., 2.4}),
                                      Tensor<1, 3>({.6, .8, 0.}),
                                      10.);
    SolidBody  first(FiberChart(line_1, line_1, 1.),
                    Distribution::volume,
                    communicator);
    SolidBody  second(FiberChart(line_2, line_2, 1.),
                     Distribution::volume,
                     communicator);
    return full_quadrature(first,
                           second,
                           PointLaw({{6, -1.}, {12, 1e-2}}),
                           FullQuadratureParameters());
  }
} // namespace

int
main(int argc, char *argv[])
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const dealii::ConditionalOStream pcout(
    std::cout, dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0);

  const FullQuadrature all = integrate(MPI_COMM_WORLD);
  const FullQuadrature one = integrate(MPI_COMM_SELF);

  const SolidResultant &result = all.value;
  pcout << std::setprecision(9) << "gauss points " << all.n_points << "\ncells "
        << all.n_cells << "\npairs " << all.n_pairs << "\nenergy "
        << result.energy << "\nforce " << result.force << "\nmoment "
        << result.moment << '\n';

  const double scale = 1e-10 * result.force.norm();
  const bool   agree = std::abs(result.energy - one.value.energy) < scale &&
                     (result.force - one.value.force).norm() < scale &&
                     (result.moment - one.value.moment).norm() < 10. * scale;
  pcout << "one rank alone " << (agree ? "agrees" : "differs") << std::endl;
  return 0;
}
