// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_interactions_target_end_h
#define setae_interactions_target_end_h

#include <setae/fibers/cell_place.h>
#include <setae/interactions/section_pose.h>
#include <setae/laws/end_fraction.h>
#include <setae/laws/flat_end.h>

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

namespace Setae
{
  /**
   * The laws of a target that ends. Beside the target, that of each power of
   * the point potential counts times the part of an infinite target that exists
   * (EndFraction); in front of its end, FlatEnd takes over.
   */
  template <typename Law>
  class TargetEnd
  {
  public:
    /** The law of one power of the point potential and its end. */
    struct Term
    {
      Law         law;
      EndFraction fraction;
      FlatEnd     flat_end;
    };

    /** @param terms empty if a target is not to end. */
    explicit TargetEnd(std::vector<Term> terms = {})
      : terms(std::move(terms))
    {}

    /** Whether the ends of a target are treated as such. */
    bool
    is_finite() const
    {
      return !terms.empty();
    }

    /** Whether they matter to a section. */
    bool
    is_finite(const CellPlace &place, const SectionPose<double> &pose) const
    {
      if (terms.empty())
        return false;
      if (place.ends.left || place.ends.right)
        return true;
      return has_side(pose.square) &&
             std::min(from_left(place, pose), from_right(place, pose)) <
               reach(pose);
    }

    /** Whether a site has an infinite surrogate beside it. */
    bool
    has_side(const double square) const
    {
      return terms[0].flat_end.has_side(square);
    }

    /** The distance from the ends of the target; a lower bound. */
    double
    clearance(const FiberEnds &ends, const SectionPose<double> &pose) const
    {
      double     result  = -std::numeric_limits<double>::infinity();
      const auto add_end = [&](const double inwards, const double x) {
        result =
          std::max(result,
                   terms[0].flat_end.clearance(
                     {pose.square, pose.along, inwards, x * pose.length}));
      };
      if (ends.left)
        add_end(pose.cosine, pose.x);
      if (ends.right)
        add_end(-pose.cosine, 1. - pose.x);
      return result;
    }

    /** The energy of a section on any number type. */
    template <typename Number>
    Number
    value(const CellPlace &place, const SectionPose<Number> &pose) const
    {
      using std::sqrt;
      Number sum = 0.;
      for (const Term &term : terms)
        {
          const FlatEnd &flat_end = term.flat_end;
          Number         gap = 0., tilt = 0., H = 0.;
          if (flat_end.has_side(pose.square))
            {
              const Number distance = sqrt(pose.square);
              gap                   = flat_end.gap(distance);
              tilt                  = pose.along / distance;
              if constexpr (has_tilt<Law>)
                H = term.law.softened_distance(gap, pose.cosine, tilt);
              else if (gap > 0.)
                H = flat_end.softened(gap);
            }
          Number     side_share = 1., missing = 0.;
          const auto add_end =
            [&](const Number &inwards, const Number &z, const bool is_in_cell) {
              if (is_in_cell)
                {
                  const auto front = flat_end.front(
                    FlatEnd::Pose<Number>{pose.square, pose.along, inwards, z},
                    H);
                  sum += front.energy;
                  side_share = side_share - (1. - front.side_share);
                  if (!(front.side_share > 0.))
                    return;
                }
              if (z < reach(pose))
                missing +=
                  CutoffSwitch(.7, 1.).value(Number(z / reach(pose))) *
                  (1. - term.fraction.value(
                          term.fraction.distance(H), gap, inwards, tilt, z));
            };
          add_end(pose.cosine, from_left(place, pose), place.ends.left);
          add_end(Number(-pose.cosine),
                  from_right(place, pose),
                  place.ends.right);
          if (side_share > 0. && flat_end.has_side(pose.square))
            sum += side_share * (1. - missing) *
                   evaluate_law(term.law, gap, pose.cosine, tilt);
        }
      return sum;
    }

  private:
    /** The distance along the target from its ends to the closest point. */
    template <typename Number>
    static Number
    from_left(const CellPlace &place, const SectionPose<Number> &pose)
    {
      const double cells =
        place.ends.left ? 0. : place.from_left / place.length;
      return (cells + pose.x) * pose.length;
    }

    template <typename Number>
    static Number
    from_right(const CellPlace &place, const SectionPose<Number> &pose)
    {
      const double cells =
        place.ends.right ? 0. : place.from_right / place.length;
      return (cells + 1. - pose.x) * pose.length;
    }

    /** From where on inside the end it is switched off: hardly seen. */
    template <typename Number>
    Number
    reach(const SectionPose<Number> &pose) const
    {
      using std::sqrt;
      const double R = terms[0].flat_end.radius();
      return 5. * sqrt(pose.square + R * R);
    }

    std::vector<Term> terms;
  };
} // namespace Setae

#endif
