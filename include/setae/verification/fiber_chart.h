// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_verification_fiber_chart_h
#define setae_verification_fiber_chart_h

#include <deal.II/base/point.h>

#include <setae/kinematics/hermite.h>

#include <vector>

namespace Setae
{
  /**
   * A fiber as a solid body: unit cubes that together fill a (bent) cylinder
   * around the Hermite centerline, without any approximation of the geometry.
   *
   * Along the fiber there are blocks, some in each cell of the centerline; each
   * block has five cubes, a square prism in the middle and four between it and
   * the lateral surface. In a cube, x runs along the radius, y along the
   * circumference (in the inner one both along the sides of the square), z
   * along the fiber; x = 1 of the four outer ones is the lateral surface.
   * Circular sections stay plane, circular and normal to the current
   * centerline, and they carry the points that they carry initially: weights
   * are volumes (or surfaces) of the initial body, so that stretching and
   * bending neither create nor destroy points, as in the reduced laws.
   */
  class FiberChart
  {
  public:
    static constexpr unsigned int n_sectors    = 5;
    static constexpr unsigned int inner_sector = 4;

    /**
     * @param initial,current The cells of one fiber. Initially, it may be
     * curved in a plane only, or straight.
     * @param block_length The length of a block over the radius, about.
     */
    FiberChart(std::vector<HermiteCell<>> initial,
               std::vector<HermiteCell<>> current,
               const double               radius,
               const double               block_length = .8);

    /** The number of unit cubes; cube c is in block c / n_sectors. */
    unsigned int
    n_cubes() const
    {
      return n_sectors * blocks.size();
    }

    unsigned int
    n_blocks() const
    {
      return blocks.size();
    }

    /** Whether the face x = 1 of a cube is on the lateral surface. */
    static bool
    is_outer(const unsigned int cube)
    {
      return cube % n_sectors != inner_sector;
    }

    /** What the chart knows of a section: all but the place in it. */
    struct Section
    {
      Tensor<1, 3> center;
      Tensor<1, 3> d1, d2; ///< unit vectors in the section
      double       length; ///< initial arc length over that of z
      double       k1, k2; ///< initial curvature along d1 and d2
    };

    Section
    section(const unsigned int cube, const double z) const;

    /** A place in the section of radius one, and its measure over dx dy. */
    struct Place
    {
      double u, v, area;
    };

    static Place
    place(const unsigned int cube, const double x, const double y);

    /** The same for the lateral surface x = 1: the measure is that over dy. */
    static Place
    boundary_place(const unsigned int cube, const double y);

    /** A point, with its volume over dx dy dz or its surface over dy dz. */
    struct Site
    {
      Tensor<1, 3> r;
      double       weight;
    };

    /** @param dimension 3 for a place, 2 for a boundary_place. */
    Site
    site(const Section     &section,
         const Place       &place,
         const unsigned int dimension) const
    {
      const double u = radius * place.u, v = radius * place.v;
      const double scale = dimension == 3 ? radius * radius : radius;
      return {section.center + u * section.d1 + v * section.d2,
              scale * place.area * section.length *
                (1. - u * section.k1 - v * section.k2)};
    }

    Tensor<1, 3>
    position(const unsigned int cube, const dealii::Point<3> &p) const
    {
      return site(section(cube, p[2]), place(cube, p[0], p[1]), 3).r;
    }

    const double radius;

  private:
    struct Block
    {
      unsigned int cell;
      double       begin, size; ///< in the reference coordinate of the cell
    };

    /** A section vector that is carried along without twist. */
    std::vector<Tensor<1, 3>>
    carry_along(const std::vector<HermiteCell<>> &cells,
                Tensor<1, 3>                      vector) const;

    std::vector<HermiteCell<>> initial, current;
    std::vector<Tensor<1, 3>>  initial_d1, current_d1; ///< at the first nodes
    std::vector<Block>         blocks;
  };
} // namespace Setae

#endif
