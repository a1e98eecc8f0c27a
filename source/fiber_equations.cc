// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <deal.II/lac/sparsity_tools.h>

#include <setae/assembly/interaction.h>
#include <setae/base/exceptions.h>
#include <setae/fiber_equations.h>
#include <setae/fibers/cross_section.h>

#include <algorithm>
#include <cmath>

namespace Setae
{
  using namespace dealii;

  namespace
  {
    /** The largest distance of a node from the origin [length]. */
    double
    extent(const std::vector<HermiteCell<>> &cells)
    {
      double largest = 0.;
      for (const HermiteCell<> &cell : cells)
        for (const unsigned int a : {0, 2})
          largest = std::max(largest, cell.coefficients[a].norm());
      return largest;
    }

    /** DynamicSystem::unit_displacements() of some unknowns, in their order. */
    std::vector<double>
    units_of_displacement(const FiberSystem &fibers, const IndexSet &dofs)
    {
      std::vector<double> result(dofs.n_elements(), 1.);
      for (unsigned int cell = 0; cell < fibers.initial.size(); ++cell)
        for (const unsigned int tangent : {3, 9})
          for (unsigned int c = 0; c < 3; ++c)
            {
              const auto dof = fibers.cell_dofs[cell][tangent + c];
              if (dof != numbers::invalid_dof_index && dofs.is_element(dof))
                result[dofs.index_within_set(dof)] = fibers.initial[cell].h;
            }
      return result;
    }

    /** EA / h of the cells at the unknowns of this rank, in their order. */
    std::vector<double>
    axial_stiffness_of(const FiberSystem &fibers)
    {
      std::vector<double> result(fibers.owned_dofs.n_elements(), 0.);
      for (unsigned int cell = 0; cell < fibers.initial.size(); ++cell)
        for (const auto dof : fibers.cell_dofs[cell])
          if (dof != numbers::invalid_dof_index &&
              fibers.owned_dofs.is_element(dof) && !fibers.is_rigid(cell))
            result[fibers.owned_dofs.index_within_set(dof)] =
              circular_section(fibers.parameters_of_cell(cell)).axial /
              fibers.initial[cell].h;
      return result;
    }

    /** EI / l^2 of the softest fiber that is not rigid, 0 if all are. */
    double
    least_bending_force(const FiberSystem &fibers)
    {
      double least = std::numeric_limits<double>::infinity();
      for (const Fiber &fiber : fibers.fibers)
        if (!fibers.is_rigid(fiber.first_cell))
          {
            const double length = fiber.arc_length.back();
            least               = std::min(least,
                             circular_section(
                               fibers.parameters_of_cell(fiber.first_cell))
                                 .bending /
                               (length * length));
          }
      return std::isfinite(least) ? least : 0.;
    }
  } // namespace



  FiberEquations::FiberEquations(const FiberSystem &fibers, TimerOutput &timer)
    : fibers(fibers)
    , scene(fibers.scene)
    , communicator(fibers.communicator)
    , timer(timer)
    , supports(fibers)
    , system(fibers)
    , units(units_of_displacement(fibers, fibers.owned_dofs))
    , solver(scene.newton.linear_solver, unit_displacements())
    , all_dofs(complete_index_set(fibers.dof_handler.n_dofs()))
    , everywhere(fibers.owned_dofs, all_dofs, communicator)
    , axial_stiffness(axial_stiffness_of(fibers))
    , initial_extent(extent(fibers.initial))
    , least_force(least_bending_force(fibers))
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
    bool changed =
      supports.move_to(state.time) || system.tangent_matrix.m() == 0;
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
    solver.clear();
    system.reinit_matrix(pattern);

    const std::vector<double> all_units =
      units_of_displacement(fibers, all_dofs);
    const Epetra_Map &columns =
      system.tangent_matrix.trilinos_matrix().ColMap();
    inverse_column_units.resize(columns.NumMyElements());
    for (int i = 0; i < columns.NumMyElements(); ++i)
      inverse_column_units[i] = 1. / all_units[columns.GID(i)];
  }



  Evaluation
  FiberEquations::evaluate(const Vector          &solution,
                           const double           time,
                           const SupportIncrement support_increment)
  {
    everywhere        = solution;
    evaluated_time    = time;
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
    if (increment_at_rest && !supports.tangents_point_forward(everywhere))
      {
        evaluation.is_valid      = false;
        evaluation.is_admissible = false;
        evaluation.reason =
          "a tangent points against the 'tangent direction' of its support";
      }
    return evaluation;
  }



  void
  FiberEquations::assemble_system(const State                     &state,
                                  const Request                    request,
                                  const AffineConstraints<double> &constraints,
                                  const InertiaForce *inertia_force,
                                  Evaluation         &evaluation)
  {
    is_damped = false;
    solver.clear();
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

    evaluation.residual_norm = force_norm(system.residual);
    evaluation.force_scale =
      std::max(std::sqrt(
                 Utilities::MPI::sum(system.sum_of_squares, communicator)),
               least_force);

    // Stiffness times the round-off of a coordinate: not of any that a fiber
    // may come to that has got lost.
    constexpr double largest_growth = 10.;
    if (request >= Request::tangent)
      evaluation.round_off =
        std::numeric_limits<double>::epsilon() * largest_stiffness() *
        std::min(extent(state.current), largest_growth * initial_extent);
  }



  bool
  FiberEquations::solve(const Vector &right_hand_side, Vector &result)
  {
    TimerOutput::Scope section(timer, "solve");
    if (!solver.factorize(system.tangent_matrix))
      return false;
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
          supports.project_motion(free);
          tangent_product(free, product);
        };
        if (!solver.solve(of_free, reduced, result))
          return false;
      }
    else if (!solver.solve(right_hand_side, result))
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
    supports.project_force(product);
  }



  bool
  FiberEquations::solve(Vector &increment)
  {
    const bool is_solved = solve(system.right_hand_side, increment);

    // Once a load step, by its predictor, or where it matters at once. With
    // inertia or in the overdamped motion, every motion meets with a
    // resistance.
    if (!inertia && !is_damped && (!increment_at_rest || !is_solved))
      check_free_fibers();
    return is_solved;
  }



  double
  FiberEquations::add_damping(const Vector &coefficients, const Vector &motion)
  {
    auto &matrix = system.tangent_matrix;
    is_damped    = true;
    solver.clear();
    Vector force(motion), diagonal(coefficients);
    force.scale(coefficients);
    supports.project_diagonal(diagonal);
    for (const auto i : fibers.owned_dofs)
      matrix.set(i, i, matrix.diag_element(i) + diagonal(i));
    matrix.compress(VectorOperation::insert);

    Vector free_force(force);
    supports.project_force(free_force);
    system.right_hand_side -= free_force;

    free_force += system.residual;
    return force_norm(free_force);
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
