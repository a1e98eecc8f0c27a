// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <setae/assembly/supports.h>
#include <setae/base/exceptions.h>

#include <algorithm>
#include <sstream>

namespace Setae
{
  using namespace dealii;

  namespace
  {
    /** The nodes of a fiber that a place of a support means. */
    std::vector<unsigned int>
    nodes_at(const Fiber       &fiber,
             const std::string &place,
             const std::string &parameter,
             const Constants   &constants)
    {
      const unsigned int n_nodes = fiber.n_cells + (fiber.closed ? 0 : 1);
      std::vector<unsigned int> nodes;
      if (place == "all")
        for (unsigned int i = 0; i < n_nodes; ++i)
          nodes.push_back(i);
      else if (place == "start")
        nodes.push_back(0);
      else if (place == "end")
        nodes.push_back(fiber.n_cells % n_nodes); // of a ring, its start
      else
        {
          const auto  &s     = fiber.arc_length;
          const double value = Expression(parameter,
                                          place,
                                          "",
                                          with_copy(constants, fiber.copy))();
          const auto   nearest =
            std::min_element(s.begin(),
                             s.begin() + n_nodes,
                             [value](double a, double b) {
                               return std::abs(a - value) < std::abs(b - value);
                             });
          std::ostringstream place_of_node;
          place_of_node << *nearest;
          AssertThrow(std::abs(*nearest - value) < 1e-8 * s.back(),
                      ExcParameter(parameter,
                                   place,
                                   "an arc length where the fiber '" +
                                     fiber.name +
                                     "' has a node; the nearest one is at " +
                                     place_of_node.str()));
          nodes.push_back(nearest - s.begin());
        }
      return nodes;
    }
  } // namespace



  Supports::Supports(const FiberSystem &fibers)
    : fibers(fibers)
  {
    for (unsigned int i = 0; i < fibers.scene.supports.size(); ++i)
      add_support(i);
    check_directions();
    hold_rigid_fibers();
    if (!fibers.scene.dynamics.is_on())
      check_every_fiber();
    check_tangents(0.);
    make_constraints();
  }



  void
  Supports::add_support(const unsigned int index)
  {
    const SupportParameters &support = fibers.scene.supports[index];
    const std::string        path    = "supports/" + support.name + "/";
    const auto               parse   = [&](const std::string &entry,
                           const std::string &text,
                           const Constants   &copy) {
      const auto parts = Utilities::split_string_list(text, ';');
      AssertThrow(parts.size() == 3,
                  ExcParameter(path + entry,
                               text,
                               "three times 'free' or a formula, separated by "
                                               "';'"));
      const Constants constants = with_copy(fibers.scene.constants, copy);
      std::array<const Expression *, 3> result = {};
      for (unsigned int c = 0; c < 3; ++c)
        if (parts[c] != "free")
          {
            expressions.push_back(std::make_unique<Expression>(
              path + entry, parts[c], "t", constants));
            result[c]            = expressions.back().get();
            const double initial = (*result[c])(0.); // must be finite
            AssertThrow(
              initial == 0. || !fibers.scene.dynamics.is_on(),
              ExcParameter(path + entry,
                           text,
                           "zero at time 0 in a scene with dynamics, "
                                           "where a motion cannot begin with a jump"));
          }
      return result;
    };

    for (const unsigned int f :
         fibers.select(support.fibers, support.copies, path + "copies"))
      {
        const Fiber &fiber = fibers.fibers[f];
        const auto   displacement =
          parse("displacement", support.displacement, fiber.copy);
        const auto tangent   = parse("tangent", support.tangent, fiber.copy);
        const auto direction = parse_direction(index, fiber);
        for (const std::string &place : support.at)
          for (const unsigned int node :
               nodes_at(fiber, place, path + "at", fibers.scene.constants))
            {
              prescribe_node(index, f, node, false, displacement);
              prescribe_node(index, f, node, true, tangent);
              if (support.tangent_direction != "free")
                direct_node(index, f, node, direction);
            }
      }
  }



  void
  Supports::prescribe_node(const unsigned int                       support,
                           const unsigned int                       fiber,
                           const unsigned int                       node,
                           const bool                               tangent,
                           const std::array<const Expression *, 3> &values)
  {
    for (unsigned int c = 0; c < 3; ++c)
      {
        const auto dof = fibers.node_dof(fiber, node, tangent, c);
        if (values[c] == nullptr || dof == numbers::invalid_dof_index)
          continue;
        const bool is_new =
          prescribed.insert({dof, {support, tangent, c, values[c]}}).second;
        const auto &supports = fibers.scene.supports;
        AssertThrow(is_new || prescribed[dof].support == support,
                    ExcParameter("supports/" + supports[support].name + "/" +
                                   (tangent ? "tangent" : "displacement"),
                                 tangent ? supports[support].tangent :
                                           supports[support].displacement,
                                 "free where the support '" +
                                   supports[prescribed[dof].support].name +
                                   "' holds the same component"));
      }

    if (tangent && std::any_of(values.begin(), values.end(), [](const auto *v) {
          return v != nullptr;
        }))
      {
        PrescribedTangent &added = prescribed_tangents.emplace_back();
        added.support            = support;
        added.initial            = fibers.initial_tangent(fiber, node);
        added.changes            = values;
        for (unsigned int c = 0; c < 3; ++c)
          {
            const bool is_active = fibers.node_dof(fiber, node, true, c) !=
                                   numbers::invalid_dof_index;
            added.is_free[c] = is_active && values[c] == nullptr;
            if (!is_active)
              added.changes[c] = nullptr;
          }
      }
  }



