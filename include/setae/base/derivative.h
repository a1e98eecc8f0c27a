// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_base_derivative_h
#define setae_base_derivative_h

#include <deal.II/base/tensor.h>

#include <functional>

namespace Setae
{
  /** The derivatives of a curve on both sides of a point. */
  struct SidedDerivatives
  {
    dealii::Tensor<1, 3> left, right;

    /** An estimate of the error of both. */
    double error = 0.;

    /** The derivative of a curve that is smooth at the point. */
    dealii::Tensor<1, 3>
    mean() const
    {
      return .5 * (left + right);
    }
  };



  /**
   * The derivatives of @p curve at @p s, from values in
   * [@p lower, @p upper] only.
   *
   * They are those of Chebyshev series of the curve in an interval around @p s,
   * or in one that begins or ends there if @p s is an end of the range or the
   * curve is not smooth in it. Terms that are lost in round-off are cut off, as
   * in Chebfun (Trefethen 2013, Sec. 9). The interval begins with @p spacing on
   * each side and is halved until the series converges, so that round-off of
   * values of size |r| leaves about eps |r| / spacing.
   *
   * @param spacing The distance within which the curve may be taken as smooth,
   * for example a cell; at most @p upper - @p lower.
   */
  SidedDerivatives
  differentiate_within(const std::function<dealii::Tensor<1, 3>(double)> &curve,
                       const double                                       s,
                       const double                                       lower,
                       const double                                       upper,
                       const double spacing);
} // namespace Setae

#endif
