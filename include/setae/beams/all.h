// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_beams_all_h
#define setae_beams_all_h

#include <setae/base/type_list.h>
#include <setae/beams/rigid.h>
#include <setae/beams/torsion_free_kirchhoff.h>

namespace Setae
{
  /** The beam formulations a fiber can choose from. */
  using Beams = TypeList<TorsionFreeKirchhoff, Rigid>;
} // namespace Setae

#endif
