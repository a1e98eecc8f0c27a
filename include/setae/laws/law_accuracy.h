// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_laws_law_accuracy_h
#define setae_laws_law_accuracy_h

namespace Setae
{
  /** How exact a law that is computed and not written has to be. */
  struct LawAccuracy
  {
    unsigned int n_depth   = 4;    ///< points of a section inwards
    unsigned int n_lateral = 9;    ///< points of a section along its edge
    double       tolerance = 5e-4; ///< relative error of a tabulated law
  };
} // namespace Setae

#endif
