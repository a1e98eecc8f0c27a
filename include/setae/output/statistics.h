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
   * The table of all steps, `statistics.txt`: one line a step, the columns
   * named in the header, ready for gnuplot. A line is written as soon as it is
   * known, so that a run of many steps does not write all of them again and
   * again.
   */
  class Statistics
  {
  public:
    /** @p term_names: the column of each energy in Evaluation::energies. */
    explicit Statistics(const std::vector<std::string> &term_names);

    /** The step to write next. */
    void
    add(const StepRecord &record);

    /** Append the step to the file, which is empty before the first one. */
    void
    write(const std::string &directory);

  private:
    void
    add_number(const std::string &name, const double value);

    void
    add_motion(const MotionReport &motion);

    std::vector<std::string> term_names;
    dealii::TableHandler     table; ///< of one step
    bool                     is_new = true;
  };
} // namespace Setae

#endif
