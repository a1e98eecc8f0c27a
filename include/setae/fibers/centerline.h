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

    unsigned int
    n_cells() const
    {
      return positions.size() - (closed ? 0 : 1);
    }

    /** One cell of the curve, with the chord as length scale. */
    HermiteCell<>
    cell(const unsigned int i) const;

    /** Whether all nodes and tangents lie on one line, up to round-off. */
    bool
    is_straight() const;
  };



  /**
   * The centerlines of the copies of a fiber, from its formula or mesh file.
   *
   * @throws ExcParameter if a formula gives no regular curve or a file cannot
   * be read.
   */
  std::vector<Centerline>
  make_centerlines(const FiberParameters &parameters,
                   const Constants       &constants);
} // namespace Setae

#endif
