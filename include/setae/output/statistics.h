// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_output_statistics_h
#define setae_output_statistics_h

#include <deal.II/base/table_handler.h>

#include <setae/output/step_record.h>

#include <string>
#include <vector>

namespace Setae
{
  /**
   * The table of all load steps, `statistics.txt`: one line a step, the columns
   * named in the header, ready for gnuplot.
   */
  class Statistics
  {
  public:
    /** @p term_names: the column of each energy in Evaluation::energies. */
    explicit Statistics(const std::vector<std::string> &term_names);

    void
    add(const StepRecord &record);

    /** Replace the file as a whole, so that it is never half written. */
    void
    write(const std::string &directory) const;

  private:
    std::vector<std::string> term_names;
    dealii::TableHandler     table;
  };
} // namespace Setae

#endif
