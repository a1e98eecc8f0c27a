// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_laws_tabulated_disk_cylinder_h
#define setae_laws_tabulated_disk_cylinder_h

#include <setae/base/spline_table.h>
#include <setae/laws/law_accuracy.h>
#include <setae/laws/oriented_disk_cylinder.h>

#include <string>
#include <vector>

namespace Setae
{
  /**
   * A disk and an infinite cylinder at any angle and any gap: the closed form
   * of OrientedDiskCylinder times a correction of order one for each power of
   * the point potential,
   * @f[ \tilde\pi = \frac1{\sqrt G}\sum_m P_m(H)\,C_m(x,y,z), @f]
   * tabulated at start-up from SectionIntegral, as its logarithm: however
   * coarse the table is, the sign is right.
   *
   * The coordinates are logarithms, because the scale of all changes is the
   * softened distance H itself: x of H, and with
   * @f$a^2=R_1^2+H^2@f$, @f$b^2=R_1^2\cos^2\alpha+H^2@f$, @f$Q^2=W+H^2@f$,
   * @f[ y = \frac{\ln(a/b)}{\ln(a/H)},\qquad z = \frac{\ln(a/Q)}{\ln(a/H)}. @f]
   * Parallel fibers are (0, 0), perpendicular ones (1, 0), a fiber that points
   * at the other one is (1, 1), and always z <= y. Beyond the diagonal the
   * values are extrapolated for the splines that cross it.
   *
   * C is held constant where H is below 1e-8 of the smaller or above 1e3 of the
   * larger radius; there the closed form has the right powers.
   */
  class TabulatedDiskCylinder : public ContactLaw<TabulatedDiskCylinder>
  {
  public:
    static constexpr const char *name = "tabulated-disk-cylinder";

    static std::string
    description()
    {
      return "section-beam: the closed form times a correction that is "
             "tabulated at start-up, right to 'law tolerance' at every angle "
             "and gap; all ends are flat";
    }

    TabulatedDiskCylinder(const PointPotential &potential,
                          const SectionPair    &sections,
                          const GapRange       &range,
                          const LawAccuracy    &accuracy);

    /** The law of the power number @p i of the potential alone. */
    TabulatedDiskCylinder
    single_power(const unsigned int i) const
    {
      TabulatedDiskCylinder result = *this;
      result.terms                 = {terms[i]};
      return result;
    }

    ContactDerivatives
    derivatives(const DiskContact<double> &contact) const;

    template <typename Number>
    Number
    value(const DiskContact<Number> &contact) const
    {
      using std::exp;
      using std::log;
      const Number H = held.value(contact.H), s = H * H, R = R1 * R1;
      const Number M = log((R + s) / s);
      const Number x = clamped(Number((log(s) - begin) / spacing));
      const Number y = n_angle / M * log((R + s) / (R * contact.C + s));
      const Number z = n_angle / M * log((R + s) / (contact.W + s));

      Number sum = 0.;
      for (const Term &term : terms)
        sum += term.powers.value(contact.H) *
               exp(Number(term.correction.value(x, y, z)));
      return sum * OrientedDiskCylinder::orientation_value(
                     R1, R2, H, contact.W, contact.C);
    }

  private:
    struct Term
    {
      Regularized<ContactPowers> powers;
      SplineTable                correction; ///< its logarithm
    };

    /** The logarithm of the correction at all nodes of the table. */
    std::vector<double>
    tabulate(const unsigned int exponent,
             const unsigned int n_depth,
             const unsigned int n_lateral) const;

    /** Held constant in the first and in the last cell. */
    template <typename Number>
    Number
    clamped(const Number &x) const
    {
      if (x < 1.)
        return Held(1.).value(x);
      if (x > n_distance - 1.)
        return double(n_distance) -
               Held(1.).value(Number(double(n_distance) - x));
      return x;
    }

    Held              held;
    unsigned int      n_distance, n_angle; ///< cells
    double            begin, spacing;      ///< of the logarithm of H^2
    std::vector<Term> terms;
  };
} // namespace Setae

#endif
