// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <deal.II/base/mpi.h>

#include <gtest/gtest.h>

/**
 * GoogleTest's own main() does not initialize MPI, which the tests that touch
 * Trilinos need.
 */
int
main(int argc, char **argv)
{
  testing::InitGoogleTest(&argc, argv);
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  return RUN_ALL_TESTS();
}
