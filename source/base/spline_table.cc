// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <setae/base/spline_table.h>

namespace Setae
{
  namespace
  {
    /**
     * The n + 3 coefficients of the cubic spline through n + 1 values, with
     * second differences at the ends that continue those inside.
     */
    std::vector<double>
    interpolate(const std::vector<double> &f)
    {
      const unsigned int n    = f.size() - 1;
      const auto         bend = [&f](const unsigned int i) {
        return f[i - 1] - 2. * f[i] + f[i + 1];
      };
      const double bend_0 = 2. * bend(1) - bend(2);
      const double bend_n = 2. * bend(n - 1) - bend(n - 2);

      // c_i-1 + 4 c_i + c_i+1 = 6 f_i; c[i + 1] is c_i.
      std::vector<double> c(n + 3), factor(n + 1);
      c[1]      = f[0] - bend_0 / 6.;
      factor[0] = 0.;
      for (unsigned int i = 1; i < n; ++i)
        {
          factor[i] = 1. / (4. - factor[i - 1]);
          c[i + 1]  = (6. * f[i] - c[i]) * factor[i];
        }
      c[n + 1] = f[n] - bend_n / 6.;
      for (unsigned int i = n - 1; i > 0; --i)
        c[i + 1] -= factor[i] * c[i + 2];
      c[0]     = bend_0 + 2. * c[1] - c[2];
      c[n + 2] = bend_n + 2. * c[n + 1] - c[n];
      return c;
    }

    /** Values, first and second derivatives of the four B-splines of a cell. */
    struct Basis
    {
      Basis(const double x)
      {
        const double y = 1. - x;
        value          = {{y * y * y / 6.,
                           (4. + x * x * (3. * x - 6.)) / 6.,
                           (4. + y * y * (3. * y - 6.)) / 6.,
                           x * x * x / 6.}};
        first          = {
                   {-.5 * y * y, x * (1.5 * x - 2.), -y * (1.5 * y - 2.), .5 * x * x}};
        second = {{y, 3. * x - 2., 3. * y - 2., x}};
      }

      std::array<double, 4> value, first, second;
    };
  } // namespace



  SplineTable::SplineTable(const std::array<unsigned int, 3> &n_cells,
                           const std::vector<double>         &values)
    : n(n_cells)
    , coefficients(values)
  {
    // One direction after the other; the array grows by two entries in each.
    std::array<unsigned int, 3> size = {{n[0] + 1, n[1] + 1, n[2] + 1}};
    for (unsigned int direction = 0; direction < 3; ++direction)
      {
        unsigned int n_before = 1, stride = 1;
        for (unsigned int i = 0; i < 3; ++i)
          (i < direction ? n_before : stride) *= i == direction ? 1 : size[i];

        const unsigned int  old_size = size[direction], new_size = old_size + 2;
        std::vector<double> result(n_before * new_size * stride);
        std::vector<double> line(old_size);
        for (unsigned int before = 0; before < n_before; ++before)
          for (unsigned int after = 0; after < stride; ++after)
            {
              for (unsigned int i = 0; i < old_size; ++i)
                line[i] =
                  coefficients[(before * old_size + i) * stride + after];
              const std::vector<double> c = interpolate(line);
              for (unsigned int i = 0; i < new_size; ++i)
                result[(before * new_size + i) * stride + after] = c[i];
            }
        coefficients    = std::move(result);
        size[direction] = new_size;
      }
  }



  SplineDerivatives
  SplineTable::derivatives(const double x, const double y, const double z) const
  {
    const std::array<unsigned int, 3> i = {
      {cell(0, x), cell(1, y), cell(2, z)}};
    const Basis X(x - i[0]), Y(y - i[1]), Z(z - i[2]);

    // The sums over x, then y, then z; the names say the derivatives.
    using Row = std::array<double, 4>;
    Row s_ = {}, s_x = {}, s_xx = {}, s_y = {}, s_xy = {}, s_yy = {};
    for (unsigned int b = 0; b < 4; ++b)
      {
        Row r_ = {}, r_x = {}, r_xx = {};
        for (unsigned int a = 0; a < 4; ++a)
          {
            const double *c = row(i, a, b);
            for (unsigned int k = 0; k < 4; ++k)
              {
                r_[k] += X.value[a] * c[k];
                r_x[k] += X.first[a] * c[k];
                r_xx[k] += X.second[a] * c[k];
              }
          }
        for (unsigned int k = 0; k < 4; ++k)
          {
            s_[k] += Y.value[b] * r_[k];
            s_x[k] += Y.value[b] * r_x[k];
            s_xx[k] += Y.value[b] * r_xx[k];
            s_y[k] += Y.first[b] * r_[k];
            s_xy[k] += Y.first[b] * r_x[k];
            s_yy[k] += Y.second[b] * r_[k];
          }
      }
    const auto sum = [](const Row &f, const Row &g) {
      return (f[0] * g[0] + f[1] * g[1]) + (f[2] * g[2] + f[3] * g[3]);
    };
    return {sum(s_, Z.value),
            {{sum(s_x, Z.value), sum(s_y, Z.value), sum(s_, Z.first)}},
            sum(s_xx, Z.value),
            sum(s_xy, Z.value),
            sum(s_x, Z.first),
            sum(s_yy, Z.value),
            sum(s_y, Z.first),
            sum(s_, Z.second)};
  }
} // namespace Setae
