// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_interactions_section_beam_h
#define setae_interactions_section_beam_h

#include <setae/base/jet.h>
#include <setae/base/local_system.h>
#include <setae/interactions/line_sites.h>
#include <setae/kinematics/closest_point.h>
#include <setae/kinematics/gap_angle.h>
#include <setae/laws/disk_contact.h>
#include <setae/laws/end_fraction.h>

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
    /** The law of one power of the point potential before the end of a target.
     */
    struct EndTerm
    {
      Law         law;
      EndFraction fraction;
    };

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
      , end_terms(std::move(end_terms))
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
          const Projection   projection = continued(closest, target, site.r);
          const TargetShapes shapes(projection.x, target.h);
          const PointPair    pair = {site.r,
                                     site.r_x,
                                     target.combine(shapes.M),
                                     target.combine(shapes.M_x)};
          const GapAngle     geometry(pair, sum_of_radii);
          if (geometry.gap >= law.cutoff())
            continue;
          const auto   site_law = place(geometry);
          const double gap      = site_law.gap();
          const double beyond   = shapes.beyond * geometry.length_2;
          smallest_gap =
            std::min(smallest_gap,
                     beyond > 0. ? std::hypot(std::max(gap, 0.), beyond) : gap);
          // Beyond an end the energy vanishes with the gap, see EndFraction.
          if (!law.admits(gap))
            continue;

          if (!end_terms.empty() && (ends.left || ends.right))
            {
              add_at_end(site,
                         target,
                         ends,
                         projection,
                         shapes,
                         pair,
                         geometry,
                         weight,
                         request,
                         local);
              continue;
            }
          const auto derivatives = weight * site_law.derivatives(law);
          local.energy += derivatives.value;
          if (request >= Request::residual)
            distribute(site,
                       target,
                       projection,
                       shapes,
                       pair,
                       geometry.energy(derivatives,
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
          const Projection   projection = continued(closest, target, site.r);
          const TargetShapes shapes(projection.x, target.h);
          const PointPair    pair = {site.r,
                                     site.r_x,
                                     target.combine(shapes.M),
                                     target.combine(shapes.M_x)};
          const GapAngle     geometry(pair, sum_of_radii);
          if (geometry.gap >= law.cutoff())
            continue;
          const auto   site_law = place(geometry);
          const double gap      = site_law.gap();
          if (!law.admits(gap))
            continue;
          PointPairEnergy energy;
          if (!end_terms.empty() && (ends.left || ends.right))
            energy = end_energy(ends, projection.x, geometry, factor).pair;
          else
            energy = geometry.energy(factor * site_law.derivatives(law), false);
          const Tensor<1, 3> force = -energy.gradient[PointPairIndex::r1];
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
           const Projection           &projection,
           const FiberEnds            &ends = {}) const
    {
      using std::sqrt;
      const bool finite       = !end_terms.empty() && (ends.left || ends.right);
      const bool beyond       = finite && !projection.moves;
      Number     x            = projection.x;
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
      const Tensor<1, 3, Number> d   = r1 - r2;
      const Number               gap = sqrt(d * d) - sum_of_radii;
      const Number cosine            = (a1 * a2) / sqrt((a1 * a1) * (a2 * a2));
      const Number tilt              = (a1 * d) / sqrt((a1 * a1) * (d * d));
      const auto   evaluate          = [&](const Law &law) {
        if constexpr (has_tilt)
          return law.energy(gap, cosine, tilt);
        else
          return law.energy(gap, cosine);
      };
      if (!finite)
        return evaluate(law);
      const Number length = sqrt(a2 * a2);
      Number       sum    = 0.;
      for (const EndTerm &term : end_terms)
        sum += evaluate(term.law) *
               existing_part(term.fraction, ends, gap, cosine, tilt, x, length);
      return sum;
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

    /**
     * Shape functions at the closest point, with derivatives. Beyond the cell
     * they continue linearly, the curve as its tangent.
     */
    struct TargetShapes
    {
      TargetShapes(const double x, const double h)
        : beyond(std::abs(x - inside(x)))
        , M(Hermite::shape_values(inside(x), h))
        , M_x(Hermite::shape_derivatives(inside(x), h))
      {
        if (beyond > 0.)
          for (unsigned int a = 0; a < 4; ++a)
            M[a] += (x - inside(x)) * M_x[a];
        else
          M_xx = Hermite::shape_second_derivatives(x, h);
      }

      const double          beyond; ///< the end, as reference coordinate
      std::array<double, 4> M, M_x, M_xx = {};

    private:
      static double
      inside(const double x)
      {
        return std::min(std::max(x, 0.), 1.);
      }
    };

    /** Let a closest point move on along the tangent at the end of a fiber. */
    Projection
    continued(const Projection    &projection,
              const HermiteCell<> &target,
              const Tensor<1, 3>  &point) const
    {
      if (projection.moves || end_terms.empty())
        return projection;
      const Tensor<1, 3> tangent = target.derivative(projection.x);
      const Tensor<1, 3> d       = point - target.position(projection.x);
      return {projection.x + d * tangent / tangent.norm_square(), true};
    }

    /**
     * What a target that ends on the left, on the right or on both sides of a
     * cell contributes of an infinite one. The length of the remaining part is
     * measured by the tangent at the closest point. The effect of an end is
     * switched off towards the inner node of its cell, because no other cell
     * knows of it.
     */
    template <typename Number>
    static Number
    existing_part(const EndFraction &fraction,
                  const FiberEnds   &ends,
                  const Number      &gap,
                  const Number      &cosine,
                  const Number      &tilt,
                  const Number      &x,
                  const Number      &length)
    {
      const bool is_fiber = ends.left && ends.right;
      Number     result   = 1.;
      const auto subtract = [&](const Number &x) {
        Number missing =
          1. - fraction.value(gap, cosine, tilt, Number(x * length));
        const Number y = 2. - 2. * x;
        if (!is_fiber && !(y > 0.))
          missing = 0.;
        else if (!is_fiber && y < 1.)
          missing = missing * (y * y * y * (10. - y * (15. - 6. * y)));
        result = result - missing;
      };
      if (ends.left)
        subtract(x);
      if (ends.right)
        subtract(Number(1. - x));
      return result;
    }

    /** Derivatives in the explicit coordinate x of the closest point. */
    struct CoordinateDerivatives
    {
      double                      x, xx;
      std::array<Tensor<1, 3>, 4> gradient_x;
    };

    struct EndEnergy
    {
      PointPairEnergy       pair;
      CoordinateDerivatives coordinate;
    };

    /** Energy of a site before a target that ends, times @p weight. */
    EndEnergy
    end_energy(const FiberEnds &ends,
               const double     x,
               const GapAngle  &geometry,
               const double     weight) const
    {
      using namespace PointPairIndex;
      using Number = Jet<5>; // of gap, cosine, tilt, x, |a2|

      Number sum = 0.;
      for (const EndTerm &term : end_terms)
        {
          GapAngleTiltDerivatives f;
          if constexpr (has_tilt)
            f = term.law(geometry.gap, geometry.cosine, geometry.tilt);
          else
            {
              const GapAngleDerivatives e =
                term.law(geometry.gap, geometry.cosine);
              f.value = e.value, f.g = e.g, f.c = e.c;
              f.gg = e.gg, f.gc = e.gc, f.cc = e.cc;
            }
          const Number law(weight * f.value,
                           {{weight * f.g, weight * f.c, weight * f.t}},
                           {{weight * f.gg,
                             weight * f.gc,
                             weight * f.cc,
                             weight * f.gt,
                             weight * f.ct,
                             weight * f.tt}});
          sum += law * existing_part(term.fraction,
                                     ends,
                                     Number::variable(0, geometry.gap),
                                     Number::variable(1, geometry.cosine),
                                     Number::variable(2, geometry.tilt),
                                     Number::variable(3, x),
                                     Number::variable(4, geometry.length_2));
        }

      const GapAngleTiltDerivatives f = {sum.val(),
                                         sum.d(0),
                                         sum.d(1),
                                         sum.d(2),
                                         sum.dd(0, 0),
                                         sum.dd(1, 0),
                                         sum.dd(2, 0),
                                         sum.dd(1, 1),
                                         sum.dd(2, 1),
                                         sum.dd(2, 2)};
      EndEnergy                     result{geometry.energy(f, true), {}};

      // The gradients of gap, cosine and tilt, and the one of the length, t2.
      const auto        &n = geometry.n, &t1 = geometry.t1, &t2 = geometry.t2;
      const Tensor<1, 3> m = (t1 - geometry.tilt * n) / geometry.distance;
      const auto         gradient =
        [&](const double g, const double c, const double t) {
          std::array<Tensor<1, 3>, 4> v;
          v[r1] = g * n + t * m;
          v[r2] = -v[r1];
          v[a1] =
            (c * (t2 - geometry.cosine * t1) + t * (n - geometry.tilt * t1)) /
            geometry.length_1;
          v[a2] = c / geometry.length_2 * (t1 - geometry.cosine * t2);
          return v;
        };
      const auto by_length = gradient(sum.dd(4, 0), sum.dd(4, 1), sum.dd(4, 2));
      result.pair.gradient[a2] += sum.d(4) * t2;
      for (unsigned int v = 0; v < 4; ++v)
        for (unsigned int i = 0; i < 3; ++i)
          for (unsigned int j = 0; j < 3; ++j)
            {
              result.pair.hessian[v][a2][i][j] += by_length[v][i] * t2[j];
              result.pair.hessian[a2][v][j][i] += by_length[v][i] * t2[j];
            }
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = 0; j < 3; ++j)
          result.pair.hessian[a2][a2][i][j] +=
            sum.dd(4, 4) * t2[i] * t2[j] +
            sum.d(4) / geometry.length_2 * ((i == j) - t2[i] * t2[j]);

      result.coordinate.x  = sum.d(3);
      result.coordinate.xx = sum.dd(3, 3);
      result.coordinate.gradient_x =
        gradient(sum.dd(3, 0), sum.dd(3, 1), sum.dd(3, 2));
      result.coordinate.gradient_x[a2] += sum.dd(4, 3) * t2;
      return result;
    }

    void
    add_at_end(const LineSite      &site,
               const HermiteCell<> &target,
               const FiberEnds     &ends,
               const Projection    &projection,
               const TargetShapes  &shapes,
               const PointPair     &pair,
               const GapAngle      &geometry,
               const double         weight,
               const Request        request,
               LocalSystem<24>     &local) const
    {
      const EndEnergy energy = end_energy(ends, projection.x, geometry, weight);
      local.energy += energy.pair.value;
      if (request >= Request::residual)
        distribute(site,
                   target,
                   projection,
                   shapes,
                   pair,
                   energy.pair,
                   &energy.coordinate,
                   request,
                   local);
    }

    void
    distribute(const LineSite              &site,
               const HermiteCell<>         &target,
               const Projection            &projection,
               const TargetShapes          &shapes,
               const PointPair             &pair,
               PointPairEnergy              L,
               const CoordinateDerivatives *explicit_x,
               const Request                request,
               LocalSystem<24>             &local) const
    {
      using namespace PointPairIndex;

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
          const double f_xi = L.gradient[r2] * pair.a2 + L.gradient[a2] * b2 +
                              (explicit_x != nullptr ? explicit_x->x : 0.);
          const double lambda = f_xi / p_xi;
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
          const Tensor<1, 3> c2 =
            shapes.beyond > 0. ? Tensor<1, 3>() : target.third_derivative();
          std::array<Tensor<1, 3>, 4> L_xi;
          for (unsigned int v = 0; v < 4; ++v)
            L_xi[v] = L.hessian[v][r2] * pair.a2 + L.hessian[v][a2] * b2;
          double L_xi_xi = pair.a2 * L_xi[r2] + b2 * L_xi[a2] +
                           L.gradient[r2] * b2 + L.gradient[a2] * c2;
          L_xi[a2] += L.gradient[r2];
          if (explicit_x != nullptr)
            {
              L_xi_xi += 2. * (explicit_x->gradient_x[r2] * pair.a2 +
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

    Law                  law;
    double               sum_of_radii;
    std::vector<EndTerm> end_terms;
  };
} // namespace Setae

#endif
