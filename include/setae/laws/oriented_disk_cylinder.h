// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_laws_oriented_disk_cylinder_h
#define setae_laws_oriented_disk_cylinder_h

#include <setae/laws/contact_law.h>
#include <setae/laws/contact_powers.h>

#include <string>

namespace Setae
{
  /**
   * A disk and an infinite cylinder at any angle, in closed form:
   * @f[ \tilde\pi = \sum_m \frac{P_m(H)}{\sqrt G},\qquad
   *     G=\frac{Q^3}{R_1^2}+\frac{R_1^2\cos^2\alpha+H^2}{R_2},\qquad
   *     Q^2 = W+H^2, @f]
   * with H and W of DiskContact and P of ContactPowers. Near its edge the disk
   * sees a half-space. The integral over the depth gives one over its
   * inclination @f$\cos\theta=\sqrt W/R_1@f$, that along its edge one over the
   * root of the curvature @f$\cos\theta/R_1+\cos^2\alpha/(R_2\cos^2\theta)@f$;
   * the product is @f$R_1\sqrt{2/G}@f$ but for the softening by H.
   *
   * Exact as the gap closes: without tilt and with parallel fibers it is
   * DiskCylinder (SBIP eq. 17), and integrated over crossing cylinders it gives
   * their asymptotic energy at every angle.
   */
  class OrientedDiskCylinder : public ContactLaw<OrientedDiskCylinder>
  {
  public:
    static constexpr const char *name = "oriented-disk-cylinder";

    static std::string
    description()
    {
      return "section-beam: a disk of the source fiber, however it leans, and "
             "the cylinder that touches the target fiber, in closed form; exact "
             "at every angle as the gap closes; all ends are flat";
    }

    OrientedDiskCylinder(const PointPotential &potential,
                         const SectionPair    &sections,
                         const GapRange       &range)
      : ContactLaw<OrientedDiskCylinder>(sections, range)
      , held(H_regularization)
      , powers(ContactPowers(potential, sections), H_regularization)
    {}

    ContactDerivatives
    derivatives(const DiskContact<double> &contact) const
    {
      const GapDerivatives     h = held.derivatives(contact.H);
      const ContactDerivatives r =
        orientation(R1, R2, h.value, contact.W, contact.C);
      return product(powers.derivatives(contact.H), h, r);
    }

    template <typename Number>
    Number
    value(const DiskContact<Number> &contact) const
    {
      return powers.value(contact.H) * orientation_value(R1,
                                                         R2,
                                                         held.value(contact.H),
                                                         contact.W,
                                                         contact.C);
    }

    /** @f$G^{-1/2}@f$ with its derivatives in H, W and C. */
    static ContactDerivatives
    orientation(const double R1,
                const double R2,
                const double H,
                const double W,
                const double C)
    {
      const double Q   = std::sqrt(W + H * H);
      const double a   = 1. / (R1 * R1);
      const double G   = Q * Q * Q * a + (R1 * R1 * C + H * H) / R2;
      const double G_W = 1.5 * Q * a, G_C = R1 * R1 / R2,
                   G_H  = 2. * H * (G_W + 1. / R2);
      const double G_WW = .75 * a / Q, G_HW = 2. * H * G_WW,
                   G_HH = 2. * (G_W + 1. / R2) + 2. * H * G_HW;

      const double i = 1. / G, r = std::sqrt(i);
      const double first = -.5 * r * i, second = .75 * r * i * i;
      return {r,
              first * G_H,
              first * G_W,
              first * G_C,
              first * G_HH + second * G_H * G_H,
              first * G_HW + second * G_H * G_W,
              second * G_H * G_C,
              first * G_WW + second * G_W * G_W,
              second * G_W * G_C,
              second * G_C * G_C};
    }

    template <typename Number>
    static Number
    orientation_value(const double  R1,
                      const double  R2,
                      const Number &H,
                      const Number &W,
                      const Number &C)
    {
      using std::sqrt;
      const Number Q = sqrt(W + H * H);
      return 1. / sqrt(Q * Q * Q / (R1 * R1) + (R1 * R1 * C + H * H) / R2);
    }

    /** p(H) f(h(H), W, C) */
    static ContactDerivatives
    product(const GapDerivatives     &p,
            const GapDerivatives     &h,
            const ContactDerivatives &f)
    {
      const double f_H  = f.H * h.first;
      const double f_HH = f.HH * h.first * h.first + f.H * h.second;
      return {p.value * f.value,
              p.first * f.value + p.value * f_H,
              p.value * f.W,
              p.value * f.C,
              p.second * f.value + 2. * p.first * f_H + p.value * f_HH,
              p.first * f.W + p.value * f.HW * h.first,
              p.first * f.C + p.value * f.HC * h.first,
              p.value * f.WW,
              p.value * f.WC,
              p.value * f.CC};
    }

  private:
    Held                       held;
    Regularized<ContactPowers> powers;
  };
} // namespace Setae

#endif
