// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_laws_offset_disks_h
#define setae_laws_offset_disks_h

#include <setae/base/invariants.h>
#include <setae/laws/disk_disk.h>
#include <setae/laws/offset_power.h>
#include <setae/laws/smooth_cutoff.h>

#include <array>
#include <string>

namespace Setae
{
  /**
   * Two disks in parallel planes at a small gap (ISSIP eq. 28), integrated over
   * both centerlines:
   * @f[ \phi_m(q_1,q_2) = c_m\, q_2^{7/2-m}\; {}_2F_1\left(\tfrac{2m-7}4,
   *     \tfrac{2m-5}4;\tfrac m2;-\tfrac{q_1^2}{q_2^2}\right), \qquad m\ge 4, @f]
   * with the offset @f$q_1@f$ between the planes and the gap @f$q_2@f$ that the
   * disks have when one is moved into the plane of the other. The constant is
   * that of DiskDisk, which is the law at @f$q_1=0@f$. Integrated over an
   * infinite parallel fiber it gives the law of two parallel cylinders, also
   * that of DiskCylinder. Evaluated by OffsetPower.
   *
   * Below the regularization gap @f$g@f$, the law continues at every offset as
   * its expansion of second order in the gap, @f$\phi(q_1,g)+x\,\phi_{,2}(q_1,g)
   * +\tfrac12x^2\phi_{,22}(q_1,g)@f$, @f$x=q_2-g@f$: with two continuous
   * derivatives, finite for every gap and offset. The cutoff acts on the
   * distance of the centers without the radii,
   * @f$\sqrt{q_1^2+(q_2+R_1+R_2)^2}-R_1-R_2@f$, as in all other laws (ISSIP
   * Sec. 6.5: the radius c around a section, less the two radii).
   */
  class OffsetDisks
  {
  public:
    static constexpr const char *name          = "offset-disks";
    static constexpr Invariants  depends_on    = Invariants::gap_offset;
    static constexpr bool        is_long_range = false;

    /** Smallest exponent of the point potential for which the law exists. */
    static constexpr unsigned int smallest_exponent = 4;

    static std::string
    description()
    {
      return "section-section with offset (ISSIP): two disks in parallel planes "
             "at a small gap, integrated over both fibers, whose ends are flat";
    }

    OffsetDisks(const PointPotential &potential,
                const SectionPair    &sections,
                const GapRange       &range)
      : sum_of_radii(sections.radius_1 + sections.radius_2)
      , regularization(range.regularization)
      , factor(range.cutoff_begin, range.cutoff)
    {
      for (const InversePower &power : potential)
        {
          const unsigned int m = power.exponent;
          const double c = DiskDisk::coefficient(m, power.prefactor, sections);
          terms.push_back(
            {{{OffsetPower(m, 0), OffsetPower(m, 1), OffsetPower(m, 2)}},
             {{c, c * (3.5 - m), c * (3.5 - m) * (2.5 - m)}}});
        }
    }

    /** Energy per length squared and its derivatives. */
    OffsetGapDerivatives
    operator()(const double offset, const double gap) const
    {
      const double distance     = std::hypot(offset, gap + sum_of_radii);
      const double distance_gap = distance - sum_of_radii;
      if (distance_gap >= factor.end)
        return {};
      const OffsetGapDerivatives f =
        gap >= regularization ? power_law(offset, gap) : expansion(offset, gap);
      if (distance_gap <= factor.begin)
        return f;

      const GapDerivatives s       = factor.derivatives(distance_gap);
      const double         o       = offset / distance;
      const double         g       = (gap + sum_of_radii) / distance;
      const double         lateral = s.first / distance;
      return {f.value * s.value,
              f.o * s.value + f.value * s.first * o,
              f.g * s.value + f.value * s.first * g,
              f.oo * s.value + 2. * f.o * s.first * o +
                f.value * (s.second * o * o + lateral * g * g),
              f.og * s.value + (f.o * g + f.g * o) * s.first +
                f.value * (s.second - lateral) * o * g,
              f.gg * s.value + 2. * f.g * s.first * g +
                f.value * (s.second * g * g + lateral * o * o)};
    }

    /** The energy alone, on any number type. */
    template <typename Number>
    Number
    energy(const Number &offset, const Number &gap) const
    {
      using std::sqrt;
      Number sum = 0.;
      for (const Term &t : terms)
        if (gap >= regularization)
          sum += t.c[0] * t.powers[0].value(offset, gap);
        else
          {
            const Number g = regularization;
            const Number x = gap - regularization;
            sum += t.c[0] * t.powers[0].value(offset, g) +
                   x * (t.c[1] * t.powers[1].value(offset, g) +
                        .5 * x * t.c[2] * t.powers[2].value(offset, g));
          }
      const Number height = gap + sum_of_radii;
      return sum *
             factor.value(Number(
               sqrt(Number(offset * offset + height * height)) - sum_of_radii));
    }

    /** The gap [length] between the centers from which on the law is zero. */
    double
    cutoff() const
    {
      return factor.end;
    }

    /** Whether the law can be evaluated at @p gap and any offset. */
    bool
    admits(const double gap) const
    {
      return gap > 0. || regularization > 0.;
    }

  private:
    /** A power of the gap and its derivatives, with their coefficients. */
    struct Term
    {
      std::array<OffsetPower, 3> powers;
      std::array<double, 3>      c;
    };

    OffsetGapDerivatives
    power_law(const double offset, const double gap) const
    {
      OffsetGapDerivatives sum;
      for (const Term &t : terms)
        sum += t.c[0] * t.powers[0].derivatives(offset, gap);
      return sum;
    }

    /** The expansion about the regularization gap. */
    OffsetGapDerivatives
    expansion(const double offset, const double gap) const
    {
      const double         x = gap - regularization;
      OffsetGapDerivatives sum;
      for (const Term &t : terms)
        {
          const auto at_regularization = [&](const unsigned int k) {
            return t.c[k] * t.powers[k].derivatives(offset, regularization);
          };
          const OffsetGapDerivatives p0 = at_regularization(0),
                                     p1 = at_regularization(1),
                                     p2 = at_regularization(2);
          sum += {p0.value + x * (p1.value + .5 * x * p2.value),
                  p0.o + x * (p1.o + .5 * x * p2.o),
                  p1.value + x * p2.value,
                  p0.oo + x * (p1.oo + .5 * x * p2.oo),
                  p1.o + x * p2.o,
                  p2.value};
        }
      return sum;
    }

    double            sum_of_radii;
    double            regularization;
    CutoffSwitch      factor;
    std::vector<Term> terms;
  };
} // namespace Setae

#endif
