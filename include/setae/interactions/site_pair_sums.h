// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_interactions_site_pair_sums_h
#define setae_interactions_site_pair_sums_h

#include <setae/base/local_system.h>
#include <setae/interactions/line_sites.h>
#include <setae/kinematics/gap_angle.h>

#include <tuple>
#include <vector>

namespace Setae
{
  /**
   * The sum of @f$B^Tg@f$ and @f$B^THB@f$ over pairs of sites of two cells, where
   * g and H are derivatives in the four vectors of a PointPair and B holds the
   * shape functions of both sites.
   *
   * What the shape functions of the source multiply is first summed over the
   * targets, and the other way around. So a pair costs a few 3 by 3 blocks, not
   * the 24 by 24 entries of the two cells. H may lack symmetry.
   */
  class SitePairSums
  {
  public:
    /** Begin with a pair of cells that has @p n_targets sites on the target. */
    void
    start(const unsigned int n_targets, const Request request)
    {
      this->request = request;
      if (request >= Request::residual)
        target_sums.assign(n_targets, Diagonal());
    }

    /** Begin with a site of the source. */
    void
    start_source()
    {
      source_sum = {};
      N_H        = {};
      H_N        = {};
    }

    /**
     * Add the pair of this source and the target number @p j. With a symmetric
     * Hessian, @p is_symmetric spares the rows of the source in the columns of
     * the target, which LocalSystem::symmetrize() then fills.
     */
    void
    add(const unsigned int     j,
        const LineSite        &target,
        const PointPairEnergy &pair,
        const bool             is_symmetric)
    {
      using namespace PointPairIndex;
      source_sum.add_gradient(pair, r1, a1);
      target_sums[j].add_gradient(pair, r2, a2);
      if (request < Request::tangent)
        return;

      const auto &H = pair.hessian;
      source_sum.add_hessian(pair, r1, a1);
      target_sums[j].add_hessian(pair, r2, a2);
      for (unsigned int a = 0; a < 4; ++a)
        {
          add_combination(
            target.N[a], H[r2][r1], target.N_x[a], H[a2][r1], N_H[a][0]);
          add_combination(
            target.N[a], H[r2][a1], target.N_x[a], H[a2][a1], N_H[a][1]);
          if (is_symmetric)
            continue;
          add_combination(
            target.N[a], H[r1][r2], target.N_x[a], H[r1][a2], H_N[a][0]);
          add_combination(
            target.N[a], H[a1][r2], target.N_x[a], H[a1][a2], H_N[a][1]);
        }
    }

    /** End with a site of the source. */
    void
    finish_source(const LineSite  &source,
                  const bool       is_symmetric,
                  LocalSystem<24> &local) const
    {
      source_sum.distribute(source, request, 0, local);
      if (request < Request::tangent)
        return;
      for (unsigned int a = 0; a < 4; ++a)
        for (unsigned int b = 0; b < 4; ++b)
          {
            local.add_block(12 + 3 * a, 3 * b, source.N[b], N_H[a][0]);
            local.add_block(12 + 3 * a, 3 * b, source.N_x[b], N_H[a][1]);
            if (is_symmetric)
              continue;
            local.add_block(3 * b, 12 + 3 * a, source.N[b], H_N[a][0]);
            local.add_block(3 * b, 12 + 3 * a, source.N_x[b], H_N[a][1]);
          }
    }

    /** End with the pair of cells. */
    void
    finish(const std::vector<LineSite> &targets, LocalSystem<24> &local) const
    {
      if (request >= Request::residual)
        for (unsigned int j = 0; j < targets.size(); ++j)
          if (target_sums[j].is_used)
            target_sums[j].distribute(targets[j], request, 12, local);
    }

  private:
    static void
    add_combination(const double        factor_0,
                    const Tensor<2, 3> &H_0,
                    const double        factor_1,
                    const Tensor<2, 3> &H_1,
                    Tensor<2, 3>       &sum)
    {
      for (unsigned int c = 0; c < 3; ++c)
        for (unsigned int e = 0; e < 3; ++e)
          sum[c][e] += factor_0 * H_0[c][e] + factor_1 * H_1[c][e];
    }

    /** The derivatives in position r and derivative a of one site. */
    struct Diagonal
    {
      bool         is_used = false;
      Tensor<1, 3> g_r, g_a;
      Tensor<2, 3> H_rr, H_ra, H_ar, H_aa;

      void
      add_gradient(const PointPairEnergy &pair,
                   const unsigned int     r,
                   const unsigned int     a)
      {
        is_used = true;
        g_r += pair.gradient[r];
        g_a += pair.gradient[a];
      }

      void
      add_hessian(const PointPairEnergy &pair,
                  const unsigned int     r,
                  const unsigned int     a)
      {
        H_rr += pair.hessian[r][r];
        H_ra += pair.hessian[r][a];
        H_ar += pair.hessian[a][r];
        H_aa += pair.hessian[a][a];
      }

      /** To the degrees of freedom from @p first on. */
      void
      distribute(const LineSite    &site,
                 const Request      request,
                 const unsigned int first,
                 LocalSystem<24>   &local) const
      {
        const auto &[N, N_x] = std::tie(site.N, site.N_x);
        for (unsigned int i = 0; i < 4; ++i)
          for (unsigned int c = 0; c < 3; ++c)
            local.residual[first + 3 * i + c] +=
              N[i] * g_r[c] + N_x[i] * g_a[c];
        if (request < Request::tangent)
          return;
        for (unsigned int i = 0; i < 4; ++i)
          {
            const Tensor<2, 3> H_r = N[i] * H_rr + N_x[i] * H_ar,
                               H_a = N[i] * H_ra + N_x[i] * H_aa;
            for (unsigned int j = 0; j < 4; ++j)
              {
                local.add_block(first + 3 * i, first + 3 * j, N[j], H_r);
                local.add_block(first + 3 * i, first + 3 * j, N_x[j], H_a);
              }
          }
      }
    };

    Request               request = Request::energy;
    Diagonal              source_sum;
    std::vector<Diagonal> target_sums;

    /** Target rows and source columns of r1 and a1, and the transposed ones. */
    std::array<std::array<Tensor<2, 3>, 2>, 4> N_H, H_N;
  };
} // namespace Setae

#endif
