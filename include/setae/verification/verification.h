// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_verification_verification_h
#define setae_verification_verification_h

#include <setae/fibers/fiber_system.h>

#include <ostream>

namespace Setae
{
  /**
   * Compare each interaction of the scene with the full quadrature over the
   * solid bodies, for all pairs of fibers that interact in @p state, and print
   * energies, resultant forces, errors and run times. Collective; only rank 0
   * prints.
   *
   * The full quadrature has no cutoff. So the law is evaluated twice, as it is
   * and with a cutoff beyond all fibers: what the law and what its cutoff
   * neglect can be told apart.
   */
  void
  verify(const FiberSystem &fibers, const State &state, std::ostream &out);
} // namespace Setae

#endif
