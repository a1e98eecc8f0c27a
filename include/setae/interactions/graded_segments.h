// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_interactions_graded_segments_h
#define setae_interactions_graded_segments_h

#include <deal.II/base/tensor.h>

#include <array>
#include <utility>
#include <vector>

namespace Setae
{
  using dealii::Tensor;

  /**
   * Integration segments that are short where another fiber is near and long
   * elsewhere, so that n Gauss points on each reach a given accuracy.
   *
   * A law of the gap @f$g@f$ is singular where the centerlines would be at the
   * distance @f$c=R_1+R_2@f$ of each other (c = 0 for a law between
   * centerlines). Beside a straight fiber, the distance from a point that moves
   * along another one at the smallest distance d is
   * @f$\sqrt{d^2+\sin^2\alpha\,s^2}@f$, and so the singularity is not closer than
   * @f$\lambda=\sqrt{d^2-c^2}=\sqrt{g(g+2c)}@f$, in the complex plane, to any
   * point of a segment on which d is the smallest distance. The error of
   * Gauss's
   * rule falls as @f$\varrho^{-2n}@f$ with
   * @f$\varrho=\delta+\sqrt{1+\delta^2}@f$ for a singularity at @f$\delta@f$
   * half-lengths beside the middle. A tolerance @f$\varepsilon@f$ therefore asks
   * for segments of at most
   * @f[ \ell = 2\lambda / \sinh\frac{\ln(20/\varepsilon)}{2n}, @f]
   * where the factor of 20 was found necessary for the high powers of the gap.
   * Segments are halved until they are. Distances are bounds from below by the
   * convex hulls of control points.
   */
  class GradedSegments
  {
  public:
    using ControlPoints = std::array<Tensor<1, 3>, 4>;

    /** A part of a cell in its reference coordinate. */
    struct Segment
    {
      double begin, end;
    };

    /** A cell beside which points are wanted. */
    struct Neighbor
    {
      ControlPoints points; ///< [length]
      double        core;   ///< c [length]
      double        reach;  ///< no interaction beyond this distance [length]
    };

    /**
     * @param tolerance relative error, below one
     * @param n_points Gauss points on each segment
     * @param n_parts equal segments of a cell to begin with
     * @param smallest_gap a law is smooth on this scale [length], not negative
     */
    GradedSegments(const double       tolerance,
                   const unsigned int n_points,
                   const unsigned int n_parts,
                   const double       smallest_gap);

    /** Segments of a cell for all of its neighbors, in ascending order. */
    void
    divide(const ControlPoints         &cell,
           const std::vector<Neighbor> &neighbors,
           std::vector<Segment>        &segments) const;

    /**
     * Pairs of segments, of a cell and a neighbor, for a double integral. What
     * is out of reach is left out.
     */
    void
    divide_both(const ControlPoints                      &cell,
                const Neighbor                           &neighbor,
                std::vector<std::pair<Segment, Segment>> &pairs) const;

  private:
    /** A segment with its control points. */
    struct Part
    {
      Segment       segment;
      ControlPoints points;
      double        length; ///< an upper bound

      Part(const ControlPoints &cell, const Segment &segment);

      bool
      may_be_halved() const;
    };

    static std::array<Part, 2>
    halves(const ControlPoints &cell, const Part &part);

    double
    largest_length(const double distance, const double core) const;

    bool
    is_too_long(const Part     &part,
                const Neighbor &neighbor,
                const Part     &of_neighbor) const;

    void
    divide(const ControlPoints         &cell,
           const std::vector<Neighbor> &neighbors,
           const Part                  &part,
           std::vector<Segment>        &segments) const;

    void
    divide_both(const ControlPoints                      &cell,
                const Neighbor                           &neighbor,
                const Part                               &part,
                const Part                               &of_neighbor,
                std::vector<std::pair<Segment, Segment>> &pairs) const;

    const double       length_factor; ///< l / lambda
    const unsigned int n_parts;
    const double       smallest_gap;
  };
} // namespace Setae

#endif
