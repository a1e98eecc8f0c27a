// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <setae/output/files.h>
#include <setae/output/statistics.h>

#include <sstream>

namespace Setae
{
  namespace
  {
    const char *const axes[] = {"x", "y", "z"};
  }



  Statistics::Statistics(const std::vector<std::string> &term_names)
    : term_names(term_names)
  {}



  void
  Statistics::add_number(const std::string &name, const double value)
  {
    table.add_value(name, value);
    table.set_precision(name, 12);
    table.set_scientific(name, true);
  }



  void
  Statistics::add_motion(const MotionReport &motion)
  {
    add_number("kinetic energy", motion.momenta.kinetic_energy);
    add_number("total energy", motion.total_energy);
    add_number("support work", motion.support_work);
    add_number("external work", motion.external_work);
    add_number("dissipated energy", motion.dissipation);
    add_number("numerical dissipation", motion.numerical_dissipation);
    add_number("energy balance", motion.balance());
    for (unsigned int c = 0; c < 3; ++c)
      add_number(std::string("linear momentum ") + axes[c],
                 motion.momenta.linear[c]);
    for (unsigned int c = 0; c < 3; ++c)
      add_number(std::string("angular momentum ") + axes[c],
                 motion.momenta.angular[c]);
  }



  void
  Statistics::add(const StepRecord &record)
  {
    table.clear();
    table.add_value("step", record.step);
    add_number("time", record.time);
    add_number("step size", record.step_size);
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
    if (record.motion)
      add_motion(*record.motion);
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
  Statistics::write(const std::string &directory)
  {
    std::ostringstream text;
    table.write_text(
      text, dealii::TableHandler::table_with_separate_column_description);

    // The columns are described once.
    std::istringstream lines(text.str());
    std::string        new_text, line;
    while (std::getline(lines, line))
      if (is_new || line[0] != '#')
        new_text += line + '\n';

    Files::append(directory + "/statistics.txt", new_text);
    is_new = false;
  }
} // namespace Setae