  std::shared_ptr<const VectorExpression>
  Supports::parse_direction(const unsigned int index, const Fiber &fiber) const
  {
    const SupportParameters &support = fibers.scene.supports[index];
    const std::string       &text    = support.tangent_direction;
    const std::string        parameter =
      "supports/" + support.name + "/tangent direction";
    if (text == "free" || text == "initial")
      return nullptr;
    require(!fibers.scene.dynamics.is_on(),
            parameter,
            text,
            "'free' or 'initial' in a scene with dynamics");
    Constants constants = fibers.scene.constants;
    constants.insert(fiber.copy.begin(), fiber.copy.end());
    return std::make_shared<VectorExpression>(parameter, text, "t", constants);
  }



  void
  Supports::direct_node(
    const unsigned int                             support,
    const unsigned int                             fiber,
    const unsigned int                             node,
    const std::shared_ptr<const VectorExpression> &direction)
  {
    const SupportParameters &parameters = fibers.scene.supports[support];
    TangentDirections::Node  added;
    added.parameter = "supports/" + parameters.name + "/tangent direction";
    added.text      = parameters.tangent_direction;
    if (fibers.is_rigid(fibers.fibers[fiber].first_cell))
      {
        require(direction == nullptr,
                added.parameter,
                added.text,
                "'free' or 'initial' for the rigid fiber '" +
                  fibers.fibers[fiber].name + "'");
        return;
      }
    added.initial   = fibers.initial_tangent(fiber, node);
    added.direction = direction;
    bool is_new     = true;
    for (unsigned int c = 0; c < 3; ++c)
      {
        added.dofs[c] = fibers.node_dof(fiber, node, true, c);
        if (added.dofs[c] == numbers::invalid_dof_index)
          continue;
        is_new = directed.insert({added.dofs[c], support}).second && is_new;
        const unsigned int other = directed[added.dofs[c]];
        require(other == support,
                added.parameter,
                added.text,
                "'free' where the support '" +
                  fibers.scene.supports[other].name +
                  "' gives the direction of the same tangent");
      }
    if (is_new)
      directions.add(added);
  }



  void
  Supports::check_directions() const
  {
    const auto &supports = fibers.scene.supports;
    for (const auto &[dof, support] : directed)
      {
        const auto held = prescribed.find(dof);
        require(held == prescribed.end(),
                "supports/" + supports[support].name + "/tangent direction",
                supports[support].tangent_direction,
                held == prescribed.end() ?
                  "" :
                  "'free' where the support '" +
                    supports[held->second.support].name +
                    "' holds a component of the tangent");
      }
  }



  void
  Supports::hold_rigid_fibers()
  {
    expressions.push_back(
      std::make_unique<Expression>("supports", "0", "t", Constants()));
    const Expression *const zero = expressions.back().get();
    for (unsigned int cell = 0; cell < fibers.initial.size(); ++cell)
      if (fibers.is_rigid(cell))
        for (const auto dof : fibers.cell_dofs[cell])
          if (dof != numbers::invalid_dof_index)
            prescribed.insert({dof, {at_rest_in_rigid_fiber, false, 0, zero}});
  }



  void
  Supports::check_every_fiber() const
  {
    std::string names;
    for (const SupportParameters &support : fibers.scene.supports)
      names += (names.empty() ? "" : ", ") + support.name;
    for (unsigned int f = 0; f < fibers.fibers.size(); ++f)
      {
        const Fiber &fiber     = fibers.fibers[f];
        bool         supported = false;
        for (unsigned int cell = fiber.first_cell;
             cell < fiber.first_cell + fiber.n_cells && !supported;
             ++cell)
          for (const auto dof : fibers.cell_dofs[cell])
            supported = supported || prescribed.count(dof) > 0;
        AssertThrow(supported,
                    ExcParameter("supports/names",
                                 names,
                                 "such that every fiber is supported, but '" +
                                   fiber.name +
                                   "' is not: it could move freely"));
      }
  }



  std::vector<SupportReport>
  Supports::report(const double                         time,
                   const TrilinosWrappers::MPI::Vector &residual) const
  {
    const auto                &supports = fibers.scene.supports;
    std::vector<SupportReport> result(supports.size());
    for (unsigned int i = 0; i < supports.size(); ++i)
      result[i] = {supports[i].name, {}, {}, {}};

    std::vector<double> reactions(3 * supports.size(), 0.);
    for (const auto &[dof, entry] : prescribed)
      if (!entry.tangent && entry.support != at_rest_in_rigid_fiber)
        {
          SupportReport &support = result[entry.support];
          if (!support.held[entry.coordinate])
            support.displacement[entry.coordinate] = (*entry.value)(time);
          support.held[entry.coordinate] = true;
          if (fibers.owned_dofs.is_element(dof))
            reactions[3 * entry.support + entry.coordinate] += residual(dof);
        }
    Utilities::MPI::sum(reactions, fibers.communicator, reactions);
    for (unsigned int i = 0; i < supports.size(); ++i)
      for (unsigned int c = 0; c < 3; ++c)
        result[i].reaction[c] = reactions[3 * i + c];
    return result;
  }
} // namespace Setae
