// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_laws_all_h
#define setae_laws_all_h

#include <setae/base/type_list.h>
#include <setae/laws/disk_cylinder.h>
#include <setae/laws/disk_disk.h>
#include <setae/laws/oriented_disk_cylinder.h>
#include <setae/laws/section_quadrature.h>
#include <setae/laws/tabulated_disk_cylinder.h>

namespace Setae
{
  /** The interaction laws a scene can choose from. */
  using Laws = TypeList<DiskDisk,
                        DiskCylinder,
                        OrientedDiskCylinder,
                        SectionQuadrature,
                        TabulatedDiskCylinder>;
} // namespace Setae

#endif
