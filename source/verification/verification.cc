// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <deal.II/base/table_handler.h>
#include <deal.II/base/timer.h>

#include <setae/assembly/interaction.h>
#include <setae/laws/penalty_contact.h>
#include <setae/verification/verification.h>

#include <algorithm>
#include <cmath>
#include <tuple>

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

      LawResultants(const FiberSystem    &fibers,
                    InteractionParameters parameters,
                    const State          &state)
      {
        parameters.far_field_tolerance = 0.; // pairs of fibers are wanted
        const auto interaction         = make_interaction(fibers, parameters);
        interaction->update_couplings(state);

        // As often as the clock needs to see it.
        Timer timer(fibers.communicator, true);
        timer.reset();
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

        const auto of_all_ranks =
          Utilities::MPI::all_gather(fibers.communicator, as_list(pairs));
        pairs.clear();
        for (const auto &of_rank : of_all_ranks)
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

      static std::vector<Entry>
      as_list(const FiberPairResultants &pairs)
      {
        std::vector<Entry> list;
        for (const auto &[pair, resultant] : pairs)
          list.emplace_back(pair, resultant.energy, resultant.force);
        return list;
      }
    };



    FiberChart
    make_chart(const FiberSystem &fibers,
               const State       &state,
               const unsigned int fiber)
    {
      const Fiber &f    = fibers.fibers[fiber];
      const auto   part = [&f](const std::vector<HermiteCell<>> &cells) {
        const auto begin = cells.begin() + f.first_cell;
        return std::vector<HermiteCell<>>(begin, begin + f.n_cells);
      };
      return FiberChart(part(fibers.initial),
                        part(state.current),
                        fibers.parameters[fiber].radius);
    }



    /** Full quadrature with the densities of the fibers. */
    FullQuadrature
    integrate(const FiberSystem                           &fibers,
              const State                                 &state,
              const InteractionParameters                 &parameters,
              const std::pair<unsigned int, unsigned int> &pair)
    {
      const auto &[first, second] = pair;
      const SectionPair sections  = section_pair(parameters,
                                                fibers.parameters[first],
                                                fibers.parameters[second]);
      const Expression strength("interactions/" + parameters.name + "/strength",
                                parameters.strength,
                                "t",
                                fibers.scene.constants);
      PointPotential   potential = point_potential(parameters, sections);
      for (InversePower &power : potential)
        power.prefactor *=
          sections.density_1 * sections.density_2 * strength(state.time);

      SolidBody body_1(make_chart(fibers, state, first),
                       sections.distribution,
                       fibers.communicator);
      SolidBody body_2(make_chart(fibers, state, second),
                       sections.distribution,
                       fibers.communicator);
      return full_quadrature(body_1,
                             body_2,
                             PointLaw(potential),
                             fibers.scene.full_quadrature);
    }



    /** One line of the table. */
    void
    add_row(TableHandler       &table,
            const Verification &v,
            const std::string  &method,
            const Resultant    &value,
            const double        energy_error,
            const double        force_error,
            const double        cpu_time)
    {
      table.add_value("interaction", v.interaction);
      table.add_value("fibers", v.fibers);
      table.add_value("method", method);
      table.add_value("energy", value.energy);
      table.add_value("error", energy_error);
      table.add_value("force x", value.force[0]);
      table.add_value("force y", value.force[1]);
      table.add_value("force z", value.force[2]);
      table.add_value("error of force", force_error);
      table.add_value("CPU time [s]", cpu_time);
    }

    /** A law, with its deviation from the full quadrature. */
    void
    add_law(TableHandler       &table,
            const Verification &v,
            const std::string  &method,
            const Resultant    &value,
            const double        cpu_time)
    {
      const Resultant &full = v.full.value;
      add_row(table,
              v,
              method,
              value,
              value.energy / full.energy - 1.,
              (value.force - full.force).norm() / full.force.norm(),
              cpu_time);
    }
  } // namespace



  std::vector<Verification>
  verify(const FiberSystem &fibers, const State &state)
  {
    std::vector<Verification> result;
    for (const InteractionParameters &parameters : fibers.scene.interactions)
      {
        if (parameters.law == PenaltyContact::name)
          continue;
        InteractionParameters unlimited = parameters;
        unlimited.cutoff                = 0.;
        const LawResultants law(fibers, parameters, state);
        const LawResultants law_without_cutoff(fibers, unlimited, state);
        for (const auto &[pair, resultant] : law.pairs)
          result.push_back({parameters.name,
                            parameters.law,
                            fibers.fibers[pair.first].name + " - " +
                              fibers.fibers[pair.second].name,
                            integrate(fibers, state, parameters, pair),
                            resultant,
                            law_without_cutoff.pairs.at(pair),
                            law.cpu_time,
                            law_without_cutoff.cpu_time});
      }
    return result;
  }



  void
  print(const std::vector<Verification> &verifications, std::ostream &out)
  {
    out
      << "\nVerification by full 6D quadrature over the fibers as solid "
         "bodies (4D over their surfaces), which has no cutoff.\nIts errors are estimates, those of "
         "the laws are deviations from it, all relative.\nForces act on the "
         "first fiber.\n";
    TableHandler table;
    bool         is_empty = true;
    for (const Verification &v : verifications)
      {
        if (!std::isfinite(v.full.error))
          {
            out << "'" << v.fibers
                << "' is too much for the limits in 'full 6D quadrature': "
                << v.full.n_cells << " cells\n";
            continue;
          }
        is_empty = false;
        add_row(table,
                v,
                "full, " + std::to_string(v.full.n_points) + " Gauss points",
                v.full.value,
                v.full.error,
                v.full.force_error,
                v.full.cpu_time);
        add_law(table,
                v,
                v.law + ", no cutoff",
                v.without_cutoff,
                v.cpu_time_without_cutoff);
        add_law(table, v, v.law, v.with_cutoff, v.cpu_time);
      }
    if (is_empty)
      return;
    for (const char *column : {"energy", "force x", "force y", "force z"})
      {
        table.set_precision(column, 6);
        table.set_scientific(column, true);
      }
    for (const char *column : {"error", "error of force", "CPU time [s]"})
      {
        table.set_precision(column, 1);
        table.set_scientific(column, true);
      }
    table.write_text(out, TableHandler::org_mode_table);
  }
} // namespace Setae
