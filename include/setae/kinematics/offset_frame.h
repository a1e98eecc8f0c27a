// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_kinematics_offset_frame_h
#define setae_kinematics_offset_frame_h

#include <setae/kinematics/gap_angle.h>

#include <cmath>

namespace Setae
{
  /**
   * The axis along which the offset of two sections is measured. Of the source:
   * its tangent (ISSIP Sec. 5.3), averaged: the direction of the sum of both
   * tangents (eq. 47), of which one is turned around if they point to opposite
   * sides.
   */
  enum class OffsetAxis
  {
    averaged,
    source
  };



  /**
   * The invariants of two sections, of which the planes are taken as normal to
   * one axis @f$\tau@f$ (ISSIP eq. 17 and 48): with @f$d=r_1-r_2@f$, the offset
   * @f$q_1=d\cdot\tau@f$ [length] and the gap @f$q_2=\hat q_2-R_1-R_2@f$,
   * @f$\hat q_2=|d-q_1\tau|@f$ [length]. In space, the normal
   * @f$n=(d-q_1\tau)/\hat q_2@f$ takes the place of that of the plane.
   *
   * The axis is that of @f$b=t_1+t_2@f$, @f$t_1-t_2@f$ or @f$t_1@f$, with
   * @f$t_i=a_i/|a_i|@f$. The length of an averaged b is at least the square root
   * of two, but its direction jumps where @f$t_1\cdot t_2@f$ changes sign: two
   * fibers that cross at a right angle have no average. At exactly zero, the
   * sum is taken. The sign of the axis does not matter to laws even in the
   * offset.
   */
  class OffsetFrame
  {
  public:
    OffsetFrame(const PointPair &pair,
                const double     sum_of_radii,
                const OffsetAxis axis)
      : d(pair.r1 - pair.r2)
      , length_1(pair.a1.norm())
      , length_2(pair.a2.norm())
      , t1(pair.a1 / length_1)
      , t2(pair.a2 / length_2)
      , sign(axis == OffsetAxis::source ? 0. :
             t1 * t2 < 0.               ? -1. :
                                          1.)
      , b(t1 + sign * t2)
      , length_b(b.norm())
      , tau(b / length_b)
      , offset(d * tau)
      , height((d - offset * tau).norm())
      , gap(height - sum_of_radii)
    {}

    const Tensor<1, 3> d;
    const double       length_1, length_2;
    const Tensor<1, 3> t1, t2;
    const double       sign; ///< of t2 in b, zero if it does not matter
    const Tensor<1, 3> b;
    const double       length_b;
    const Tensor<1, 3> tau;
    const double       offset; ///< @f$q_1@f$
    const double       height; ///< @f$\hat q_2@f$
    const double       gap;    ///< @f$q_2@f$

    /**
     * The chain rule from the derivatives of a law in (offset, gap) to those in
     * the four vectors of the pair (ISSIP app. C and D, including the moments).
     * The Hessian is written if @p with_hessian. Sections on one axis have no
     * normal, and none is preferred: its terms are then left out.
     */
    PointPairEnergy
    energy(const OffsetGapDerivatives &law, const bool with_hessian) const;

  private:
    /** The Hessian in d and b, the axis not being normalised. */
    struct Hessian
    {
      Tensor<2, 3> dd, bd, bb;
    };

    Hessian
    hessian(const OffsetGapDerivatives &law,
            const Tensor<1, 3>         &n,
            const double                inverse_height) const;
  };



