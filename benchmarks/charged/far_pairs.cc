// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

// Far pairs by clusters of cells: cost and error over the number of charged
// fibers at constant density, against the sum over all pairs of points.
// far_pairs.csv has the table.

#include <deal.II/base/mpi.h>

#include <setae/assembly/far_field.h>
#include <setae/assembly/interaction.h>
#include <setae/assembly/interaction_kernel.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <iostream>

#include "../comparison.h"

using namespace Setae;
using namespace dealii;

namespace
{
  /** Straight fibers of length 1 in all directions, half of each charge. */
  std::string
  scene_of(const std::array<unsigned int, 3> &copies, const double tolerance)
  {
    const std::string fiber = R"(
      set copies     = )" + std::to_string(copies[0]) +
                              ", " + std::to_string(copies[1]) + ", " +
                              std::to_string(copies[2]) + R"(
      set length     = 1
      set radius     = 0.01
      set cells      = 4
)";
    std::ostringstream text;
    text << R"(
subsection fibers
  set names = positive, negative
  subsection positive
)" << fiber
         << R"(
      set centerline = 2*i + s*sin(7.1*i+3.7*j+5.3*k)*cos(2.9*i+8.3*j+k); \
                       2*j + s*sin(7.1*i+3.7*j+5.3*k)*sin(2.9*i+8.3*j+k); \
                       2*k + s*cos(7.1*i+3.7*j+5.3*k)
      set surface density = 1
  end
  subsection negative
)" << fiber
         << R"(
      set centerline = 1+2*i + s*sin(3.1*i+6.7*j+2.3*k)*cos(5.9*i+4.3*j+k); \
                       1+2*j + s*sin(3.1*i+6.7*j+2.3*k)*sin(5.9*i+4.3*j+k); \
                       1+2*k + s*cos(3.1*i+6.7*j+2.3*k)
      set surface density = -1
  end
end
subsection interactions
  set names = coulomb
  subsection coulomb
    set law                  = monopole
    set distribution         = surface
    set exponents            = 1
    set prefactors           = 1
    set integration segments = 1
    set integration tolerance = 0
    set gauss points         = 5
    set far field tolerance  = )"
         << tolerance << R"(
  end
end
)";
    return text.str();
  }



  /** How many pairs of clusters and of cells there are for each cell. */
  struct Pairs
  {
    double near, far;
  };

  Pairs
  count_pairs(const FiberSystem &fibers)
  {
    const InteractionParameters &parameters = fibers.scene.interactions.front();
    const double                 n          = fibers.initial.size();
    if (parameters.far_field_tolerance == 0.)
      return {.5 * (n - 4.), 0.};
    const InteractionRoles roles(fibers, parameters);
    FarField far_field(fibers, parameters, roles, integration_rule(parameters));
    State    state;
    state.current = fibers.initial;
    far_field.build(state, fibers.owned_cells);
    return {far_field.n_near_pairs() / n, far_field.n_far_pairs() / n};
  }



  double
  cpu_time()
  {
    return double(std::clock()) / CLOCKS_PER_SEC;
  }



  /** One evaluation of energy and residual. */
  struct Result
  {
    double              setup_time, time; ///< [s]
    double              energy;
    std::vector<double> residual; ///< of all degrees of freedom
  };

  Result
  evaluate(const FiberSystem &fibers)
  {
    const auto term =
      make_interaction(fibers, fibers.scene.interactions.front());
    GlobalSystem              system(fibers);
    AffineConstraints<double> none;
    none.close();
    TrilinosWrappers::MPI::Vector zero(fibers.owned_dofs, fibers.communicator);
    const State                   state = fibers.state(zero, 0.);

    Result result;
    double start = cpu_time();
    term->update_couplings(state);
    result.setup_time = cpu_time() - start;

    start = cpu_time();
    system.start(Request::residual, none);
    result.energy = term->assemble(state, Request::residual, system);
    system.finish();
    result.time = cpu_time() - start;
    for (const auto i : fibers.owned_dofs)
      result.residual.push_back(system.residual(i));
    return result;
  }



  /** What a fiber feels from all others by a plain sum over points. */
  struct PlainSum
  {
    Tensor<1, 3> force;
    double       magnitude = 0.; ///< sum of the magnitudes
  };

  PlainSum
  plain_sum(const FiberSystem                        &fibers,
            const std::vector<std::vector<LineSite>> &sites,
            const unsigned int                        fiber)
  {
    const auto charge = [&](const unsigned int f) {
      const FiberParameters &p =
        fibers.scene.fibers[fibers.fibers[f].parameters];
      return 2. * M_PI * p.radius * p.surface_density;
    };
    PlainSum result;
    for (unsigned int other = 0; other < fibers.fibers.size(); ++other)
      if (other != fiber)
        for (const LineSite &i : sites[fiber])
          for (const LineSite &j : sites[other])
            {
              const Tensor<1, 3> d = i.r - j.r;
              const double       q =
                charge(fiber) * charge(other) * i.weight * j.weight;
              const double square = d.norm_square();
              result.force += q / (square * std::sqrt(square)) * d;
              result.magnitude += std::abs(q) / square;
            }
    return result;
  }



  /** Errors of the forces on some fibers, relative to sums of magnitudes. */
  struct Errors
  {
    double mean = 0., largest = 0.;
  };

  Errors
  errors(const FiberSystem &fibers, const Result &result)
  {
    const Quadrature<1> rule =
      integration_rule(fibers.scene.interactions.front());
    std::vector<std::vector<LineSite>> sites(fibers.fibers.size());
    std::vector<LineSite>              of_cell;
    for (unsigned int c = 0; c < fibers.initial.size(); ++c)
      {
        evaluate_sites(rule, fibers.initial[c], fibers.initial[c], of_cell);
        auto &list = sites[fibers.fiber_of_cell[c]];
        list.insert(list.end(), of_cell.begin(), of_cell.end());
      }

    constexpr unsigned int n_samples = 100;
    const unsigned int     n         = fibers.fibers.size();
    const unsigned int     every     = std::max(1u, n / n_samples);
    Errors                 errors;
    double                 sum = 0., magnitudes = 0.;
    for (unsigned int f = 0; f < n; f += every)
      {
        const PlainSum exact = plain_sum(fibers, sites, f);
        Tensor<1, 3>   force;
        for (unsigned int node = 0; node <= fibers.fibers[f].n_cells; ++node)
          for (unsigned int c = 0; c < 3; ++c)
            force[c] -= result.residual[fibers.node_dof(f, node, false, c)];
        const double error = (force - exact.force).norm();
        sum += error;
        magnitudes += exact.magnitude;
        errors.largest = std::max(errors.largest, error / exact.magnitude);
      }
    errors.mean = sum / magnitudes;
    return errors;
  }
} // namespace



