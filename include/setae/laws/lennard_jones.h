// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_laws_lennard_jones_h
#define setae_laws_lennard_jones_h

#include <setae/laws/disk_cylinder.h>

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
} // namespace Setae

#endif
