// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_benchmarks_laws_results_h
#define setae_benchmarks_laws_results_h

#include <deal.II/base/table_handler.h>

#include <fstream>
#include <functional>
#include <iostream>
#include <set>
#include <string>
#include <vector>

#include "../comparison.h"
#include "curve.h"
#include "exact.h"

namespace Setae
{
  namespace LawReport
  {
    /** One way to compute an Interaction. */
    struct Method
    {
      std::string                               name;
      std::function<Interaction(const Place &)> evaluate;
      std::string                               resolution =
        ""; ///< points or tolerance, if there are several
    };



    /**
     * All evaluations of a program: a CSV file with each of them, and a table
     * to read.
     */
    class Results
    {
    public:
      /** Evaluate methods at a place, with or without their CPU times. */
      void
      add(const Place               &place,
          const Exact               &exact,
          const std::vector<Method> &methods,
          const bool                 with_time)
      {
        for (const Method &method : methods)
          {
            const auto evaluate      = [&] { return method.evaluate(place); };
            const auto [value, time] = timed(evaluate, with_time);
            rows.push_back(
              {place,
               method.name,
               method.resolution,
               value,
               (value.energy - exact.value.energy) / exact.scale.energy,
               (value.force - exact.value.force) / exact.scale.force,
               time});
          }
      }

      /**
       * The exact number as a method of its own, with the estimates of its
       * errors.
       */
      void
      add_exact(const Place &place, const Exact &exact, const std::string &name)
      {
        rows.push_back({place,
                        name,
                        "",
                        exact.value,
                        exact.error.energy / std::abs(exact.scale.energy),
                        exact.error.force / std::abs(exact.scale.force),
                        exact.cpu_time});
      }

      const Curve &
      all() const
      {
        return rows;
      }

      Curve
      curve(const std::string &configuration,
            const std::string &potential,
            const std::string &method,
            const std::string &resolution = "") const
      {
        Curve result;
        for (const Row &row : rows)
          if (row.place.configuration == configuration &&
              row.place.potential == potential && row.method == method &&
              row.resolution == resolution)
            result.push_back(row);
        return result;
      }

      void
      write_csv(const std::string &file_name) const
      {
        std::ofstream csv(file_name);
        csv
          << "configuration,potential,method,resolution,gap/R,angle,offset/R,energy,"
             "force,energy error,force error,CPU time [s],curvature*R,R2/R\n";
        csv.precision(10);
        for (const Row &row : rows)
          csv << row.place.configuration << ',' << row.place.potential << ','
              << row.method << ',' << row.resolution << ',' << row.place.gap
              << ',' << row.place.angle << ',' << row.place.offset << ','
              << row.value.energy << ',' << row.value.force << ','
              << row.energy_error << ',' << row.force_error << ','
              << row.cpu_time << ',' << row.place.curvature << ','
              << row.place.radius_2 << '\n';
      }

      /**
       * A table for each configuration and potential: relative errors of the
       * energy and, after the slash, of the force at some of the places, and
       * the smallest CPU time.
       *
       * @param column The title of the column of a place to print, or nothing.
       */
      void
      print(std::ostream                                    &out,
            const std::function<std::string(const Place &)> &column) const
      {
        std::set<std::pair<std::string, std::string>> done;
        for (const Row &row : rows)
          {
            const std::string &configuration = row.place.configuration,
                              &potential     = row.place.potential;
            if (!done.insert({configuration, potential}).second)
              continue;
            out << '\n' << configuration << ", " << potential << '\n';
            print_table(out, configuration, potential, column);
          }
        out << "\nErrors of energy / force, relative to the sum of the "
               "magnitudes of all powers;\npositive: too strong.\n"
            << std::endl;
      }

    private:
      void
      print_table(std::ostream      &out,
                  const std::string &configuration,
                  const std::string &potential,
                  const std::function<std::string(const Place &)> &column) const
      {
        using Name = std::pair<std::string, std::string>;
        std::vector<Name> methods;
        for (const Row &row : rows)
          {
            const Name name = {row.method, row.resolution};
            if (row.place.configuration == configuration &&
                row.place.potential == potential &&
                std::find(methods.begin(), methods.end(), name) ==
                  methods.end())
              methods.push_back(name);
          }

        dealii::TableHandler table;
        for (const auto &[method, resolution] : methods)
          {
            double smallest_time = Comparison::none;
            table.add_value("method",
                            resolution.empty() ? method :
                                                 method + ", " + resolution);
            for (const Row &row :
                 curve(configuration, potential, method, resolution))
              {
                if (row.cpu_time < smallest_time || std::isnan(smallest_time))
                  smallest_time = row.cpu_time;
                const std::string title = column(row.place);
                if (!title.empty())
                  table.add_value(title,
                                  short_text(row.energy_error) + " / " +
                                    short_text(row.force_error));
              }
            table.add_value("CPU time [us]", short_text(1e6 * smallest_time));
            table.start_new_row();
          }
        table.set_auto_fill_mode(true);
        table.write_text(out, dealii::TableHandler::org_mode_table);
      }

      Curve rows;
    };



    /**
     * The program of a figure.
     *
     * @param name Of the CSV file.
     * @param evaluate Returns all evaluations.
     * @param compare Returns what these have to do with what is published.
     * @param column Of the printed table, see Results::print().
     * @return Of main().
     */
    inline int
    report(const std::string                                &name,
           const std::function<Results()>                   &evaluate,
           const std::function<Comparison(const Results &)> &compare,
           const std::function<std::string(const Place &)>  &column)
    {
      try
        {
          const Results results = evaluate();
          results.write_csv(name + ".csv");
          results.print(std::cout, column);
          const Comparison comparison = compare(results);
          comparison.print(std::cout);
          return comparison.succeeds() ? 0 : 1;
        }
      catch (const std::exception &error)
        {
          std::cerr << error.what() << std::endl;
          return 1;
        }
    }
  } // namespace LawReport
} // namespace Setae

#endif
