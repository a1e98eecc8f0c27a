// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_tests_verification_solids_h
#define setae_tests_verification_solids_h

#include <setae/verification/full_quadrature.h>

#include <cmath>
#include <vector>

namespace Setae
{
  /** A straight centerline through @p middle along the unit vector @p t. */
  inline std::vector<HermiteCell<>>
  straight_line(const Tensor<1, 3> &middle,
                const Tensor<1, 3> &t,
                const double        length)
  {
    const Tensor<1, 3> half = .5 * length * t;
    return {{{{middle - half, t, middle + half, t}}, length}};
  }



  /** An arc of a circle about the origin in the x, y plane, from the x-axis. */
  inline std::vector<HermiteCell<>>
  arc(const double radius, const double angle, const unsigned int n_cells)
  {
    const auto place = [=](const unsigned int i) {
      const double phi = angle * i / n_cells;
      return Tensor<1, 3>({radius * std::cos(phi), radius * std::sin(phi), 0.});
    };
    const auto tangent = [=](const unsigned int i) {
      const double phi = angle * i / n_cells;
      return Tensor<1, 3>({-std::sin(phi), std::cos(phi), 0.});
    };
    std::vector<HermiteCell<>> cells;
    for (unsigned int i = 0; i < n_cells; ++i)
      cells.push_back({{{place(i), tangent(i), place(i + 1), tangent(i + 1)}},
                       radius * angle / n_cells});
    return cells;
  }



  inline double
  arc_length(const std::vector<HermiteCell<>> &cells)
  {
    constexpr unsigned int n      = 1000;
    double                 length = 0.;
    for (const HermiteCell<> &cell : cells)
      for (unsigned int i = 0; i < n; ++i)
        {
          // Simpson's rule
          length += (cell.derivative(double(i) / n).norm() +
                     4. * cell.derivative((i + .5) / n).norm() +
                     cell.derivative((i + 1.) / n).norm()) /
                    (6. * n);
        }
    return length;
  }



  /** Two straight cylinders of radius one, crossing at the middle. */
  struct CrossingCylinders
  {
    double       gap          = 1.;
    double       angle        = 0.;
    double       length       = 10.;
    Distribution distribution = Distribution::volume;

    FullQuadrature
    integrate(const PointLaw                 &law,
              const FullQuadratureParameters &parameters,
              const MPI_Comm communicator = MPI_COMM_SELF) const
    {
      const auto line_1 =
        straight_line(Tensor<1, 3>(), Tensor<1, 3>({1., 0., 0.}), length);
      const auto line_2 =
        straight_line(Tensor<1, 3>({0., 0., 2. + gap}),
                      Tensor<1, 3>({std::cos(angle), std::sin(angle), 0.}),
                      length);
      SolidBody first(FiberChart(line_1, line_1, 1.),
                      distribution,
                      communicator);
      SolidBody second(FiberChart(line_2, line_2, 1.),
                       distribution,
                       communicator);
      return full_quadrature(first, second, law, parameters);
    }
  };
} // namespace Setae

#endif
