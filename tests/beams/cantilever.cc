// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include "cantilever.h"

#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/ellint_2.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

using namespace Setae;
using Setae::Test::Cantilever;

namespace
{
  // Length 1, EI = 1, and EA = 4 EI / R^2 of a circular section.
  Cantilever
  cantilever(const unsigned int n_cells,
             const double       slenderness,
             const unsigned int n_gauss_points = 4)
  {
    return Cantilever(n_cells,
                      1.,
                      {4. * slenderness * slenderness, 1.},
                      n_gauss_points);
  }



  /**
   * Largest error of the position of a node after an end moment has bent the
   * fiber to a full circle.
   */
  double
  error_of_full_circle(const unsigned int n_cells,
                       const double       slenderness,
                       const unsigned int n_gauss_points = 4)
  {
    Cantilever fiber = cantilever(n_cells, slenderness, n_gauss_points);

    // A moment on a cell shorter than the radius takes small steps.
    const unsigned int n_steps = slenderness < 100. ? 16 : 8;
    for (unsigned int step = 1; step <= n_steps; ++step)
      fiber.solve({{}, Tensor<1, 3>({0., 0., 2. * M_PI * step / n_steps})});

    double error = 0.;
    for (unsigned int i = 0; i <= n_cells; ++i)
      {
        const double       s     = 1. / n_cells * i;
        const double       angle = 2. * M_PI * s;
        const Tensor<1, 3> exact({std::sin(angle) / (2. * M_PI),
                                  (1. - std::cos(angle)) / (2. * M_PI),
                                  0.});
        error = std::max(error, (fiber.position(s) - exact).norm());
      }
    return error;
  }



  /**
   * A fiber without axial strain under the force P across its tip, in terms of
   * the angle at the tip. With k^2 = (1 + sin(tip angle)) / 2 and
   * 1 + sin(angle) = 2 k^2 sin^2(phi), phi from phi_1 to pi/2:
   *   s = [F(phi) - F(phi_1)] / sqrt(P/EI),
   *   x = 2 k [cos(phi_1) - cos(phi)] / sqrt(P/EI),
   *   y = s - 2 [E(phi) - E(phi_1)] / sqrt(P/EI).
   */
  class Elastica
  {
  public:
    explicit Elastica(const double tip_angle)
      : k(std::sqrt((1. + std::sin(tip_angle)) / 2.))
      , phi_1(std::asin(std::sqrt(0.5) / k))
      , root_of_force(boost::math::ellint_1(k) -
                      boost::math::ellint_1(k, phi_1))
    {}

    double
    force() const
    {
      return root_of_force * root_of_force;
    }

    /** Arc length and position at a fraction of the range of phi. */
    std::pair<double, Tensor<1, 3>>
    point(const double fraction) const
    {
      using boost::math::ellint_1;
      using boost::math::ellint_2;
      const double phi = phi_1 + fraction * (M_PI / 2. - phi_1);

      const double s = (ellint_1(k, phi) - ellint_1(k, phi_1)) / root_of_force;
      const double x =
        2. * k * (std::cos(phi_1) - std::cos(phi)) / root_of_force;
      const double y =
        2. * (ellint_2(k, phi) - ellint_2(k, phi_1)) / root_of_force;
      return {std::min(s, 1.), Tensor<1, 3>({x, s - y, 0.})};
    }

  private:
    const double k, phi_1, root_of_force;
  };



  /** Largest error of the position of 101 points under a force at the tip. */
  double
  error_of_elastica(const unsigned int n_cells, const double slenderness)
  {
    const Elastica elastica(70. * M_PI / 180.);
    Cantilever     fiber = cantilever(n_cells, slenderness);
    EXPECT_LE(fiber.solve({Tensor<1, 3>({0., elastica.force(), 0.}), {}}), 10);

    double error = 0.;
    for (unsigned int i = 0; i <= 100; ++i)
      {
        const auto [s, exact] = elastica.point(i / 100.);
        error = std::max(error, (fiber.position(s) - exact).norm());
      }
    return error;
  }
} // namespace



TEST(Cantilever, BendsToAFullCircleWithOrderFour)
{
  for (const double slenderness : {10., 100., 1e3, 1e4})
    {
      SCOPED_TRACE(slenderness);
      EXPECT_NEAR(std::log2(error_of_full_circle(8, slenderness) /
                            error_of_full_circle(16, slenderness)),
                  4.,
                  0.1);
    }
  EXPECT_NEAR(std::log2(error_of_full_circle(16, 1e4) /
                        error_of_full_circle(32, 1e4)),
              4.,
              0.03);
}



TEST(Cantilever, ErrorOfFullCircleDoesNotGrowWithSlenderness)
{
  const double error = error_of_full_circle(16, 1e4);
  EXPECT_NEAR(error_of_full_circle(16, 1e3), error, 0.001 * error);
  EXPECT_NEAR(error_of_full_circle(16, 100.), error, 0.02 * error);
  // Cells shorter than the radius have some axial strain to give.
  EXPECT_LT(error_of_full_circle(16, 10.), error);
}



TEST(Cantilever, BendsToTheElasticaWithOrderFour)
{
  EXPECT_NEAR(std::log2(error_of_elastica(8, 1e5) / error_of_elastica(16, 1e5)),
              4.,
              0.1);
  EXPECT_NEAR(std::log2(error_of_elastica(16, 1e5) /
                        error_of_elastica(32, 1e5)),
              4.,
              0.05);
}



// Axial strain at the Gauss points locks here: the error at slenderness 1e4 is
// 270 times larger with 16 cells, and fewer cells do not converge.
TEST(Cantilever, ErrorOfElasticaDoesNotDependOnSlenderness)
{
  const double error = error_of_elastica(8, 1e6);
  EXPECT_NEAR(error_of_elastica(8, 1e5), error, 1e-4 * error);
  EXPECT_NEAR(error_of_elastica(8, 1e4), error, 0.01 * error);
}



TEST(Cantilever, FourGaussPointsAreEnough)
{
  const double error = error_of_full_circle(16, 1e4, 8);
  EXPECT_NEAR(error_of_full_circle(16, 1e4, 4), error, 0.001 * error);
  EXPECT_NEAR(error_of_full_circle(16, 1e4, 3), error, 0.1 * error);
}
