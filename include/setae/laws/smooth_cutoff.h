// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_laws_smooth_cutoff_h
#define setae_laws_smooth_cutoff_h

#include <setae/laws/inverse_powers.h>

#include <limits>

namespace Setae
{
  /**
   * A factor that falls from one to zero between the gaps @p begin and @p end,
   * @f$10y^3-15y^4+6y^5@f$ with y from 1 to 0. It has two continuous
   * derivatives, so neither force nor stiffness jumps when a pair of points
   * enters or leaves. @p end = infinity means that it is always one.
   */
  class CutoffSwitch
  {
  public:
    CutoffSwitch(const double begin = std::numeric_limits<double>::infinity(),
                 const double end   = std::numeric_limits<double>::infinity())
      : begin(begin)
      , end(end)
    {}

    template <typename Number>
    Number
    value(const Number &gap) const
    {
      if (gap >= end)
        return Number(0.);
      if (gap <= begin)
        return Number(1.);
      const Number y = (end - gap) / (end - begin);
      return y * y * y * (10. - y * (15. - 6. * y));
    }

    GapDerivatives
    derivatives(const double gap) const
    {
      if (gap >= end)
        return {};
      if (gap <= begin)
        return {1., 0., 0.};
      const double width = end - begin;
      const double x = (gap - begin) / width, y = (end - gap) / width;
      return {y * y * y * (10. - y * (15. - 6. * y)),
              -30. * x * x * y * y / width,
              -60. * x * y * (1. - 2. * x) / (width * width)};
    }

    double begin, end;
  };



  /**
   * Switches a function of the gap off by CutoffSwitch.
   */
  template <typename Function>
  class SmoothCutoff
  {
  public:
    SmoothCutoff(const Function &function, const double begin, const double end)
      : function(function)
      , factor(begin, end)
    {}

    /** The gap [length] from which on the function is zero. */
    double
    cutoff() const
    {
      return factor.end;
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
      if (gap >= factor.end)
        return Number(0.);
      if (gap <= factor.begin)
        return function.value(gap);
      return function.value(gap) * factor.value(gap);
    }

    GapDerivatives
    derivatives(const double gap) const
    {
      if (gap >= factor.end)
        return {};
      const GapDerivatives f = function.derivatives(gap);
      if (gap <= factor.begin)
        return f;
      const GapDerivatives s = factor.derivatives(gap);
      return {f.value * s.value,
              f.first * s.value + f.value * s.first,
              f.second * s.value + 2. * f.first * s.first + f.value * s.second};
    }

  private:
    Function     function;
    CutoffSwitch factor;
  };
} // namespace Setae

#endif
