// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_laws_gap_law_h
#define setae_laws_gap_law_h

#include <setae/base/invariants.h>
#include <setae/base/law_derivatives.h>

#include <utility>

namespace Setae
{
  /**
   * A law of two sections that is a function of their gap alone, per length of
   * both fibers: what DiskDisk and Multipole have in common.
   *
   * @tparam GapFunction A function of the gap with a cutoff, for example
   * ShortRange.
   */
  template <typename GapFunction>
  class GapLaw
  {
  public:
    static constexpr Invariants depends_on = Invariants::gap;

    explicit GapLaw(GapFunction gap_function)
      : gap_function(std::move(gap_function))
    {}

    /** Energy per length squared and its derivatives with respect to the gap.
     */
    GapDerivatives
    operator()(const double gap) const
    {
      return gap_function.derivatives(gap);
    }

    /** The energy alone, on any number type. */
    template <typename Number>
    Number
    energy(const Number &gap) const
    {
      return gap_function.value(gap);
    }

    /** The gap [length] from which on the law is zero. */
    double
    cutoff() const
    {
      return gap_function.cutoff();
    }

    /** Whether the law can be evaluated at @p gap. */
    bool
    admits(const double gap) const
    {
      return gap_function.admits(gap);
    }

  private:
    GapFunction gap_function;
  };
} // namespace Setae

#endif
