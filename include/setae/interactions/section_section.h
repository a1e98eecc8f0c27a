// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_interactions_section_section_h
#define setae_interactions_section_section_h

#include <setae/base/law_derivatives.h>
#include <setae/base/local_system.h>
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
      double smallest_gap = std::numeric_limits<double>::infinity();

      // The sums over the target that meet the shape functions of the source.
      Tensor<1, 3>                f;
      Tensor<2, 3>                H;
      std::array<Tensor<2, 3>, 4> N_H;

      for (const LineSite &target : targets)
        {
          const Tensor<1, 3> d        = source.r - target.r;
          const double       distance = d.norm();
          const double       gap      = distance - sum_of_radii;
          if (gap >= law.cutoff())
            continue;
          smallest_gap = std::min(smallest_gap, gap);
          if (!law.admits(gap))
            continue;

          const double         weight = factor * source.weight * target.weight;
          const GapDerivatives pi     = law(gap);
          local.energy += weight * pi.value;
          if (request < Request::residual)
            continue;

          const Tensor<1, 3> n       = d / distance;
          const Tensor<1, 3> force_g = weight * pi.first * n;
          f += force_g;
          for (unsigned int a = 0; a < 4; ++a)
            for (unsigned int c = 0; c < 3; ++c)
              local.residual[12 + 3 * a + c] -= target.N[a] * force_g[c];
          if (request < Request::tangent)
            continue;

          const double lateral = weight * pi.first / distance;
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
      return smallest_gap;
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
      for (unsigned int i = 0; i < sites.size(); ++i)
        for (const LineSite &other : others)
          {
            const Tensor<1, 3> d        = sites[i].r - other.r;
            const double       distance = d.norm();
            const double       gap      = distance - sum_of_radii;
            if (gap >= law.cutoff() || !law.admits(gap))
              continue;
            forces[i].force -=
              factor * other.weight * law(gap).first / distance * d;
            forces[i].gap = std::min(forces[i].gap, gap);
          }
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
    Law    law;
    double sum_of_radii;
  };
} // namespace Setae

#endif
