// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_laws_disk_contact_h
#define setae_laws_disk_contact_h

#include <setae/base/law_derivatives.h>

#include <algorithm>
#include <cmath>

namespace Setae
{
  /**
   * How a disk of radius R1 stands before an infinite cylinder of radius R2.
   *
   * Seen along the axis of the cylinder the disk is an ellipse. In the
   * direction e, at the angle psi from the connecting vector n, it is separated
   * from the cylinder by
   * @f[ D-\sqrt{W},\qquad D=d\cos\psi-R_2,\qquad
   *     W=R_1^2\bigl(1-(t_1\cdot e)^2\bigr), @f]
   * and the largest of these is the true smallest distance. It is a poor
   * variable: where the disk turns its face to the cylinder it has a kink,
   * because the nearest point jumps from one side of the disk to the other.
   * Setae softens the edge of the disk by the gap itself,
   * @f$D-\sqrt{W+H^2}=H@f$, that is
   * @f[ H=\max_\psi\frac{D^2-W}{2D}, @f]
   * which is as smooth as the energy, equals the distance in the limit of small
   * gaps, lies between one half of it and all of it, and is positive wherever
   * disk and cylinder are apart.
   *
   * With the inclination W at the maximum and @f$C=\cos^2\alpha@f$ it describes
   * the disk completely: the map back to @f$(d^2,\tau^2d^2,C)@f$ is rational,
   * and the chain rule inverts its derivatives.
   */
  template <typename Number = double>
  struct DiskContact
  {
    Number H; ///< softened distance [length]
    Number W; ///< (R1 times the cosine between disk and e)^2 [length^2]
    Number C; ///< cos^2 of the angle between disk normal and cylinder axis

    /** Distance of disk and cylinder in the direction e [length]. */
    Number
    clearance() const
    {
      using std::sqrt;
      const Number Q = sqrt(W + H * H); // D = H + Q
      return 2. * (H + Q) * H / (H + Q + sqrt(W));
    }
  };



  /** Partial derivatives in the three variables of a DiskContact. */
  struct ContactDerivatives
  {
    double value = 0.;
    double H = 0., W = 0., C = 0.;
    double HH = 0., HW = 0., HC = 0., WW = 0., WC = 0., CC = 0.;

    ContactDerivatives &
    operator+=(const ContactDerivatives &f)
    {
      value += f.value;
      H += f.H;
      W += f.W;
      C += f.C;
      HH += f.HH;
      HW += f.HW;
      HC += f.HC;
      WW += f.WW;
      WC += f.WC;
      CC += f.CC;
      return *this;
    }

    /** The product with another function. */
    ContactDerivatives
    times(const ContactDerivatives &f) const
    {
      return {value * f.value,
              value * f.H + H * f.value,
              value * f.W + W * f.value,
              value * f.C + C * f.value,
              value * f.HH + 2. * H * f.H + HH * f.value,
              value * f.HW + H * f.W + W * f.H + HW * f.value,
              value * f.HC + H * f.C + C * f.H + HC * f.value,
              value * f.WW + 2. * W * f.W + WW * f.value,
              value * f.WC + W * f.C + C * f.W + WC * f.value,
              value * f.CC + 2. * C * f.C + CC * f.value};
    }
  };



  /**
   * Computes the DiskContact from the gap, @f$c=t_1\cdot t_2@f$ and the tilt
   * @f$\tau=t_1\cdot n@f$, and maps derivatives back.
   */
  class DiskContactMap
  {
  public:
    DiskContactMap(const double radius_1, const double radius_2)
      : R1(radius_1)
      , R2(radius_2)
    {}

    /** @p gap must be above -R1: the center of the disk is not in the cylinder.
     */
    DiskContact<double>
    contact(const double gap, const double cosine, const double tilt) const
    {
      const Invariants<double> x = invariants(gap, cosine, tilt);
      return contact(x, direction(x));
    }

