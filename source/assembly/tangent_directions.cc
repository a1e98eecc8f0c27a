// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <setae/assembly/tangent_directions.h>
#include <setae/base/exceptions.h>

#include <cmath>
#include <sstream>

namespace Setae
{
  using namespace dealii;

  namespace
  {
    unsigned int
    largest_component(const Tensor<1, 3> &vector)
    {
      unsigned int largest = 0;
      for (unsigned int c = 1; c < 3; ++c)
        if (std::abs(vector[c]) > std::abs(vector[largest]))
          largest = c;
      return largest;
    }
  } // namespace



  void
  TangentDirections::add(const Node &node)
  {
    DirectedNode result{node, direction(node, 0.), 0};
    result.leading_component = largest_component(result.now);
    nodes.push_back(result);
    any_turns = any_turns || node.direction != nullptr;
    follow(result);
  }



  bool
  TangentDirections::move_to(const double time)
  {
    if (!any_turns)
      return false;

    // A component that is large enough goes on to lead: each change costs a new
    // pattern of the matrix.
    constexpr double large_enough = .5;

    bool changed = false;
    all_followers.clear();
    for (DirectedNode &node : nodes)
      {
        node.now = direction(node, time);
        if (std::abs(node.now[node.leading_component]) < large_enough)
          {
            node.leading_component = largest_component(node.now);
            changed                = true;
          }
        follow(node);
      }
    return changed;
  }



  bool
  TangentDirections::point_forward(
    const TrilinosWrappers::MPI::Vector &solution) const
  {
    for (const DirectedNode &node : nodes)
      {
        Tensor<1, 3> tangent = node.initial;
        for (unsigned int c = 0; c < 3; ++c)
          if (node.dofs[c] != numbers::invalid_dof_index)
            tangent[c] += solution(node.dofs[c]);
        if (!(tangent * node.now > 0.))
          return false;
      }
    return true;
  }



  Tensor<1, 3>
  TangentDirections::direction(const Node &node, const double time)
  {
    if (node.direction == nullptr)
      return node.initial / node.initial.norm();
    const Tensor<1, 3> vector = (*node.direction)(time);
    const double       length = vector.norm();

    // A coordinate that is switched off does not move.
    constexpr double round_off = 1e-10;
    bool             in_plane  = true;
    for (unsigned int c = 0; c < 3; ++c)
      in_plane = in_plane && (node.dofs[c] != numbers::invalid_dof_index ||
                              (std::abs(vector[c]) <= round_off * length &&
                               std::abs(node.initial[c]) <= round_off));
    std::ostringstream at;
    at << ", but not at t = " << time;
    AssertThrow(length > 0.,
                ExcParameter(node.parameter,
                             node.text,
                             "a vector with a direction at every time" +
                               at.str()));
    AssertThrow(in_plane,
                ExcParameter(node.parameter,
                             node.text,
                             "a vector in the plane of the active coordinates, "
                             "like the fiber itself" +
                               at.str()));
    return vector / length;
  }



  void
  TangentDirections::follow(const DirectedNode &node)
  {
    // The initial direction may leave the active coordinates: then the part
    // that stays fixes the length of the tangent.
    constexpr double round_off = 1e-10;
    bool             is_fixed  = false;
    for (unsigned int c = 0; c < 3; ++c)
      is_fixed = is_fixed || (node.dofs[c] == numbers::invalid_dof_index &&
                              std::abs(node.now[c]) > round_off);

    const unsigned int leading = node.leading_component;
    for (unsigned int c = 0; c < 3; ++c)
      if (node.dofs[c] != numbers::invalid_dof_index &&
          (c != leading || is_fixed))
        {
          Follower follower{node.dofs[c], numbers::invalid_dof_index};
          if (!is_fixed)
            {
              follower.leader = node.dofs[leading];
              follower.ratio  = node.now[c] / node.now[leading];
              if (node.direction != nullptr)
                follower.offset =
                  follower.ratio * node.initial[leading] - node.initial[c];
            }
          all_followers.push_back(follower);
        }
  }
} // namespace Setae
