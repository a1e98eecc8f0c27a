// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_base_shared_exit_h
#define setae_base_shared_exit_h

#include <deal.II/base/exceptions.h>
#include <deal.II/base/mpi.h>

#include <string>

namespace Setae
{
  /**
   * A rank that ends only because another one has reported that it cannot go
   * on: the other one says why.
   */
  DeclExceptionMsg(ExcOtherRank, "Another rank cannot go on.");

  /**
   * The end of a program on several ranks. Most errors reach all ranks, which
   * then meet here, and one of them tells. An error of one rank alone leaves
   * the others in a collective call that never returns: the rank waits for them
   * some seconds, tells, and ends all of them.
   */
  class SharedExit
  {
  public:
    /** Collective. */
    explicit SharedExit(const MPI_Comm communicator);

    ~SharedExit();

    SharedExit(const SharedExit &) = delete;
    SharedExit &
    operator=(const SharedExit &) = delete;

    /** The exit status of a rank that has done its part. */
    int
    success();

    /**
     * The exit status of a rank with an error, described by @p line, which is
     * printed by the first of all ranks with an error; without a @p line, the
     * error is that of another rank.
     */
    int
    failure(const std::string &line);

  private:
    /**
     * Find the smallest of the numbers of all ranks.
     *
     * @return Whether all ranks have come within @p patience [s].
     */
    bool
    smallest(const int number, const double patience, int &result);

    MPI_Comm communicator;
    int      rank, n_ranks;
  };
} // namespace Setae

#endif
