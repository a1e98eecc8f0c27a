// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_laws_short_range_h
#define setae_laws_short_range_h

#include <setae/laws/inverse_powers.h>
#include <setae/laws/regularized.h>
#include <setae/laws/smooth_cutoff.h>

#include <limits>

namespace Setae
{
  /**
   * Where a law is regularized and where it is cut off, all as gaps between the
   * surfaces [length].
   */
  struct GapRange
  {
    double regularization = 0.; ///< 0 means none
    double cutoff_begin   = std::numeric_limits<double>::infinity();
    double cutoff         = std::numeric_limits<double>::infinity();
  };

  /**
   * Inverse powers of the gap, regularized below and cut off above: the
   * dependence on the gap of every short-range law.
   */
  class ShortRange : public SmoothCutoff<Regularized<InversePowers>>
  {
  public:
    ShortRange(std::vector<InversePowers::Term> terms, const GapRange &range)
      : SmoothCutoff<Regularized<InversePowers>>(
          Regularized<InversePowers>(InversePowers(std::move(terms)),
                                     range.regularization),
          range.cutoff_begin,
          range.cutoff)
    {}
  };
} // namespace Setae

#endif
