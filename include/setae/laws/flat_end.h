// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_laws_flat_end_h
#define setae_laws_flat_end_h

#include <setae/base/integer_power.h>
#include <setae/laws/contact_law.h>
#include <setae/laws/disk_overlap.h>
#include <setae/laws/point_potential.h>
#include <setae/laws/regularized.h>
#include <setae/laws/smooth_cutoff.h>

#include <cmath>
#include <vector>

namespace Setae
{
  /**
   * A disk of the source before the flat end of a half-infinite target, for one
   * power of the point potential: what stands in front of the end or next to
   * its edge, where no infinite cylinder is a surrogate.
   *
   * A half-space at the distance D of the center of a disk with
   * @f$W=(R_1\sin)^2@f$ of the angle between its normal and the direction e of
   * D has, with H of DiskContact, exactly
   * @f[ \frac{2\pi k_m\rho_1\rho_2}{(m-2)(m-3)}\,\pi R_1^2\,(2H)^{9/2-m}
   *     D^{-3/2}\,F\bigl(\tfrac{7-m}2,\tfrac{6-m}2;2;W/D^2\bigr), @f]
   * and the hypergeometric function is a polynomial for integer m >= 6.
   * - In front, e points out of the end. The part of the half-space that exists
   *   is that of the area over which disk and end face each other
   *   (DiskOverlap); a disk that leans over counts with the part of it that is
   *   near and as far from the axis as that is.
   * - At the edge, e is the direction in which disk and edge are separated
   *   best: the eigenvector of the larger eigenvalue of
   *   @f$D^2-W@f$ as a quadratic form. The wedge has a constant part of the
   *   half-space, and less if the disk is round before it.
   * - Far away, both bodies become one point and two lines, which have the mean
   *   and the variance of the squared distance.
   *
   * The partition is smooth and made by H in the three directions: a form that
   * sees the disk touch has no weight where another one does not. A disk that
   * is parallel to the end stays beside the target until it is much farther
   * from the end than from the side.
   */
  class FlatEnd
  {
  public:
    FlatEnd(const InversePower &power,
            const SectionPair  &sections,
            const GapRange     &range);

    /** Where a disk is: all scalars stay smooth on the axis of the target. */
    template <typename Number>
    struct Pose
    {
      Number square; ///< of the distance from the axis [length^2]
      Number
        along; ///< that distance, as a vector, times the normal of the disk
      Number cosine; ///< normal of the disk times axis, which points inwards
      Number z;      ///< axial distance inside the end, negative beyond
    };

    /** The parts of the two directions that are not the side of the target. */
    template <typename Number>
    struct Front
    {
      Number side_share; ///< by which the energy beside the target counts
      Number energy;     ///< what comes in addition, per length of the source
    };

    /** @param H_side DiskContact::H beside the target, negative where it
     * touches. */
    template <typename Number>
    Front<Number>
    front(const Pose<Number> &pose, const Number &H_side) const;

    /** Of the target [length]. */
    double
    radius() const
    {
      return R2;
    }

    /** The gap to the side of a disk that is @p distance from the axis. */
    template <typename Number>
    Number
    gap(const Number &distance) const
    {
      return distance - (R1 + R2);
    }

    /** H beside the target of a disk that is not inclined to it. */
    template <typename Number>
    Number
    softened(const Number &gap) const
    {
      return gap * (gap + 2. * R1) / (2. * (gap + R1));
    }

    /** Whether there is a side of the target: the axis is not in the way. */
    template <typename Number>
    bool
    has_side(const Number &square) const
    {
      return square > R2 * R2;
    }

    /** A lower bound of the distance, sharp in front and at the edge. */
    double
    clearance(const Pose<double> &pose) const;

  private:
    /** The disk in a direction: D, W and what DiskContact makes of them. */
    template <typename Number>
    struct Direction
    {
      Number D, W, H;
    };

    template <typename Number>
    Direction<Number>
    of_cap(const Pose<Number> &pose) const
    {
      const Number D = -pose.z;
      const Number W = R1 * R1 * (1. - pose.cosine * pose.cosine);
      return {D, W, .5 * (D - W / D)};
    }

    /**
     * Zero if there is no such direction between side and end.
     *
     * @param[out] share What the edge is of a half-space.
     * @param[out] gate Zero where the disk is nearest to the inner part of the
     * end.
     */
    template <typename Number>
    Direction<Number>
    edge(const Pose<Number> &pose, Number &share, Number &gate) const;

    template <typename Number>
    Number
    half_space(const Direction<Number> &at) const;

    template <typename Number>
    Number
    in_front(const Pose<Number> &pose, const Direction<Number> &at) const;

    template <typename Number>
    Number
    from_afar(const Pose<Number> &pose, const Number &height) const;

