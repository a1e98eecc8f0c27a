// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <deal.II/base/config.h>

#include <setae/base/exceptions.h>
#include <setae/solvers/ida.h>

#ifdef DEAL_II_WITH_SUNDIALS
#  include <deal.II/base/utilities.h>

#  include <deal.II/lac/trilinos_parallel_block_vector.h>

#  include <deal.II/sundials/ida.h>
#endif

#include <fcntl.h>
#include <unistd.h>

#include <cmath>
#include <exception>
#include <string>

namespace Setae
{
#ifdef DEAL_II_WITH_SUNDIALS
  using namespace dealii;

  namespace
  {
    using Vector      = NonlinearSystem::Vector;
    using BlockVector = TrilinosWrappers::MPI::BlockVector;

    /**
     * The callbacks of IDA. They return 0 for success, 1 if a shorter step may
     * help and -1 if not; no exception may pass through IDA.
     */
    class Callbacks
    {
    public:
      Callbacks(DynamicSystem &system,
                const double   damping,
                const Motion  &initial)
        : meter(system, damping, initial)
        , system(system)
        , damping(damping)
      {}

      int
      residual(const double       time,
               const BlockVector &y,
               const BlockVector &y_dot,
               BlockVector       &result)
      {
        return guarded([&]() {
          last_time           = time;
          last_y              = y;
          last_y_dot          = y_dot;
          const Motion motion = evaluate(time, y, y_dot, 0., Request::residual);
          if (!last.is_admissible)
            {
              refusal = last.reason;
              return 1;
            }
          meter.add(motion, time);

          result.block(0) = y_dot.block(0);
          result.block(0) -= y.block(1);
          system.set_supports_to_zero(result.block(0));
          result.block(0) += y.block(0);
          result.block(0) -= motion.displacement;

          result.block(1) = system.residual();
          system.project_force(result.block(1));
          result.block(1) += y.block(1);
          result.block(1) -= motion.velocity;
          return 0;
        });
      }

      int
      setup(const double       time,
            const BlockVector &y,
            const BlockVector &y_dot,
            const double       alpha)
      {
        return guarded([&]() {
          this->alpha = alpha;
          evaluate(time, y, y_dot, alpha * (alpha + damping), Request::tangent);
          return last.is_valid ? 0 : 1;
        });
      }

      /** The equations of X and V, the latter eliminated. */
      int
      solve(const BlockVector &right_hand_side, BlockVector &result)
      {
        return guarded([&]() {
          ++n_solved;
          // The equations of the supports stand in the rows that are not free.
          Vector first(right_hand_side.block(0)),
            second(right_hand_side.block(1));
          Vector first_of_supports(first), second_of_supports(second);
          system.set_supports_to_zero(first);
          system.set_supports_to_zero(second);
          first_of_supports -= first;
          second_of_supports -= second;
          system.project_motion(first);

          Vector force = system.times_mass(first);
          force *= alpha + damping;
          system.project_force(force);
          force += second;
          Vector displacement(force);
          if (!system.solve(force, displacement) &&
              !(assemble_again() && system.solve(force, displacement)))
            return 1;

          result.block(0) = displacement;
          result.block(0) += first_of_supports;
          result.block(1) = second_of_supports;
          result.block(1).add(alpha, displacement, -1., first);
          return 0;
        });
      }

      /**
       * The motion at the end of an interval; throws what a callback could not.
       */
      Motion
      motion(const double time, const BlockVector &y, const BlockVector &y_dot)
      {
        if (exception)
          std::rethrow_exception(exception);
        Motion result{y.block(0), y.block(1), y_dot.block(1)};
        system.prescribe(result, time);
        return result;
      }

      unsigned int n_solved = 0;
      Evaluation   last;
      std::string  refusal; ///< why the last state was refused
      WorkMeter    meter;

    private:
      template <typename Function>
      int
      guarded(const Function &function)
      {
        try
          {
            return function();
          }
        catch (...)
          {
            exception = std::current_exception();
            return -1;
          }
      }

      /**
       * The matrix at the state of the last residual: where fibers have become
       * neighbors, its pattern has changed and its entries are gone.
       */
      bool
      assemble_again()
      {
        evaluate(last_time,
                 last_y,
                 last_y_dot,
                 alpha * (alpha + damping),
                 Request::tangent);
        return last.is_valid;
      }

      /** With what the supports do instead of the prescribed unknowns. */
      Motion
      evaluate(const double       time,
               const BlockVector &y,
               const BlockVector &y_dot,
               const double       mass_factor,
               const Request      request)
      {
        Motion motion{y.block(0), y.block(1), y_dot.block(1)};
        system.prescribe(motion, time);
        Vector rate(motion.acceleration);
        rate.add(damping, motion.velocity);
        last = system.evaluate_motion(
          motion.displacement, rate, mass_factor, time, request);
        return motion;
      }

      DynamicSystem     &system;
      const double       damping;
      double             alpha     = 0.;
      double             last_time = 0.;
      BlockVector        last_y, last_y_dot;
      std::exception_ptr exception;
    };



    /**
     * IDA prints a notice on the standard error each time it has taken 500
     * steps, and deal.II does not let it be told otherwise. What is wrong is
     * said by the exception that ends a run.
     */
    class SilentNotices
    {
    public:
      SilentNotices()
        : standard_error(dup(STDERR_FILENO))
      {
        const int nowhere = open("/dev/null", O_WRONLY);
        dup2(nowhere, STDERR_FILENO);
        close(nowhere);
      }

