// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_laws_multipole_h
#define setae_laws_multipole_h

#include <setae/laws/gap_law.h>
#include <setae/laws/inverse_distances.h>
#include <setae/laws/point_potential.h>
#include <setae/laws/short_range.h>

#include <cmath>
#include <string>

namespace Setae
{
  /** How many points, or how much charge, a fiber has per length. */
  inline double
  points_per_length(const double       radius,
                    const double       density,
                    const Distribution distribution)
  {
    return density * M_PI * radius *
           (distribution == Distribution::volume ? radius : 2.);
  }



  /**
   * Two sections as far apart as the points on their centerlines, integrated
   * over both fibers. With q points per length of a fiber, @f$q=\rho\pi R^2@f$
   * in its volume or @f$q=\sigma 2\pi R@f$ on its surface,
   * @f[ \tilde{\tilde\pi}_m(d) = q_1 q_2 k_m \left[ d^{-m} +
   *     m(m-1)\,(\kappa_1 R_1^2 + \kappa_2 R_2^2)\, d^{-m-2} \right],
   *     \qquad d = |r_1-r_2|, @f]
   * the first term (SSIP eq. 35, A.6) being the monopole. The second one, for
   * which @p order is 2, is the quadrupole: the mean of a function f over a
   * section is @f$f+\kappa R^2\,\Delta_\perp f@f$ up to the fourth order, with
   * the Laplacian in the plane of the section and @f$\kappa=1/8@f$ for a disk
   * and 1/4 for a circle. It differs from the Laplacian in space by the second
   * derivative along the fiber, whose integral is left at the ends of the fiber
   * only, so that no orientation occurs: exact to the fourth order but for the
   * ends. For Coulomb's potential, m = 1, it is zero, which is why the monopole
   * is as good as it is there.
   *
   * For the long-range exponents @f$m\le 3@f$ the far pairs of sections dominate
   * and the law holds for fibers at any gap; for larger exponents it needs a
   * gap of some radii.
   */
  template <unsigned int order>
  class Multipole : public GapLaw<SmoothCutoff<InverseDistances>>
  {
    static_assert(order == 1 || order == 2);

  public:
    static constexpr const char  *name = order == 1 ? "monopole" : "quadrupole";
    static constexpr bool         is_long_range     = true;
    static constexpr unsigned int smallest_exponent = 1;

    static std::string
    description()
    {
      return order == 1 ?
               "section-section at large distance: all points of a section as "
               "if on the centerline, for Coulomb and other long-range "
               "potentials, without a cutoff unless one is given; no points "
               "are beyond the ends, which are flat" :
               "the monopole with the next term in radius over distance";
    }

    Multipole(const PointPotential &potential,
              const SectionPair    &sections,
              const GapRange       &range)
      : GapLaw(SmoothCutoff<InverseDistances>(
          InverseDistances(terms(potential, sections),
                           sections.radius_1 + sections.radius_2),
          range.cutoff_begin,
          range.cutoff))
    {}

  private:
    static std::vector<InverseDistances::Term>
    terms(const PointPotential &potential, const SectionPair &sections)
    {
      const auto &[R1, R2, density_1, density_2, distribution] = sections;
      const double q1    = points_per_length(R1, density_1, distribution),
                   q2    = points_per_length(R2, density_2, distribution);
      const double kappa = distribution == Distribution::volume ? .125 : .25;

      std::vector<InverseDistances::Term> result;
      for (const auto &[m, k] : potential)
        {
          result.push_back({q1 * q2 * k, m});
          if (order == 2)
            result.push_back(
              {q1 * q2 * k * m * (m - 1.) * kappa * (R1 * R1 + R2 * R2),
               m + 2});
        }
      return result;
    }
  };
} // namespace Setae

#endif
