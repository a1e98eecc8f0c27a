// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <setae/base/shared_exit.h>

#include <chrono>
#include <iostream>
#include <limits>
#include <thread>

namespace Setae
{
  namespace
  {
    // Ranks with the same error come within milliseconds of each other; more
    // than this they are apart only on a machine that is overloaded many times.
    constexpr double patience_with_others = 3.; // [s]

    void
    print(const std::string &line)
    {
      std::cerr << "setae: " + line + "\n" << std::flush;
    }
  } // namespace



  SharedExit::SharedExit(const MPI_Comm communicator)
    : communicator(dealii::Utilities::MPI::duplicate_communicator(communicator))
    , rank(dealii::Utilities::MPI::this_mpi_process(communicator))
    , n_ranks(dealii::Utilities::MPI::n_mpi_processes(communicator))
  {}



  SharedExit::~SharedExit()
  {
    dealii::Utilities::MPI::free_communicator(communicator);
  }



  bool
  SharedExit::smallest(const int number, const double patience, int &result)
  {
    MPI_Request request;
    MPI_Iallreduce(
      &number, &result, 1, MPI_INT, MPI_MIN, communicator, &request);
    const auto begin = std::chrono::steady_clock::now();
    for (;;)
      {
        int is_complete = 0;
        MPI_Test(&request, &is_complete, MPI_STATUS_IGNORE);
        if (is_complete)
          return true;
        if (std::chrono::duration<double>(std::chrono::steady_clock::now() -
                                          begin)
              .count() > patience)
          return false;
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
      }
  }



  int
  SharedExit::success()
  {
    int first_failed;
    smallest(n_ranks + 1,
             std::numeric_limits<double>::infinity(),
             first_failed);
    return first_failed == n_ranks + 1 ? 0 : 1;
  }



  int
  SharedExit::failure(const std::string &line)
  {
    int first_failed;
    if (!smallest(line.empty() ? n_ranks : rank,
                  patience_with_others,
                  first_failed))
      {
        print(line.empty() ? "A rank does not answer." : line);
        MPI_Abort(communicator, 1);
      }
    if (first_failed == rank)
      print(line);
    return 1;
  }
} // namespace Setae
