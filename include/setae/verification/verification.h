// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_verification_verification_h
#define setae_verification_verification_h

#include <setae/fibers/fiber_system.h>
#include <setae/verification/full_quadrature.h>

#include <ostream>
#include <string>
#include <vector>

namespace Setae
{
  /** A law of the scene beside the full quadrature, for one pair of fibers. */
  struct Verification
  {
    std::string    interaction, law, fibers;
    FullQuadrature full;

    /** As it is in the scene, and with a cutoff beyond all fibers. */
    Resultant with_cutoff, without_cutoff;

    /** CPU time of the law for one pair, on the average [s]. */
    double cpu_time, cpu_time_without_cutoff;
  };



  /**
   * Compare each interaction of the scene with the full quadrature over the
   * solid bodies, for all pairs of fibers that interact in @p state. Collective.
   *
   * The full quadrature has no cutoff. So the law is evaluated twice, with and
   * without, and what the law and what its cutoff neglect can be told apart.
   */
  std::vector<Verification>
  verify(const FiberSystem &fibers, const State &state);



  /** Energies, resultant forces, errors and run times as a table. */
  void
  print(const std::vector<Verification> &verifications, std::ostream &out);
} // namespace Setae

#endif