      ~SilentNotices()
      {
        dup2(standard_error, STDERR_FILENO);
        close(standard_error);
      }

    private:
      const int standard_error;
    };



    BlockVector
    two_blocks(const Vector &first, const Vector &second)
    {
      BlockVector result(std::vector<IndexSet>(2,
                                               first.locally_owned_elements()),
                         first.get_mpi_communicator());
      result.block(0) = first;
      result.block(1) = second;
      return result;
    }



    /** The absolute tolerance of each unknown. */
    BlockVector
    tolerances(const DynamicSystem      &system,
               const DynamicsParameters &parameters)
    {
      Vector displacement = system.unit_displacements();
      for (const auto i : displacement.locally_owned_elements())
        displacement(i) = parameters.tolerance / displacement(i);
      displacement.compress(VectorOperation::insert);
      Vector velocity(displacement);
      velocity *= 1. / parameters.time_step;
      return two_blocks(displacement, velocity);
    }



    /** The unknowns of this rank that are not prescribed. */
    IndexSet
    differential_unknowns(const DynamicSystem &system)
    {
      Vector is_free = system.unit_displacements();
      system.set_supports_to_zero(is_free);
      const auto n = is_free.size();
      IndexSet   result(2 * n);
      for (const auto i : is_free.locally_owned_elements())
        if (is_free(i) != 0.)
          {
            result.add_index(i);
            result.add_index(n + i);
          }
      return result;
    }
  } // namespace



  Ida::Ida(const DynamicsParameters &parameters)
    : parameters(parameters)
  {}



  void
  Ida::run(DynamicSystem &system,
           const Motion  &initial,
           const Visit   &visit) const
  {
    using Solver = SUNDIALS::IDA<BlockVector>;

    // A little more than an interval, so that the last one is cut off by the
    // end time instead of missing it by round-off.
    const double n_intervals =
      std::ceil(parameters.end_time / parameters.time_step * (1. - 1e-9));
    const double interval = parameters.end_time / n_intervals * (1. + 1e-13);

    Solver::AdditionalData data;
    data.final_time                        = parameters.end_time;
    data.initial_step_size                 = 0.; // IDA finds one
    data.output_period                     = interval;
    data.maximum_order                     = parameters.max_order;
    data.relative_tolerance                = 0.;
    data.ic_type                           = Solver::AdditionalData::none;
    data.reset_type                        = Solver::AdditionalData::none;
    data.ignore_algebraic_terms_for_errors = true;

    Callbacks   callbacks(system, parameters.damping, initial);
    BlockVector y     = two_blocks(initial.displacement, initial.velocity);
    BlockVector y_dot = two_blocks(initial.velocity, initial.acceleration);
    BlockVector absolute_tolerances = tolerances(system, parameters);

    Solver ida(data, initial.displacement.get_mpi_communicator());
    ida.reinit_vector = [&](BlockVector &vector) { vector.reinit(y); };
    ida.residual      = [&](const double       time,
                       const BlockVector &y,
                       const BlockVector &y_dot,
                       BlockVector       &result) {
      return callbacks.residual(time, y, y_dot, result);
    };
    ida.setup_jacobian = [&](const double       time,
                             const BlockVector &y,
                             const BlockVector &y_dot,
                             const double       alpha) {
      return callbacks.setup(time, y, y_dot, alpha);
    };
    ida.solve_with_jacobian = [&](const BlockVector &right_hand_side,
                                  BlockVector       &result,
                                  const double) {
      return callbacks.solve(right_hand_side, result);
    };
    ida.differential_components = [&]() {
      return differential_unknowns(system);
    };
    ida.get_local_tolerances = [&]() -> BlockVector & {
      return absolute_tolerances;
    };

    // In Release, deal.II does not look at what IDA returns. If it has not come
    // to the end of the interval, it has taken the 500 steps that it takes at a
    // time, and is called again; if it has not moved at all, it has failed.
    //
    // Where no step is right, IDA takes ever shorter ones instead of failing:
    // 500 of them that are shorter than the smallest step together, twice in a
    // row, are no progress.
    constexpr unsigned int n_steps_at_a_time = 500;
    bool                   is_slow           = false;
    double                 last_time         = -1.;
    ida.output_step                          = [&](const double       time,
                          const BlockVector &y,
                          const BlockVector &y_dot,
                          const unsigned int) {
      const Motion motion   = callbacks.motion(time, y, y_dot);
      const bool   was_slow = is_slow;
      is_slow               = callbacks.n_solved >= n_steps_at_a_time &&
                time - last_time < parameters.shortest_step();
      AssertThrow(
        time > last_time && !(is_slow && was_slow),
        ExcRun("IDA cannot go on at time " + Utilities::to_string(time) +
               (callbacks.refusal.empty() ? "" : ": " + callbacks.refusal) +
               " ('dynamics/smallest step' bounds its steps from below). The "
                                        "states before it are on disk."));
      if (time > 0.)
        visit(time, motion, callbacks.meter, callbacks.n_solved);
      callbacks.n_solved = 0;
      callbacks.refusal.clear();
      last_time = time;
    };
    const SilentNotices silence;
    ida.solve_dae(y, y_dot);
  }

#else

  Ida::Ida(const DynamicsParameters &parameters)
  {
    AssertThrow(false,
                ExcParameter("dynamics/integrator",
                             parameters.integrator,
                             "another one: this deal.II was configured without "
                             "SUNDIALS"));
  }



  void
  Ida::run(DynamicSystem &, const Motion &, const Visit &) const
  {}

#endif
} // namespace Setae
