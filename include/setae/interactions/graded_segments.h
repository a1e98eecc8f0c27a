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
   *
   * Contact has no singularity but ends with a kink where the surfaces meet, at
   * @f$\pm\lambda/\sin\alpha@f$ with @f$\lambda=\sqrt{p(2c-p)}@f$ for the
   * penetration p. Points that are h apart make a relative error of about
   * @f$0.6\,(h\sin\alpha/\lambda)^2@f$ of the force, so that
   * @f[ \ell = n\,\lambda\sqrt{\varepsilon/0.6}\,/\,\sigma @f]
   * with p = c/200; the error at a penetration p is
   * @f$\varepsilon\,c/(200p)@f$. The slope @f$\sigma@f$ bounds
   * @f$\sin\alpha@f$ and what curvature adds to it on the segment: fibers that
   * press on each other side by side need no more points than others.
   *
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
     * @param is_contact whether the law is that of contact
     */
    GradedSegments(const double       tolerance,
                   const unsigned int n_points,
                   const unsigned int n_parts,
                   const double       smallest_gap,
                   const bool         is_contact = false);

    /**
     * The longest segment at a @p distance of the centerlines whose surfaces
     * touch at the distance @p core [length]; @p slope, for contact and for
     * whoever knows it, is the sine of the angle.
     */
    double
    largest_length(const double distance,
                   const double core,
                   const double slope = 1.) const;

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
      may_be_halved(const double core) const;

      /** How much the derivative differs from its mean, over that. */
      double
      turn() const;
    };

    static std::array<Part, 2>
    halves(const ControlPoints &cell, const Part &part);

    /** A bound of the slope of the distance between two parts. */
    static double
    slope(const Part &part, const Part &of_neighbor, const double core);

    bool
    overlaps(const Part     &part,
             const Neighbor &neighbor,
             const Part     &of_neighbor) const;

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

    const bool         is_contact;
    const double       length_factor; ///< l / lambda
    const unsigned int n_parts;
    const double       smallest_gap;
  };
} // namespace Setae

#endif
