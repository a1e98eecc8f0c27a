// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_laws_lennard_jones_h
#define setae_laws_lennard_jones_h

#include <boost/math/tools/minima.hpp>

#include <setae/laws/disk_cylinder.h>
#include <setae/laws/parallel_fibers.h>

#include <cmath>
#include <limits>

namespace Setae
{
  /**
   * The Lennard-Jones potential of two infinite parallel cylinders with
   * equilibrium gap @p equilibrium_gap [length] and smallest (most attractive)
   * force per length @p force_minimum [force/length], a negative number
   * (SBIP eq. 31-32).
   *
   * The force @f$f=\tfrac32 K_6' g^{-5/2}+\tfrac{15}{2}K_{12}' g^{-17/2}@f$
   * vanishes at @f$g_\mathrm{eq}^6=-5K_{12}'/K_6'@f$ and is smallest at
   * @f$g_\mathrm{min}^6=\tfrac{17}{5}g_\mathrm{eq}^6@f$, where
   * @f$f_\mathrm{min}=\tfrac{18}{17}K_6' g_\mathrm{min}^{-5/2}@f$.
   */
  inline PointPotential
  lennard_jones_of_cylinders(const double       equilibrium_gap,
                             const double       force_minimum,
                             const SectionPair &sections)
  {
    const double R1 = sections.radius_1, R2 = sections.radius_2;
    const double scale = sections.density_1 * sections.density_2 *
                         std::sqrt(2. * R1 * R2 / (R1 + R2));

    const double gap_minimum = equilibrium_gap * std::pow(17. / 5., 1. / 6.);
    const double K6  = 17. / 18. * force_minimum * std::pow(gap_minimum, 2.5);
    const double K12 = -K6 * std::pow(equilibrium_gap, 6) / 5.;
    return {{6, K6 / (scale * DiskCylinder::coefficient(6, 1.))},
            {12, K12 / (scale * DiskCylinder::coefficient(12, 1.))}};
  }



  /**
   * The prefactor of attraction of a material with the Hamaker constant
   * @f$A=-\pi^2\rho_1\rho_2k_6@f$ [energy] between points of the two number
   * densities.
   */
  inline InversePower
  attraction_of_hamaker_constant(const double       hamaker_constant,
                                 const SectionPair &sections)
  {
    return {6,
            -hamaker_constant /
              (M_PI * M_PI * sections.density_1 * sections.density_2)};
  }



  /**
   * Lennard-Jones' potential by a law that is linear in its prefactors, as two
   * infinite parallel fibers feel it: without regularization and cutoff.
   *
   * @tparam Law One of PotentialLaws with a short range.
   */
  template <typename Law>
  class LennardJonesOfLaw
  {
  public:
    /**
     * @param attraction, repulsion The law of @f$-r^{-6}@f$ and of
     * @f$r^{-12}@f$ alone.
     */
    LennardJonesOfLaw(const Law         &attraction,
                      const Law         &repulsion,
                      const SectionPair &sections)
      : attraction(attraction)
      , repulsion(repulsion)
      , sum_of_radii(sections.radius_1 + sections.radius_2)
    {}

    /** The ratio -k12/k6 with which the force vanishes at @p equilibrium_gap
     * [length^6]. */
    double
    repulsion_over_attraction(const double equilibrium_gap) const
    {
      return -force(attraction, equilibrium_gap) /
             force(repulsion, equilibrium_gap);
    }

    /**
     * The potential with which the force per length vanishes at
     * @p equilibrium_gap [length] and is @p force_minimum [force/length], a
     * negative number, where it attracts most.
     */
    PointPotential
    potential(const double equilibrium_gap, const double force_minimum) const
    {
      // For powers of the gap the force is smallest at 1.12 (far apart) to
      // 1.23 (near) times the equilibrium gap. Boost's tolerance is an absolute
      // one for small arguments.
      constexpr double farthest = 2.;
      const double     ratio    = repulsion_over_attraction(equilibrium_gap);
      const double     smallest =
        boost::math::tools::brent_find_minima(
          [&](const double x) {
            const double gap = x * equilibrium_gap;
            return force(attraction, gap) + ratio * force(repulsion, gap);
          },
          1.,
          farthest,
          std::numeric_limits<double>::digits / 2)
          .second;
      const double factor = force_minimum / smallest;
      return {{6, -factor}, {12, factor * ratio}};
    }

  private:
    double
    force(const Law &law, const double gap) const
    {
      return parallel_fibers(law, sum_of_radii, gap).force;
    }

    Law    attraction, repulsion;
    double sum_of_radii;
  };
} // namespace Setae

#endif
