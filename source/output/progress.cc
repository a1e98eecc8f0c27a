// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <deal.II/base/config.h>

#include <setae/output/progress.h>
#include <setae/revision.h>

#include <iomanip>
#include <sstream>

namespace Setae
{
  using namespace dealii;

  Progress::Progress(const ConditionalOStream       &out,
                     const Scene                    &scene,
                     const std::vector<std::string> &term_names)
    : out(out)
    , scene(scene)
    , term_names(term_names)
  {}



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
    if (!scene.newton.log_iterations)
      return;
    std::ostringstream line;
    line << "    iteration " << std::setw(3) << report.iteration
         << "  residual " << std::scientific << std::setprecision(3)
         << report.residual_norm << "  increment " << report.increment_norm
         << "  factor " << report.factor;
    if (!scene.interactions.empty())
      line << "  gap " << report.smallest_gap;
    out << line.str() << std::endl;
  }



  void
  Progress::print_rejection(const std::string &reason)
  {
    if (scene.newton.log_iterations)
      out << "    rejected: " << reason << std::endl;
  }



  void
  Progress::print_warning(const std::string &warning)
  {
    out << "warning: " << warning << std::endl;
  }



  void
  Progress::print_step(const StepRecord &record)
  {
    const double       progress = record.time / scene.end_time();
    std::ostringstream line;
    line << "step " << std::setw(4) << record.step << "  t " << std::fixed
         << std::setprecision(6) << record.time << "  dt " << std::scientific
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
    if (progress > 0. && progress < 1.)
      line << " of about " << record.wall_time / progress << " s";
    if (record.is_snap)
      line << "  [snap to the next stable state]";
    out << line.str() << std::endl;
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
    out << "Smallest gap of all steps: " << summary.smallest_gap << '\n';
    for (const InteractionParameters &interaction : scene.interactions)
      if (interaction.regularization > 0.)
        out << "Regularized below " << interaction.regularization
            << ": no step has a smaller gap, so the solution does not depend "
               "on it\n";
  }
} // namespace Setae
