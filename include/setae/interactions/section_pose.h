// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_interactions_section_pose_h
#define setae_interactions_section_pose_h

#include <setae/base/jet.h>
#include <setae/interactions/site_projection.h>
#include <setae/kinematics/gap_angle.h>

#include <algorithm>
#include <type_traits>

namespace Setae
{
  /** Energy of a site that depends on the place of its closest point too. */
  struct PlacedEnergy
  {
    PointPairEnergy       pair;
    CoordinateDerivatives coordinate;
  };


  /**
   * How a section stands before a target whose ends matter, with
   * @f$d=r_1-r_2@f$ normal to the target at the closest point: all scalars are
   * smooth where a site is on the axis of the target.
   */
  template <typename Number>
  struct SectionPose
  {
    Number square; ///< @f$|d|^2@f$ [length^2]
    Number along;  ///< @f$t_1\cdot d@f$ [length]
    Number cosine; ///< @f$t_1\cdot t_2@f$
    Number x;      ///< coordinate of the closest point on its cell
    Number length; ///< of the derivative of the target there [length]
  };

  /** With the derivatives in all five scalars. */
  using PoseVariables = Jet<5>;

  inline SectionPose<PoseVariables>
  section_pose(const GapAngle &geometry, const double x)
  {
    return {PoseVariables::variable(0, geometry.d * geometry.d),
            PoseVariables::variable(1, geometry.d * geometry.t1),
            PoseVariables::variable(2, geometry.cosine),
            PoseVariables::variable(3, x),
            PoseVariables::variable(4, geometry.length_2)};
  }

  /** Whether the law of a section and a cylinder knows the tilt. */
  template <typename Law>
  inline constexpr bool has_tilt =
    std::is_invocable_v<Law, double, double, double>;

  /** A law of gap, angle and tilt that themselves have derivatives. */
  template <typename Law>
  PoseVariables
  evaluate_law(const Law           &law,
               const PoseVariables &gap,
               const PoseVariables &cosine,
               const PoseVariables &tilt)
  {
    GapAngleTiltDerivatives f;
    if constexpr (has_tilt<Law>)
      f = law(gap.val(), cosine.val(), tilt.val());
    else
      {
        const GapAngleDerivatives e = law(gap.val(), cosine.val());
        f.value = e.value, f.g = e.g, f.c = e.c;
        f.gg = e.gg, f.gc = e.gc, f.cc = e.cc;
      }
    return PoseVariables::function<3>(
      {{gap, cosine, tilt}},
      Jet<3>(f.value,
             {{f.g, f.c, f.t}},
             {{f.gg, f.gc, f.cc, f.gt, f.ct, f.tt}}));
  }

  /** The same on any other number type, as a reference. */
  template <typename Law, typename Number>
  Number
  evaluate_law(const Law    &law,
               const Number &gap,
               const Number &cosine,
               const Number &tilt)
  {
    if constexpr (has_tilt<Law>)
      return law.energy(gap, cosine, tilt);
    else
      return law.energy(gap, cosine);
  }

  /**
   * The chain rule from the scalars of the pose to the four vectors of the pair
   * and, explicitly, the coordinate of the closest point.
   */
  inline PlacedEnergy
  chain_rule(const PoseVariables &f, const GapAngle &geometry)
  {
    using namespace PointPairIndex;
    constexpr unsigned int n = 4, coordinate = 3;
    constexpr unsigned int variables[n] = {0, 1, 2, 4};

    // The gradients of |d|^2, s = t1.d, cosine and |a2| in the four vectors
    const auto        &d = geometry.d, &t1 = geometry.t1, &t2 = geometry.t2;
    const double       c = geometry.cosine, s = d * t1;
    const double       l1 = geometry.length_1, l2 = geometry.length_2;
    const Tensor<1, 3> q = d - s * t1, w1 = t2 - c * t1, w2 = t1 - c * t2;
    std::array<std::array<Tensor<1, 3>, 4>, n> G;
    G[0][r1] = 2. * d;
    G[0][r2] = -2. * d;
    G[1][r1] = t1;
    G[1][r2] = -t1;
    G[1][a1] = q / l1;
    G[2][a1] = w1 / l1;
    G[2][a2] = w2 / l2;
    G[3][a2] = t2;

    PlacedEnergy result;
    auto        &gradient = result.pair.gradient;
    auto        &H        = result.pair.hessian;
    result.pair.value     = f.val();
    result.coordinate.x   = f.d(coordinate);
    result.coordinate.xx  = f.dd(coordinate, coordinate);
    for (unsigned int k = 0; k < n; ++k)
      {
        const unsigned int i = variables[k];
        for (unsigned int v = 0; v < 4; ++v)
          {
            gradient[v] += f.d(i) * G[k][v];
            result.coordinate.gradient_x[v] +=
              f.dd(std::max(i, coordinate), std::min(i, coordinate)) * G[k][v];
          }
        for (unsigned int l = 0; l < n; ++l)
          {
            const unsigned int j    = variables[l];
            const double       f_ij = f.dd(std::max(i, j), std::min(i, j));
            for (unsigned int v = 0; v < 4; ++v)
              for (unsigned int w = 0; w < 4; ++w)
                H[v][w] += f_ij * outer_product(G[k][v], G[l][w]);
          }
      }

    // Their second derivatives
    const double f_s = f.d(1), f_c = f.d(2);
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = 0; j < 3; ++j)
        {
          const double I  = i == j ? 1. : 0.;
          const double I1 = I - t1[i] * t1[j], I2 = I - t2[i] * t2[j];

          const double rr = 2. * f.d(0) * I, ra = f_s / l1 * I1;
          H[r1][r1][i][j] += rr;
          H[r2][r2][i][j] += rr;
          H[r1][r2][i][j] -= rr;
          H[r2][r1][i][j] -= rr;
          H[r1][a1][i][j] += ra;
          H[a1][r1][i][j] += ra;
          H[r2][a1][i][j] -= ra;
          H[a1][r2][i][j] -= ra;
          H[a1][a1][i][j] -= (f_s * (q[i] * t1[j] + t1[i] * q[j] + s * I1) +
                              f_c * (w1[i] * t1[j] + t1[i] * w1[j] + c * I1)) /
                             (l1 * l1);
          H[a2][a2][i][j] +=
            f.d(4) / l2 * I2 -
            f_c * (w2[i] * t2[j] + t2[i] * w2[j] + c * I2) / (l2 * l2);
          const double a1a2 =
            f_c / (l1 * l2) * (I1 - t2[i] * t2[j] + c * t1[i] * t2[j]);
          H[a1][a2][i][j] += a1a2;
          H[a2][a1][j][i] += a1a2;
        }
    return result;
  }
} // namespace Setae

#endif
