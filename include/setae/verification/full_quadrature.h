// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_verification_full_quadrature_h
#define setae_verification_full_quadrature_h

#include <setae/interactions/resultant.h>
#include <setae/laws/point_law.h>
#include <setae/scene.h>
#include <setae/verification/solid_body.h>

#include <limits>

namespace Setae
{
  /** With the moment as well. */
  struct SolidResultant : Resultant
  {
    Tensor<1, 3> moment; ///< on the first body, about the origin [force length]
  };



  /** What a full quadrature found, and how sure it is. */
  struct FullQuadrature
  {
    SolidResultant value;

    /**
     * Estimates of the errors of energy and force, relative to these: the
     * change by the last Gauss point or a quarter of the change by the one
     * before, whichever is larger, since a change can be small by chance. The
     * true errors are usually several times smaller. Infinity without three
     * sums.
     */
    double error       = std::numeric_limits<double>::infinity();
    double force_error = std::numeric_limits<double>::infinity();

    /** In each direction of the closest cells. */
    unsigned int n_points = 0;

    double n_pairs  = 0.; ///< pairs of points, of all sums
    double n_cells  = 0.; ///< of both meshes
    double cpu_time = 0.; ///< of all ranks [s]
  };



  /**
   * The interaction of all points of two bodies by the law of two points: an
   * integral over six dimensions (four, if the points are on the surfaces),
   * with nothing assumed but the number of its Gauss points.
   *
   * The meshes are refined towards each other until all pairs of active cells
   * are apart by a multiple of their size. Pairs that are farther apart are
   * summed on the level of ancestors, with as many Gauss points as have the
   * same error. That number is raised until the energy changes by less than the
   * tolerance. Collective; the result is the same for every number of ranks up
   * to round-off.
   */
  FullQuadrature
  full_quadrature(SolidBody                      &first,
                  SolidBody                      &second,
                  const PointLaw                 &law,
                  const FullQuadratureParameters &parameters);
} // namespace Setae

#endif
