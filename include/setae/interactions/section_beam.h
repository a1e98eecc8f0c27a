// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_interactions_section_beam_h
#define setae_interactions_section_beam_h

#include <setae/interactions/faded_target.h>
#include <setae/interactions/target_end.h>
#include <setae/laws/disk_contact.h>

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

namespace Setae
{
  /**
   * Interaction of every section of a source cell with the target cell next to
   * it (SBIP eq. 14): one integral over the source, with the law evaluated
   * between a site and its closest points on the target. SiteProjection moves
   * these with the degrees of freedom.
   *
   * Beyond the end of a target, the closest point stays at its last point
   * (SBIP), which a law with tilt cannot do, or it moves on along the tangent
   * and the target ends (TargetEnd) or fades (FadedTarget) there.
   *
   * @tparam Law A law of gap and cos(alpha), for example DiskCylinder, or of gap,
   * cos(alpha) and tilt, for example TabulatedDiskCylinder.
   */
  template <typename Law>
  class SectionBeam
  {
  public:
    SectionBeam(const Law &law, const double sum_of_radii)
      : law(law)
      , sum_of_radii(sum_of_radii)
    {}

    SectionBeam(const Law &law, const double sum_of_radii, TargetEnd<Law> end)
      : law(law)
      , sum_of_radii(sum_of_radii)
      , end(std::move(end))
    {}

    SectionBeam(const Law       &law,
                const double     sum_of_radii,
                FadedTarget<Law> fading)
      : law(law)
      , sum_of_radii(sum_of_radii)
      , fading(std::move(fading))
    {}

    /**
     * Add the interaction of one site, times @p weight, to the system of the two
     * cells (source first).
     *
     * @param place Where the target cell is on its fiber.
     * @return The smallest gap to the target cell [length], infinity beyond the
     * cutoff. Nothing is added if the law cannot be evaluated because the gap
     * is not positive and the law not regularized: the caller must then discard
     * the state.
     */
    double
    add(const LineSite      &site,
        const HermiteCell<> &target,
        const CellPlace     &place,
        const double         weight,
        const Request        request,
        LocalSystem<24>     &local) const
    {
      double smallest_gap = std::numeric_limits<double>::infinity();
      for_each_projection(
        site,
        target,
        place,
        [&](const SiteProjection &pair,
            const GapAngle       &geometry,
            const Standing       &standing) {
          smallest_gap = std::min(smallest_gap, standing.gap);
          if (!law.admits(standing.gap))
            return;
          if (standing.near_end && request == Request::energy)
            local.energy +=
              weight * energy_near_end(place, pose_of(pair, geometry));
          else if (standing.near_end)
            {
              const PlacedEnergy energy =
                chain_rule(weight *
                             energy_near_end(place,
                                             section_pose(geometry,
                                                          pair.projection.x)),
                           geometry);
              local.energy += energy.pair.value;
              pair.distribute(energy.pair, &energy.coordinate, request, local);
            }
          else
            {
              const auto derivatives =
                weight * surrogate(geometry).derivatives(law);
              local.energy += derivatives.value;
              if (request >= Request::residual)
                pair.distribute(geometry.energy(derivatives,
                                                request >= Request::tangent),
                                nullptr,
                                request,
                                local);
            }
        });
      return smallest_gap;
    }

    /**
     * The smallest gap of one site to the target cell [length], infinity beyond
     * the cutoff.
     */
    double
    gap(const LineSite      &site,
        const HermiteCell<> &target,
        const CellPlace     &place) const
    {
      double result = std::numeric_limits<double>::infinity();
      for_each_projection(site,
                          target,
                          place,
                          [&result](const SiteProjection &,
                                    const GapAngle &,
                                    const Standing &standing) {
                            result = std::min(result, standing.gap);
                          });
      return result;
    }

    /**
     * The forces per source length on both centerlines at one site, for output.
     */
    void
    forces(const LineSite         &site,
           const HermiteCell<>    &target,
           const CellPlace        &place,
           const double            factor,
           std::vector<SiteForce> &result) const
    {
      for_each_projection(
        site,
        target,
        place,
        [&](const SiteProjection &pair,
            const GapAngle       &geometry,
            const Standing       &standing) {
          if (!law.admits(standing.gap))
            return;
          PointPairEnergy energy;
          if (standing.near_end)
            energy =
              chain_rule(factor *
                           energy_near_end(
                             place, section_pose(geometry, pair.projection.x)),
                         geometry)
                .pair;
          else
            energy =
              geometry.energy(factor * surrogate(geometry).derivatives(law),
                              false);
          const Tensor<1, 3> force = -energy.gradient[PointPairIndex::r1];
          result.push_back({pair.points.r1, force, standing.gap});
          result.push_back({pair.points.r2, -force, standing.gap});
        });
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
           const CellPlace            &place = {}) const
    {
      using std::sqrt;
      Number               x  = projection.x;
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
      else if (moves_on())
        {
          const Number step = ((r1 - r2) * a2) / (a2 * a2);
          x += step;
          r2 += step * a2;
        }
      const Tensor<1, 3, Number> d = r1 - r2;
      const Number length_1 = sqrt(a1 * a1), length_2 = sqrt(a2 * a2);
      const Number cosine = (a1 * a2) / (length_1 * length_2);
      const Number along  = (a1 * d) / length_1;
      if (moves_on())
        return energy_near_end(
          place,
          SectionPose<Number>{Number(d * d), along, cosine, x, length_2});
      const Number distance = sqrt(d * d);
      return evaluate_law(law,
                          Number(distance - sum_of_radii),
                          cosine,
                          Number(along / distance));
    }

