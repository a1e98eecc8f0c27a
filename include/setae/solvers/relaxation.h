// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_solvers_relaxation_h
#define setae_solvers_relaxation_h

#include <setae/solvers/newton.h>

namespace Setae
{
  /**
   * The overdamped motion to the next stable equilibrium, for loads at which the
   * branch followed so far has ended.
   *
   * Steps of the linearly implicit Euler method for @f$D\dot X=-R(X)@f$, with D
   * the magnitude of the diagonal of the tangent matrix: every step must lower
   * the energy, else it is repeated with more damping; success reduces the
   * damping, so that near the new equilibrium the steps become Newton's.
   */
  class Relaxation
  {
  public:
    using Vector = NonlinearSystem::Vector;

    Relaxation(const NewtonParameters &parameters, const Newton::Log &log);

    /**
     * Follow the motion at @p time from @p solution, which is left unchanged if
     * no equilibrium is found.
     */
    SolverResult
    solve(NonlinearSystem &system, Vector &solution, const double time) const;

  private:
    NewtonParameters parameters;
    Newton::Log      log;
  };
} // namespace Setae

#endif
