// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_benchmarks_comparison_h
#define setae_benchmarks_comparison_h

#include <deal.II/base/table_handler.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

namespace Setae
{
  /**
   * Where a measured number must lie for a figure to be reproduced. By default
   * anywhere: the number is for information.
   */
  struct Requirement
  {
    double lower = -std::numeric_limits<double>::infinity();
    double upper = std::numeric_limits<double>::infinity();

    static Requirement
    within(const double value, const double tolerance)
    {
      return {value - tolerance, value + tolerance};
    }

    static Requirement
    at_most(const double value)
    {
      return {-std::numeric_limits<double>::infinity(), value};
    }

    static Requirement
    at_least(const double value)
    {
      return {value, std::numeric_limits<double>::infinity()};
    }

    bool
    is_information() const
    {
      return std::isinf(lower) && std::isinf(upper);
    }

    /** False for NaN. */
    bool
    accepts(const double value) const
    {
      return is_information() || (value >= lower && value <= upper);
    }
  };



  /**
   * Published numbers beside measured ones, and what must be reached.
   */
  class Comparison
  {
  public:
    static constexpr double none = std::numeric_limits<double>::quiet_NaN();

    struct Row
    {
      std::string quantity;
      double      published; ///< or none
      double      measured;
      Requirement requirement = {};

      /** Measured again with twice the cells, and twice the Gauss points. */
      double with_cells = none, with_gauss_points = none;
    };

    void
    add(const Row &row)
    {
      rows.push_back(row);
    }

    bool
    succeeds() const
    {
      for (const Row &row : rows)
        if (!row.requirement.accepts(row.measured))
          return false;
      return true;
    }

    /** A table to read. */
    void
    print(std::ostream &out) const
    {
      const bool has_changes =
        std::any_of(rows.begin(), rows.end(), [](const Row &row) {
          return !std::isnan(row.with_cells) ||
                 !std::isnan(row.with_gauss_points);
        });

      dealii::TableHandler table;
      for (const Row &row : rows)
        {
          table.add_value("quantity", row.quantity);
          table.add_value("published", text(row.published, 3));
          table.add_value("measured", text(row.measured, 5));
          table.add_value("deviation", percent(row.measured, target(row)));
          if (has_changes)
            {
              table.add_value("2x cells",
                              percent(row.with_cells, row.measured));
              table.add_value("2x Gauss",
                              percent(row.with_gauss_points, row.measured));
            }
          table.add_value("must be", text(row.requirement));
          table.add_value("verdict", verdict(row));
        }
      table.write_text(out, dealii::TableHandler::org_mode_table);
    }

    /** The same for programs; deviations and changes in percent. */
    void
    write_csv(const std::string &file_name) const
    {
      std::ofstream csv(file_name);
      csv << "quantity,published,measured,deviation,change with 2x cells,"
             "change with 2x Gauss points,verdict\n";
      for (const Row &row : rows)
        csv << '"' << row.quantity << "\"," << text(row.published, 10) << ','
            << text(row.measured, 10) << ','
            << text(change(row.measured, target(row)), 4) << ','
            << text(change(row.with_cells, row.measured), 4) << ','
            << text(change(row.with_gauss_points, row.measured), 4) << ','
            << verdict(row) << '\n';
    }

  private:
    static double
    change(const double value, const double reference)
    {
      return 100. * (value / reference - 1.);
    }

    /** What a deviation refers to: not a number that is only a bound. */
    static double
    target(const Row &row)
    {
      return std::isinf(row.requirement.lower) ==
                 std::isinf(row.requirement.upper) ?
               row.published :
               none;
    }

    /** Nothing for NaN. */
    static std::string
    text(const double value, const unsigned int precision)
    {
      if (std::isnan(value))
        return "";
      std::ostringstream stream;
      stream.precision(precision);
      stream << value;
      return stream.str();
    }

    static std::string
    percent(const double value, const double reference)
    {
      const std::string number = text(change(value, reference), 2);
      return number.empty() ? number : number + "%";
    }

    static std::string
    text(const Requirement &requirement)
    {
      if (requirement.is_information())
        return "";
      if (std::isinf(requirement.lower))
        return "<= " + text(requirement.upper, 3);
      if (std::isinf(requirement.upper))
        return ">= " + text(requirement.lower, 3);
      return text(requirement.lower, 4) + " to " + text(requirement.upper, 4);
    }

    static std::string
    verdict(const Row &row)
    {
      if (row.requirement.is_information())
        return "";
      return row.requirement.accepts(row.measured) ? "reached" : "MISSED";
    }

    std::vector<Row> rows;
  };
} // namespace Setae

#endif
