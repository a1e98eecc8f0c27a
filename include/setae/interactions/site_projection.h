// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_interactions_site_projection_h
#define setae_interactions_site_projection_h

#include <setae/base/local_system.h>
#include <setae/interactions/line_sites.h>
#include <setae/interactions/target_shapes.h>
#include <setae/kinematics/closest_point.h>
#include <setae/kinematics/gap_angle.h>

#include <array>

namespace Setae
{
  /** Derivatives in the explicit coordinate x of the closest point. */
  struct CoordinateDerivatives
  {
    double                      x, xx;
    std::array<Tensor<1, 3>, 4> gradient_x;
  };

  /**
   * A site of the source and a closest point on the target, and how a function
   * of the two points and of the derivatives of both curves there acts on the
   * degrees of freedom of the two cells.
   *
   * The coordinate @f$\xi(q)@f$ of the closest point moves with the degrees of
   * freedom q of both cells, held by @f$p(q,\xi)=(r_1-r_2)\cdot r_{2,\xi}=0@f$.
   * With @f$L=f-\lambda p@f$ and @f$\lambda=f_{,\xi}/p_{,\xi}@f$ kept fixed,
   * @f$L_{,\xi}=0@f$, and the energy @f$f(q,\xi(q))@f$ has the gradient
   * @f$L_{,q}@f$ and the Hessian
   * @f[ L_{,qq} + L_{,q\xi}\otimes\xi_{,q} + \xi_{,q}\otimes L_{,q\xi} +
   *     L_{,\xi\xi}\,\xi_{,q}\otimes\xi_{,q}, \qquad
   *     \xi_{,q}=-p_{,q}/p_{,\xi}. @f]
   * These are SBIP eq. 24-29 and B10-B25 without a second derivative of
   * @f$\xi@f$.
   */
  class SiteProjection
  {
  public:
    SiteProjection(const LineSite      &site,
                   const HermiteCell<> &target,
                   const Projection    &projection)
      : site(site)
      , target(target)
      , projection(projection)
      , shapes(projection.x, target.h)
      , points{site.r,
               site.r_x,
               target.combine(shapes.M),
               target.combine(shapes.M_x)}
    {}

    const LineSite      &site;
    const HermiteCell<> &target;
    const Projection     projection;
    const TargetShapes   shapes;
    const PointPair      points;

    /**
     * Add the derivatives of a function of the four vectors and, if it depends
     * on that too, explicitly of the coordinate of the closest point.
     */
    void
    distribute(PointPairEnergy              L,
               const CoordinateDerivatives *explicit_x,
               const Request                request,
               LocalSystem<24>             &local) const
    {
      using namespace PointPairIndex;

      const Tensor<1, 3> b2 = target.combine(shapes.M_xx);
      const Tensor<1, 3> d  = points.r1 - points.r2;

      // The Lagrangian f - lambda p of a closest point that moves. Where the
      // site sits in the center of curvature of the target, every point nearby
      // is closest and none is preferred: the projection then counts as fixed.
      const double p_xi = d * b2 - points.a2 * points.a2;
      const bool   moves =
        projection.moves && p_xi < -1e-8 * points.a2.norm_square();
      if (moves)
        {
          const double f_xi = L.gradient[r2] * points.a2 + L.gradient[a2] * b2 +
                              (explicit_x != nullptr ? explicit_x->x : 0.);
          const double lambda = f_xi / p_xi;
          L.gradient[r1] -= lambda * points.a2;
          L.gradient[r2] += lambda * points.a2;
          L.gradient[a2] -= lambda * d;
          if (request >= Request::tangent)
            for (unsigned int c = 0; c < 3; ++c)
              {
                L.hessian[r1][a2][c][c] -= lambda;
                L.hessian[a2][r1][c][c] -= lambda;
                L.hessian[r2][a2][c][c] += lambda;
                L.hessian[a2][r2][c][c] += lambda;
              }
        }

      add_residual(L, local);
      if (request < Request::tangent)
        return;

      Row xi_q = {}, w = {};
      if (moves)
        {
          // The motion of the closest point, v_xi = (0, 0, a2, b2) and its
          // derivative (0, 0, b2, c2), in the four vectors and then in q.
          const Tensor<1, 3> c2 =
            shapes.beyond > 0. ? Tensor<1, 3>() : target.third_derivative();
          std::array<Tensor<1, 3>, 4> L_xi;
          for (unsigned int v = 0; v < 4; ++v)
            L_xi[v] = L.hessian[v][r2] * points.a2 + L.hessian[v][a2] * b2;
          double L_xi_xi = points.a2 * L_xi[r2] + b2 * L_xi[a2] +
                           L.gradient[r2] * b2 + L.gradient[a2] * c2;
          L_xi[a2] += L.gradient[r2];
          if (explicit_x != nullptr)
            {
              L_xi_xi += 2. * (explicit_x->gradient_x[r2] * points.a2 +
                               explicit_x->gradient_x[a2] * b2) +
                         explicit_x->xx;
              for (unsigned int v = 0; v < 4; ++v)
                L_xi[v] += explicit_x->gradient_x[v];
            }

          const auto &M = shapes.M, &M_x = shapes.M_x, &M_xx = shapes.M_xx;
          for (unsigned int a = 0; a < 4; ++a)
            for (unsigned int c = 0; c < 3; ++c)
              {
                const unsigned int i = 3 * a + c, j = 12 + i;
                xi_q[i] = -site.N[a] * points.a2[c] / p_xi;
                xi_q[j] = (M[a] * points.a2[c] - M_x[a] * d[c]) / p_xi;
                w[i]    = site.N[a] * L_xi[r1][c] + site.N_x[a] * L_xi[a1][c];
                w[j]    = M[a] * L_xi[r2][c] + M_x[a] * L_xi[a2][c] +
                       M_xx[a] * L.gradient[a2][c];
              }
          for (unsigned int i = 0; i < 24; ++i)
            w[i] += .5 * L_xi_xi * xi_q[i];
        }
      add_tangent(L, xi_q, w, local);
    }

