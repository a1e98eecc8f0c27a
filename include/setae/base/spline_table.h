// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_base_spline_table_h
#define setae_base_spline_table_h

#include <array>
#include <cmath>
#include <vector>

namespace Setae
{
  /** A function of three variables with its derivatives up to order two. */
  struct SplineDerivatives
  {
    double                value;
    std::array<double, 3> first;
    double                xx, xy, xz, yy, yz, zz;
  };

  /** The exponential function of a function with the derivatives @p f. */
  inline SplineDerivatives
  exponential(const SplineDerivatives &f)
  {
    const double      E = std::exp(f.value);
    const auto       &d = f.first;
    SplineDerivatives result;
    result.value = E;
    for (unsigned int i = 0; i < 3; ++i)
      result.first[i] = E * d[i];
    result.xx = E * (f.xx + d[0] * d[0]);
    result.xy = E * (f.xy + d[0] * d[1]);
    result.xz = E * (f.xz + d[0] * d[2]);
    result.yy = E * (f.yy + d[1] * d[1]);
    result.yz = E * (f.yz + d[1] * d[2]);
    result.zz = E * (f.zz + d[2] * d[2]);
    return result;
  }



  /**
   * Tricubic B-splines that interpolate values on a regular grid: a function
   * with two continuous derivatives, of which an evaluation reads 64
   * coefficients and no more, however fine the grid. The error decreases with
   * the fourth power of the spacing. Coordinates are in units of the spacing,
   * from 0 to the number of cells in each direction.
   */
  class SplineTable
  {
  public:
    /**
     * @param n_cells In each direction, at least 4.
     * @param values At the nodes, the last direction fastest.
     */
    SplineTable(const std::array<unsigned int, 3> &n_cells,
                const std::vector<double>         &values);

    /** Outside of the grid the cells at the boundary go on. */
    SplineDerivatives
    derivatives(const double x, const double y, const double z) const;

    /** The value alone, on any number type. */
    template <typename Number>
    Number
    value(const Number &x, const Number &y, const Number &z) const
    {
      const std::array<unsigned int, 3> i = {
        {cell(0, x), cell(1, y), cell(2, z)}};
      const auto X   = basis(Number(x - double(i[0])));
      const auto Y   = basis(Number(y - double(i[1])));
      const auto Z   = basis(Number(z - double(i[2])));
      Number     sum = 0.;
      for (unsigned int a = 0; a < 4; ++a)
        for (unsigned int b = 0; b < 4; ++b)
          {
            const double *c = row(i, a, b);
            sum += X[a] * Y[b] *
                   (c[0] * Z[0] + c[1] * Z[1] + c[2] * Z[2] + c[3] * Z[3]);
          }
      return sum;
    }

  private:
    /** The four B-splines that are not zero in a cell. */
    template <typename Number>
    static std::array<Number, 4>
    basis(const Number &x)
    {
      const Number y = 1. - x;
      return {{y * y * y / 6.,
               (4. + x * x * (3. * x - 6.)) / 6.,
               (4. + y * y * (3. * y - 6.)) / 6.,
               x * x * x / 6.}};
    }

    template <typename Number>
    unsigned int
    cell(const unsigned int direction, const Number &x) const
    {
      if (!(x >= 1.))
        return 0;
      return x < n[direction] - 1. ? integer(x) : n[direction] - 1;
    }

    static unsigned int
    integer(const double x)
    {
      return static_cast<unsigned int>(x);
    }

    template <typename Number>
    static unsigned int
    integer(const Number &x)
    {
      return integer(x.val());
    }

    const double *
    row(const std::array<unsigned int, 3> &cell,
        const unsigned int                 a,
        const unsigned int                 b) const
    {
      return &coefficients[((cell[0] + a) * (n[1] + 3) + cell[1] + b) *
                             (n[2] + 3) +
                           cell[2]];
    }

    std::array<unsigned int, 3> n;
    std::vector<double>         coefficients;
  };
} // namespace Setae

#endif
