// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <setae/output/files.h>
#include <setae/output/output_directory.h>
#include <setae/output/visualization.h>

#include <iomanip>
#include <sstream>

namespace Setae
{
  using namespace dealii;

  Visualization::Visualization(const FiberSystem &fibers,
                               const std::string &directory)
    : fibers(fibers)
    , directory(directory + "/")
  {}



  void
  Visualization::write(const State                                    &state,
                       const StrainEnergy                             &strain,
                       const std::vector<std::unique_ptr<EnergyTerm>> &terms)
  {
    write_fibers(state, strain);
    if (!fibers.scene.interactions.empty())
      write_forces(state, terms);
    ++counter;
  }



  void
  Visualization::write_fibers(const State &state, const StrainEnergy &strain)
  {
    const unsigned int n = fibers.scene.output.n_subdivisions;
    PointFields        points;
    points.fields            = {{"displacement", 3},
                                {"tangent", 3},
                                {"bending_moment", 3},
                                {"radius", 1},
                                {"axial_force", 1},
                                {"fiber", 1}};
    points.n_points_of_chain = n + 1;
    const auto add           = [&points](const Tensor<1, 3> &vector) {
      for (unsigned int c = 0; c < 3; ++c)
        points.values.push_back(vector[c]);
    };
    for (const unsigned int cell : fibers.owned_cells)
      for (unsigned int i = 0; i <= n; ++i)
        {
          const double        x      = static_cast<double>(i) / n;
          const Tensor<1, 3>  t      = state.current[cell].derivative(x);
          const SectionForces forces = strain.section_forces(state, cell, x);
          add(state.current[cell].position(x));
          add(state.displacement[cell].position(x));
          add(t / t.norm());
          add(forces.bending_moment);
          points.values.push_back(fibers.parameters_of_cell(cell).radius);
          points.values.push_back(forces.axial_force);
          points.values.push_back(fibers.fiber_of_cell[cell]);
        }
    write_time("fibers", state.time, points, fiber_files);
  }



  void
  Visualization::write_forces(
    const State                                    &state,
    const std::vector<std::unique_ptr<EnergyTerm>> &terms)
  {
    std::vector<SiteForce> forces;
    for (const auto &term : terms)
      term->add_site_forces(state, forces);

    PointFields points;
    points.fields = {{"force_per_length", 3}, {"gap", 1}};
    for (const SiteForce &site : forces)
      {
        for (const Tensor<1, 3> &vector : {site.position, site.force})
          for (unsigned int c = 0; c < 3; ++c)
            points.values.push_back(vector[c]);
        points.values.push_back(site.gap);
      }
    write_time("interaction", state.time, points, force_files);
  }



  void
  Visualization::write_time(const std::string                           &name,
                            const double                                 time,
                            PointFields                                 &points,
                            std::vector<std::pair<double, std::string>> &files)
  {
    // One file of all ranks: a full disk is noticed on the rank that tells.
    const std::vector<std::vector<double>> values =
      Utilities::MPI::gather(fibers.communicator, points.values);
    Files::on_first_rank(fibers.communicator, [&]() {
      points.values.clear();
      for (const std::vector<double> &of_rank : values)
        points.values.insert(points.values.end(),
                             of_rank.begin(),
                             of_rank.end());
      std::ostringstream file;
      file << name << '_' << std::setw(5) << std::setfill('0') << counter
           << ".vtu";
      Files::replace(directory + file.str(), vtu(points, mark_of_origin()));
      files.emplace_back(time, file.str());
      Files::replace(directory + name + ".pvd", pvd(files, mark_of_origin()));
    });
  }
} // namespace Setae