    template <typename Number>
    static Number
    step(const Number &x)
    {
      if (!(x > 0.))
        return 0.;
      if (x >= 1.)
        return 1.;
      return x * x * x * (10. - x * (15. - 6. * x));
    }

    /** Of the disk's curvature before the edge, found by comparison. */
    static constexpr double roundness = .06;

    /** Steps of the search for the direction of the edge. */
    static constexpr unsigned int n_edge_steps = 6;

    unsigned int               m;
    double                     R1, R2;
    double                     line_of_points; ///< factor of from_afar()
    std::vector<double>        polynomial;     ///< F over W / D^2
    double                     fringe_width;   ///< over the height
    double                     softness; ///< of an overlap, over the height
    double                     thinness; ///< of the target in front of its end
    double                     wedge;    ///< its part of a half-space
    Held                       held;
    Regularized<InversePowers> powers;
    CutoffSwitch               cutoff;
  };



  template <typename Number>
  FlatEnd::Direction<Number>
  FlatEnd::edge(const Pose<Number> &pose, Number &share, Number &gate) const
  {
    using std::sqrt;
    constexpr double tiny = 1e-20, corner = .001;
    const double     R = R1 * R1;
    const Number     C = pose.cosine * pose.cosine, W_axis = R * (1. - C);

    // The edge is approached in the plane of the axis and of d - shift t1. The
    // first shift is to the point of the disk that is farthest inwards; each of
    // the next ones separates better, because -sqrt(W) is convex in t1.e.
    Number shift =
      R * pose.cosine / sqrt(W_axis + .25 * pose.z * pose.z + tiny * R);
    Number            S = 0., u0 = 0.;
    Direction<Number> result;
    for (unsigned int i = 0; i < n_edge_steps; ++i)
      {
        const Number across = pose.along - shift * (1. - C);
        const Number square = pose.square - shift * (pose.along + across);
        const double least  = .25 * R2 * R2;
        const Number y      = sqrt(Held(2. * least).value(square));
        gate                = step(Number(square / least - 1.));

        // u = (cos, sin) of the angle from there to the end: D is X u, W is
        // R1^2 (1 - (p u)^2), and D^2 - W is u K u. A negative K01 points out
        // of the quadrant between side and end.
        const Number X[2] = {(pose.square - shift * pose.along) / y - R2,
                             -pose.z};
        const Number p[2] = {across / y, -pose.cosine};
        const Number K00  = X[0] * X[0] - R * (1. - p[0] * p[0]);
        const Number K11  = X[1] * X[1] - R * (1. - p[1] * p[1]);
        const Number K01  = X[0] * X[1] + R * p[0] * p[1];
        const double soft = corner * corner * R * R;
        const Number bend = sqrt(K01 * K01 + soft);
        const Number K    = K01 > 0. ? Number(.5 * (K01 + bend)) :
                                       Number(.5 * soft / (bend - K01));

        const Number difference = K00 - K11;
        const Number root       = sqrt(difference * difference + 4. * K * K);
        const bool   to_side    = difference > 0.;
        const Number larger =
          sqrt(.5 + (to_side ? .5 : -.5) * difference / root);
        const Number smaller = K / (root * larger);
        const Number u[2]    = {to_side ? larger : smaller,
                             to_side ? smaller : larger};
        const Number t = p[0] * u[0] + p[1] * u[1];
        result.D       = X[0] * u[0] + X[1] * u[1];
        result.W       = R * (1. - t * t);
        u0             = u[0];
        S              = 1. - p[0] * p[0] - C;
        shift = -R * t / sqrt(result.W + .25 * result.D * result.D + tiny * R);
      }
    if (!(result.D > 0.))
      return {0., 0., 0.};
    result.H       = .5 * (result.D - result.W / result.D);
    const Number H = held.value(result.H), W = result.W + H * H;
    const Number Q     = sqrt(W);
    const Number wide  = H * R1 / Q;
    const Number round = roundness * (m - 4.) * R * R * S / (W * Q);
    share =
      H /
      sqrt((wide * wide + H * round) * (1. + (1. - S) * R * u0 / (Q * R2))) *
      wedge;
    return result;
  }



  template <typename Number>
  Number
  FlatEnd::half_space(const Direction<Number> &at) const
  {
    using std::sqrt;
    const Number H   = held.value(at.H);
    const Number D   = H + sqrt(at.W + H * H);
    const Number x   = at.W / (D * D);
    Number       sum = 0.;
    for (unsigned int k = polynomial.size(); k > 0; --k)
      sum = polynomial[k - 1] + x * sum;
    return powers.value(at.H) * sum / (D * sqrt(D));
  }



