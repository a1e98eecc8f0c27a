// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <deal.II/base/quadrature_lib.h>

#include <gtest/gtest.h>

#include "solids.h"

using namespace Setae;

namespace
{
  FullQuadratureParameters
  to_tolerance(const double tolerance)
  {
    FullQuadratureParameters parameters;
    parameters.tolerance = tolerance;
    return parameters;
  }

  FullQuadratureParameters
  with_points(const unsigned int n)
  {
    FullQuadratureParameters parameters;
    parameters.tolerance    = 1e-15;
    parameters.max_n_points = n;
    return parameters;
  }

  /**
   * Crossing infinite cylinders of radius one: both integrals along the axes
   * are done by hand, those over the depths z with the chords 2 sqrt(1 - z^2)
   * by Gauss-Chebyshev quadrature of the second kind.
   */
  double
  crossing_infinite_cylinders(const double       gap,
                              const double       angle,
                              const unsigned int m)
  {
    constexpr unsigned int n   = 100;
    double                 sum = 0.;
    for (unsigned int i = 1; i <= n; ++i)
      for (unsigned int j = 1; j <= n; ++j)
        {
          const double a = M_PI * i / (n + 1), b = M_PI * j / (n + 1);
          const double weight =
            std::pow(M_PI / (n + 1) * std::sin(a) * std::sin(b), 2);
          sum += 4. * weight *
                 std::pow(2. + gap - std::cos(a) - std::cos(b), 2. - m);
        }
    return 2. * M_PI / (m - 2.) / std::sin(angle) * sum;
  }

  /** Points of a cylinder of radius one along z in polar coordinates. */
  std::vector<std::pair<Tensor<1, 3>, double>>
  polar_sites(const Tensor<1, 3> &middle,
              const double        length,
              const bool          is_surface)
  {
    const dealii::QGauss<1>                      rule(10);
    constexpr unsigned int                       n_angles = 40;
    std::vector<std::pair<Tensor<1, 3>, double>> sites;
    for (unsigned int i = 0; i < (is_surface ? 1 : rule.size()); ++i)
      for (unsigned int j = 0; j < n_angles; ++j)
        for (unsigned int k = 0; k < rule.size(); ++k)
          {
            const double r      = is_surface ? 1. : rule.point(i)[0];
            const double phi    = 2. * M_PI * j / n_angles;
            const double weight = (is_surface ? 1. : rule.weight(i) * r) *
                                  (2. * M_PI / n_angles) * rule.weight(k) *
                                  length;
            sites.emplace_back(middle + Tensor<1, 3>(
                                          {r * std::cos(phi),
                                           r * std::sin(phi),
                                           length * (rule.point(k)[0] - .5)}),
                               weight);
          }
    return sites;
  }
} // namespace

TEST(FullQuadrature, CrossingCylindersHaveTheExactEnergyWithinTheEstimate)
{
  // What fibers of finite length miss of the energy.
  constexpr double beyond_the_ends = 2e-5;
  for (const unsigned int m : {6, 12})
    for (const double angle : {M_PI / 2., M_PI / 4.})
      {
        const double         exact = crossing_infinite_cylinders(1., angle, m);
        const FullQuadrature full =
          CrossingCylinders{1., angle, 100.}.integrate(PointLaw({{m, 1.}}),
                                                       to_tolerance(1e-3));
        EXPECT_LT(full.error, 1e-3);
        EXPECT_NEAR(full.value.energy,
                    exact,
                    (full.error + beyond_the_ends) * exact)
          << m << ' ' << angle;
      }
}

