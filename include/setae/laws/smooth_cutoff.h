// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_laws_smooth_cutoff_h
#define setae_laws_smooth_cutoff_h

#include <setae/laws/inverse_powers.h>

#include <limits>

namespace Setae
{
  /**
   * Switches a function of the gap off between the gaps @p begin and @p end
   * by the factor @f$1-10x^3+15x^4-6x^5@f$, x from 0 to 1: the energy keeps two
   * continuous derivatives, so neither force nor stiffness jumps when a pair of
   * points enters or leaves. @p end = infinity means no cutoff.
   */
  template <typename Function>
  class SmoothCutoff
  {
  public:
    SmoothCutoff(const Function &function, const double begin, const double end)
      : function(function)
      , begin(begin)
      , end(end)
    {}

    /** The gap [length] from which on the function is zero. */
    double
    cutoff() const
    {
      return end;
    }

    /** Whether the function is defined at @p gap. */
    bool
    admits(const double gap) const
    {
      return function.admits(gap);
    }

    template <typename Number>
    Number
    value(const Number &gap) const
    {
      if (gap >= end)
        return Number(0.);
      if (gap <= begin)
        return function.value(gap);
      const Number x = (gap - begin) / (end - begin);
      return function.value(gap) *
             (1. - x * x * x * (10. - x * (15. - 6. * x)));
    }

    GapDerivatives
    derivatives(const double gap) const
    {
      if (gap >= end)
        return {};
      const GapDerivatives f = function.derivatives(gap);
      if (gap <= begin)
        return f;

      const double width = end - begin;
      const double x     = (gap - begin) / width;
      const double y     = 1. - x;
      const double s     = 1. - x * x * x * (10. - x * (15. - 6. * x));
      const double s_g   = -30. * x * x * y * y / width;
      const double s_gg  = -60. * x * y * (1. - 2. * x) / (width * width);
      return {f.value * s,
              f.first * s + f.value * s_g,
              f.second * s + 2. * f.first * s_g + f.value * s_gg};
    }

  private:
    Function function;
    double   begin;
    double   end;
  };
} // namespace Setae

#endif
