// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <setae/base/exceptions.h>
#include <setae/output/statistics.h>

#include <cstdio>
#include <fstream>

namespace Setae
{
  Statistics::Statistics(const std::vector<std::string> &term_names)
    : term_names(term_names)
  {}



  void
  Statistics::add(const StepRecord &record)
  {
    const auto add_number = [this](const std::string &name,
                                   const double       value) {
      table.add_value(name, value);
      table.set_precision(name, 12);
      table.set_scientific(name, true);
    };

    table.add_value("step", record.step);
    add_number("time", record.time);
    add_number("step size", record.step_size);
    const char *axes[] = {"x", "y", "z"};
    for (const SupportReport &support : record.supports)
      for (unsigned int c = 0; c < 3; ++c)
        if (support.held[c])
          {
            const std::string suffix =
              std::string(" ") + axes[c] + " (" + support.name + ")";
            add_number("displacement" + suffix, support.displacement[c]);
            add_number("reaction" + suffix, support.reaction[c]);
          }
    for (const LoadReport &load : record.loads)
      for (unsigned int c = 0; c < 3; ++c)
        add_number(std::string("point displacement ") + axes[c] + " (" +
                     load.name + ")",
                   load.displacement[c]);
    for (unsigned int i = 0; i < term_names.size(); ++i)
      add_number(term_names[i] + " energy", record.evaluation.energies[i]);
    if (record.has_interactions)
      add_number("smallest gap", record.evaluation.gaps.smallest);
    add_number("residual", record.evaluation.residual_norm);
    table.add_value("iterations", record.n_iterations);
    table.add_value("rejected iterations", record.n_iterations_rejected);
    table.add_value("rejected steps", record.n_rejected);
    table.add_value("snap", record.is_snap ? 1 : 0);
    table.add_value("wall time", record.wall_time);
  }



  void
  Statistics::write(const std::string &directory) const
  {
    const std::string name      = directory + "/statistics.txt";
    const std::string temporary = name + ".new";
    {
      std::ofstream stream(temporary);
      table.write_text(
        stream, dealii::TableHandler::table_with_separate_column_description);
      AssertThrow(stream.good(),
                  ExcRun("The file '" + temporary + "' cannot be written."));
    }
    AssertThrow(std::rename(temporary.c_str(), name.c_str()) == 0,
                ExcRun("The file '" + name + "' cannot be written."));
  }
} // namespace Setae
