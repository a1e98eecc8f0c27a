// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_solvers_relaxation_h
#define setae_solvers_relaxation_h

#include <setae/solvers/newton.h>

namespace Setae
{
  /**
   * The overdamped motion to the next stable equilibrium, for loads at which
   * the branch followed so far has ended.
   *
   * Steps of the implicit Euler method for @f$D\dot X=-R(X)@f$, with D the
   * magnitude of the diagonal of the tangent matrix at the beginning, so that
   * time has no unit. Each step is solved by Newton's method to a loose
   * tolerance and has to lower the energy. The steps grow until they are
   * Newton's for the equilibrium itself; one that fails is repeated with a
   * smaller size.
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
    /** One step of the implicit Euler method. */
    struct Step
    {
      bool        succeeded = false;
      Evaluation  evaluation;
      double      increment_norm = 0.; ///< of its last iteration
      std::string reason;              ///< of a failure, in words
    };

    Step
    advance(NonlinearSystem &system,
            Vector          &current,
            const Vector    &coefficients,
            const double     time,
            const double     upper_bound,
            SolverResult    &result) const;

    NewtonParameters parameters;
    Newton::Log      log;
  };
} // namespace Setae

#endif
