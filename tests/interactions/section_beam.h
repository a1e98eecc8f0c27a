// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_tests_interactions_section_beam_h
#define setae_tests_interactions_section_beam_h

// Configurations of a site and a target cell, and their evaluation by hand and
// by automatic differentiation.

#include <setae/interactions/section_beam.h>
#include <setae/laws/disk_cylinder.h>
#include <setae/laws/lennard_jones.h>

#include <limits>
#include <random>

#include "../nested_sacado.h"
#include "cell_pair.h"

namespace Setae
{
  namespace SectionBeamTests
  {
    inline constexpr double infinity = std::numeric_limits<double>::infinity();
    inline constexpr double weight   = 1.7;

    /**
     * A law in which gap and angle are equally important at distances of order
     * one, so that no part of the tangent matrix is small beside another.
     */
    struct BalancedLaw
    {
      double
      cutoff() const
      {
        return infinity;
      }

      bool
      admits(const double) const
      {
        return true;
      }

      GapAngleDerivatives
      operator()(const double g, const double c) const
      {
        const double A = 2. + c + c * c, A_c = 1. + 2. * c, A_cc = 2.;
        const double B = 1. + g - g * g, B_g = 1. - 2. * g, B_gg = -2.;
        return {A * B, A * B_g, A_c * B, A * B_gg, A_c * B_g, A_cc * B};
      }

      template <typename Number>
      Number
      energy(const Number &g, const Number &c) const
      {
        return (2. + c + c * c) * (1. + g - g * g);
      }
    };

    using Balanced     = SectionBeam<BalancedLaw>;
    using LennardJones = SectionBeam<DiskCylinder>;

    inline constexpr double gap_equilibrium = 1e-3;

    inline LennardJones
    lennard_jones(const GapRange    &range,
                  const SectionPair &sections = {.02, .03, 1., 1.})
    {
      return {
        DiskCylinder(lennard_jones_of_cylinders(gap_equilibrium, -1., sections),
                     sections,
                     range),
        sections.radius_1 + sections.radius_2};
    }

    /** A source site and its target. */
    struct Configuration
    {
      CellPair  cells;
      double    x     = .3;
      CellPlace place = {};
    };

    template <typename Interaction>
    LocalSystem<24>
    by_hand(const Interaction &interaction, const Configuration &c)
    {
      LocalSystem<24> local;
      interaction.add(site_at(c.cells.source, c.x),
                      c.cells.target,
                      c.place,
                      weight,
                      Request::tangent,
                      local);
      local.symmetrize();
      return local;
    }

    template <typename Interaction>
    LocalSystem<24>
    by_sacado(const Interaction &interaction, const Configuration &c)
    {
      const auto    q      = variables<24>(c.cells.coefficients());
      const auto    source = cell_of(q, 0, c.cells.source.h);
      const auto    target = cell_of(q, 12, c.cells.target.h);
      NestedFad<24> energy = 0.;
      for (const Projection &projection : closest_points(
             c.cells.target, c.cells.source.position(c.x), c.place.ends))
        energy += weight * interaction.energy(source.position(c.x),
                                              source.derivative(c.x),
                                              target,
                                              projection);
      return local_system<24>(energy);
    }

    /**
     * A random pair of cells such that the point at @p xi of the target is a
     * closest one to the site and @p distance from it. The ratio of the distance
     * to the radius of curvature of the target in that direction lies between
     * the bounds; above zero the site is on the inner side.
     */
    inline Configuration
    random_configuration(std::mt19937 &random,
                         const double  bend,
                         const double  xi,
                         const double  distance,
                         const double  smallest_ratio = -infinity,
                         const double  largest_ratio  = .5)
    {
      for (unsigned int i = 0; i < 100000; ++i)
        {
          Configuration  result;
          HermiteCell<> &source = result.cells.source,
                        &target = result.cells.target;
          source = random_cell(random_direction(random), .4, bend, random);
          target =
            random_cell(1.2 * random_direction(random), .5, bend, random);

          const Tensor<1, 3> tangent = target.derivative(xi);
          const Tensor<1, 3> d = distance * random_normal_to(tangent, random);
          const double       ratio =
            d * target.second_derivative(xi) / tangent.norm_square();
          move_to(source, result.x, target.position(xi) + d);
          if (ratio > smallest_ratio && ratio < largest_ratio &&
              closest_points(target, source.position(result.x), {}).size() == 1)
            return result;
        }
      ADD_FAILURE() << "no such configuration";
      return {};
    }
  } // namespace SectionBeamTests
} // namespace Setae

#endif
