// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <deal.II/lac/sparsity_tools.h>

#include <setae/assembly/interaction.h>
#include <setae/base/exceptions.h>
#include <setae/fiber_equations.h>
#include <setae/solvers/linear_solver.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace Setae
{
  using namespace dealii;

  namespace
  {
    /** The largest distance of a node from the first one [length]. */
    double
    extent(const State &state)
    {
      double             largest = 0.;
      const Tensor<1, 3> origin  = state.current.front().coefficients[0];
      for (const HermiteCell<> &cell : state.current)
        for (const unsigned int a : {0, 2})
          largest = std::max(largest, (cell.coefficients[a] - origin).norm());
      return largest;
    }
  } // namespace



  FiberEquations::FiberEquations(const FiberSystem &fibers, TimerOutput &timer)
    : fibers(fibers)
    , scene(fibers.scene)
    , communicator(fibers.communicator)
    , timer(timer)
    , supports(fibers)
    , system(fibers)
    , all_dofs(complete_index_set(fibers.dof_handler.n_dofs()))
    , everywhere(fibers.owned_dofs, all_dofs, communicator)
  {
    setup_terms();
    if (scene.dynamics.is_on())
      {
        inertia = std::make_unique<Inertia>(fibers);
        inertia->initial_velocity(); // its formulas must be right
      }
  }



  void
  FiberEquations::setup_terms()
  {
    auto strain_energy = std::make_unique<StrainEnergy>(fibers);
    strain             = strain_energy.get();
    terms.push_back(std::move(strain_energy));
    for (const LoadParameters &load : scene.loads)
      {
        auto term = std::make_unique<Load>(fibers, load);
        loads.push_back(term.get());
        terms.push_back(std::move(term));
      }
    for (const InteractionParameters &interaction : scene.interactions)
      terms.push_back(make_interaction(fibers, interaction));
  }



  /**
   * Let the terms look for partners, and give the matrix its pattern if that is
   * new on any rank.
   */
  void
  FiberEquations::find_pairs(const State &state)
  {
    bool changed = system.tangent_matrix.m() == 0;
    for (const auto &term : terms)
      if (term->has_search())
        {
          TimerOutput::Scope section(timer, "search");
          changed = term->update_couplings(state) || changed;
        }
    if (Utilities::MPI::max(changed ? 1 : 0, communicator) == 1)
      setup_matrix();
  }



  void
  FiberEquations::setup_matrix()
  {
    TimerOutput::Scope section(timer, "setup");

    std::vector<std::pair<unsigned int, unsigned int>> pairs;
    for (const unsigned int cell : fibers.owned_cells)
      pairs.emplace_back(cell, cell);
    for (const auto &term : terms)
      term->add_couplings(pairs);

    DynamicSparsityPattern               pattern(all_dofs);
    std::vector<types::global_dof_index> dofs;
    for (const auto &[first, second] : pairs)
      {
        dofs.clear();
        for (const unsigned int cell : {first, second})
          for (const auto dof : fibers.cell_dofs[cell])
            if (dof != numbers::invalid_dof_index)
              dofs.push_back(dof);
        // A cell coupled with itself, or two that share a node, name some
        // twice.
        std::sort(dofs.begin(), dofs.end());
        dofs.erase(std::unique(dofs.begin(), dofs.end()), dofs.end());
        supports.at_rest().add_entries_local_to_global(dofs, pattern, false);
      }
    SparsityTools::distribute_sparsity_pattern(pattern,
                                               fibers.owned_dofs,
                                               communicator,
                                               all_dofs);
    system.reinit_matrix(pattern);
  }



  Evaluation
  FiberEquations::evaluate(const Vector          &solution,
                           const double           time,
                           const SupportIncrement support_increment)
  {
    everywhere        = solution;
    const State state = fibers.state(everywhere, time);
    find_pairs(state);

    increment_at_rest = support_increment == SupportIncrement::at_rest;
    if (!increment_at_rest)
      increment_constraints = supports.increment_to(time, everywhere);

    Evaluation evaluation;
    assemble_system(state,
                    Request::tangent,
                    increment_at_rest ? supports.at_rest() :
                                        increment_constraints,
                    nullptr,
                    evaluation);
    judge(evaluation);
    return evaluation;
  }



  void
  FiberEquations::assemble_system(const State                     &state,
                                  const Request                    request,
                                  const AffineConstraints<double> &constraints,
                                  const InertiaForce *inertia_force,
                                  Evaluation         &evaluation)
  {
    system.start(request, constraints);
    has_product = std::any_of(terms.begin(), terms.end(), [](const auto &term) {
      return term->has_tangent_product();
    });
    bool is_complete = true;
    evaluation.energies.assign(terms.size(), 0.);
    for (unsigned int i = 0; i < terms.size(); ++i)
      {
        TimerOutput::Scope section(timer, terms[i]->name());
        try
          {
            evaluation.energies[i] = terms[i]->assemble(state, request, system);
          }
        catch (const TorsionFreeKirchhoff::ExcCollapsedCell &)
          {
            is_complete = false;
          }
      }
    if (inertia_force != nullptr)
      {
        TimerOutput::Scope section(timer, "inertia");
        inertia->add(inertia_force->rate, inertia_force->mass_factor, system);
      }
    system.finish();

    evaluation.is_valid =
      Utilities::MPI::min(is_complete ? 1 : 0, communicator) == 1;
    if (!evaluation.is_valid)
      evaluation.reason = "a cell has collapsed to a point";

    Utilities::MPI::sum(evaluation.energies, communicator, evaluation.energies);
    for (const double energy : evaluation.energies)
      evaluation.energy += energy;

    Vector free_residual(system.residual);
    supports.at_rest().set_zero(free_residual);
    evaluation.residual_norm = free_residual.l2_norm();

    // Stiffness times the round-off of a coordinate.
    if (request >= Request::tangent)
      evaluation.round_off = std::numeric_limits<double>::epsilon() *
                             system.tangent_matrix.linfty_norm() *
                             extent(state);
  }



  /** Collect the gaps of all terms and ranks, and find what is wrong. */
  void
  FiberEquations::judge(Evaluation &evaluation) const
  {
    if (!std::isfinite(evaluation.residual_norm) ||
        !std::isfinite(evaluation.energy))
      {
        evaluation.is_valid = false;
        evaluation.reason   = "the residual is not finite";
      }
    evaluation.is_admissible = evaluation.is_valid;
    for (const auto &term : terms)
      {
        GapReport gaps;
        for (const GapReport &report :
             Utilities::MPI::all_gather(communicator, term->gaps()))
          gaps.see(report);
        evaluation.gaps.see(gaps);

        const double limit = term->smallest_admissible_gap();
        if (gaps.smallest <= term->singular_gap())
          evaluation.is_valid = false;
        if (gaps.smallest < limit || !evaluation.is_valid)
          {
            evaluation.is_admissible = false;
            std::ostringstream text;
            text << "the gap is " << gaps.smallest << " " << where(gaps)
                 << ", below " << limit;
            evaluation.reason = text.str();
          }
      }
  }



  bool
  FiberEquations::solve(const Vector &right_hand_side, Vector &result)
  {
    TimerOutput::Scope section(timer, "solve");
    const LinearSolver solver(scene.newton.linear_solver);
    if (has_product)
      {
        Vector reduced(right_hand_side);
        if (!increment_at_rest)
          {
            Vector prescribed(fibers.owned_dofs, communicator),
              product(prescribed);
            increment_constraints.distribute(prescribed);
            tangent_product(prescribed, product);
            reduced -= product;
          }
        const auto of_free = [this](const Vector &x, Vector &product) {
          Vector free(x);
          supports.at_rest().set_zero(free);
          tangent_product(free, product);
        };
        if (!solver.solve(system.tangent_matrix, of_free, reduced, result))
          return false;
      }
    else if (!solver.solve(system.tangent_matrix, right_hand_side, result))
      return false;
    (increment_at_rest ? supports.at_rest() : increment_constraints)
      .distribute(result);
    return true;
  }



  /** What the terms leave out of the tangent matrix, on the free unknowns. */
  void
  FiberEquations::tangent_product(const Vector &x, Vector &product)
  {
    everywhere            = x;
    const State direction = fibers.state(everywhere, 0.);
    product               = 0.;
    for (const auto &term : terms)
      if (term->has_tangent_product())
        term->add_tangent_product(direction, product);
    product.compress(VectorOperation::add);
    supports.at_rest().set_zero(product);
  }



  bool
  FiberEquations::solve(Vector &increment)
  {
    return solve(system.right_hand_side, increment);
  }



  double
  FiberEquations::add_damping(const Vector &coefficients, const Vector &motion)
  {
    auto  &matrix = system.tangent_matrix;
    Vector force(motion);
    force.scale(coefficients);
    for (const auto i : fibers.owned_dofs)
      matrix.set(i, i, matrix.diag_element(i) + coefficients(i));
    matrix.compress(VectorOperation::insert);

    Vector free_force(force);
    supports.at_rest().set_zero(free_force);
    system.right_hand_side -= free_force;

    free_force += system.residual;
    supports.at_rest().set_zero(free_force);
    return free_force.l2_norm();
  }



  FiberEquations::Vector
  FiberEquations::diagonal() const
  {
    Vector result(fibers.owned_dofs, communicator);
    for (const auto i : fibers.owned_dofs)
      result(i) = std::abs(system.tangent_matrix.diag_element(i));
    result.compress(VectorOperation::insert);
    return result;
  }



  double
  FiberEquations::largest_displacement(const Vector &increment) const
  {
    double largest = 0.;
    for (const unsigned int cell : fibers.owned_cells)
      for (const unsigned int shape : {0u, 2u})
        for (unsigned int c = 0; c < 3; ++c)
          {
            const auto dof = fibers.cell_dofs[cell][3 * shape + c];
            if (fibers.owned_dofs.is_element(dof))
              largest = std::max(largest, std::abs(increment(dof)));
          }
    return Utilities::MPI::max(largest, communicator);
  }



  std::string
  FiberEquations::where(const GapReport &gaps) const
  {
    const auto place = [this](const unsigned int cell) {
      const Fiber &f = fibers.fibers[fibers.fiber_of_cell[cell]];
      return "'" + f.name + "'";
    };
    const Fiber       &f = fibers.fibers[fibers.fiber_of_cell[gaps.source]];
    const auto         i = gaps.source - f.first_cell;
    std::ostringstream text;
    text << "between " << place(gaps.source) << " (at s = "
         << f.arc_length[i] + gaps.x * (f.arc_length[i + 1] - f.arc_length[i])
         << ") and " << place(gaps.target);
    return text.str();
  }



  std::string
  FiberEquations::passage(const Vector &from, const Vector &to) const
  {
    const State begin = state(from, 0.), end = state(to, 0.);
    Passage     first;
    first.fraction = std::numeric_limits<double>::infinity();
    for (const auto &term : terms)
      for (const Passage &passage : Utilities::MPI::all_gather(
             communicator, term->find_passage(begin, end).value_or(first)))
        if (passage.is_before(first))
          first = passage;
    if (std::isinf(first.fraction))
      return {};
    GapReport place;
    place.source = first.source;
    place.target = first.target;
    place.x      = first.x;
    return "fibers would pass through each other " + where(place);
  }



  bool
  FiberEquations::has_potential() const
  {
    return std::all_of(terms.begin(), terms.end(), [](const auto &term) {
      return term->has_potential();
    });
  }



  State
  FiberEquations::state(const Vector &solution, const double time) const
  {
    everywhere = solution;
    return fibers.state(everywhere, time);
  }
} // namespace Setae
