// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_benchmarks_program_sections_h
#define setae_benchmarks_program_sections_h

#include <deal.II/base/timer.h>

#include <fstream>
#include <map>
#include <sstream>
#include <string>

namespace Setae
{
  /** What the clocks of the program say about one part of it. */
  struct ProgramSection
  {
    double cpu_time = 0.; ///< [s]
    double n_calls  = 0.;

    /** [s] */
    double
    per_call() const
    {
      return cpu_time / n_calls;
    }
  };

  using ProgramSections = std::map<std::string, ProgramSection>;



  inline ProgramSections
  program_sections(const dealii::TimerOutput &timer)
  {
    ProgramSections result;
    for (const auto &[name, seconds] :
         timer.get_summary_data(dealii::TimerOutput::total_cpu_time))
      result[name].cpu_time = seconds;
    for (const auto &[name, n] :
         timer.get_summary_data(dealii::TimerOutput::n_calls))
      result[name].n_calls = n;
    return result;
  }



  inline std::string
  read_file(const std::string &name)
  {
    std::ifstream stream(name);
    AssertThrow(stream.good(), dealii::ExcFileNotOpen(name));
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
  }
} // namespace Setae

#endif
