// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

// What supports make of increments, forces and motions.

#include <setae/assembly/supports.h>
#include <setae/base/differentiate.h>
#include <setae/base/exceptions.h>

#include <cmath>
#include <sstream>

namespace Setae
{
  using namespace dealii;

  void
  Supports::make_constraints()
  {
    homogeneous.clear();
    for (const auto &[dof, entry] : prescribed)
      homogeneous.add_line(dof);
    for (const TangentDirections::Follower &follower : directions.followers())
      {
        homogeneous.add_line(follower.dof);
        if (follower.ratio != 0.)
          homogeneous.add_entry(follower.dof, follower.leader, follower.ratio);
      }
    homogeneous.close();
  }



  bool
  Supports::move_to(const double time)
  {
    const bool new_pattern = directions.move_to(time);
    if (directions.turn())
      make_constraints();
    return new_pattern;
  }



  void
  Supports::check_tangents(const double time) const
  {
    // What formulas with numbers of a few digits and numerical derivatives of
    // the centerline leave.
    constexpr double round_off = 1e-6;

    std::map<const Expression *, double> values;
    for (const PrescribedTangent &tangent : prescribed_tangents)
      {
        double square  = 0.;
        bool   is_free = false;
        for (unsigned int c = 0; c < 3; ++c)
          if (tangent.is_free[c])
            is_free = true;
          else
            {
              double                  component = tangent.initial[c];
              const Expression *const change    = tangent.changes[c];
              if (change != nullptr)
                {
                  if (values.count(change) == 0)
                    values[change] = (*change)(time);
                  component += values[change];
                }
              square += component * component;
            }
        const double length = std::sqrt(square);
        if (length <= 1. + round_off && (is_free || length >= 1. - round_off))
          continue;
        const SupportParameters &support =
          fibers.scene.supports[tangent.support];
        std::ostringstream allowed;
        allowed << "such that the tangent keeps the length 1, but "
                << (is_free ? "the components that are given have" : "it has")
                << " the length " << length << " at t = " << time
                << "; 'tangent direction' leaves the stretch free";
        AssertThrow(false,
                    ExcParameter("supports/" + support.name + "/tangent",
                                 support.tangent,
                                 allowed.str()));
      }
  }



  AffineConstraints<double>
  Supports::increment_to(const double                         time,
                         const TrilinosWrappers::MPI::Vector &solution) const
  {
    check_tangents(time);
    AffineConstraints<double> constraints;
    for (const auto &[dof, entry] : prescribed)
      {
        constraints.add_line(dof);
        constraints.set_inhomogeneity(dof, (*entry.value)(time)-solution(dof));
      }
    for (const TangentDirections::Follower &follower : directions.followers())
      {
        constraints.add_line(follower.dof);
        double target = follower.offset;
        if (follower.ratio != 0.)
          {
            constraints.add_entry(follower.dof,
                                  follower.leader,
                                  follower.ratio);
            target += follower.ratio * solution(follower.leader);
          }
        constraints.set_inhomogeneity(follower.dof,
                                      target - solution(follower.dof));
      }
    constraints.close();
    return constraints;
  }



  void
  Supports::project_force(TrilinosWrappers::MPI::Vector &force) const
  {
    for (const TangentDirections::Follower &follower : directions.followers())
      if (follower.ratio != 0. && fibers.owned_dofs.is_element(follower.dof))
        force(follower.leader) =
          force(follower.leader) + follower.ratio * force(follower.dof);
    homogeneous.set_zero(force);
  }



  void
  Supports::project_diagonal(TrilinosWrappers::MPI::Vector &diagonal) const
  {
    if (directions.followers().empty())
      return;
    for (const TangentDirections::Follower &follower : directions.followers())
      if (follower.ratio != 0. && fibers.owned_dofs.is_element(follower.dof))
        diagonal(follower.leader) =
          diagonal(follower.leader) +
          follower.ratio * follower.ratio * diagonal(follower.dof);
    diagonal.compress(VectorOperation::insert);
  }



  void
  Supports::project_motion(TrilinosWrappers::MPI::Vector &motion) const
  {
    homogeneous.set_zero(motion);
    follow(motion);
  }



  void
  Supports::follow(TrilinosWrappers::MPI::Vector &motion) const
  {
    if (directions.followers().empty())
      return;
    for (const TangentDirections::Follower &follower : directions.followers())
      if (fibers.owned_dofs.is_element(follower.dof))
        motion(follower.dof) =
          follower.ratio == 0. ? 0. : follower.ratio * motion(follower.leader);
    motion.compress(VectorOperation::insert);
  }



  std::map<types::global_dof_index, std::array<double, 3>>
  Supports::motion_at(const double time, const double spacing) const
  {
    check_tangents(time);

    // Many degrees of freedom share a formula.
    std::map<const Expression *, std::array<double, 3>>      motions;
    std::map<types::global_dof_index, std::array<double, 3>> result;
    for (const auto &[dof, entry] : prescribed)
      {
        const Expression &value = *entry.value;
        if (motions.count(&value) == 0)
          motions[&value] = differentiate(value, time, spacing, 0.);
        result[dof] = motions[&value];
      }
    return result;
  }
} // namespace Setae
