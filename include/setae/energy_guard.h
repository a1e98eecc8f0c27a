// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_energy_guard_h
#define setae_energy_guard_h

#include <setae/output/step_record.h>

#include <string>
#include <vector>

namespace Setae
{
  struct DynamicsParameters;

  /**
   * Watches that the integration of a motion creates no energy. What a step has
   * created is the change of kinetic and potential energy, with what damping
   * and numerical damping took and without the work from outside. Numerical
   * damping may not pay for it; but if it has given energy so far instead of
   * taking some, that was created, too, unless it was in a first step in which
   * supports move: they accelerate fibers at once. Twenty times as much may be
   * lost, where contacts begin and end, but not by steps that conserve the
   * energy.
   *
   * The bound is a part of the largest energy so far: the sum of the kinetic
   * energy, of what damping took, and of what the energy of each term has
   * changed by since time 0. A constant in a potential does not count. IDA,
   * which cannot repeat a step, may also create a part of the total energy: at
   * the beginning of a motion little has changed yet, less than its tolerance
   * makes.
   */
  class EnergyGuard
  {
  public:
    /**
     * @param dynamics The bound, and whether steps conserve the energy: then
     * they may not lose more than they may create.
     * @param has_potential Without one there is no energy to watch.
     */
    EnergyGuard(const DynamicsParameters &dynamics, const bool has_potential);

    /** From this state on. */
    void
    start(const MotionReport &motion, const Evaluation &evaluation);

    /**
     * What a step to a state creates or loses, as a part of what it may: half
     * of what is left.
     *
     * @param path The sum of the magnitudes of all increments of the step: with
     * the round-off of the forces, it gives the one of their work.
     */
    double
    measure(const MotionReport &motion,
            const Evaluation   &evaluation,
            const double        path) const;

    /** Whether more has been created than is allowed in the whole run. */
    bool
    is_exceeded(const MotionReport &motion, const Evaluation &evaluation) const;

    /** Go on from a state. */
    void
    accept(const MotionReport &motion, const Evaluation &evaluation);

    /** What is wrong with a state, with all numbers. */
    std::string
    reason(const MotionReport &motion, const Evaluation &evaluation) const;

  private:
    /** What a step creates and loses, as parts of what it may. */
    struct Parts
    {
      double gain, loss;
    };

    Parts
    parts(const MotionReport &motion,
          const Evaluation   &evaluation,
          const double        path) const;

    /** What has been created from the start to a state [energy]. */
    double
    created(const MotionReport &motion) const;

    /**
     * What numerical damping has taken in a first step, if supports move in it.
     */
    static double
    moved_by_supports(const MotionReport &motion);

    /** What was created, with what numerical damping has given. */
    double
    gain(const MotionReport &motion) const;

    /** The largest energy, this state included. */
    double
    largest_energy(const MotionReport &motion,
                   const Evaluation   &evaluation) const;

    /** What is below the round-off of energies that are this large. */
    static double
    round_off(const MotionReport &motion, const Evaluation &evaluation);

    const double        bound;
    const double        loss_factor; ///< what may be lost over what may come in
    const bool          can_repeat;
    double              first_balance = 0., largest = 0.;
    double              last_gain = 0., last_loss = 0.;
    double              least_dissipation = 0.;
    bool                is_first          = true; ///< no step is accepted yet
    std::vector<double> first_energies;
  };
} // namespace Setae

#endif
