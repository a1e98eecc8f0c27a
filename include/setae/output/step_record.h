// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_output_step_record_h
#define setae_output_step_record_h

#include <setae/assembly/momenta.h>
#include <setae/assembly/supports.h>
#include <setae/solvers/nonlinear_system.h>

#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace Setae
{
  /** The displacement of a loaded point, for the statistics. */
  struct LoadReport
  {
    std::string  name;
    Tensor<1, 3> displacement; ///< [length]
  };



  /** What is known of a step of a motion beyond that of a load step. */
  struct MotionReport
  {
    Momenta momenta;

    /** What the supports have done on the fibers since time 0 [energy]. */
    double support_work = 0.;

    /**
     * What loads and interactions have done by their formulas of time since
     * time 0 [energy]. The energy of a dead force is among those of all terms:
     * that one works only as its formula changes.
     */
    double external_work = 0.;

    /** What the viscous damping has taken away since time 0 [energy]. */
    double dissipation = 0.;

    /**
     * What generalized-alpha with a spectral radius below one has taken from
     * the kinetic energy since time 0 [energy]; not known of IDA. In a single
     * step it may be negative, by an amount of third order.
     */
    double numerical_dissipation = 0.;

    /** The sum of the energies of all terms and of the kinetic one [energy]. */
    double total_energy = 0.;

    /**
     * The total energy, with what has been taken out and without what has come
     * in since time 0 [energy]: it stays what it is but for errors of the time
     * integration and for its numerical damping.
     */
    double
    balance() const
    {
      return total_energy + dissipation - support_work - external_work;
    }
  };



  /** One load or time step, as it goes to the screen and to the statistics. */
  struct StepRecord
  {
    unsigned int                step      = 0;
    double                      time      = 0.;
    double                      step_size = 0.;
    std::vector<SupportReport>  supports;
    std::vector<LoadReport>     loads;
    Evaluation                  evaluation;
    bool                        has_interactions      = false;
    unsigned int                n_iterations          = 0; ///< of this step
    unsigned int                n_iterations_rejected = 0; ///< before it
    unsigned int                n_rejected = 0;    ///< attempts before it
    bool                        is_snap   = false; ///< by the overdamped motion
    double                      wall_time = 0.;    ///< since the start [s]
    std::optional<MotionReport> motion;            ///< none in a static scene
  };



  /**
   * Called with each step once it is solved: what is known of it so far, and
   * the unknowns of this rank.
   */
  using StepVisitor =
    std::function<void(StepRecord                     record,
                       const SolverResult            &result,
                       const NonlinearSystem::Vector &solution)>;



  /** What a whole run took. */
  struct RunSummary
  {
    unsigned int n_steps               = 0;
    unsigned int n_iterations          = 0; ///< rejected ones included
    unsigned int n_rejected_steps      = 0;
    unsigned int n_rejected_iterations = 0;
    unsigned int n_snaps               = 0;
    double       smallest_gap = std::numeric_limits<double>::infinity();
    std::string  smallest_gap_place; ///< between which fibers, and when
    double       cpu_time  = 0.;     ///< of this rank [s]
    double       wall_time = 0.;     ///< [s]

    void
    add(const StepRecord &record);
  };
} // namespace Setae

#endif
