// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_assembly_tangent_directions_h
#define setae_assembly_tangent_directions_h

#include <deal.II/base/types.h>

#include <setae/base/expression.h>
#include <setae/fibers/fiber_system.h>

#include <memory>
#include <string>
#include <vector>

namespace Setae
{
  /**
   * Nodes whose tangent has a prescribed direction and any length. One
   * component of the tangent, the largest one of the direction, leads; the
   * others follow it in proportion.
   */
  class TangentDirections
  {
  public:
    /** One node, as a support asks for it. */
    struct Node
    {
      std::array<dealii::types::global_dof_index, 3> dofs;    ///< or invalid
      Tensor<1, 3>                                   initial; ///< tangent

      /** A vector as a function of time; none for the initial direction. */
      std::shared_ptr<const VectorExpression> direction;

      std::string parameter, text; ///< for messages
    };

    /**
     * A component that follows another one: their changes from the initial
     * tangent are in the relation @f$q = \mathrm{ratio}\cdot q_\mathrm{leader}
     * + \mathrm{offset}@f$. Where the length is fixed by a coordinate that is
     * switched off, there is no leader and the ratio is zero.
     */
    struct Follower
    {
      dealii::types::global_dof_index dof, leader;
      double                          ratio  = 0.;
      double                          offset = 0.;
    };

    /**
     * @throws ExcParameter if the direction at time 0 is none or is out of the
     * plane of the active coordinates.
     */
    void
    add(const Node &node);

    /**
     * Turn the directions to where they are at @p time.
     *
     * @return Whether other components lead than before.
     * @throws ExcParameter as add().
     */
    bool
    move_to(const double time);

    /** Whether any of the directions is a function of time. */
    bool
    turn() const
    {
      return any_turns;
    }

    /** All of them, on every rank. */
    const std::vector<Follower> &
    followers() const
    {
      return all_followers;
    }

    /**
     * Whether every tangent points along its direction and not against it.
     *
     * @param solution The unknowns, known on every rank.
     */
    bool
    point_forward(const dealii::TrilinosWrappers::MPI::Vector &solution) const;

  private:
    struct DirectedNode : Node
    {
      Tensor<1, 3> now; ///< the direction, of length 1
      unsigned int leading_component = 0;
    };

    /** The followers of a node, appended. */
    void
    follow(const DirectedNode &node);

    /** The direction of a node at @p time, checked. */
    static Tensor<1, 3>
    direction(const Node &node, const double time);

    std::vector<DirectedNode> nodes;
    std::vector<Follower>     all_followers;
    bool                      any_turns = false;
  };
} // namespace Setae

#endif
