// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <deal.II/base/exceptions.h>

#include <setae/base/integer_power.h>
#include <setae/far_field/taylor_expansion.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Setae
{
  TaylorExpansion::TaylorExpansion(const PointPotential &potential,
                                   const unsigned int    order)
    : potential(potential)
    , p(order)
    , run_begins((p + 1) * (p + 1))
  {
    Assert(p >= 1 && p <= max_order,
           dealii::ExcIndexRange(p, 1, max_order + 1));
    for (unsigned int x = 0; x <= p; ++x)
      for (unsigned int y = 0; x + y <= p; ++y)
        {
          const unsigned int cube     = (x * (p + 1) + y) * (p + 1);
          run_begins[x * (p + 1) + y] = indices.size();
          runs.push_back(
            {x, y, static_cast<unsigned int>(indices.size()), cube});
          for (unsigned int z = 0; x + y + z <= p; ++z)
            indices.push_back({x, y, z, cube + z});
        }
  }



  TaylorExpansion::ScaledPowers
  TaylorExpansion::scaled_powers(const Tensor<1, 3> &a) const
  {
    ScaledPowers result;
    for (unsigned int c = 0; c < 3; ++c)
      {
        result[c][0] = result[c][1] = 0.;
        result[c][2]                = 1.;
        for (unsigned int n = 1; n <= p; ++n)
          result[c][n + 2] = result[c][n + 1] * a[c] / n;
      }
    return result;
  }



  void
  TaylorExpansion::add_charge(const double        charge,
                              const Tensor<1, 3> &a,
                              double             *moments) const
  {
    const auto [X, Y, Z] = scaled_powers(a);
    for (const Run &run : runs)
      {
        const double xy = charge * X[run.x + 2] * Y[run.y + 2];
        for (unsigned int z = 0; run.x + run.y + z <= p; ++z)
          moments[run.begin + z] += xy * Z[z + 2];
      }
  }



  void
  TaylorExpansion::add_moving_charge(const double        charge,
                                     const Tensor<1, 3> &a,
                                     const Tensor<1, 3> &v,
                                     double             *moments) const
  {
    const auto [X, Y, Z] = scaled_powers(a);
    for (const Run &run : runs)
      {
        const unsigned int x = run.x + 2, y = run.y + 2;
        const double       along_xy =
          charge * (v[0] * X[x - 1] * Y[y] + v[1] * X[x] * Y[y - 1]);
        const double along_z = charge * v[2] * X[x] * Y[y];
        for (unsigned int z = 0; run.x + run.y + z <= p; ++z)
          moments[run.begin + z] += along_xy * Z[z + 2] + along_z * Z[z + 1];
      }
  }



  void
  TaylorExpansion::shift_moments(const Tensor<1, 3> &shift,
                                 const double       *moments,
                                 double             *shifted) const
  {
    const auto [X, Y, Z] = scaled_powers(shift);
    for (const Run &to : runs)
      for (unsigned int x = 0; x <= to.x; ++x)
        for (unsigned int y = 0; y <= to.y; ++y)
          {
            const double *from = moments + begin_of_run(x, y);
            const double  xy   = X[to.x - x + 2] * Y[to.y - y + 2];
            for (unsigned int n = 0; to.x + to.y + n <= p; ++n)
              for (unsigned int z = 0; z <= n; ++z)
                shifted[to.begin + n] += xy * Z[n - z + 2] * from[z];
          }
  }



  void
  TaylorExpansion::shift_local(const Tensor<1, 3> &shift,
                               const double       *local,
                               double             *shifted) const
  {
    const auto [X, Y, Z] = scaled_powers(shift);
    for (const Run &from : runs)
      for (unsigned int x = 0; x <= from.x; ++x)
        for (unsigned int y = 0; y <= from.y; ++y)
          {
            double      *to = shifted + begin_of_run(x, y);
            const double xy = X[from.x - x + 2] * Y[from.y - y + 2];
            for (unsigned int n = 0; from.x + from.y + n <= p; ++n)
              for (unsigned int z = 0; z <= n; ++z)
                to[z] += xy * Z[n - z + 2] * local[from.begin + n];
          }
  }



  /**
   * The Taylor coefficients of @f$\psi(h)=|R+h|^{-m}@f$ follow from
   * @f$|R+h|^2\,h\cdot\nabla\psi=-m\,(R\cdot h+h^2)\,\psi@f$ by degree; here they
   * are multiplied by k!.
   */
  void
  TaylorExpansion::evaluate_kernel(const Tensor<1, 3> &R, Kernel &kernel) const
  {
    const unsigned int stride[3]      = {(p + 1) * (p + 1), p + 1, 1};
    const double       inverse_square = 1. / R.norm_square();
    const double       inverse        = std::sqrt(inverse_square);

    kernel.D.assign(stride[0] * (p + 1), 0.);
    kernel.power.resize(kernel.D.size());
    for (const auto &[m, prefactor] : potential)
      {
        std::vector<double> &D = kernel.power;
        for (const MultiIndex &k : indices)
          {
            const unsigned int n = k.degree();
            if (n == 0)
              {
                D[0] = prefactor * integer_power(inverse, m);
                continue;
              }
            const unsigned int degrees[3] = {k.x, k.y, k.z};
            double             first = 0., second = 0.;
            for (unsigned int c = 0; c < 3; ++c)
              {
                if (degrees[c] >= 1)
                  first += degrees[c] * R[c] * D[k.cube - stride[c]];
                if (degrees[c] >= 2)
                  second +=
                    degrees[c] * (degrees[c] - 1.) * D[k.cube - 2 * stride[c]];
              }
            D[k.cube] = -((2. * n + m - 2.) * first + (n + m - 2.) * second) *
                        inverse_square / n;
          }
        for (const MultiIndex &k : indices)
          kernel.D[k.cube] += D[k.cube];
      }
  }



  /** Sums over (-1)^|l| D_{k+l} M_l, or over (-1)^|k| D_{k+l} M_l. */
  void
  TaylorExpansion::contract(const std::vector<double> &D,
                            const bool                 alternate,
                            const double              *moments,
                            double                    *local) const
  {
    for (unsigned int i = 0; i < indices.size(); ++i)
      {
        const MultiIndex  &l    = indices[i];
        const unsigned int rest = p - l.degree();
        const double       M =
          alternate && l.degree() % 2 == 1 ? -moments[i] : moments[i];
        const double *D_l = D.data() + l.cube;
        for (const Run &k : runs)
          {
            if (k.x > rest)
              break;
            if (k.x + k.y > rest)
              continue;
            const unsigned int n = rest - k.x - k.y + 1;
            for (unsigned int z = 0; z < n; ++z)
              local[k.begin + z] += M * D_l[k.cube + z];
          }
      }
  }



  void
  TaylorExpansion::interact(const Kernel &kernel,
                            const double *moments_B,
                            double       *local_A) const
  {
    contract(kernel.D, true, moments_B, local_A);
  }



  void
  TaylorExpansion::interact_reversed(const Kernel &kernel,
                                     const double *moments_A,
                                     double       *local_B) const
  {
    std::vector<double> local(size(), 0.);
    contract(kernel.D, false, moments_A, local.data());
    for (unsigned int i = 0; i < size(); ++i)
      local_B[i] += indices[i].degree() % 2 == 1 ? -local[i] : local[i];
  }



  double
  TaylorExpansion::value(const double *local, const Tensor<1, 3> &a) const
  {
    const auto [X, Y, Z] = scaled_powers(a);
    double result        = 0.;
    for (const Run &run : runs)
      {
        double sum = 0.;
        for (unsigned int z = 0; run.x + run.y + z <= p; ++z)
          sum += local[run.begin + z] * Z[z + 2];
        result += X[run.x + 2] * Y[run.y + 2] * sum;
      }
    return result;
  }



  TaylorExpansion::Derivatives
  TaylorExpansion::derivatives(const double *local, const Tensor<1, 3> &a) const
  {
    const auto [X, Y, Z] = scaled_powers(a);
    Derivatives result;
    for (const Run &run : runs)
      {
        double sum[3] = {}; // with the derivatives in z
        for (unsigned int z = 0; run.x + run.y + z <= p; ++z)
          for (unsigned int d = 0; d < 3; ++d)
            sum[d] += local[run.begin + z] * Z[z + 2 - d];

        const double *x = &X[run.x + 2], *y = &Y[run.y + 2];
        result.value += x[0] * y[0] * sum[0];
        result.gradient[0] += x[-1] * y[0] * sum[0];
        result.gradient[1] += x[0] * y[-1] * sum[0];
        result.gradient[2] += x[0] * y[0] * sum[1];
        result.hessian[0][0] += x[-2] * y[0] * sum[0];
        result.hessian[1][1] += x[0] * y[-2] * sum[0];
        result.hessian[2][2] += x[0] * y[0] * sum[2];
        result.hessian[0][1] += x[-1] * y[-1] * sum[0];
        result.hessian[0][2] += x[-1] * y[0] * sum[1];
        result.hessian[1][2] += x[0] * y[-1] * sum[1];
      }
    for (unsigned int c = 0; c < 3; ++c)
      for (unsigned int e = 0; e < c; ++e)
        result.hessian[c][e] = result.hessian[e][c];
    return result;
  }



  double
  TaylorExpansion::relative_error(const std::vector<double> &powers_A,
                                  const std::vector<double> &powers_B,
                                  const double               radii,
                                  const double               D) const
  {
    if (powers_A[0] == 0. || powers_B[0] == 0.)
      return 0.;
    const double theta = radii / D;
    if (!(theta < 1.))
      return std::numeric_limits<double>::infinity();

    double first = 0., binomial = 1.;
    for (unsigned int n = 0; n <= p; ++n)
      {
        first += binomial * powers_A[n] * powers_B[p - n];
        binomial *= double(p - n) / (n + 1);
      }
    first /= powers_A[0] * powers_B[0] * integer_power(D, p);

    double largest = 0.;
    for (const auto &[m, prefactor] : potential)
      {
        double coefficient = 1.; // (p + 1) (p + m over p + 1) / m
        for (unsigned int i = 1; i <= m; ++i)
          coefficient *= double(p + i) / i;
        // From one term to the next, the largest factor is the first one.
        const double factor = theta * (p + 1. + m) / (p + 1.);
        if (!(factor < 1.))
          return std::numeric_limits<double>::infinity();
        largest = std::max(largest,
                           coefficient / (1. - factor) *
                             integer_power(1. + theta, m + 1));
      }
    return largest * first;
  }
} // namespace Setae