int
main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  // 10 to 1e4 fibers; all pairs of the most would take a quarter of an hour.
  const std::vector<std::array<unsigned int, 3>> sizes = {
    {{5, 1, 1}}, {{5, 5, 2}}, {{8, 8, 8}}, {{11, 11, 11}}, {{17, 17, 17}}};
  constexpr double largest_for_all_pairs = 3000.;

  TableHandler table;
  Comparison   comparison;
  for (const double tolerance : {0., 1e-2, 1e-3, 1e-4, 1e-6})
    {
      double first_cost = 0., cost = 0., largest_error = 0.;
      for (const auto &copies : sizes)
        {
          const Scene scene =
            Scene::read(scene_of(copies, tolerance), "far_pairs.prm");
          const FiberSystem fibers(scene, MPI_COMM_WORLD);
          const double      n = fibers.fibers.size();
          if (tolerance == 0. && n > largest_for_all_pairs)
            continue;
          const Result result = evaluate(fibers);
          const Errors error  = errors(fibers, result);
          const Pairs  pairs  = count_pairs(fibers);
          cost                = result.time / (n * std::log2(n));
          if (n > 500. && first_cost == 0.)
            first_cost = cost;
          largest_error = std::max(largest_error, error.mean);

          table.add_value("tolerance", tolerance);
          table.add_value("fibers", static_cast<unsigned int>(n));
          table.add_value("near pairs/cell", pairs.near);
          table.add_value("far pairs/cell", pairs.far);
          table.add_value("setup [s]", result.setup_time);
          table.add_value("time [s]", result.time);
          table.add_value("time/(n log2 n) [us]", 1e6 * cost);
          table.add_value("mean error", error.mean);
          table.add_value("largest error", error.largest);
        }
      if (tolerance > 0.)
        {
          std::ostringstream name;
          name << "tolerance " << tolerance;
          comparison.add({name.str() + ": error of the forces over tolerance",
                          Comparison::none,
                          largest_error / tolerance,
                          Requirement::at_most(1.)});
          comparison.add({name.str() + ": time/(n log n), 1e4 over 1e3 fibers",
                          Comparison::none,
                          cost / first_cost,
                          Requirement::at_most(2.)});
        }
    }
  for (const char *column : {"tolerance", "mean error", "largest error"})
    table.set_scientific(column, true);
  table.write_text(std::cout, TableHandler::org_mode_table);
  std::cout << std::endl;
  comparison.print(std::cout);
  std::ofstream csv("far_pairs.csv");
  table.write_text(csv,
                   TableHandler::simple_table_with_separate_column_description);
  return comparison.succeeds() ? 0 : 1;
}
