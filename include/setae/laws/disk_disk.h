// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_laws_disk_disk_h
#define setae_laws_disk_disk_h

#include <setae/laws/gap_law.h>
#include <setae/laws/point_potential.h>
#include <setae/laws/short_range.h>

#include <string>

namespace Setae
{
  /**
   * Two disks in one plane at a small gap (SSIP eq. 30-31), integrated over
   * both centerlines:
   * @f[ \tilde{\tilde\pi}_m(g) = c_m\, g^{7/2-m}, \qquad
   *     g = |r_1-r_2|-R_1-R_2, \qquad m \ge 4. @f]
   * It knows nothing of the orientation of the disks: integrated over two
   * parallel cylinders it is too strong at small gaps.
   */
  class DiskDisk : public GapLaw<ShortRange>
  {
  public:
    static constexpr const char *name          = "disk-disk";
    static constexpr bool        is_long_range = false;

    /** Smallest exponent of the point potential for which the law exists. */
    static constexpr unsigned int smallest_exponent = 4;

    static std::string
    description()
    {
      return "section-section (SSIP): two coplanar disks at a small gap, "
             "integrated over both fibers, whose ends are flat";
    }

    DiskDisk(const PointPotential &potential,
             const SectionPair    &sections,
             const GapRange       &range)
      : GapLaw(ShortRange(terms(potential, sections), range))
    {}

    /**
     * The constant @f$c_m@f$ of SSIP eq. 31, in the form without a quotient of
     * large factorials, for any real exponent above 7/2.
     */
    static double
    coefficient(const double       exponent,
                const double       prefactor,
                const SectionPair &sections)
    {
      const double R1 = sections.radius_1, R2 = sections.radius_2;
      const double gamma = std::tgamma(exponent / 2.);
      return prefactor * sections.density_1 * sections.density_2 *
             std::pow(2., 2.5 - exponent) * std::pow(M_PI, 1.5) *
             std::sqrt(R1 * R2 / (R1 + R2)) * std::tgamma(exponent - 3.5) /
             (gamma * gamma);
    }

  private:
    static std::vector<InversePowers::Term>
    terms(const PointPotential &potential, const SectionPair &sections)
    {
      std::vector<InversePowers::Term> result;
      for (const InversePower &power : potential)
        result.push_back(
          {coefficient(power.exponent, power.prefactor, sections),
           power.exponent - 4});
      return result;
    }
  };
} // namespace Setae

#endif
