// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <deal.II/base/config.h>

#include <setae/output/progress.h>
#include <setae/revision.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace Setae
{
  using namespace dealii;

  Progress::Progress(const ConditionalOStream       &out,
                     const Scene                    &scene,
                     const std::vector<std::string> &term_names,
                     const double                    silence)
    : out(out)
    , scene(scene)
    , term_names(term_names)
    , silence(silence)
    , last_line(std::chrono::steady_clock::now())
  {}



  void
  Progress::print_line(const std::string &line)
  {
    out << line << std::endl;
    last_line = std::chrono::steady_clock::now();
  }



  void
  Progress::print_header(const FiberSystem &fibers)
  {
    out << "Setae " << version << " (" << git_revision << "), deal.II "
        << DEAL_II_PACKAGE_VERSION << ", "
        << Utilities::MPI::n_mpi_processes(fibers.communicator) << " rank(s)\n"
        << (scene.title.empty() ? "" : scene.title + "\n")
        << fibers.fibers.size() << " fiber(s), " << fibers.initial.size()
        << " cells, " << fibers.dof_handler.n_dofs() << " degrees of freedom\n"
        << "Output directory: " << scene.output.directory << '\n'
        << std::endl;
  }



  void
  Progress::print_iteration(const IterationReport &report)
  {
    print_iteration("iteration", report);
  }



  void
  Progress::print_relaxation(const IterationReport &report)
  {
    print_iteration("overdamped motion, iteration", report);
  }



  void
  Progress::print_iteration(const std::string     &what,
                            const IterationReport &report)
  {
    const std::chrono::duration<double> since_last_line =
      std::chrono::steady_clock::now() - last_line;
    if (!scene.newton.log_iterations && since_last_line.count() < silence)
      return;
    std::ostringstream line;
    line << "    " << what << " " << std::setw(3) << report.iteration
         << "  residual " << std::scientific << std::setprecision(3)
         << report.residual_norm << "  increment " << report.increment_norm
         << "  factor " << report.factor;
    if (!scene.interactions.empty())
      line << "  gap " << report.smallest_gap;
    print_line(line.str());
  }



  void
  Progress::print_rejection(const std::string &reason)
  {
    if (scene.newton.log_iterations)
      print_line("    rejected: " + reason);
  }



  std::optional<double>
  Progress::expected_time(const StepRecord &record)
  {
    constexpr unsigned int n_steps       = 10;
    constexpr double       largest_ratio = 1.5;

    // Steps that stay as they are so early need not do so to the end.
    constexpr double least_part = .05;

    last_steps.emplace_back(record.time, record.wall_time);
    if (last_steps.size() > n_steps + 1)
      last_steps.pop_front();
    const double left = scene.end_time() - record.time;
    if (last_steps.size() <= n_steps || left <= 0. ||
        record.time < least_part * scene.end_time())
      return {};

    const auto pace = [this](const unsigned int begin, const unsigned int end) {
      const auto &[first_time, first_wall_time] = last_steps[begin];
      const auto &[last_time, last_wall_time]   = last_steps[end];
      return (last_wall_time - first_wall_time) / (last_time - first_time);
    };
    const double earlier = pace(0, n_steps / 2),
                 later   = pace(n_steps / 2, n_steps);
    if (std::max(earlier, later) > largest_ratio * std::min(earlier, later))
      return {};
    return record.wall_time + left * pace(0, n_steps);
  }



  void
  Progress::print_warning(const std::string &warning)
  {
    out << "warning: " << warning << std::endl;
  }



  void
  Progress::print_step(const StepRecord &record)
  {
    std::ostringstream line;
    line << "step " << std::setw(4) << record.step << "  t " << std::setw(10)
         << std::left << record.time << std::right << "  dt " << std::scientific
         << std::setprecision(1) << record.step_size << "  iterations "
         << std::setw(2) << record.n_iterations;
    if (record.n_rejected > 0)
      line << " (+" << record.n_iterations_rejected << " rejected)";
    line << std::setprecision(4);
    if (record.has_interactions)
      line << "  gap " << record.evaluation.gaps.smallest;
    line << "  energy";
    for (unsigned int i = 0; i < term_names.size(); ++i)
      line << ' ' << term_names[i] << ' ' << record.evaluation.energies[i];
    if (record.motion)
      line << " kinetic " << record.motion->momenta.kinetic_energy << " total "
           << record.motion->total_energy;
    line << std::fixed << std::setprecision(1) << "  " << record.wall_time
         << " s";
    if (const std::optional<double> expected = expected_time(record))
      line << " of about " << *expected << " s";
    if (record.is_snap)
      line << "  [snap to the next stable state]";
    print_line(line.str());
  }



  void
  Progress::print_summary(const RunSummary &summary)
  {
    out << '\n'
        << summary.n_steps << " steps, " << summary.n_iterations
        << " iterations (" << summary.n_rejected_iterations << " of them in "
        << summary.n_rejected_steps << " rejected steps), " << summary.n_snaps
        << " instabilities passed\n";
    if (scene.interactions.empty())
      return;
    if (!std::isfinite(summary.smallest_gap))
      {
        out << "No fibers have come near enough to interact in any step\n";
        return;
      }
    out << "Smallest gap of all steps: " << summary.smallest_gap << " "
        << summary.smallest_gap_place << '\n';
    for (const InteractionParameters &interaction : scene.interactions)
      if (interaction.regularization > 0.)
        {
          out << "'" << interaction.name << "' is regularized below "
              << interaction.regularization;
          if (summary.smallest_gap >= interaction.regularization)
            out << ": no step has a smaller gap, so the solution does not "
                   "depend on it\n";
          else
            out << ": there are smaller gaps, so the solution may depend on "
                   "it\n";
        }
  }
} // namespace Setae
