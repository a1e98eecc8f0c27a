// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_laws_all_h
#define setae_laws_all_h

#include <setae/base/type_list.h>
#include <setae/laws/disk_cylinder.h>
#include <setae/laws/disk_disk.h>
#include <setae/laws/multipole.h>
#include <setae/laws/offset_disks.h>
#include <setae/laws/oriented_disk_cylinder.h>
#include <setae/laws/penalty_contact.h>
#include <setae/laws/section_quadrature.h>
#include <setae/laws/tabulated_disk_cylinder.h>

#include <type_traits>

namespace Setae
{
  /** The laws that reduce the potential between the points of two fibers. */
  using PotentialLaws = TypeList<DiskDisk,
                                 OffsetDisks,
                                 DiskCylinder,
                                 OrientedDiskCylinder,
                                 SectionQuadrature,
                                 TabulatedDiskCylinder,
                                 Multipole<1>,
                                 Multipole<2>>;

  /** All interaction laws that a scene can choose from. */
  using Laws = PotentialLaws::with<PenaltyContact>;

  /** A law of PotentialLaws, with an accuracy if it is computed, not written.
   */
  template <typename Law>
  Law
  make_law(const PointPotential &potential,
           const SectionPair    &sections,
           const GapRange       &range,
           const LawAccuracy    &accuracy = {})
  {
    if constexpr (std::is_constructible_v<Law,
                                          PointPotential,
                                          SectionPair,
                                          GapRange,
                                          LawAccuracy>)
      return Law(potential, sections, range, accuracy);
    else
      return Law(potential, sections, range);
  }
} // namespace Setae

#endif
