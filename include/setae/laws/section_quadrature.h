// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_laws_section_quadrature_h
#define setae_laws_section_quadrature_h

#include <setae/base/jet.h>
#include <setae/laws/contact_law.h>
#include <setae/laws/contact_powers.h>
#include <setae/laws/law_accuracy.h>
#include <setae/laws/section_integral.h>

#include <string>
#include <vector>

namespace Setae
{
  /**
   * A disk and an infinite cylinder at any angle and gap, by quadrature over
   * the disk of the exact potential of the cylinder (SectionIntegral), with as
   * many points as the scene asks for. Its gradient and Hessian are those of
   * the quadrature itself, by forward differentiation in the three variables of
   * the contact.
   *
   * Regularized, it continues below @f$H_\mathrm{reg}@f$ as the Taylor
   * polynomial of second order of a power of H, scaled to meet it.
   */
  class SectionQuadrature : public ContactLaw<SectionQuadrature>
  {
  public:
    static constexpr const char *name = "section-quadrature";

    static std::string
    description()
    {
      return "section-beam: the same by quadrature over the disk, with the "
             "points that 'section points' asks for; exact at every angle and "
             "gap in the limit of many; all ends are flat";
    }

    SectionQuadrature(const PointPotential &potential,
                      const SectionPair    &sections,
                      const GapRange       &range,
                      const LawAccuracy    &accuracy)
      : ContactLaw<SectionQuadrature>(sections, range)
      , held(H_regularization)
    {
      for (const InversePower &power : potential)
        terms.push_back(
          {power.prefactor * sections.density_1 * sections.density_2,
           SectionIntegral(
             power.exponent, R1, R2, accuracy.n_depth, accuracy.n_lateral),
           ContactPowers({{power.exponent, 1.}}, {R1, R2, 1., 1.}),
           Regularized<ContactPowers>(ContactPowers({{power.exponent, 1.}},
                                                    {R1, R2, 1., 1.}),
                                      H_regularization)});
    }

    ContactDerivatives
    derivatives(const DiskContact<double> &contact) const
    {
      const Jet<3> f =
        value(DiskContact<Jet<3>>{Jet<3>::variable(0, contact.H),
                                  Jet<3>::variable(1, contact.W),
                                  Jet<3>::variable(2, contact.C)});
      return {f.val(),
              f.d(0),
              f.d(1),
              f.d(2),
              f.dd(0, 0),
              f.dd(1, 0),
              f.dd(2, 0),
              f.dd(1, 1),
              f.dd(2, 1),
              f.dd(2, 2)};
    }

    template <typename Number>
    Number
    value(const DiskContact<Number> &contact) const
    {
      // Keep the direction of the chords defined where the disk turns its face
      // to the cylinder: 1e-4 rad from there.
      constexpr double          tiny = 1e-8;
      const DiskContact<Number> at   = {held.value(contact.H),
                                        contact.W + tiny * R1 * R1,
                                        contact.C};
      Number                    sum  = 0.;
      for (const Term &term : terms)
        {
          const Number f = term.factor * term.integral(at);
          if (contact.H >= H_regularization)
            sum += f;
          else
            sum +=
              f * term.regularized.value(contact.H) / term.powers.value(at.H);
        }
      return sum;
    }

  private:
    struct Term
    {
      double                     factor;
      SectionIntegral            integral;
      ContactPowers              powers;
      Regularized<ContactPowers> regularized;
    };

    Held              held;
    std::vector<Term> terms;
  };
} // namespace Setae

#endif
