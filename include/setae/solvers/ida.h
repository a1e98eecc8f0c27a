// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_solvers_ida_h
#define setae_solvers_ida_h

#include <setae/scene.h>
#include <setae/solvers/work_between.h>

#include <functional>

namespace Setae
{
  /**
   * Integration by IDA of SUNDIALS (backward differentiation formulas of
   * variable order and step), through deal.II's wrapper.
   *
   * The unknowns are displacements X and velocities V with
   * @f[ \dot X - V = 0,\qquad M\dot V + cMV + R(X,t) = 0. @f]
   * Prescribed entries are algebraic equations, X and V equal to the motion of
   * the support; everywhere else, R and M see that motion instead of them, with
   * its acceleration. So they have an index of one, and the linear systems
   * reduce to ones with the matrix @f$R' + \alpha(\alpha+c)M@f$ for the free
   * displacements, where @f$\alpha@f$ is IDA's factor of @f$\dot X@f$.
   *
   * States with a gap that is not admissible are refused inside the right-hand
   * side: IDA then takes a shorter step.
   *
   * The error is controlled in the mean over all unknowns: of displacements by
   * the tolerance, of velocities by the tolerance over the time between two
   * reports.
   */
  class Ida
  {
  public:
    /**
     * Called at the end of each interval, and after each 500 steps of IDA
     * within one, with the work on the way there and the linear systems solved
     * since the last call.
     */
    using Visit = std::function<void(const double       time,
                                     const Motion      &motion,
                                     const WorkMeter   &meter,
                                     const unsigned int n_solved)>;

    /**
     * @throws ExcParameter if deal.II was configured without SUNDIALS.
     */
    explicit Ida(const DynamicsParameters &parameters);

    /**
     * Integrate from the @p initial motion at time 0 to the end time.
     *
     * @throws ExcRun if IDA fails, after the visits of all intervals before.
     */
    void
    run(DynamicSystem &system, const Motion &initial, const Visit &visit) const;

  private:
    DynamicsParameters parameters;
  };
} // namespace Setae

#endif
