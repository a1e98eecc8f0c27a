// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_search_hull_distance_h
#define setae_search_hull_distance_h

#include <deal.II/base/tensor.h>

#include <algorithm>
#include <array>
#include <limits>

namespace Setae
{
  using dealii::Tensor;

  namespace internal
  {
    /**
     * The place in [0,1] where a quadratic function is smallest that descends
     * with slope @p descent at zero and has the given curvature.
     */
    inline double
    minimizer(const double descent, const double curvature)
    {
      return curvature > 0. ? std::clamp(descent / curvature, 0., 1.) : 0.;
    }
  } // namespace internal



  /**
   * The vector [length] from the chord of the first to the chord of the second
   * cell, both given by their Bernstein-Bezier control points [length], where
   * these are closest (Ericson, Real-Time Collision Detection, 2005, section
   * 5.1.9).
   */
  inline Tensor<1, 3>
  connecting_vector(const std::array<Tensor<1, 3>, 4> &first,
                    const std::array<Tensor<1, 3>, 4> &second)
  {
    using internal::minimizer;
    const Tensor<1, 3> u = first[3] - first[0];
    const Tensor<1, 3> v = second[3] - second[0];
    const Tensor<1, 3> r = second[0] - first[0];

    const double uu = u * u, uv = u * v, vv = v * v;
    const double ur = u * r, vr = v * r;

    // The first value is best if the second chord were a whole line. Then
    // each in turn is best for the other; after two steps both are.
    double       s = minimizer(ur * vv - vr * uv, uu * vv - uv * uv);
    const double t = minimizer(uv * s - vr, vv);
    s              = minimizer(uv * t + ur, uu);

    return r + t * v - s * u;
  }



  /**
   * A lower bound for the distance [length] of the convex hulls of the control
   * points, and so of the two curves: exact for straight ones.
   */
  inline double
  hull_distance(const std::array<Tensor<1, 3>, 4> &first,
                const std::array<Tensor<1, 3>, 4> &second)
  {
    const Tensor<1, 3> w    = connecting_vector(first, second);
    const double       norm = w.norm();
    if (norm == 0.)
      return 0.;
    double end_of_first    = std::numeric_limits<double>::lowest();
    double begin_of_second = std::numeric_limits<double>::max();
    for (unsigned int k = 0; k < 4; ++k)
      {
        end_of_first    = std::max(end_of_first, w * first[k]);
        begin_of_second = std::min(begin_of_second, w * second[k]);
      }
    return std::max(0., (begin_of_second - end_of_first) / norm);
  }
} // namespace Setae

#endif
