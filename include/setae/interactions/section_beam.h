// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_interactions_section_beam_h
#define setae_interactions_section_beam_h

#include <setae/base/local_system.h>
#include <setae/interactions/line_sites.h>
#include <setae/kinematics/closest_point.h>
#include <setae/kinematics/gap_angle.h>
#include <setae/laws/disk_contact.h>

#include <type_traits>

namespace Setae
{
  /**
   * Interaction of every section of a source cell with the target cell next to
   * it (SBIP eq. 14): one integral over the source, with the law evaluated
   * between a site and its closest points on the target.
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
      for (const Projection &projection : closest_points(target, site.r, ends))
        {
          const PointPair pair = {site.r,
                                  site.r_x,
                                  target.position(projection.x),
                                  target.derivative(projection.x)};
          const GapAngle  geometry(pair, sum_of_radii);
          if (geometry.gap >= law.cutoff())
            continue;
          const auto   site_law = place(geometry);
          const double gap      = site_law.gap();
          smallest_gap          = std::min(smallest_gap, gap);
          if (!law.admits(gap))
            continue;

          const auto derivatives = weight * site_law.derivatives(law);
          local.energy += derivatives.value;
          if (request >= Request::residual)
            distribute(site,
                       target,
                       projection,
                       pair,
                       geometry.energy(derivatives,
                                       request >= Request::tangent),
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
      for (const Projection &projection : closest_points(target, site.r, ends))
        {
          const PointPair pair = {site.r,
                                  site.r_x,
                                  target.position(projection.x),
                                  target.derivative(projection.x)};
          const GapAngle  geometry(pair, sum_of_radii);
          if (geometry.gap >= law.cutoff())
            continue;
          const auto   site_law = place(geometry);
          const double gap      = site_law.gap();
          if (!law.admits(gap))
            continue;
          const Tensor<1, 3> force =
            -factor *
            geometry.energy(site_law.derivatives(law), false).gradient[0];
          result.push_back({pair.r1, force, gap});
          result.push_back({pair.r2, -force, gap});
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
           const Projection           &projection) const
    {
      using std::sqrt;
      Number x = projection.x;
      if (projection.moves)
        for (unsigned int step = 0; step < 2; ++step)
          {
            const Tensor<1, 3, Number> d   = r1 - target.position(x);
            const Tensor<1, 3, Number> r_x = target.derivative(x);
            x -= (d * r_x) / (d * target.second_derivative(x) - r_x * r_x);
          }
      const Tensor<1, 3, Number> d   = r1 - target.position(x);
      const Tensor<1, 3, Number> a2  = target.derivative(x);
      const Number               gap = sqrt(d * d) - sum_of_radii;
      const Number cosine            = (a1 * a2) / sqrt((a1 * a1) * (a2 * a2));
      if constexpr (has_tilt)
        {
          const Number tilt = (a1 * d) / sqrt((a1 * a1) * (d * d));
          return law.energy(gap, cosine, tilt);
        }
      else
        return law.energy(gap, cosine);
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

    /** An entry for every degree of freedom of the two cells. */
    using Row = std::array<double, 24>;

    /** Shape functions at the closest point, with derivatives. */
    struct TargetShapes
    {
      std::array<double, 4> M, M_x, M_xx;
    };

    void
    distribute(const LineSite      &site,
               const HermiteCell<> &target,
               const Projection    &projection,
               const PointPair     &pair,
               PointPairEnergy      L,
               const Request        request,
               LocalSystem<24>     &local) const
    {
      using namespace PointPairIndex;

      const TargetShapes shapes = {
        Hermite::shape_values(projection.x, target.h),
        Hermite::shape_derivatives(projection.x, target.h),
        Hermite::shape_second_derivatives(projection.x, target.h)};
      const Tensor<1, 3> b2 = target.combine(shapes.M_xx);
      const Tensor<1, 3> d  = pair.r1 - pair.r2;

      // The Lagrangian f - lambda p of a closest point that moves. Where the
      // site sits in the center of curvature of the target, every point nearby
      // is closest and none is preferred: the projection then counts as fixed.
      const double p_xi = d * b2 - pair.a2 * pair.a2;
      const bool   moves =
        projection.moves && p_xi < -1e-8 * pair.a2.norm_square();
      if (moves)
        {
          const double lambda =
            (L.gradient[r2] * pair.a2 + L.gradient[a2] * b2) / p_xi;
          L.gradient[r1] -= lambda * pair.a2;
          L.gradient[r2] += lambda * pair.a2;
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

      add_residual(site, shapes, L, local);
      if (request < Request::tangent)
        return;

      Row xi_q = {}, w = {};
      if (moves)
        {
          // The motion of the closest point, v_xi = (0, 0, a2, b2) and its
          // derivative (0, 0, b2, c2), in the four vectors and then in q.
          const Tensor<1, 3>          c2 = target.third_derivative();
          std::array<Tensor<1, 3>, 4> L_xi;
          for (unsigned int v = 0; v < 4; ++v)
            L_xi[v] = L.hessian[v][r2] * pair.a2 + L.hessian[v][a2] * b2;
          const double L_xi_xi = pair.a2 * L_xi[r2] + b2 * L_xi[a2] +
                                 L.gradient[r2] * b2 + L.gradient[a2] * c2;
          L_xi[a2] += L.gradient[r2];

          const auto &[M, M_x, M_xx] = shapes;
          for (unsigned int a = 0; a < 4; ++a)
            for (unsigned int c = 0; c < 3; ++c)
              {
                const unsigned int i = 3 * a + c, j = 12 + i;
                xi_q[i] = -site.N[a] * pair.a2[c] / p_xi;
                xi_q[j] = (M[a] * pair.a2[c] - M_x[a] * d[c]) / p_xi;
                w[i]    = site.N[a] * L_xi[r1][c] + site.N_x[a] * L_xi[a1][c];
                w[j]    = M[a] * L_xi[r2][c] + M_x[a] * L_xi[a2][c] +
                       M_xx[a] * L.gradient[a2][c];
              }
          for (unsigned int i = 0; i < 24; ++i)
            w[i] += .5 * L_xi_xi * xi_q[i];
        }
      add_tangent(site, shapes, L, xi_q, w, local);
    }

    /** Add B^T L_v for the gradient in the four vectors v = B q. */
    static void
    add_residual(const LineSite        &site,
                 const TargetShapes    &shapes,
                 const PointPairEnergy &L,
                 LocalSystem<24>       &local)
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
    static void
    add_tangent(const LineSite        &site,
                const TargetShapes    &shapes,
                const PointPairEnergy &L,
                const Row              xi_q,
                const Row              w,
                LocalSystem<24>       &local)
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

    Law    law;
    double sum_of_radii;
  };
} // namespace Setae

#endif
