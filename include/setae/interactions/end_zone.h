// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_interactions_end_zone_h
#define setae_interactions_end_zone_h

#include <setae/fibers/cell_place.h>
#include <setae/laws/smooth_cutoff.h>

#include <algorithm>

namespace Setae
{
  /**
   * The part of a fiber next to its ends whose sections are integrated over
   * although the fiber is a target. There the other fiber is the infinite
   * cylinder of the law, so that an end is where an integral ends.
   *
   * A share of the sections, one at the end and zero inside, belongs to the
   * zone; as a target, the fiber fades by this share. It is a function of the
   * initial arc length from the end, one over the sum of the radii and then
   * fading over four times that.
   */
  class EndZone
  {
  public:
    /** A fiber that is shorter than two zones fades faster; one without room
     * for that is all zone. */
    EndZone(const double sum_of_radii, const double fiber_length)
      : full(sum_of_radii)
      , end(std::min(5. * sum_of_radii, .5 * fiber_length))
    {}

    /** Whether the fiber has nothing else. */
    bool
    is_all() const
    {
      return end < 2. * full;
    }

    /** Where the share begins to fall and where it is zero [length]. */
    double
    fading_begins() const
    {
      return full;
    }

    double
    fading_ends() const
    {
      return end;
    }

    /** The share at a coordinate of a cell. */
    double
    share(const CellPlace &place, const double x) const
    {
      if (is_all())
        return 1.;
      const CutoffSwitch fading(full, end);
      return fading.value(place.from_left + x * place.length) +
             fading.value(place.from_right + (1. - x) * place.length);
    }

    /** Whether any section of a cell has a share. */
    bool
    touches(const CellPlace &place) const
    {
      return is_all() || place.from_left < end || place.from_right < end;
    }

  private:
    double full, end;
  };
} // namespace Setae

#endif
