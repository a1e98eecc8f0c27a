// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_fibers_centerline_h
#define setae_fibers_centerline_h

#include <setae/base/expression.h>
#include <setae/kinematics/hermite.h>
#include <setae/scene.h>

#include <string>
#include <vector>

namespace Setae
{
  /**
   * The initial centerline of one fiber as nodes with positions [length] and
   * unit tangents, in the order along the fiber.
   */
  struct Centerline
  {
    std::vector<Tensor<1, 3>> positions;
    std::vector<Tensor<1, 3>> tangents;

    /** A ring: the last node is followed by the first one. */
    bool closed = false;

    /** The numbers i, j, k of the copy within an array, else 0. */
    Constants copy;

    /** By how much the coordinates of a node may be rounded [length]. */
    double rounding = 0.;

    /** The parameter s of each node of a formula, or nothing [length]. */
    std::vector<double> parameters;

    unsigned int
    n_cells() const
    {
      return positions.size() - (closed ? 0 : 1);
    }

    /** One cell of the curve, with the chord as length scale. */
    HermiteCell<>
    cell(const unsigned int i) const;

    /** The shortest chord of a cell [length]. */
    double
    shortest_cell() const;

    /** By how much a tangent may differ from that of the curve. */
    double
    tangent_tolerance() const;

    /**
     * Whether all nodes are on one line, and all tangents along it, up to the
     * rounding of the coordinates and 1e-10 of the length.
     */
    bool
    is_straight() const;

    /**
     * Move the nodes of a straight centerline onto the line through its ends
     * and turn the tangents along it.
     *
     * @return By how much a node has moved at most [length].
     */
    double
    straighten();
  };



  /**
   * The centerlines of the copies of a fiber, from its formula or mesh file.
   *
   * @param notices What a user should know of them is added to it.
   *
   * @throws ExcParameter if a formula gives no regular curve, one with a kink
   * or one so far out that rounding spoils it, or if a file cannot be read or
   * has branches or kinks.
   */
  std::vector<Centerline>
  make_centerlines(const FiberParameters    &parameters,
                   const Constants          &constants,
                   std::vector<std::string> &notices);

  /** The same without the notices. */
  std::vector<Centerline>
  make_centerlines(const FiberParameters &parameters,
                   const Constants       &constants);

  /** The centerlines of the chains of lines of a mesh file. */
  std::vector<Centerline>
  centerlines_of_mesh(const FiberParameters    &parameters,
                      std::vector<std::string> &notices);

  /** The centerline of one copy, from its formula. */
  Centerline
  centerline_of_formula(const FiberParameters    &parameters,
                        const Constants          &constants,
                        const Constants          &copy,
                        std::vector<std::string> &notices);
} // namespace Setae

#endif