  template <typename Number>
  Number
  FlatEnd::in_front(const Pose<Number> &pose, const Direction<Number> &at) const
  {
    using std::sqrt;
    const Number H = held.value(at.H), Q = sqrt(at.W + H * H);

    // The part of the disk that is near, as a smaller disk
    const double narrow      = .5 * (m - 4.);
    const Number part        = H / Q;
    const Number radius      = R1 * sqrt(part / (part + narrow * (1. - part)));
    const Number shift       = R1 * R1 / Q * pose.cosine;
    const Number sine_square = 1. - pose.cosine * pose.cosine;
    const Number square =
      pose.square + shift * (shift * sine_square - 2. * pose.along);

    const Number height = 2. * H;
    const Number low    = height * R1 / (height + R1);
    const Number fringe = fringe_width * low;
    const Number y =
      sqrt((square > 0. ? square : Number(0.)) + fringe * fringe);
    // Where the disk leans, it is lower over the rest of the overlap.
    const Number wide =
      softness * height / (1. + (1. - part * part) * height / R1);
    const Number r    = integer_power(radius, 8) + integer_power(Number(R2), 8);
    const Number thin = thinness * height * height / sqrt(sqrt(r));
    const Number near =
      half_space(at) *
      disk_overlap(y, radius, R2, wide, Number(softness * low)) /
      (M_PI * radius * radius * (1. + thin));

    const Number f         = height * height / (1.4 * (R1 * R1 + R2 * R2));
    const Number far_share = 1. - 1. / (1. + f * f * f);
    return near + far_share * (from_afar(pose, height) - near);
  }



  template <typename Number>
  Number
  FlatEnd::from_afar(const Pose<Number> &pose, const Number &height) const
  {
    using std::sqrt;
    // Mean and variance of the squared distance in the plane of the end
    const double square_1 = R1 * R1, square_2 = R2 * R2;
    const Number C    = pose.cosine * pose.cosine;
    const Number mean = pose.square + .5 * square_2 + .25 * square_1 * (1. + C);
    const Number variance =
      square_2 * pose.square +
      square_1 * (pose.square - pose.along * pose.along) +
      square_2 * (square_2 / 12. + .25 * square_1 * (1. + C)) +
      square_1 * square_1 / 16. * (1. - C * (2. / 3. - C));
    const Number deviation = sqrt(variance);
    const auto   line      = [&](const Number &lateral) -> Number {
      const Number square = height * height + lateral;
      const Number x      = lateral / square;

      constexpr unsigned int n_terms = 12;
      Number                 sum     = 0.;
      for (unsigned int k = n_terms; k > 0; --k)
        sum = x * ((.5 * m + k - 1.) / (.5 * m + k - .5)) * (1. + sum);
      const Number inverse = 1. / square;
      Number       power   = integer_power(inverse, m / 2);
      if (m % 2 == 1)
        power = power * sqrt(inverse);
      return power * (1. + sum);
    };
    return .5 * line_of_points * height *
           (line(Number(mean - deviation)) + line(Number(mean + deviation)));
  }



  template <typename Number>
  FlatEnd::Front<Number>
  FlatEnd::front(const Pose<Number> &pose, const Number &H_side) const
  {
    using std::sqrt;
    const Direction<Number> cap  = of_cap(pose);
    const Number            end  = cap.D > 0. ? held.value(cap.H) : Number(0.);
    Number                  side = held.value(H_side);

    // EndFraction knows well how a parallel section leaves the side.
    if (cap.D > 0. && cap.H > 0.)
      {
        const Number parallel = 2. * cap.H / cap.D;
        side                  = side * (1. + 4. * parallel * parallel);
      }
    const Number sum = side + end;

    // The edge counts where it is much farther away than the others say.
    constexpr double        least = 1.2, most = 2.7;
    Number                  edge_share = 0., energy = 0., part = 0., gate = 0.;
    const Direction<Number> edge = this->edge(pose, part, gate);
    if (edge.H > 0.)
      {
        // One that is small beside the edge goes to zero smoothly, because
        // held does not.
        const Number h   = held.value(edge.H);
        const auto   let = [&](const Number &x) -> Number {
          return x * step(Number(5. * x / h));
        };
        const Number others = let(side) + let(end);
        if (h >= most * others)
          edge_share = gate;
        else if (h > least * others)
          edge_share =
            gate *
            step(Number((h - least * others) / ((most - least) * others)));
        energy = edge_share * part * half_space(edge);
      }

    // A product of shares, so that none of the side is left by round-off.
    const Number others     = 1. - edge_share;
    Number       side_share = others;
    if (end > .25 * sum)
      {
        const Number end_share = step(Number(2. * end / sum - .5));
        side_share             = others * (1. - end_share);
        energy += others * end_share * in_front(pose, cap);
      }
    return {side_share,
            energy * cutoff.value(
                       Number(sqrt(pose.square + pose.z * pose.z) - R1 - R2))};
  }
} // namespace Setae

#endif
