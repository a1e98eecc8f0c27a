// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_assembly_interaction_h
#define setae_assembly_interaction_h

#include <setae/assembly/energy_term.h>
#include <setae/laws/point_potential.h>

#include <memory>

namespace Setae
{
  /** What the laws need to know of the sections of two fibers. */
  SectionPair
  section_pair(const InteractionParameters &parameters,
               const FiberParameters       &source,
               const FiberParameters       &target);

  /**
   * The potential of two points of fibers with these sections: as the scene
   * gives it, or such that parallel fibers feel by the law of the scene what it
   * says of them.
   */
  PointPotential
  point_potential(const InteractionParameters &parameters,
                  const SectionPair           &sections);

  /**
   * The interaction of the points of two groups of fibers by the law that
   * @p parameters name.
   *
   * @throws ExcParameter if the parameters do not fit the fibers.
   */
  std::unique_ptr<EnergyTerm>
  make_interaction(const FiberSystem           &fibers,
                   const InteractionParameters &parameters);
} // namespace Setae

#endif
