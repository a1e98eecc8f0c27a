// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_beams_rigid_h
#define setae_beams_rigid_h

#include <string>

namespace Setae
{
  /**
   * A fiber that does not deform: it has no strain energy, and what no support
   * prescribes stays at rest. It may have any curve.
   */
  struct Rigid
  {
    static constexpr const char *name = "rigid";

    static std::string
    description()
    {
      return "keeps its shape and stays where it is unless supports move it";
    }
  };
} // namespace Setae

#endif
