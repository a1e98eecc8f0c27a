// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_interactions_section_section_h
#define setae_interactions_section_section_h

#include <deal.II/base/array_view.h>

#include <setae/base/law_derivatives.h>
#include <setae/base/local_system.h>
#include <setae/interactions/double_sum.h>
#include <setae/interactions/line_sites.h>

#include <cmath>

namespace Setae
{
  /**
   * Interaction of all pairs of sections of two cells (SSIP eq. 10): a double
   * integral over both centerlines.
   *
   * @tparam Law A law of the gap @f$g=|r_1-r_2|-R_1-R_2@f$, for example DiskDisk.
   */
  template <typename Law>
  class SectionSection
  {
  public:
    SectionSection(const Law &law, const double sum_of_radii)
      : law(law)
      , sum_of_radii(sum_of_radii)
    {}

    /**
     * Add the interaction of one site of the source with all sites of the
     * target cell, times @p factor, to the system of the two cells (source
     * first).
     *
     * @return The smallest gap seen [length], infinity if all are beyond the
     * cutoff. Pairs whose gap is not positive are left out unless the law is
     * regularized: the caller must then discard the state.
     */
    double
    add(const LineSite              &source,
        const std::vector<LineSite> &targets,
        const double                 factor,
        const Request                request,
        LocalSystem<24>             &local) const
    {
      CellPairSum sum(law, source.weight * factor, request, local);
      double_sum(dealii::ArrayView<const LineSite>(&source, 1),
                 targets,
                 *this,
                 sum);
      return sum.smallest_gap;
    }

    /**
     * Add the forces per length on the centerline at @p sites from all @p others,
     * times @p factor, to @p forces, one for each site.
     */
    void
    add_forces(const std::vector<LineSite> &sites,
               const std::vector<LineSite> &others,
               const double                 factor,
               std::vector<SiteForce>      &forces) const
    {
      if (forces.empty())
        for (const LineSite &site : sites)
          forces.push_back(
            {site.r, {}, std::numeric_limits<double>::infinity()});
      ForceSum sum{law, factor, forces.data()};
      double_sum(sites, others, *this, sum);
    }

    /** Distance and gap of two sections, which the law sees. */
    struct Coordinate
    {
      double distance, gap;
    };

    Coordinate
    coordinate(const Tensor<1, 3> &d) const
    {
      const double distance = d.norm();
      return {distance, distance - sum_of_radii};
    }

    GapDerivatives
    operator()(const Coordinate &x) const
    {
      return law(x.gap);
    }

    /**
     * The energy of one pair of sites on any number type: the reference for the
     * derivatives.
     */
    template <typename Number>
    Number
    energy(const Tensor<1, 3, Number> &r1, const Tensor<1, 3, Number> &r2) const
    {
      using std::sqrt;
      const Tensor<1, 3, Number> d = r1 - r2;
      return law.energy(Number(sqrt(d * d) - sum_of_radii));
    }

    /** Distance of two centerlines from which on the law is zero [length]. */
    double
    reach() const
    {
      return law.cutoff() + sum_of_radii;
    }

  private:
    /** Energy, residual and tangent matrix of two cells. */
    struct CellPairSum
    {
      CellPairSum(const Law       &law,
                  const double     factor,
                  const Request    request,
                  LocalSystem<24> &local)
        : law(law)
        , factor(factor)
        , request(request)
        , local(local)
      {}

      void
      begin(const LineSite &)
      {}

      DEAL_II_ALWAYS_INLINE bool
      accepts(const Coordinate &x)
      {
        if (x.gap >= law.cutoff())
          return false;
        smallest_gap = std::min(smallest_gap, x.gap);
        return law.admits(x.gap);
      }

      DEAL_II_ALWAYS_INLINE void
      add(const LineSite &,
          const LineSite       &target,
          const Tensor<1, 3>   &d,
          const Coordinate     &x,
          const GapDerivatives &pi)
      {
        const double weight = factor * target.weight;
        local.energy += weight * pi.value;
        if (request < Request::residual)
          return;

        const Tensor<1, 3> n       = d / x.distance;
        const Tensor<1, 3> force_g = weight * pi.first * n;
        f += force_g;
        for (unsigned int a = 0; a < 4; ++a)
          for (unsigned int c = 0; c < 3; ++c)
            local.residual[12 + 3 * a + c] -= target.N[a] * force_g[c];
        if (request < Request::tangent)
          return;

        const double lateral = weight * pi.first / x.distance;
        Tensor<2, 3> H_pair =
          outer_product(n, (weight * pi.second - lateral) * n);
        for (unsigned int c = 0; c < 3; ++c)
          H_pair[c][c] += lateral;
        H += H_pair;
        for (unsigned int a = 0; a < 4; ++a)
          {
            const Tensor<2, 3> N_a_H = target.N[a] * H_pair;
            N_H[a] += N_a_H;
            for (unsigned int b = 0; b <= a; ++b)
              local.add_block(12 + 3 * a, 12 + 3 * b, target.N[b], N_a_H);
          }
      }

      void
      end(const LineSite &source)
      {
        if (request >= Request::residual)
          for (unsigned int a = 0; a < 4; ++a)
            for (unsigned int c = 0; c < 3; ++c)
              local.residual[3 * a + c] += source.N[a] * f[c];
        if (request >= Request::tangent)
          for (unsigned int a = 0; a < 4; ++a)
            for (unsigned int b = 0; b < 4; ++b)
              {
                if (b <= a)
                  local.add_block(3 * a, 3 * b, source.N[a] * source.N[b], H);
                local.add_block(12 + 3 * a, 3 * b, -source.N[b], N_H[a]);
              }
      }

      double smallest_gap = std::numeric_limits<double>::infinity();

    private:
      const Law       &law;
      const double     factor; ///< with the weight of the source
      const Request    request;
      LocalSystem<24> &local;

      // The sums over the target that meet the shape functions of the source.
      Tensor<1, 3>                f;
      Tensor<2, 3>                H;
      std::array<Tensor<2, 3>, 4> N_H;
    };

    /** Forces at the sites of one cell. */
    struct ForceSum
    {
      const Law   &law;
      const double factor;
      SiteForce   *force; ///< of the present source

      void
      begin(const LineSite &)
      {}

      bool
      accepts(const Coordinate &x) const
      {
        return x.gap < law.cutoff() && law.admits(x.gap);
      }

      void
      add(const LineSite &,
          const LineSite       &target,
          const Tensor<1, 3>   &d,
          const Coordinate     &x,
          const GapDerivatives &pi)
      {
        force->force -= factor * target.weight * pi.first / x.distance * d;
        force->gap = std::min(force->gap, x.gap);
      }

      void
      end(const LineSite &)
      {
        ++force;
      }
    };

    Law    law;
    double sum_of_radii;
  };
} // namespace Setae

#endif
