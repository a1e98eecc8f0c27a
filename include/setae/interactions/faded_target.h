// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_interactions_faded_target_h
#define setae_interactions_faded_target_h

#include <setae/interactions/end_zone.h>
#include <setae/interactions/section_pose.h>
#include <setae/laws/fading_fraction.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace Setae
{
  /**
   * The laws of a target that fades towards its ends (EndZone): that of each
   * power of the point potential times the part of an infinite target that is
   * left of it (FadingFraction). Where nothing is left next to a
   * section, what there is farther along is seen from its distance.
   */
  template <typename Law>
  class FadedTarget
  {
  public:
    /** The law of one power of the point potential and its end. */
    struct Term
    {
      Law            law;
      FadingFraction fraction;
    };

    /** @param terms empty if a target is not to fade. */
    explicit FadedTarget(const double      sum_of_radii = 0.,
                         std::vector<Term> terms        = {})
      : sum_of_radii(sum_of_radii)
      , terms(std::move(terms))
    {}

    bool
    is_finite() const
    {
      return !terms.empty();
    }

    /** The place of a section before the infinite cylinder of the law. */
    template <typename Number>
    struct Surrogate
    {
      Number gap, tilt;
    };

    template <typename Number>
    Surrogate<Number>
    surrogate(const CellPlace &place, const SectionPose<Number> &pose) const
    {
      using std::sqrt;
      const EndZone zone(sum_of_radii, place.fiber_length);
      Number        square = pose.square;
      for (const Number &s : {from_left(place, pose), from_right(place, pose)})
        if (s < zone.fading_begins())
          {
            const double full   = zone.fading_begins();
            const Number beyond = full - s;
            const Number along  = beyond * pose.length / place.length *
                                 (1. - CutoffSwitch(0., full).value(beyond));
            square += along * along;
          }
      const Number distance = sqrt(square);
      return {distance - sum_of_radii, pose.along / distance};
    }

    /** The smallest and the largest part that is left for any of the powers. */
    std::pair<double, double>
    parts(const CellPlace           &place,
          const SectionPose<double> &pose,
          const Surrogate<double>   &at) const
    {
      const double distance = this->distance(pose, at);
      double       least = 1., most = 0.;
      for (const Term &term : terms)
        {
          const double p = part(term, distance, place, pose, at);
          least          = std::min(least, p);
          most           = std::max(most, p);
        }
      return {least, most};
    }

    /** The energy of a section on any number type. */
    template <typename Number>
    Number
    value(const CellPlace &place, const SectionPose<Number> &pose) const
    {
      const Surrogate<Number> at       = surrogate(place, pose);
      const Number            distance = this->distance(pose, at);
      Number                  sum      = 0.;
      for (const Term &term : terms)
        {
          const Number p = part(term, distance, place, pose, at);
          if (p > 0.)
            sum += p * evaluate_law(term.law, at.gap, pose.cosine, at.tilt);
        }
      return sum;
    }

  private:
    /** The initial arc length from an end to the closest point. */
    template <typename Number>
    static Number
    from_left(const CellPlace &place, const SectionPose<Number> &pose)
    {
      return place.from_left + place.length * pose.x;
    }

    template <typename Number>
    static Number
    from_right(const CellPlace &place, const SectionPose<Number> &pose)
    {
      return place.from_right + place.length * (1. - pose.x);
    }

    /** Of a section and the infinite target, see FadingFraction. */
    template <typename Number>
    Number
    distance(const SectionPose<Number> &pose, const Surrogate<Number> &at) const
    {
      const Term &term = terms[0];
      if constexpr (has_tilt<Law>)
        return evaluate_reduced(
          [&](const auto &...x) {
            return term.fraction.distance(term.law.softened_distance(x...));
          },
          at.gap,
          pose.cosine,
          at.tilt);
      else
        return at.gap > 0. ? at.gap : Number(0.);
    }

    /** The part that is left of the target for one power. */
    template <typename Number>
    Number
    part(const Term                &term,
         const Number              &distance,
         const CellPlace           &place,
         const SectionPose<Number> &pose,
         const Surrogate<Number>   &at) const
    {
      const EndZone zone(sum_of_radii, place.fiber_length);
      if (zone.is_all())
        return 0.;
      const double middle  = .5 * (zone.fading_begins() + zone.fading_ends());
      const double half    = zone.fading_ends() - middle;
      const Number stretch = pose.length / place.length;
      const auto from = [&](const Number &s, const Number &inwards) -> Number {
        const Number z = (s - middle) * stretch, b = half * stretch;
        if (z - b < term.fraction.reach(distance))
          return term.fraction.value(distance, inwards, at.tilt, z, b);
        return 1.;
      };
      if (!(place.from_left < CellPlace::infinity))
        return 1.;
      const Number left  = from(from_left(place, pose), pose.cosine),
                   right = from(from_right(place, pose), Number(-pose.cosine));
      if (left >= 1.)
        return right;
      if (right >= 1.)
        return left;
      return left + right - 1.;
    }

    double            sum_of_radii;
    std::vector<Term> terms;
  };
} // namespace Setae

#endif
