// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <setae/base/exceptions.h>
#include <setae/fiber_equations.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace Setae
{
  using namespace dealii;

  namespace
  {
    /**
     * The stiffness of a free motion over the axial one of the cells: a hundred
     * times round-off. Bending a fiber of slenderness 1e5 in a hundred cells is
     * forty times as stiff.
     */
    constexpr double free_stiffness =
      100. * std::numeric_limits<double>::epsilon();

    /** Irregular forces meet with more, as only a part of them is on a motion
     * that is free. */
    constexpr double screening = 1e6 * free_stiffness;
  } // namespace



  /** What the axial stiffness of the cells answers a motion with [force]. */
  double
  FiberEquations::axial_force(const Vector &motion) const
  {
    double sum = 0.;
    for (unsigned int i = 0; i < units.size(); ++i)
      {
        const double force = axial_stiffness[i] * motion.begin()[i] * units[i];
        sum += force * force;
      }
    return std::sqrt(Utilities::MPI::sum(sum, communicator));
  }



  /**
   * Inverse iterations for the motion that meets with the least stiffness, with
   * the supports at rest.
   *
   * @return The force on it over that of the axial stiffness.
   */
  double
  FiberEquations::soften(Vector &motion)
  {
    constexpr unsigned int n_iterations = 2;
    double                 stiffness    = 1.;
    for (unsigned int i = 0; i < n_iterations; ++i)
      {
        // On every unknown a force as large as its displacement.
        const double norm = increment_norm(motion);
        Vector       force(motion);
        for (unsigned int k = 0; k < units.size(); ++k)
          force.begin()[k] *= units[k] * units[k] / norm;
        solver.solve(force, motion);
        supports.project_motion(motion);
        stiffness = force_norm(force) / axial_force(motion);
      }
    return stiffness;
  }



  /** Forces on all unknowns, without any symmetry of a scene. */
  FiberEquations::Vector
  FiberEquations::irregular_forces() const
  {
    Vector       result(fibers.owned_dofs, communicator);
    unsigned int k = 0;
    for (const auto dof : fibers.owned_dofs)
      {
        result.begin()[k] = units[k] * std::cos(1. + 1.7 * dof * dof);
        ++k;
      }
    supports.project_force(result);
    return result;
  }



  void
  FiberEquations::check_free_fibers()
  {
    constexpr double round_off = std::numeric_limits<double>::epsilon();
    const Vector     force     = irregular_forces();
    if (force_norm(force) == 0.)
      return; // nothing can move
    if (!solver.factorize(system.tangent_matrix))
      {
        // A pivot is exactly zero: a stiffness below round-off replaces it.
        auto &matrix = system.tangent_matrix;
        for (const auto i : fibers.owned_dofs)
          matrix.set(i,
                     i,
                     matrix.diag_element(i) +
                       round_off * std::abs(matrix.diag_element(i)));
        matrix.compress(VectorOperation::insert);
        if (!solver.factorize(matrix))
          return;
      }
    Vector motion(force);
    if (!solver.solve(force, motion))
      return;
    supports.project_motion(motion);
    if (force_norm(force) < screening * axial_force(motion) &&
        soften(motion) < free_stiffness)
      refuse_free_fiber(motion);
  }



  /** @throws ExcRun with the fiber that moves most. */
  void
  FiberEquations::refuse_free_fiber(const Vector &motion) const
  {
    everywhere                   = motion;
    double             largest   = 0.;
    unsigned int       of_fiber  = 0;
    bool               is_turned = false;
    const Tensor<1, 3> zero;
    const auto         position = [&](const unsigned int cell,
                              const unsigned int shape) {
      Tensor<1, 3> result = zero;
      for (unsigned int c = 0; c < 3; ++c)
        {
          const auto dof = fibers.cell_dofs[cell][3 * shape + c];
          if (dof != numbers::invalid_dof_index)
            result[c] = everywhere(dof);
        }
      return result;
    };
    for (unsigned int f = 0; f < fibers.fibers.size(); ++f)
      {
        const Fiber       &fiber = fibers.fibers[f];
        const Tensor<1, 3> start = position(fiber.first_cell, 0);
        double             most = start.norm(), change = 0.;
        for (unsigned int i = 0; i < fiber.n_cells; ++i)
          {
            const Tensor<1, 3> x = position(fiber.first_cell + i, 2);
            most                 = std::max(most, x.norm());
            change               = std::max(change, (x - start).norm());
          }
        if (most > largest)
          {
            largest   = most;
            of_fiber  = f;
            is_turned = change > .1 * most;
          }
      }
    std::ostringstream text;
    text << "The fiber '" << fibers.fibers[of_fiber].name << "' can "
         << (is_turned ? "rotate" : "move") << " freely at time "
         << evaluated_time
         << ": no force brings it back, so it has no equilibrium of its own; "
            "hold it by a support ('supports/names') or keep an interaction "
            "within reach."
         << (evaluated_time > 0. ? " The states before are on disk." : "");
    AssertThrow(false, ExcRun(text.str()));
  }
} // namespace Setae