  inline PointPairEnergy
  OffsetFrame::energy(const OffsetGapDerivatives &law,
                      const bool                  with_hessian) const
  {
    using namespace PointPairIndex;

    const bool   has_normal     = height > 1e-12 * std::abs(offset);
    const double inverse_height = has_normal ? 1. / height : 0.;

    // dq1 = tau . dd + q2^ n . dtau,  dq2 = n . dd - q1 n . dtau, where
    // dtau = (I - tau tau) db / |b| and db = sum (I - t_i t_i) da_i / |a_i|.
    const Tensor<1, 3> n   = inverse_height * (d - offset * tau);
    const Tensor<1, 3> g_b = (law.o * height - law.g * offset) / length_b * n;
    const double       scale_1 = 1. / length_1, scale_2 = sign / length_2;
    const double       g_t1 = g_b * t1, g_t2 = g_b * t2;
    const Tensor<1, 3> g_1 = g_b - g_t1 * t1, g_2 = g_b - g_t2 * t2;

    PointPairEnergy result;
    result.value        = law.value;
    result.gradient[r1] = law.o * tau + law.g * n;
    result.gradient[r2] = -result.gradient[r1];
    result.gradient[a1] = scale_1 * g_1;
    result.gradient[a2] = scale_2 * g_2;
    if (!with_hessian)
      return result;

    // The projections of the Hessian in b, and the second derivatives of t_i.
    const auto [dd, bd, bb]  = hessian(law, n, inverse_height);
    const Tensor<1, 3> t1_bd = t1 * bd, t2_bd = t2 * bd;
    const Tensor<1, 3> t1_bb = t1 * bb, t2_bb = t2 * bb;
    const double       t1_bb_t1 = t1_bb * t1, t1_bb_t2 = t1_bb * t2,
                 t2_bb_t2 = t2_bb * t2;
    const double bend_1 = scale_1 * scale_1, bend_2 = sign * scale_2 * scale_2;
    auto        &H = result.hessian;
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = 0; j < 3; ++j)
        {
          const double I = i == j ? 1. : 0.;

          H[r1][r1][i][j] = H[r2][r2][i][j] = dd[i][j];
          H[r1][r2][i][j] = H[r2][r1][i][j] = -dd[i][j];

          const double a1r = scale_1 * (bd[i][j] - t1[i] * t1_bd[j]);
          H[a1][r1][i][j] = H[r1][a1][j][i] = a1r;
          H[a1][r2][i][j] = H[r2][a1][j][i] = -a1r;

          const double a2r = scale_2 * (bd[i][j] - t2[i] * t2_bd[j]);
          H[a2][r1][i][j] = H[r1][a2][j][i] = a2r;
          H[a2][r2][i][j] = H[r2][a2][j][i] = -a2r;

          H[a1][a1][i][j] =
            bend_1 * (bb[i][j] - t1[i] * t1_bb[j] - t1_bb[i] * t1[j] +
                      t1_bb_t1 * t1[i] * t1[j] - g_1[i] * t1[j] -
                      t1[i] * g_1[j] - g_t1 * (I - t1[i] * t1[j]));
          H[a2][a2][i][j] =
            bend_2 *
            (sign * (bb[i][j] - t2[i] * t2_bb[j] - t2_bb[i] * t2[j] +
                     t2_bb_t2 * t2[i] * t2[j]) -
             g_2[i] * t2[j] - t2[i] * g_2[j] - g_t2 * (I - t2[i] * t2[j]));
          H[a1][a2][i][j] = H[a2][a1][j][i] =
            scale_1 * scale_2 *
            (bb[i][j] - t1[i] * t1_bb[j] - t2_bb[i] * t2[j] +
             t1_bb_t2 * t1[i] * t2[j]);
        }
    return result;
  }



  inline OffsetFrame::Hessian
  OffsetFrame::hessian(const OffsetGapDerivatives &law,
                       const Tensor<1, 3>         &n,
                       const double                inverse_height) const
  {
    // The couple and its derivatives in offset and height.
    const double couple   = law.o * height - law.g * offset;
    const double couple_o = law.oo * height - law.og * offset - law.g;
    const double couple_g = law.og * height - law.gg * offset + law.o;

    // Along the third axis, I - tau tau - n n, only the directions turn.
    const double turn_dd   = law.g * inverse_height;
    const double turn_bd   = couple * inverse_height;
    const double turn_bb   = -couple * offset * inverse_height;
    const double twice     = couple_o * height - couple_g * offset;
    const double inverse_b = 1. / length_b;

    Hessian H;
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = 0; j < 3; ++j)
        {
          const double tt = tau[i] * tau[j], nn = n[i] * n[j],
                       nt = n[i] * tau[j], tn = tau[i] * n[j],
                       third = (i == j ? 1. : 0.) - tt - nn;
          H.dd[i][j] =
            law.oo * tt + law.og * (tn + nt) + law.gg * nn + turn_dd * third;
          H.bd[i][j] =
            inverse_b * (couple_o * nt + couple_g * nn + turn_bd * third);
          H.bb[i][j] = inverse_b * inverse_b *
                       (twice * nn - couple * (nt + tn) + turn_bb * third);
        }
    return H;
  }
} // namespace Setae

#endif
