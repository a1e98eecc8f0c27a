// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_verification_full_quadrature_h
#define setae_verification_full_quadrature_h

#include <setae/interactions/resultant.h>
#include <setae/laws/point_law.h>
#include <setae/scene.h>
#include <setae/verification/solid_body.h>

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
    /** With the most Gauss points, and with one less in each direction. */
    SolidResultant finest, second_finest;

    /** Gauss points in each direction of the closest cells; 0 if even two are
     * too many for the limits that were set. */
    unsigned int n_points = 0;

    double n_pairs  = 0.; ///< pairs of points, of all attempts
    double n_cells  = 0.; ///< of both meshes
    double cpu_time = 0.; ///< of all ranks [s]

    /**
     * Estimate of the relative error of the energy: its last change. The true
     * error is usually ten times smaller.
     */
    double
    error() const;

    /** The same for the force, over the norm of the force. */
    double
    force_error() const;
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
