// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_fibers_cross_section_h
#define setae_fibers_cross_section_h

#include <setae/beams/torsion_free_kirchhoff.h>
#include <setae/scene.h>

#include <cmath>

namespace Setae
{
  /** The area of a solid circular section [length^2]. */
  inline double
  area_of_circular_section(const FiberParameters &fiber)
  {
    return M_PI * fiber.radius * fiber.radius;
  }



  /**
   * The stiffness of a solid circular section: @f$EA=E\pi R^2@f$,
   * @f$EI=E\pi R^4/4@f$.
   */
  inline SectionStiffness
  circular_section(const FiberParameters &fiber)
  {
    const double area = area_of_circular_section(fiber);
    return {fiber.youngs_modulus * area,
            fiber.youngs_modulus * area * fiber.radius * fiber.radius / 4.};
  }
} // namespace Setae

#endif