  private:
    /** An entry for every degree of freedom of the two cells. */
    using Row = std::array<double, 24>;

    /** Add B^T L_v for the gradient in the four vectors v = B q. */
    void
    add_residual(const PointPairEnergy &L, LocalSystem<24> &local) const
    {
      using namespace PointPairIndex;
      for (unsigned int a = 0; a < 4; ++a)
        for (unsigned int c = 0; c < 3; ++c)
          {
            local.residual[3 * a + c] +=
              site.N[a] * L.gradient[r1][c] + site.N_x[a] * L.gradient[a1][c];
            local.residual[12 + 3 * a + c] += shapes.M[a] * L.gradient[r2][c] +
                                              shapes.M_x[a] * L.gradient[a2][c];
          }
    }

    /**
     * Add B^T L_vv B + w xi_q^T + xi_q w^T, but for the rows of the source in
     * the columns of the target, which LocalSystem::symmetrize() fills. The
     * last two rows come by value: then the compiler knows that they are none
     * of the tangent matrix.
     */
    void
    add_tangent(const PointPairEnergy &L,
                const Row              xi_q,
                const Row              w,
                LocalSystem<24>       &local) const
    {
      using namespace PointPairIndex;

      // L_vv B, without the part of r2, which is the negative one of r1 because
      // L depends on r1 - r2 only, and of (a1, target), which is not needed.
      const auto        &H = L.hessian;
      const auto        &N = site.N, &N_x = site.N_x;
      const auto        &M = shapes.M, &M_x = shapes.M_x;
      std::array<Row, 3> H_r1, H_a1, H_a2;
      for (unsigned int c = 0; c < 3; ++c)
        for (unsigned int b = 0; b < 4; ++b)
          for (unsigned int e = 0; e < 3; ++e)
            {
              const unsigned int i = 3 * b + e, j = 12 + i;
              H_r1[c][i] = H[r1][r1][c][e] * N[b] + H[r1][a1][c][e] * N_x[b];
              H_a1[c][i] = H[a1][r1][c][e] * N[b] + H[a1][a1][c][e] * N_x[b];
              H_a2[c][i] = H[a2][r1][c][e] * N[b] + H[a2][a1][c][e] * N_x[b];
              H_r1[c][j] = H[r1][r2][c][e] * M[b] + H[r1][a2][c][e] * M_x[b];
              H_a2[c][j] = H[a2][r2][c][e] * M[b] + H[a2][a2][c][e] * M_x[b];
            }

      for (unsigned int a = 0; a < 4; ++a)
        for (unsigned int c = 0; c < 3; ++c)
          {
            const unsigned int i = 3 * a + c, j = 12 + i;
            add_combination<12>(N[a],
                                H_r1[c],
                                N_x[a],
                                H_a1[c],
                                w[i],
                                xi_q,
                                xi_q[i],
                                w,
                                local.tangent[i]);
            add_combination<24>(-M[a],
                                H_r1[c],
                                M_x[a],
                                H_a2[c],
                                w[j],
                                xi_q,
                                xi_q[j],
                                w,
                                local.tangent[j]);
          }
    }

    /** Add a linear combination of rows to the first @p n entries of one. */
    template <unsigned int n>
    static void
    add_combination(const double factor_0,
                    const Row   &row_0,
                    const double factor_1,
                    const Row   &row_1,
                    const double factor_2,
                    const Row   &row_2,
                    const double factor_3,
                    const Row   &row_3,
                    Row         &result)
    {
      for (unsigned int k = 0; k < n; ++k)
        result[k] += factor_0 * row_0[k] + factor_1 * row_1[k] +
                     factor_2 * row_2[k] + factor_3 * row_3[k];
    }
  };
} // namespace Setae

#endif
