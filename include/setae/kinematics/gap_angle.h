// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_kinematics_gap_angle_h
#define setae_kinematics_gap_angle_h

#include <deal.II/base/tensor.h>

#include <setae/base/law_derivatives.h>

#include <array>
#include <type_traits>

namespace Setae
{
  using dealii::Tensor;

  /**
   * Two points of two curves: positions [length] and, along any parameter, the
   * derivatives of the curves there.
   */
  struct PointPair
  {
    Tensor<1, 3> r1, a1, r2, a2;
  };

  /** The places of the four vectors of a PointPair in its derivatives. */
  namespace PointPairIndex
  {
    inline constexpr unsigned int r1 = 0, a1 = 1, r2 = 2, a2 = 3;
  }

  /** Energy of a PointPair with gradient and Hessian in its four vectors. */
  struct PointPairEnergy
  {
    double                                     value = 0.;
    std::array<Tensor<1, 3>, 4>                gradient;
    std::array<std::array<Tensor<2, 3>, 4>, 4> hessian;
  };



  /**
   * The invariants of a disk and a cylinder: gap @f$g=|r_1-r_2|-R_1-R_2@f$
   * [length], @f$c=\cos\alpha=t_1\cdot t_2@f$ with @f$t_i=a_i/|a_i|@f$ and the
   * tilt @f$t=t_1\cdot n@f$ along the connecting vector @f$n=(r_1-r_2)/|r_1-r_2|@f$.
   * The laws are even in c and in t, so the orientation of the fibers does not
   * matter.
   */
  class GapAngle
  {
  public:
    GapAngle(const PointPair &pair, const double sum_of_radii)
      : d(pair.r1 - pair.r2)
      , distance(d.norm())
      , n(d / distance)
      , length_1(pair.a1.norm())
      , length_2(pair.a2.norm())
      , t1(pair.a1 / length_1)
      , t2(pair.a2 / length_2)
      , gap(distance - sum_of_radii)
      , cosine(t1 * t2)
      , tilt(t1 * n)
    {}

    const Tensor<1, 3> d;
    const double       distance;
    const Tensor<1, 3> n;
    const double       length_1, length_2;
    const Tensor<1, 3> t1, t2;
    const double       gap;
    const double       cosine;
    const double       tilt;

    /**
     * The chain rule from the derivatives of a law in (gap, cosine) or in (gap,
     * cosine, tilt) to those in the four vectors of the pair (SBIP eq. 23-25
     * and B13-B25, here at a fixed point of the target). The Hessian is written
     * if
     * @p with_hessian.
     */
    template <typename LawDerivatives>
    PointPairEnergy
    energy(const LawDerivatives &law, const bool with_hessian) const
    {
      constexpr bool has_tilt =
        std::is_same_v<LawDerivatives, GapAngleTiltDerivatives>;

      using namespace PointPairIndex;

      // dg = n . (dr1 - dr2),  dc = w1 . da1 + w2 . da2
      const Tensor<1, 3> w1 = (t2 - cosine * t1) / length_1;
      const Tensor<1, 3> w2 = (t1 - cosine * t2) / length_2;

      PointPairEnergy result;
      result.value        = law.value;
      result.gradient[r1] = law.g * n;
      result.gradient[r2] = -law.g * n;
      result.gradient[a1] = law.c * w1;
      result.gradient[a2] = law.c * w2;

      // dt = m . (dr1 - dr2) + w3 . da1
      Tensor<1, 3> m, w3;
      if constexpr (has_tilt)
        {
          m  = (t1 - tilt * n) / distance;
          w3 = (n - tilt * t1) / length_1;
          result.gradient[r1] += law.t * m;
          result.gradient[r2] -= law.t * m;
          result.gradient[a1] += law.t * w3;
        }
      if (!with_hessian)
        return result;

      // The products of two gradients and, times law.g and law.c, the second
      // derivatives of g and c; I is the identity.
      const double lateral = law.g / distance;
      const double mixed   = law.c / (length_1 * length_2);
      const double bend_1  = law.c / length_1;
      const double bend_2  = law.c / length_2;
      auto        &H       = result.hessian;
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = 0; j < 3; ++j)
          {
            const double I = i == j ? 1. : 0.;

            double rr = law.gg * n[i] * n[j] + lateral * (I - n[i] * n[j]);
            if constexpr (has_tilt)
              rr += (law.gt - law.t / distance) * (n[i] * m[j] + m[i] * n[j]) +
                    law.tt * m[i] * m[j] -
                    law.t * tilt / (distance * distance) * (I - n[i] * n[j]);
            H[r1][r1][i][j] = H[r2][r2][i][j] = rr;
            H[r1][r2][i][j] = H[r2][r1][i][j] = -rr;

            double ra1 = law.gc * n[i] * w1[j];
            if constexpr (has_tilt)
              ra1 += (law.gt - law.t / distance) * n[i] * w3[j] +
                     law.ct * m[i] * w1[j] + law.tt * m[i] * w3[j] +
                     law.t / (distance * length_1) * (I - t1[i] * t1[j]);
            H[r1][a1][i][j] = H[a1][r1][j][i] = ra1;
            H[r2][a1][i][j] = H[a1][r2][j][i] = -ra1;

            double ra2 = law.gc * n[i] * w2[j];
            if constexpr (has_tilt)
              ra2 += law.ct * m[i] * w2[j];
            H[r1][a2][i][j] = H[a2][r1][j][i] = ra2;
            H[r2][a2][i][j] = H[a2][r2][j][i] = -ra2;

            H[a1][a1][i][j] =
              law.cc * w1[i] * w1[j] -
              bend_1 * (t1[i] * w1[j] + w1[i] * t1[j] +
                        cosine / length_1 * (I - t1[i] * t1[j]));
            if constexpr (has_tilt)
              H[a1][a1][i][j] += law.ct * (w1[i] * w3[j] + w3[i] * w1[j]) +
                                 law.tt * w3[i] * w3[j] -
                                 law.t / length_1 *
                                   (t1[i] * w3[j] + w3[i] * t1[j] +
                                    tilt / length_1 * (I - t1[i] * t1[j]));
            H[a2][a2][i][j] =
              law.cc * w2[i] * w2[j] -
              bend_2 * (t2[i] * w2[j] + w2[i] * t2[j] +
                        cosine / length_2 * (I - t2[i] * t2[j]));

            double a1a2 = law.cc * w1[i] * w2[j] +
                          mixed * (I - t1[i] * t1[j] - t2[i] * t2[j] +
                                   cosine * t1[i] * t2[j]);
            if constexpr (has_tilt)
              a1a2 += law.ct * w3[i] * w2[j];
            H[a1][a2][i][j] = H[a2][a1][j][i] = a1a2;
          }
      return result;
    }
  };
} // namespace Setae

#endif
