// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_assembly_strain_energy_h
#define setae_assembly_strain_energy_h

#include <setae/assembly/energy_term.h>
#include <setae/beams/all.h>

#include <memory>

namespace Setae
{
  /**
   * The strain energy of all fibers but the rigid ones.
   */
  class StrainEnergy : public EnergyTerm
  {
  public:
    explicit StrainEnergy(const FiberSystem &fibers);

    std::string
    name() const override
    {
      return "strain";
    }

    double
    assemble(const State  &state,
             const Request request,
             GlobalSystem &system) override;

    /**
     * Axial force and bending moment at the reference coordinate @p x of an
     * owned cell; zero in a rigid fiber, whose forces are not known.
     */
    SectionForces
    section_forces(const State       &state,
                   const unsigned int cell,
                   const double       x) const;

  private:
    const FiberSystem                &fibers;
    std::vector<unsigned int>         cells; ///< owned, of elastic fibers
    std::vector<TorsionFreeKirchhoff> beams; ///< of these cells
  };
} // namespace Setae

#endif