    /** The share of a site of the source that is in its EndZone. */
    double
    share_of_zone(const CellPlace &source, const double x) const
    {
      return EndZone(sum_of_radii, source.fiber_length).share(source, x);
    }

    /** Distance of two centerlines from which on the law is zero [length]. */
    double
    reach() const
    {
      return law.cutoff() + sum_of_radii;
    }

  private:
    /** A law of gap and angle at a site. */
    struct GapAngleSurrogate
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
    struct ContactSurrogate
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
    surrogate(const GapAngle &geometry) const
    {
      if constexpr (has_tilt<Law>)
        return ContactSurrogate{
          geometry, law.contact(geometry.gap, geometry.cosine, geometry.tilt)};
      else
        return GapAngleSurrogate{geometry};
    }

    /** How a section stands before the target. */
    struct Standing
    {
      double gap;      ///< to what there is of the target [length]
      bool   near_end; ///< so that it is not infinite
      bool   acts;     ///< whether there is anything of it
    };

    /** Call a function for every closest point within the cutoff. */
    template <typename Function>
    void
    for_each_projection(const LineSite      &site,
                        const HermiteCell<> &target,
                        const CellPlace     &place,
                        const Function      &function) const
    {
      for (const Projection &closest :
           closest_points(target, site.r, place.ends))
        {
          const SiteProjection pair(site,
                                    target,
                                    continued(closest, target, site.r));
          const GapAngle       geometry(pair.points, sum_of_radii);
          if (geometry.gap >= law.cutoff())
            continue;
          const Standing standing = this->standing(pair, geometry, place);
          if (standing.acts)
            function(pair, geometry, standing);
        }
    }

    static SectionPose<double>
    pose_of(const SiteProjection &pair, const GapAngle &geometry)
    {
      return {geometry.d * geometry.d,
              geometry.d * geometry.t1,
              geometry.cosine,
              pair.projection.x,
              geometry.length_2};
    }

    Standing
    standing(const SiteProjection &pair,
             const GapAngle       &geometry,
             const CellPlace      &place) const
    {
      const SectionPose<double> pose = pose_of(pair, geometry);
      if (fading.is_finite())
        {
          const auto at            = fading.surrogate(place, pose);
          const auto [least, most] = fading.parts(place, pose, at);
          if (!(most > 0.))
            return {0., true, false};
          constexpr double round_off = 1e-12;
          return {clearance(at.gap, pose.cosine, at.tilt),
                  least < 1. - round_off,
                  true};
        }
      if (!end.is_finite(place, pose))
        return {surrogate(geometry).gap(), false, true};
      const double of_end = end.clearance(place.ends, pose);
      return {end.has_side(pose.square) ?
                std::max(of_end, surrogate(geometry).gap()) :
                of_end,
              true,
              true};
    }

    /** Distance of a section and an infinite cylinder. */
    double
    clearance(const double gap, const double cosine, const double tilt) const
    {
      if constexpr (has_tilt<Law>)
        return law.contact(gap, cosine, tilt).clearance();
      else
        return gap;
    }

    template <typename Number>
    Number
    energy_near_end(const CellPlace           &place,
                    const SectionPose<Number> &pose) const
    {
      return fading.is_finite() ? fading.value(place, pose) :
                                  end.value(place, pose);
    }

    /** Whether the closest point does not stop at the end of a target. */
    bool
    moves_on() const
    {
      return end.is_finite() || fading.is_finite();
    }

    /** Let a closest point move on along the tangent at the end of a fiber. */
    Projection
    continued(const Projection    &projection,
              const HermiteCell<> &target,
              const Tensor<1, 3>  &point) const
    {
      if (projection.moves || !moves_on())
        return projection;
      const Tensor<1, 3> tangent = target.derivative(projection.x);
      const Tensor<1, 3> d       = point - target.position(projection.x);
      return {projection.x + d * tangent / tangent.norm_square(), true};
    }

    Law              law;
    double           sum_of_radii;
    TargetEnd<Law>   end;
    FadedTarget<Law> fading;
  };
} // namespace Setae

#endif