TEST(FullQuadrature, AgreesWithPolarCoordinates)
{
  // Two short coaxial cylinders would need no turning of the axes: side by
  // side.
  const double       length = 2.;
  const Tensor<1, 3> t({0., 0., 1.}), shift({3., .5, .4});
  const auto         line_1 = straight_line({}, t, length);
  const auto         line_2 = straight_line(shift, t, length);
  for (const bool is_surface : {false, true})
    for (const unsigned int m : {1, 6})
      {
        const PointLaw law({{m, 1.}});
        double         energy = 0.;
        Tensor<1, 3>   force, moment;
        const auto     others = polar_sites(shift, length, is_surface);
        for (const auto &[r1, w1] : polar_sites({}, length, is_surface))
          for (const auto &[r2, w2] : others)
            {
              const Tensor<1, 3> d = r1 - r2;
              energy += w1 * w2 * law(d.norm_square()).value;
              const Tensor<1, 3> f =
                -w1 * w2 * law(d.norm_square()).first_over_r * d;
              force += f;
              moment += cross_product_3d(r1, f);
            }

        const Distribution distribution =
          is_surface ? Distribution::surface : Distribution::volume;
        SolidBody            first(FiberChart(line_1, line_1, 1.),
                        distribution,
                        MPI_COMM_SELF);
        SolidBody            second(FiberChart(line_2, line_2, 1.),
                         distribution,
                         MPI_COMM_SELF);
        const SolidResultant full =
          full_quadrature(first, second, law, to_tolerance(1e-7)).value;
        EXPECT_NEAR(full.energy, energy, 1e-6 * energy) << is_surface << m;
        EXPECT_LT((full.force - force).norm(), 1e-5 * force.norm());
        EXPECT_LT((full.moment - moment).norm(), 1e-5 * force.norm());
      }
}

TEST(FullQuadrature, ErrorFallsWithEachPointAndIsBelowItsEstimate)
{
  const CrossingCylinders cylinders{.3, 1.};
  const PointLaw          law({{6, -1.}});
  const double exact    = cylinders.integrate(law, with_points(7)).value.energy;
  double       previous = 1.;
  for (unsigned int n = 2; n <= 5; ++n)
    {
      const FullQuadrature full = cylinders.integrate(law, with_points(n));
      ASSERT_EQ(full.n_points, n);
      const double error = std::abs(full.value.energy / exact - 1.);
      EXPECT_LT(error, .35 * previous) << n;
      EXPECT_LT(error, full.error) << n;
      previous = error;
    }
  EXPECT_LT(previous, 3e-5);
}

TEST(FullQuadrature, ForceIsTheDerivativeOfTheEnergy)
{
  const PointLaw law({{6, -1.}, {12, .01}});
  const double   step = 1e-2;
  const auto     at   = [&](const double gap) {
    return CrossingCylinders{gap, .7, 6.}.integrate(law, with_points(6)).value;
  };
  // Richardson's extrapolation of central differences
  const auto difference = [&](const double h) {
    return (at(.6 + h).energy - at(.6 - h).energy) / (2. * h);
  };
  const double derivative =
    (4. * difference(step) - difference(2. * step)) / 3.;

  // The second cylinder is the one that is moved.
  EXPECT_NEAR(at(.6).force[2], derivative, 1e-5 * std::abs(derivative));
}

TEST(FullQuadrature, ActionIsReaction)
{
  const auto line_1 = straight_line({}, Tensor<1, 3>({1., 0., 0.}), 4.);
  const auto line_2 =
    straight_line(Tensor<1, 3>({1., .5, 2.5}), Tensor<1, 3>({.6, .8, 0.}), 4.);
  const PointLaw law({{6, -1.}});
  const auto     body = [](const std::vector<HermiteCell<>> &line) {
    return SolidBody(FiberChart(line, line, 1.),
                     Distribution::volume,
                     MPI_COMM_SELF);
  };
  SolidBody  first = body(line_1), second = body(line_2);
  SolidBody  first_again = body(line_1), second_again = body(line_2);
  const auto on_first = full_quadrature(first, second, law, with_points(4));
  const auto on_second =
    full_quadrature(second_again, first_again, law, with_points(4));
  const double scale = on_first.value.force.norm();
  EXPECT_NEAR(on_first.value.energy, on_second.value.energy, 1e-3 * scale);
  EXPECT_LT((on_first.value.force + on_second.value.force).norm(),
            1e-3 * scale);
  EXPECT_LT((on_first.value.moment + on_second.value.moment).norm(),
            1e-3 * scale);
}

TEST(FullQuadrature, LeavesOutWhatIsTooMuch)
{
  FullQuadratureParameters parameters;
  parameters.max_n_cells = 1e3;
  const PointLaw law({{6, -1.}});
  const auto     full = CrossingCylinders{1e-2, 1.}.integrate(law, parameters);
  EXPECT_EQ(full.n_points, 0u);
  EXPECT_GT(full.error, 1.);

  parameters             = {};
  parameters.tolerance   = 1e-12;
  parameters.max_n_pairs = 1e7;
  EXPECT_LE(CrossingCylinders{}.integrate(law, parameters).n_pairs, 1e7);
}
