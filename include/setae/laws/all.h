// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_laws_all_h
#define setae_laws_all_h

#include <setae/base/type_list.h>
#include <setae/laws/disk_cylinder.h>
#include <setae/laws/disk_disk.h>
#include <setae/laws/multipole.h>
#include <setae/laws/offset_disks.h>
#include <setae/laws/penalty_contact.h>

namespace Setae
{
  /** The laws that reduce the potential between the points of two fibers. */
  using PotentialLaws =
    TypeList<DiskDisk, OffsetDisks, DiskCylinder, Multipole<1>, Multipole<2>>;

  /** All interaction laws that a scene can choose from. */
  using Laws = PotentialLaws::with<PenaltyContact>;
} // namespace Setae

#endif
