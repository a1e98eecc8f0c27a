// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_interactions_offset_sections_h
#define setae_interactions_offset_sections_h

#include <setae/interactions/site_pair_sums.h>
#include <setae/kinematics/offset_frame.h>
#include <setae/laws/smooth_cutoff.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Setae
{
  /**
   * Interaction of all pairs of sections of two cells, with regard to their
   * offset (ISSIP eq. 30): a double integral over both centerlines.
   *
   * With moments, the residual is the variation of the energy, also that of the
   * axis of the offset (ISSIP eq. 40 and 53): forces and moments are in balance
   * and the tangent matrix is symmetric. In the plane, each tangent of an
   * averaged axis gets half of the moment whatever the radii, which is what the
   * weights of ISSIP eq. 46 are for equal ones; the axis of the source gives
   * all of it to the source.
   *
   * Without moments (eq. 50), the axis is held in the variation but not in the
   * linearization (app. D): the forces are in balance, the moments are not,
   * there is no potential, and the tangent matrix is consistent but lacks
   * symmetry.
   *
   * A law may be cut off as an energy, by itself, or here by its forces and
   * moments: they are multiplied by a function of the distance of the centers.
   * So those of the paper, which leaves out distant pairs (Sec. 6.5), but
   * without jumps. They are in balance, but have no potential either.
   *
   * @tparam Law A law of offset and gap, for example OffsetDisks.
   */
  template <typename Law>
  class OffsetSections
  {
  public:
    OffsetSections(const Law          &law,
                   const double        sum_of_radii,
                   const OffsetAxis    axis,
                   const bool          with_moments,
                   const CutoffSwitch &force_switch = CutoffSwitch())
      : law(law)
      , sum_of_radii(sum_of_radii)
      , axis(axis)
      , with_moments(with_moments)
      , force_switch(force_switch)
    {}

    /** Whether there is a potential, and the tangent matrix symmetric. */
    bool
    is_symmetric() const
    {
      return with_moments && std::isinf(force_switch.begin);
    }

    /**
     * Add the interaction of one site of the source with all sites of the
     * target cell, times @p factor, to the system of the two cells (source
     * first) and to @p sums, which have to be started before and finished
     * after all sites of the source. The energy is that of the law, also where
     * forces are switched off.
     *
     * @param spacing What consecutive targets are apart at most [length].
     * @return The smallest gap seen [length], infinity if all are beyond the
     * cutoff: the distance of two centers less the radii. Where the law does
     * not admit the gap across the axis, it is that one, and the pair is left
     * out: the caller must then discard the state.
     */
    double
    add(const LineSite              &source,
        const std::vector<LineSite> &targets,
        const double                 spacing,
        const double                 factor,
        const Request                request,
        SitePairSums                &sums,
        LocalSystem<24>             &local) const
    {
      double smallest_gap = std::numeric_limits<double>::infinity();
      bool   is_used      = false;
      for_each_near(source, targets, spacing, [&](const unsigned int j) {
        const LineSite   &target = targets[j];
        const OffsetFrame geometry(pair(source, target), sum_of_radii, axis);
        if (!law.admits(geometry.gap))
          {
            smallest_gap = std::min(smallest_gap, geometry.gap);
            return;
          }
        const double distance = geometry.d.norm();
        smallest_gap          = std::min(smallest_gap, distance - sum_of_radii);
        const OffsetGapDerivatives phi =
          (factor * source.weight * target.weight) *
          law(geometry.offset, geometry.gap);
        local.energy += phi.value;
        if (request < Request::residual)
          return;
        if (!is_used)
          sums.start_source();
        is_used = true;
        PointPairEnergy derivatives =
          geometry.energy(phi, request >= Request::tangent);
        if (!with_moments)
          leave_out_moments(derivatives);
        if (distance > force_switch.begin + sum_of_radii)
          switch_forces(geometry.d, distance, derivatives);
        sums.add(j, target, derivatives, is_symmetric());
      });
      if (is_used)
        sums.finish_source(source, is_symmetric(), local);
      return smallest_gap;
    }

    /**
     * Add the forces per length on both centerlines, times @p factor, to those
     * at the sites of the two cells.
     */
    void
    add_forces(const std::vector<LineSite> &sources,
               const std::vector<LineSite> &targets,
               const double                 factor,
               std::vector<SiteForce>      &on_sources,
               std::vector<SiteForce>      &on_targets) const
    {
      start(sources, on_sources);
      start(targets, on_targets);
      const double spacing = largest_spacing(targets);
      for (unsigned int i = 0; i < sources.size(); ++i)
        for_each_near(sources[i], targets, spacing, [&](const unsigned int j) {
          const OffsetFrame geometry(pair(sources[i], targets[j]),
                                     sum_of_radii,
                                     axis);
          if (!law.admits(geometry.gap))
            return;
          const double       gap = geometry.d.norm() - sum_of_radii;
          const Tensor<1, 3> f =
            -factor * force_switch.value(gap) *
            geometry.energy(law(geometry.offset, geometry.gap), false)
              .gradient[PointPairIndex::r1];
          on_sources[i].force += targets[j].weight * f;
          on_targets[j].force -= sources[i].weight * f;
          on_sources[i].gap = std::min(on_sources[i].gap, gap);
          on_targets[j].gap = std::min(on_targets[j].gap, gap);
        });
    }

    /**
     * The energy of one pair of sites on any number type: the reference for the
     * derivatives.
     */
    template <typename Number>
    Number
    energy(const Tensor<1, 3, Number> &r1,
           const Tensor<1, 3, Number> &a1,
           const Tensor<1, 3, Number> &r2,
           const Tensor<1, 3, Number> &a2) const
    {
      using std::sqrt;
      Tensor<1, 3, Number> b = a1 / Number(sqrt(Number(a1 * a1)));
      if (axis == OffsetAxis::averaged)
        b += Number((a1 * a2 < 0. ? -1. : 1.) / Number(sqrt(Number(a2 * a2)))) *
             a2;
      const Tensor<1, 3, Number> tau    = b / Number(sqrt(Number(b * b)));
      const Tensor<1, 3, Number> d      = r1 - r2;
      const Number               offset = d * tau;
      const Tensor<1, 3, Number> normal = d - offset * tau;
      return law.energy(offset,
                        Number(sqrt(Number(normal * normal)) - sum_of_radii));
    }

    /** Distance of two centerlines from which on there is no force [length]. */
    double
    reach() const
    {
      return std::min(law.cutoff(), force_switch.end) + sum_of_radii;
    }

    /** The largest distance of consecutive sites [length]. */
    static double
    largest_spacing(const std::vector<LineSite> &sites)
    {
      double result = 0.;
      for (unsigned int i = 1; i < sites.size(); ++i)
        result = std::max(result, (sites[i].r - sites[i - 1].r).norm_square());
      return std::sqrt(result);
    }

  private:
    static PointPair
    pair(const LineSite &source, const LineSite &target)
    {
      return {source.r, source.r_x, target.r, target.r_x};
    }

    /**
     * Visit the targets within reach. The distance changes by no more than the
     * spacing from one site to the next, so those sites that it takes to come
     * within reach are jumped over.
     */
    template <typename Visitor>
    void
    for_each_near(const LineSite              &source,
                  const std::vector<LineSite> &targets,
                  const double                 spacing,
                  const Visitor               &visit) const
    {
      const double reach = this->reach();
      for (std::size_t j = 0; j < targets.size(); ++j)
        {
          const double square = (source.r - targets[j].r).norm_square();
          if (square < reach * reach)
            visit(j);
          else if (spacing > 0.)
            j += std::min<double>((std::sqrt(square) - reach) / spacing,
                                  targets.size());
        }
    }

    /** Forces do not act on the tangents. */
    static void
    leave_out_moments(PointPairEnergy &pair)
    {
      using namespace PointPairIndex;
      for (const unsigned int a : {a1, a2})
        {
          pair.gradient[a] = 0.;
          pair.hessian[a]  = {};
        }
    }

    /** Multiply the gradient by the switch, and differentiate that. */
    void
    switch_forces(const Tensor<1, 3> &d,
                  const double        distance,
                  PointPairEnergy    &pair) const
    {
      using namespace PointPairIndex;
      const GapDerivatives s =
        force_switch.derivatives(distance - sum_of_radii);
      const Tensor<1, 3> slope = s.first / distance * d;
      for (const unsigned int i : {r1, a1, r2, a2})
        {
          for (const unsigned int j : {r1, a1, r2, a2})
            pair.hessian[i][j] *= s.value;
          const Tensor<2, 3> change = outer_product(pair.gradient[i], slope);
          pair.hessian[i][r1] += change;
          pair.hessian[i][r2] -= change;
          pair.gradient[i] *= s.value;
        }
    }

    static void
    start(const std::vector<LineSite> &sites, std::vector<SiteForce> &forces)
    {
      if (forces.empty())
        for (const LineSite &site : sites)
          forces.push_back(
            {site.r, {}, std::numeric_limits<double>::infinity()});
    }

    Law          law;
    double       sum_of_radii;
    OffsetAxis   axis;
    bool         with_moments;
    CutoffSwitch force_switch; ///< of the gap between the centers
  };
} // namespace Setae

#endif
