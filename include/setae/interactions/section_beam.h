// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_interactions_section_beam_h
#define setae_interactions_section_beam_h

#include <setae/interactions/target_end.h>
#include <setae/laws/disk_contact.h>

#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace Setae
{
  /**
   * Interaction of every section of a source cell with the target cell next to
   * it (SBIP eq. 14): one integral over the source, with the law evaluated
   * between a site and its closest points on the target. SiteProjection moves
   * these with the degrees of freedom, TargetEnd takes the ends into account.
   *
   * @tparam Law A law of gap and cos(alpha), for example DiskCylinder, or of gap,
   * cos(alpha) and tilt, for example TabulatedDiskCylinder.
   */
  template <typename Law>
  class SectionBeam
  {
  public:
    using EndTerm = typename TargetEnd<Law>::Term;

    /**
     * @param end_terms The law of each power, if the ends of a target are
     * treated as such; empty to stay at the last point of the target beyond its
     * end (SBIP), which a law with tilt cannot do.
     */
    SectionBeam(const Law           &law,
                const double         sum_of_radii,
                std::vector<EndTerm> end_terms = {})
      : law(law)
      , sum_of_radii(sum_of_radii)
      , end(std::move(end_terms))
    {}

    /**
     * Add the interaction of one site, times @p weight, to the system of the two
     * cells (source first).
     *
     * @return The smallest gap to the target cell [length], infinity beyond the
     * cutoff. Nothing is added if the law cannot be evaluated because the gap
     * is not positive and the law not regularized: the caller must then discard
     * the state.
     */
    double
    add(const LineSite      &site,
        const HermiteCell<> &target,
        const FiberEnds     &ends,
        const double         weight,
        const Request        request,
        LocalSystem<24>     &local) const
    {
      double smallest_gap = std::numeric_limits<double>::infinity();
      for (const Projection &closest : closest_points(target, site.r, ends))
        {
          const SiteProjection pair(site,
                                    target,
                                    continued(closest, target, site.r));
          const GapAngle       geometry(pair.points, sum_of_radii);
          if (geometry.gap >= law.cutoff())
            continue;
          const double gap = this->gap(pair, geometry, ends);
          smallest_gap     = std::min(smallest_gap, gap);
          if (!law.admits(gap))
            continue;

          if (end.is_finite(ends))
            {
              const EndEnergy energy =
                end.energy(ends, pair.projection.x, geometry, weight);
              local.energy += energy.pair.value;
              if (request >= Request::residual)
                pair.distribute(energy.pair,
                                &energy.coordinate,
                                request,
                                local);
              continue;
            }
          const auto derivatives = weight * place(geometry).derivatives(law);
          local.energy += derivatives.value;
          if (request >= Request::residual)
            pair.distribute(geometry.energy(derivatives,
                                            request >= Request::tangent),
                            nullptr,
                            request,
                            local);
        }
      return smallest_gap;
    }

    /**
     * The forces per source length on both centerlines at one site, for output.
     */
    void
    forces(const LineSite         &site,
           const HermiteCell<>    &target,
           const FiberEnds        &ends,
           const double            factor,
           std::vector<SiteForce> &result) const
    {
      for (const Projection &closest : closest_points(target, site.r, ends))
        {
          const SiteProjection pair(site,
                                    target,
                                    continued(closest, target, site.r));
          const GapAngle       geometry(pair.points, sum_of_radii);
          if (geometry.gap >= law.cutoff())
            continue;
          const double gap = this->gap(pair, geometry, ends);
          if (!law.admits(gap))
            continue;
          PointPairEnergy energy;
          if (end.is_finite(ends))
            energy = end.energy(ends, pair.projection.x, geometry, factor).pair;
          else
            energy =
              geometry.energy(factor * place(geometry).derivatives(law), false);
          const Tensor<1, 3> force = -energy.gradient[PointPairIndex::r1];
          result.push_back({pair.points.r1, force, gap});
          result.push_back({pair.points.r2, -force, gap});
        }
    }

    /**
     * The energy of one site on any number type, the reference for the
     * derivatives. @p projection is a converged closest point; two Newton steps
     * on the number type give it its first and second derivatives.
     */
    template <typename Number>
    Number
    energy(const Tensor<1, 3, Number> &r1,
           const Tensor<1, 3, Number> &a1,
           const HermiteCell<Number>  &target,
           const Projection           &projection,
           const FiberEnds            &ends = {}) const
    {
      using std::sqrt;
      const bool           finite = end.is_finite(ends);
      const bool           beyond = finite && !projection.moves;
      Number               x      = projection.x;
      Tensor<1, 3, Number> r2 = target.position(x), a2 = target.derivative(x);
      if (projection.moves)
        {
          for (unsigned int step = 0; step < 2; ++step)
            {
              const Tensor<1, 3, Number> d   = r1 - target.position(x);
              const Tensor<1, 3, Number> r_x = target.derivative(x);
              x -= (d * r_x) / (d * target.second_derivative(x) - r_x * r_x);
            }
          r2 = target.position(x);
          a2 = target.derivative(x);
        }
      else if (beyond)
        {
          const Number step = ((r1 - r2) * a2) / (a2 * a2);
          x += step;
          r2 += step * a2;
        }
      const Tensor<1, 3, Number> d = r1 - r2;
      const Number length_1 = sqrt(a1 * a1), length_2 = sqrt(a2 * a2);
      const Number cosine   = (a1 * a2) / (length_1 * length_2);
      const Number along    = (a1 * d) / length_1;
      const auto   evaluate = [](const Law    &law,
                               const Number &gap,
                               const Number &cosine,
                               const Number &tilt) {
        if constexpr (has_tilt)
          return law.energy(gap, cosine, tilt);
        else
          return law.energy(gap, cosine);
      };
      if (finite)
        return end.value(
          ends, Number(d * d), along, cosine, x, length_2, evaluate);
      const Number distance = sqrt(d * d);
      return evaluate(law,
                      Number(distance - sum_of_radii),
                      cosine,
                      Number(along / distance));
    }

    /** Distance of two centerlines from which on the law is zero [length]. */
    double
    reach() const
    {
      return law.cutoff() + sum_of_radii;
    }

  private:
    static constexpr bool has_tilt =
      std::is_invocable_v<Law, double, double, double>;

    /** A law of gap and angle at a site. */
    struct GapAnglePlace
    {
      const GapAngle &geometry;

      double
      gap() const
      {
        return geometry.gap;
      }

      GapAngleDerivatives
      derivatives(const Law &law) const
      {
        return law(geometry.gap, geometry.cosine);
      }
    };

    /** A law of gap, angle and tilt at a site. */
    struct ContactPlace
    {
      const GapAngle     &geometry;
      DiskContact<double> contact;

      double
      gap() const
      {
        return contact.clearance();
      }

      GapAngleTiltDerivatives
      derivatives(const Law &law) const
      {
        return law(contact, geometry.gap, geometry.cosine, geometry.tilt);
      }
    };

    auto
    place(const GapAngle &geometry) const
    {
      if constexpr (has_tilt)
        return ContactPlace{
          geometry, law.contact(geometry.gap, geometry.cosine, geometry.tilt)};
      else
        return GapAnglePlace{geometry};
    }

    /** Distance of a section and the target: its side or an end. */
    double
    gap(const SiteProjection &pair,
        const GapAngle       &geometry,
        const FiberEnds      &ends) const
    {
      if (!end.is_finite(ends))
        return place(geometry).gap();
      const double square = geometry.d * geometry.d;
      const double of_end = end.clearance(
        ends, pair.projection.x, square, geometry.d * geometry.t1, geometry);
      return end.has_side(square) ? std::max(of_end, place(geometry).gap()) :
                                    of_end;
    }

    /** Let a closest point move on along the tangent at the end of a fiber. */
    Projection
    continued(const Projection    &projection,
              const HermiteCell<> &target,
              const Tensor<1, 3>  &point) const
    {
      if (projection.moves || !end.is_finite())
        return projection;
      const Tensor<1, 3> tangent = target.derivative(projection.x);
      const Tensor<1, 3> d       = point - target.position(projection.x);
      return {projection.x + d * tangent / tangent.norm_square(), true};
    }

    Law            law;
    double         sum_of_radii;
    TargetEnd<Law> end;
  };
} // namespace Setae

#endif
