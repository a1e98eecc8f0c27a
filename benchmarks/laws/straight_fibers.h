// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_benchmarks_laws_straight_fibers_h
#define setae_benchmarks_laws_straight_fibers_h

#include <deal.II/base/quadrature_lib.h>

#include <setae/base/invariants.h>
#include <setae/kinematics/gap_angle.h>
#include <setae/kinematics/offset_frame.h>

#include <cmath>
#include <limits>
#include <vector>

#include "interaction.h"

namespace Setae
{
  namespace LawReport
  {
    /**
     * The law between two points of the centerlines: energy per length (or
     * length squared) and force in the direction z on the source, through the
     * invariants and the chain rule of the kernels.
     */
    template <typename Law>
    Interaction
    of_pair(const Law &law, const PointPair &pair, const double sum_of_radii)
    {
      if constexpr (Law::depends_on == Invariants::gap)
        {
          const Tensor<1, 3>   d        = pair.r1 - pair.r2;
          const double         distance = d.norm();
          const GapDerivatives f        = law(distance - sum_of_radii);
          return {f.value, -f.first * d[2] / distance};
        }
      else
        {
          const PointPairEnergy e = [&] {
            if constexpr (Law::depends_on == Invariants::gap_offset)
              {
                const OffsetFrame frame(pair,
                                        sum_of_radii,
                                        OffsetAxis::averaged);
                return frame.energy(law(frame.offset, frame.gap), false);
              }
            else
              {
                const GapAngle geometry(pair, sum_of_radii);
                if constexpr (Law::depends_on == Invariants::gap_angle)
                  return geometry.energy(law(geometry.gap, geometry.cosine),
                                         false);
                else
                  return geometry.energy(
                    law(geometry.gap, geometry.cosine, geometry.tilt), false);
              }
          }();
          return {e.value, -e.gradient[PointPairIndex::r1][2]};
        }
    }



    /**
     * A quadrature for functions on a line that have a peak of width one at
     * zero and decay from there: Gauss points in the intervals of length one of
     * u, x = sinh(u).
     */
    class PeakRule
    {
    public:
      struct Node
      {
        double x, weight;
      };

      /**
       * Many points: with section-quadrature 12 x 24, the most exact law, what
       * is left of the steric error at small gaps is below 5e-6.
       *
       * @param narrowness Of the peak: one over its width.
       */
      static PeakRule
      fine(const double narrowness = 1.)
      {
        return PeakRule(std::ceil(8. * narrowness), 32);
      }

      /**
       * @param n_points In each interval.
       * @param range Largest u.
       */
      PeakRule(const unsigned int n_points, const int range)
        : gauss(n_points)
        , range(range)
        , nodes(to(std::numeric_limits<double>::infinity()))
      {}

      /** The part of the line up to @p end. */
      std::vector<Node>
      to(const double end) const
      {
        const double      last = std::min<double>(std::asinh(end), range);
        std::vector<Node> result;
        for (double u = -range; u < last; u += 1.)
          {
            const double length = std::min(1., last - u);
            for (unsigned int q = 0; q < gauss.size(); ++q)
              {
                const double v = u + length * gauss.point(q)[0];
                result.push_back(
                  {std::sinh(v), length * gauss.weight(q) * std::cosh(v)});
              }
          }
        return result;
      }

    private:
      dealii::QGauss<1> gauss;
      int               range;

    public:
      const std::vector<Node> nodes; ///< of the whole line
    };



    /** The length on which the gap grows where axes pass each other. */
    inline double
    peak_width(const double gap, const double sum_of_radii)
    {
      return std::sqrt(gap * (gap + 2. * sum_of_radii));
    }



    /** Parallel fibers, infinite: energy and force per length. */
    template <typename Law>
    Interaction
    parallel_fibers(const Law      &law,
                    const double    gap,
                    const double    sum_of_radii,
                    const PeakRule &rule)
    {
      const Tensor<1, 3> t({1., 0., 0.});
      PointPair pair = {Tensor<1, 3>({0., 0., gap + sum_of_radii}), t, {}, t};
      if constexpr (Law::depends_on == Invariants::gap ||
                    Law::depends_on == Invariants::gap_offset)
        {
          const double width = Law::depends_on == Invariants::gap_offset ?
                                 gap :
                                 peak_width(gap, sum_of_radii);
          Interaction  sum;
          for (const PeakRule::Node &node : rule.nodes)
            {
              pair.r2 = width * node.x * t;
              sum += width * node.weight * of_pair(law, pair, sum_of_radii);
            }
          return sum;
        }
      else
        return of_pair(law, pair, sum_of_radii);
    }



