// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <deal.II/base/quadrature_lib.h>

#include <setae/verification/fiber_chart.h>

#include <algorithm>
#include <cmath>

namespace Setae
{
  using namespace dealii;

  namespace
  {
    /** Half the side of the inner square over the radius. */
    constexpr double inner_size = .42;

    Tensor<1, 3>
    tangent(const HermiteCell<> &cell, const double x)
    {
      const Tensor<1, 3> derivative = cell.derivative(x);
      return derivative / derivative.norm();
    }

    /**
     * The smallest rotation that takes the unit vector @p from to @p to, applied
     * to a vector normal to @p from. If these are opposite, the half turn about
     * the vector itself.
     */
    Tensor<1, 3>
    rotate(const Tensor<1, 3> &vector,
           const Tensor<1, 3> &from,
           const Tensor<1, 3> &to)
    {
      const double denominator = 1. + from * to;
      if (denominator < 1e-12)
        return vector;
      return vector - (vector * to / denominator) * (from + to);
    }

    Tensor<1, 3>
    any_normal(const Tensor<1, 3> &t)
    {
      unsigned int smallest = 0;
      for (unsigned int c = 1; c < 3; ++c)
        if (std::abs(t[c]) < std::abs(t[smallest]))
          smallest = c;
      Tensor<1, 3> result;
      result[smallest] = 1.;
      result -= (result * t) * t;
      return result / result.norm();
    }

    double
    arc_length(const HermiteCell<> &cell)
    {
      static const QGauss<1> rule(8);
      double                 length = 0.;
      for (unsigned int q = 0; q < rule.size(); ++q)
        length += rule.weight(q) * cell.derivative(rule.point(q)[0]).norm();
      return length;
    }
  } // namespace



  FiberChart::FiberChart(std::vector<HermiteCell<>> initial_cells,
                         std::vector<HermiteCell<>> current_cells,
                         const double               radius,
                         const double               block_length)
    : radius(radius)
    , initial(std::move(initial_cells))
    , current(std::move(current_cells))
  {
    const Tensor<1, 3> t0 = tangent(initial.front(), 0.);
    const Tensor<1, 3> d0 = any_normal(t0);
    initial_d1            = carry_along(initial, d0);
    current_d1 =
      carry_along(current, rotate(d0, t0, tangent(current.front(), 0.)));

    for (unsigned int cell = 0; cell < initial.size(); ++cell)
      {
        const unsigned int n = std::max(1.,
                                        std::round(arc_length(initial[cell]) /
                                                   (block_length * radius)));
        for (unsigned int i = 0; i < n; ++i)
          blocks.push_back({cell, double(i) / n, 1. / n});
      }
  }



  std::vector<Tensor<1, 3>>
  FiberChart::carry_along(const std::vector<HermiteCell<>> &cells,
                          Tensor<1, 3>                      vector) const
  {
    std::vector<Tensor<1, 3>> result;
    for (const HermiteCell<> &cell : cells)
      {
        result.push_back(vector);
        vector = rotate(vector, tangent(cell, 0.), tangent(cell, 1.));
      }
    return result;
  }



  FiberChart::Section
  FiberChart::section(const unsigned int cube, const double z) const
  {
    const Block         &block = blocks[cube / n_sectors];
    const double         x     = block.begin + z * block.size;
    const HermiteCell<> &cell  = current[block.cell];

    Section            result;
    const Tensor<1, 3> t = tangent(cell, x);
    result.center        = cell.position(x);
    result.d1            = rotate(current_d1[block.cell], tangent(cell, 0.), t);
    result.d2            = cross_product_3d(t, result.d1);

    const HermiteCell<> &cell_0 = initial[block.cell];
    const Tensor<1, 3>   r_x    = cell_0.derivative(x);
    const double         J      = r_x.norm();
    const Tensor<1, 3>   t_0    = r_x / J;
    const Tensor<1, 3>   d1 =
      rotate(initial_d1[block.cell], tangent(cell_0, 0.), t_0);
    const Tensor<1, 3> curvature = cell_0.second_derivative(x) / (J * J);
    result.length                = J * block.size;
    result.k1                    = curvature * d1;
    result.k2                    = curvature * cross_product_3d(t_0, d1);
    return result;
  }



  FiberChart::Place
  FiberChart::place(const unsigned int cube, const double x, const double y)
  {
    const unsigned int sector = cube % n_sectors;
    if (sector == inner_sector)
      return {inner_size * (2. * x - 1.),
              inner_size * (2. * y - 1.),
              4. * inner_size * inner_size};

    // From the side of the square to the arc, in the sector of angles around
    // zero; eta in [-1, 1] is tangent and angle.
    const double eta   = 2. * y - 1.;
    const double angle = M_PI / 4. * eta;
    const double c = std::cos(angle), s = std::sin(angle);
    const double u   = (1. - x) * inner_size + x * c;
    const double v   = (1. - x) * inner_size * eta + x * s;
    const double u_x = c - inner_size, u_eta = -x * M_PI / 4. * s;
    const double v_x   = s - inner_size * eta;
    const double v_eta = (1. - x) * inner_size + x * M_PI / 4. * c;

    const double area = 2. * (u_x * v_eta - u_eta * v_x);
    switch (sector)
      {
        case 0:
          return {u, v, area};
        case 1:
          return {-v, u, area};
        case 2:
          return {-u, -v, area};
        default:
          return {v, -u, area};
      }
  }



  FiberChart::Place
  FiberChart::boundary_place(const unsigned int cube, const double y)
  {
    Place result = place(cube, 1., y);
    result.area  = M_PI / 2.;
    return result;
  }
} // namespace Setae