    /**
     * The same on a number with derivatives: two Newton steps from the
     * converged direction give it its first and second derivatives.
     */
    template <typename Number>
    DiskContact<Number>
    contact(const Number &gap,
            const Number &cosine,
            const Number &tilt,
            const double  direction) const
    {
      const Invariants<Number> x = invariants(gap, cosine, tilt);
      Number                   u = direction;
      for (unsigned int i = 0; i < 2; ++i)
        {
          const Stationarity<Number> f = stationarity(x, u);
          u = u - f.value / f.slope;
        }
      return contact(x, u);
    }

    /** tan(psi) / (tilt sqrt(1 - cosine^2 - tilt^2)) of the direction e. */
    double
    direction(const double gap, const double cosine, const double tilt) const
    {
      return direction(invariants(gap, cosine, tilt));
    }

    /** Derivatives in (gap, cosine, tilt) of a function of the contact. */
    GapAngleTiltDerivatives
    derivatives(const DiskContact<double> &contact,
                const ContactDerivatives  &f,
                const double               gap,
                const double               cosine,
                const double               tilt) const;

    /** A number without its derivatives. */
    static double
    double_of(const double x)
    {
      return x;
    }

    template <typename Number>
    static double
    double_of(const Number &x)
    {
      return double_of(x.val());
    }

  private:
    /** Distance d and, with n and t2 n as axes, the squares of t1. */
    template <typename Number>
    struct Invariants
    {
      Number gap, d, C, T, S;
    };

    template <typename Number>
    Invariants<Number>
    invariants(const Number &gap,
               const Number &cosine,
               const Number &tilt) const
    {
      const Number C = cosine * cosine, T = tilt * tilt;
      Number       S = 1. - C - T;
      if (S < 0.) // by rounding
        S = S - double_of(S);
      return {gap, gap + (R1 + R2), C, T, S};
    }

    /** cos(psi), (t1.e)/tilt, D, W, Q at tan(psi) = tilt sqrt(S) u. */
    template <typename Number>
    struct Separation
    {
      Number cos_psi, w, sag, D, W, Q;
    };

    template <typename Number>
    Separation<Number>
    separation(const Invariants<Number> &x, const Number &u) const
    {
      using std::sqrt;
      Separation<Number> s;
      const Number       tan_square = x.S * x.T * u * u;
      s.cos_psi                     = 1. / sqrt(1. + tan_square);
      s.w                           = s.cos_psi * (1. + x.S * u);
      s.sag = x.d * tan_square * s.cos_psi * s.cos_psi / (1. + s.cos_psi);
      s.D   = x.gap + R1 - s.sag;
      s.W   = R1 * R1 * (1. - x.T * s.w * s.w);
      s.Q   = (s.D * s.D + s.W) / (2. * s.D);
      return s;
    }

    /**
     * The derivative of H by u, up to a negative factor, and its derivative:
     * the root is the direction e.
     */
    template <typename Number>
    struct Stationarity
    {
      Number value, slope, D;
    };

    template <typename Number>
    Stationarity<Number>
    stationarity(const Invariants<Number> &x, const Number &u) const
    {
      const Separation<Number> s    = separation(x, u);
      const Number             cos3 = s.cos_psi * s.cos_psi * s.cos_psi;
      const Number             rest = 1. - x.T * u;
      const Number             w_u  = x.S * cos3 * rest;
      const Number             D_u  = -x.d * x.S * x.T * u * cos3;
      const Number Q_u = (D_u * (s.D - s.Q) - R1 * R1 * x.T * s.w * w_u) / s.D;
      return {u * x.d * s.Q - R1 * R1 * s.w * rest,
              x.d * (s.Q + u * Q_u) - R1 * R1 * (w_u * rest - s.w * x.T),
              s.D};
    }

    double
    direction(const Invariants<double> &x) const;

    template <typename Number>
    DiskContact<Number>
    contact(const Invariants<Number> &x, const Number &u) const
    {
      const Separation<Number> s = separation(x, u);
      // D^2 - W without cancellation at a small gap
      const Number tilted = R1 * R1 * x.T * s.w * s.w;
      return {((x.gap - s.sag) * (s.D + R1) + tilted) / (2. * s.D), s.W, x.C};
    }

    double R1, R2;
  };
} // namespace Setae

#endif
