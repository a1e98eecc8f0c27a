// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_output_visualization_h
#define setae_output_visualization_h

#include <setae/assembly/energy_term.h>
#include <setae/assembly/strain_energy.h>
#include <setae/output/vtu.h>

#include <string>
#include <utility>
#include <vector>

namespace Setae
{
  /**
   * Writes a time series for ParaView into a directory: the fibers as lines
   * where they are, with displacement, tangent, radius, axial force and bending
   * moment (`fibers.pvd`), and the interaction forces as a cloud of points with
   * force per length and gap (`interaction.pvd`).
   */
  class Visualization
  {
  public:
    Visualization(const FiberSystem &fibers, const std::string &directory);

    /** Write one time; collective. */
    void
    write(const State                                    &state,
          const StrainEnergy                             &strain,
          const std::vector<std::unique_ptr<EnergyTerm>> &terms);

  private:
    void
    write_fibers(const State &state, const StrainEnergy &strain);

    void
    write_forces(const State                                    &state,
                 const std::vector<std::unique_ptr<EnergyTerm>> &terms);

    /** Write the @p points of all ranks, and add them to the @p files. */
    void
    write_time(const std::string                           &name,
               const double                                 time,
               PointFields                                 &points,
               std::vector<std::pair<double, std::string>> &files);

    const FiberSystem &fibers;
    std::string        directory; ///< ends with '/'
    unsigned int       counter = 0;

    std::vector<std::pair<double, std::string>> fiber_files, force_files;
  };
} // namespace Setae

#endif
