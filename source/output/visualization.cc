// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <deal.II/base/data_out_base.h>

#include <setae/output/visualization.h>

#include <fstream>

namespace Setae
{
  using namespace dealii;

  namespace
  {
    /**
     * Patches that are made elsewhere, with the names of their data. Vectors
     * come first, three components each.
     */
    template <int dim>
    class PatchOutput : public DataOutInterface<dim, 3>
    {
    public:
      PatchOutput(const std::vector<std::string> &vector_names,
                  const std::vector<std::string> &scalar_names)
        : n_vectors(vector_names.size())
      {
        for (const std::string &name : vector_names)
          names.insert(names.end(), 3, name);
        names.insert(names.end(), scalar_names.begin(), scalar_names.end());
      }

      std::vector<DataOutBase::Patch<dim, 3>> patches;

      /** Write all ranks' patches, return the name of the record. */
      std::string
      write_time(const std::string &directory,
                 const std::string &name,
                 const unsigned int counter,
                 MPI_Comm           communicator) const
      {
        return this->write_vtu_with_pvtu_record(
          directory, name, counter, communicator, 5, 1);
      }

    private:
      const std::vector<DataOutBase::Patch<dim, 3>> &
      get_patches() const override
      {
        return patches;
      }

      std::vector<std::string>
      get_dataset_names() const override
      {
        return names;
      }

      std::vector<
        std::tuple<unsigned int,
                   unsigned int,
                   std::string,
                   DataComponentInterpretation::DataComponentInterpretation>>
      get_nonscalar_data_ranges() const override
      {
        std::vector<
          std::tuple<unsigned int,
                     unsigned int,
                     std::string,
                     DataComponentInterpretation::DataComponentInterpretation>>
          ranges;
        for (unsigned int v = 0; v < n_vectors; ++v)
          ranges.emplace_back(
            3 * v,
            3 * v + 2,
            names[3 * v],
            DataComponentInterpretation::component_is_part_of_vector);
        return ranges;
      }

      unsigned int             n_vectors;
      std::vector<std::string> names;
    };



    void
    write_record(const std::string                                 &directory,
                 const std::string                                 &name,
                 const std::vector<std::pair<double, std::string>> &files)
    {
      std::ofstream stream(directory + name);
      DataOutBase::write_pvd_record(stream, files);
    }
  } // namespace



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
    PatchOutput<1>     output({"displacement", "tangent", "bending_moment"},
                          {"radius", "axial_force", "fiber"});
    const unsigned int n_data = 12, n = fibers.scene.output.n_subdivisions;
    for (const unsigned int cell : fibers.owned_cells)
      {
        const HermiteCell<>     &current = state.current[cell];
        DataOutBase::Patch<1, 3> patch;
        patch.patch_index          = output.patches.size();
        patch.reference_cell       = ReferenceCells::Line;
        patch.n_subdivisions       = n;
        patch.vertices[0]          = Point<3>(current.position(0.));
        patch.vertices[1]          = Point<3>(current.position(1.));
        patch.points_are_available = true;
        patch.data.reinit(n_data + 3, n + 1);
        for (unsigned int i = 0; i <= n; ++i)
          {
            const double        x      = static_cast<double>(i) / n;
            const Tensor<1, 3>  r      = current.position(x);
            const Tensor<1, 3>  u      = state.displacement[cell].position(x);
            const Tensor<1, 3>  t      = current.derivative(x);
            const SectionForces forces = strain.section_forces(state, cell, x);
            for (unsigned int c = 0; c < 3; ++c)
              {
                patch.data(c, i)          = u[c];
                patch.data(3 + c, i)      = t[c] / t.norm();
                patch.data(6 + c, i)      = forces.bending_moment[c];
                patch.data(n_data + c, i) = r[c];
              }
            patch.data(9, i)  = fibers.parameters_of_cell(cell).radius;
            patch.data(10, i) = forces.axial_force;
            patch.data(11, i) = fibers.fiber_of_cell[cell];
          }
        output.patches.push_back(patch);
      }
    fiber_files.emplace_back(
      state.time,
      output.write_time(directory, "fibers", counter, fibers.communicator));
    if (Utilities::MPI::this_mpi_process(fibers.communicator) == 0)
      write_record(directory, "fibers.pvd", fiber_files);
  }



  void
  Visualization::write_forces(
    const State                                    &state,
    const std::vector<std::unique_ptr<EnergyTerm>> &terms)
  {
    std::vector<SiteForce> forces;
    for (const auto &term : terms)
      term->add_site_forces(state, forces);

    PatchOutput<0> output({"force_per_length"}, {"gap"});
    for (const SiteForce &site : forces)
      {
        DataOutBase::Patch<0, 3> patch;
        patch.patch_index = output.patches.size();
        patch.vertices[0] = Point<3>(site.position);
        patch.data.reinit(4, 1);
        for (unsigned int c = 0; c < 3; ++c)
          patch.data(c, 0) = site.force[c];
        patch.data(3, 0) = site.gap;
        output.patches.push_back(patch);
      }
    force_files.emplace_back(state.time,
                             output.write_time(directory,
                                               "interaction",
                                               counter,
                                               fibers.communicator));
    if (Utilities::MPI::this_mpi_process(fibers.communicator) == 0)
      write_record(directory, "interaction.pvd", force_files);
  }
} // namespace Setae
