// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <deal.II/base/table_handler.h>
#include <deal.II/base/timer.h>

#include <setae/assembly/interaction.h>
#include <setae/verification/full_quadrature.h>
#include <setae/verification/verification.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace Setae
{
  using namespace dealii;

  namespace
  {
    /** A law of the scene, evaluated for all pairs of fibers. */
    struct LawResultants
    {
      FiberPairResultants pairs;
      double              cpu_time; ///< of one pair, on the average [s]

      LawResultants(const FiberSystem           &fibers,
                    const InteractionParameters &parameters,
                    const State                 &state)
      {
        const auto interaction = make_interaction(fibers, parameters);
        interaction->update_couplings(state);

        // As often as the clock needs to see it.
        Timer        timer(fibers.communicator, true);
        unsigned int n_times = 0;
        do
          {
            timer.start();
            pairs = interaction->pair_resultants(state);
            timer.stop();
            ++n_times;
          }
        while (Utilities::MPI::max(timer.wall_time(), fibers.communicator) <
               1e-2);

        for (const auto &of_rank :
             Utilities::MPI::all_gather(fibers.communicator,
                                        as_list(std::move(pairs))))
          for (const auto &[pair, energy, force] : of_rank)
            {
              pairs[pair].energy += energy;
              pairs[pair].force += force;
            }
        cpu_time =
          timer.cpu_time() / (n_times * std::max<int>(1, pairs.size()));
      }

    private:
      using Entry =
        std::tuple<std::pair<unsigned int, unsigned int>, double, Tensor<1, 3>>;

      /** For MPI; leaves nothing behind. */
      static std::vector<Entry>
      as_list(FiberPairResultants &&pairs)
      {
        std::vector<Entry> list;
        for (const auto &[pair, resultant] : pairs)
          list.emplace_back(pair, resultant.energy, resultant.force);
        pairs.clear();
        return list;
      }
    };



    /** The diameter of a sphere around all fibers [length]. */
    double
    extent(const FiberSystem &fibers, const State &state)
    {
      double             largest = 0.;
      const Tensor<1, 3> origin  = state.current.front().coefficients[0];
      for (const HermiteCell<> &cell : state.current)
        for (const Tensor<1, 3> &point : cell.control_points())
          largest = std::max(largest, (point - origin).norm());
      for (const FiberParameters &fiber : fibers.scene.fibers)
        largest = std::max(largest, fiber.radius);
      return 2. * largest;
    }



    SolidBody
    make_body(const FiberSystem &fibers,
              const State       &state,
              const unsigned int fiber)
    {
      const Fiber &f    = fibers.fibers[fiber];
      const auto   part = [&f](const std::vector<HermiteCell<>> &cells) {
        return std::vector<HermiteCell<>>(cells.begin() + f.first_cell,
                                          cells.begin() + f.first_cell +
                                            f.n_cells);
      };
      return SolidBody(FiberChart(part(fibers.initial),
                                  part(state.current),
                                  fibers.scene.fibers[f.parameters].radius),
                       PointDistribution::volume,
                       fibers.communicator);
    }



    /** Full quadrature with the densities of the fibers. */
    FullQuadrature
    integrate(const FiberSystem                           &fibers,
              const State                                 &state,
              const InteractionParameters                 &parameters,
              const std::pair<unsigned int, unsigned int> &pair)
    {
      const SectionPair sections = section_pair(
        fibers.scene.fibers[fibers.fibers[pair.first].parameters],
        fibers.scene.fibers[fibers.fibers[pair.second].parameters]);
      PointPotential potential = point_potential(parameters, sections);
      for (InversePower &power : potential)
        power.prefactor *= sections.density_1 * sections.density_2;

      SolidBody first  = make_body(fibers, state, pair.first);
      SolidBody second = make_body(fibers, state, pair.second);
      return full_quadrature(first,
                             second,
                             PointLaw(potential),
                             fibers.scene.full_quadrature);
    }



    class Table
    {
    public:
      void
      add_full(const std::string    &interaction,
               const std::string    &fibers,
               const FullQuadrature &full)
      {
        reference = full.value;
        add(interaction,
            fibers,
            "6D, " + std::to_string(full.n_points) + " Gauss points",
            full.value,
            full.error,
            full.force_error,
            full.cpu_time);
      }

      /** With the deviation from the full quadrature added last. */
      void
      add_law(const std::string &interaction,
              const std::string &fibers,
              const std::string &method,
              const Resultant   &value,
              const double       cpu_time)
      {
        add(interaction,
            fibers,
            method,
            value,
            value.energy / reference.energy - 1.,
            (value.force - reference.force).norm() / reference.force.norm(),
            cpu_time);
      }

      void
      print(std::ostream &out)
      {
        for (const char *column : {"energy", "force x", "force y", "force z"})
          {
            table.set_precision(column, 6);
            table.set_scientific(column, true);
          }
        for (const char *column :
             {"energy error", "force error", "CPU time [s]"})
          {
            table.set_precision(column, 1);
            table.set_scientific(column, true);
          }
        table.write_text(out, TableHandler::org_mode_table);
      }

    private:
      void
      add(const std::string &interaction,
          const std::string &fibers,
          const std::string &method,
          const Resultant   &value,
          const double       energy_error,
          const double       force_error,
          const double       cpu_time)
      {
        table.add_value("interaction", interaction);
        table.add_value("fibers", fibers);
        table.add_value("method", method);
        table.add_value("energy", value.energy);
        table.add_value("energy error", energy_error);
        table.add_value("force x", value.force[0]);
        table.add_value("force y", value.force[1]);
        table.add_value("force z", value.force[2]);
        table.add_value("force error", force_error);
        table.add_value("CPU time [s]", cpu_time);
      }

      TableHandler table;
      Resultant    reference;
    };
  } // namespace



  void
  verify(const FiberSystem &fibers, const State &state, std::ostream &out)
  {
    Table              table;
    std::ostringstream skipped;
    for (const InteractionParameters &parameters : fibers.scene.interactions)
      {
        InteractionParameters unlimited = parameters;
        unlimited.cutoff                = 2. * extent(fibers, state) /
                           (1. - std::min(.5, parameters.switch_width));
        unlimited.switch_width = std::min(.5, parameters.switch_width);
        const LawResultants law(fibers, parameters, state);
        const LawResultants law_without_cutoff(fibers, unlimited, state);

        for (const auto &[pair, resultant] : law.pairs)
          {
            const std::string names = fibers.fibers[pair.first].name + " - " +
                                      fibers.fibers[pair.second].name;
            const FullQuadrature full =
              integrate(fibers, state, parameters, pair);
            if (!std::isfinite(full.error))
              {
                skipped << "'" << names
                        << "' is too close for the limits of 'full 6D "
                           "quadrature': "
                        << full.n_cells << " cells\n";
                continue;
              }
            table.add_full(parameters.name, names, full);
            table.add_law(parameters.name,
                          names,
                          parameters.law + ", no cutoff",
                          law_without_cutoff.pairs.at(pair),
                          law_without_cutoff.cpu_time);
            table.add_law(
              parameters.name, names, parameters.law, resultant, law.cpu_time);
          }
      }
    if (Utilities::MPI::this_mpi_process(fibers.communicator) != 0)
      return;
    out
      << "\nVerification of the last state, t = " << state.time
      << ". 6D: all pairs of points of the fibers as solid bodies, without "
         "cutoff; its errors\nare estimates from the last changes with the "
         "number of Gauss points, those of the laws are deviations from it, all "
         "relative.\nForces act on the first fiber.\n";
    table.print(out);
    out << skipped.str();
  }
} // namespace Setae
