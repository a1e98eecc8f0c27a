// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_laws_regularized_h
#define setae_laws_regularized_h

#include <setae/laws/inverse_powers.h>

namespace Setae
{
  /**
   * Continues a function of the gap below @p gap_regularization as its
   * second-order Taylor expansion there (SBIP eq. C26-C28), so that the force
   * is linear in the gap and finite for every gap, also a negative one. A
   * regularization gap of zero leaves the function as it is.
   *
   * An equilibrium whose smallest gap is above the regularization gap is an
   * equilibrium of the original function.
   */
  template <typename Function>
  class Regularized
  {
  public:
    Regularized(const Function &function, const double gap_regularization)
      : function(function)
      , gap_regularization(gap_regularization)
    {
      if (gap_regularization > 0.)
        expansion = function.derivatives(gap_regularization);
    }

    /** Whether the function is defined at @p gap. */
    bool
    admits(const double gap) const
    {
      return gap > 0. || gap_regularization > 0.;
    }

    template <typename Number>
    Number
    value(const Number &gap) const
    {
      if (gap >= gap_regularization)
        return function.value(gap);
      const Number x = gap - gap_regularization;
      return expansion.value +
             x * (expansion.first + .5 * x * expansion.second);
    }

    GapDerivatives
    derivatives(const double gap) const
    {
      if (gap >= gap_regularization)
        return function.derivatives(gap);
      const double x = gap - gap_regularization;
      return {expansion.value +
                x * (expansion.first + .5 * x * expansion.second),
              expansion.first + x * expansion.second,
              expansion.second};
    }

  private:
    Function       function;
    double         gap_regularization;
    GapDerivatives expansion;
  };
} // namespace Setae

#endif