    /**
     * Two infinite fibers that cross, or a source that ends at the distance
     * @p overhang beyond the point of crossing. Along the source runs s, along
     * the target u; both are zero there.
     */
    class CrossingFibers
    {
    public:
      /** @param angle Between the axes, in (0, pi/2]. */
      CrossingFibers(
        const double gap,
        const double angle,
        const double sum_of_radii,
        const double overhang = std::numeric_limits<double>::infinity())
        : sum_of_radii(sum_of_radii)
        , distance(gap + sum_of_radii)
        , angle(angle)
        , overhang(overhang)
        , t1({1., 0., 0.})
        , t2({std::cos(angle), std::sin(angle), 0.})
      {}

      template <typename Law>
      Interaction
      operator()(const Law &law, const PeakRule &rule) const
      {
        if constexpr (Law::depends_on == Invariants::gap)
          return sections(law, rule);
        else if constexpr (Law::depends_on == Invariants::gap_offset)
          return offset_sections(law, rule);
        else
          return section_and_beam(law, rule);
      }

    private:
      /** The gap at @p lateral away from where it is smallest. */
      double
      gap_at(const double lateral) const
      {
        return std::hypot(distance, lateral) - sum_of_radii;
      }

      double
      width_at(const double lateral) const
      {
        return peak_width(gap_at(lateral), sum_of_radii);
      }

      template <typename Law>
      Interaction
      of_sites(const Law &law, const double s, const double u) const
      {
        return of_pair(law,
                       {Tensor<1, 3>({s, 0., distance}), t1, u * t2, t2},
                       sum_of_radii);
      }

      /** The gap is smallest at u = s cos(angle). */
      template <typename Law>
      Interaction
      sections(const Law &law, const PeakRule &rule) const
      {
        const double width = width_at(0.) / std::sin(angle);
        Interaction  sum;
        for (const auto &[x, weight] : rule.to(overhang / width))
          {
            const double s = width * x, w = width_at(s * std::sin(angle));
            Interaction  line;
            for (const auto &[y, weight_y] : rule.nodes)
              line += weight_y * of_sites(law, s, s * std::cos(angle) + w * y);
            sum += (width * weight * w) * line;
          }
        return sum;
      }

      /**
       * The gap across the averaged axis depends on s+u alone, the offset along
       * it on s-u, and the law varies with the offset on the length of the gap.
       */
      template <typename Law>
      Interaction
      offset_sections(const Law &law, const PeakRule &rule) const
      {
        const double c = std::cos(.5 * angle), sine = std::sin(.5 * angle);
        const double width = width_at(0.) / sine;
        Interaction  sum;
        for (const auto &[x, weight] : rule.nodes)
          {
            const double plus = width * x, w = gap_at(plus * sine) / c;
            Interaction  line;
            const auto   add = [&](const PeakRule::Node &node) {
              const double minus = w * node.x;
              line += node.weight *
                      of_sites(law, .5 * (plus + minus), .5 * (plus - minus));
            };
            if (std::isinf(overhang))
              for (const PeakRule::Node &node : rule.nodes)
                add(node);
            else
              for (const PeakRule::Node &node :
                   rule.to((2. * overhang - plus) / w))
                add(node);
            sum += (.5 * width * weight * w) * line;
          }
        return sum;
      }

      /** The closest point is u = s cos(angle). */
      template <typename Law>
      Interaction
      section_and_beam(const Law &law, const PeakRule &rule) const
      {
        const double width = width_at(0.) / std::sin(angle);
        Interaction  sum;
        for (const auto &[x, weight] : rule.to(overhang / width))
          sum += (width * weight) *
                 of_sites(law, width * x, width * x * std::cos(angle));
        return sum;
      }

      double       sum_of_radii, distance, angle, overhang;
      Tensor<1, 3> t1, t2;
    };
  } // namespace LawReport
} // namespace Setae

#endif
