// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_laws_disk_cylinder_h
#define setae_laws_disk_cylinder_h

#include <setae/base/invariants.h>
#include <setae/laws/point_potential.h>
#include <setae/laws/short_range.h>

#include <string>

namespace Setae
{
  /**
   * A disk of the source fiber and an infinite cylinder along the tangent of
   * the target at the closest point (SBIP eq. 17), integrated over the source:
   * @f[ \tilde\pi_m(g,\alpha) = K_m \rho_1\rho_2
   *     \sqrt{\frac{2R_1R_2}{R_1\cos^2\alpha+R_2}}\; g^{9/2-m}, \qquad m\ge 6. @f]
   * Exact for parallel cylinders as the gap closes; at other angles the energy
   * of two crossing cylinders is overestimated, by 41% for equal radii at 90
   * degrees.
   */
  class DiskCylinder
  {
  public:
    static constexpr const char  *name              = "disk-cylinder";
    static constexpr Invariants   depends_on        = Invariants::gap_angle;
    static constexpr bool         is_long_range     = false;
    static constexpr unsigned int smallest_exponent = 6;

    static std::string
    description()
    {
      return "section-beam (SBIP): a disk of the source fiber and the cylinder "
             "that touches the target fiber at the closest point, integrated "
             "over the source fiber, whose ends are flat; those of the target "
             "are infinite cylinders unless 'target ends' makes them finite "
             "and flat";
    }

    DiskCylinder(const PointPotential &potential,
                 const SectionPair    &sections,
                 const GapRange       &range)
      : R1(sections.radius_1)
      , R2(sections.radius_2)
      , gap_function(terms(potential, sections), range)
    {}

    /**
     * @f$K_m@f$ of SBIP eq. 17 for any exponent; @f$K_6=\pi^2 k_6/24@f$ and
     * @f$K_{12}=143\pi^2 k_{12}/(15\cdot 2^{14})@f$ are SBIP eq. 18.
     */
    static double
    coefficient(const double exponent, const double prefactor)
    {
      return prefactor * M_PI * M_PI * std::pow(2., 3. - exponent) *
             std::tgamma(exponent - 4.5) /
             (std::tgamma((exponent - 1.) / 2.) * std::tgamma(exponent / 2.));
    }

    /** Energy per length of the source and its derivatives. */
    GapAngleDerivatives
    operator()(const double gap, const double cosine) const
    {
      const GapDerivatives p = gap_function.derivatives(gap);

      // The angular factor A = sqrt(2 R1 R2 / q), q = R1 c^2 + R2, and its
      // derivatives, SBIP eq. 22 and B12.
      const double q  = R1 * cosine * cosine + R2;
      const double A  = std::sqrt(2. * R1 * R2 / q);
      const double b  = R1 * cosine / q;
      const double A1 = -b * A;
      const double A2 = (3. * b * b - R1 / q) * A;
      return {A * p.value,
              A * p.first,
              A1 * p.value,
              A * p.second,
              A1 * p.first,
              A2 * p.value};
    }

    /** The energy alone, on any number type. */
    template <typename Number>
    Number
    energy(const Number &gap, const Number &cosine) const
    {
      using std::sqrt;
      return sqrt(2. * R1 * R2 / (R1 * cosine * cosine + R2)) *
             gap_function.value(gap);
    }

    /** The gap [length] from which on the law is zero. */
    double
    cutoff() const
    {
      return gap_function.cutoff();
    }

    /** Whether the law can be evaluated at @p gap. */
    bool
    admits(const double gap) const
    {
      return gap_function.admits(gap);
    }

  private:
    static std::vector<InversePowers::Term>
    terms(const PointPotential &potential, const SectionPair &sections)
    {
      std::vector<InversePowers::Term> result;
      for (const InversePower &power : potential)
        result.push_back({sections.density_1 * sections.density_2 *
                            coefficient(power.exponent, power.prefactor),
                          power.exponent - 5});
      return result;
    }

    double     R1;
    double     R2;
    ShortRange gap_function;
  };
} // namespace Setae

#endif
