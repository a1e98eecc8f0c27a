// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_solvers_newton_h
#define setae_solvers_newton_h

#include <setae/scene.h>
#include <setae/solvers/nonlinear_system.h>

#include <functional>

namespace Setae
{
  /** One line of the log of the iterations. */
  struct IterationReport
  {
    unsigned int iteration;
    double       residual_norm;
    double       increment_norm;
    double       factor; ///< of the increment, below 1 after backtracking
    double       smallest_gap;
  };



  /**
   * Newton's method for the equilibrium at a given time.
   *
   * The first increment starts from the equilibrium of the last load step and
   * takes the supports to their new places: it is the tangent predictor. All
   * further ones are corrections with the supports at rest. A correction is
   * halved until the norm of the residual decreases and every gap remains
   * valid, and can be bounded in the displacement of the nodes. A state is
   * accepted if residual and last increment are below their tolerances and no
   * gap is below the regularization of its law.
   */
  class Newton
  {
  public:
    using Vector = NonlinearSystem::Vector;
    using Log    = std::function<void(const IterationReport &)>;

    Newton(const NewtonParameters &parameters, const Log &log);

    /**
     * Find the equilibrium at @p time, starting from @p solution, which is left
     * unchanged if that fails. If the @p supports are at rest, the first
     * increment is a correction as the further ones.
     */
    SolverResult
    solve(
      NonlinearSystem       &system,
      Vector                &solution,
      const double           time,
      const SupportIncrement supports = SupportIncrement::to_prescribed) const;

  private:
    NewtonParameters parameters;
    Log              log;
  };
} // namespace Setae

#endif
