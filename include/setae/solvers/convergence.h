// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_solvers_convergence_h
#define setae_solvers_convergence_h

#include <setae/scene.h>
#include <setae/solvers/nonlinear_system.h>

#include <limits>
#include <string>

namespace Setae
{
  /**
   * Whether an iteration has found an equilibrium: residual and last increment
   * are below their tolerances. These are relative to the forces and to the
   * length scale of the scene, unless it states absolute ones, so that a scene
   * takes the same iterations in every system of units.
   *
   * Round-off leaves a residual that depends on the stiffness and the size of
   * the fibers (Evaluation::round_off), and an increment that is this residual
   * over the stiffness of the softest motion. A residual below the former
   * counts as zero. The latter shows by increments that do not decrease any
   * more while the residual is at its round-off; they are accepted up to a ten
   * thousandth of the length scale, so that no state passes as an equilibrium
   * that round-off moves farther.
   */
  class Convergence
  {
  public:
    Convergence(const NewtonParameters &parameters,
                const NonlinearSystem  &system);

    /** The largest residual of an equilibrium [force]. */
    double
    residual_tolerance(const Evaluation &evaluation) const;

    bool
    has_small_residual(const Evaluation &evaluation) const
    {
      return evaluation.residual_norm <= residual_tolerance(evaluation);
    }

    /**
     * Whether the state after an increment is an equilibrium. To be asked after
     * each one.
     *
     * @param increment_norm NonlinearSystem::increment_norm() [length]
     * @param is_cut Whether the increment has been shortened.
     */
    bool
    is_reached(const Evaluation &evaluation,
               const double      increment_norm,
               const bool        is_cut);

    /** Residual and last increment beside what is allowed, in words. */
    std::string
    distance(const Evaluation &evaluation) const;

  private:
    const NewtonParameters parameters;
    const double           length_scale;
    const double           increment_tolerance; ///< [length]
    double last_increment = std::numeric_limits<double>::infinity();
  };
} // namespace Setae

#endif
