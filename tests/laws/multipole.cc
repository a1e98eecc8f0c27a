// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

// The laws for large distances against the sum over all points of two parallel
// infinite cylinders.

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/base/tensor.h>

#include <boost/math/quadrature/exp_sinh.hpp>

#include <gtest/gtest.h>

#include <setae/laws/multipole.h>

#include <cmath>
#include <vector>

using namespace Setae;

namespace
{
  /** Points of a section, with as many of the potential as stand for each. */
  struct SectionPoint
  {
    double x, y, weight;
  };

  std::vector<SectionPoint>
  section(const double radius, const double density, const Distribution where)
  {
    constexpr unsigned int    n_angles = 24;
    const dealii::QGauss<1>   gauss(8);
    std::vector<SectionPoint> result;
    const auto add_circle = [&](const double r, const double weight) {
      for (unsigned int i = 0; i < n_angles; ++i)
        {
          const double phi = 2. * M_PI * i / n_angles;
          result.push_back({r * std::cos(phi),
                            r * std::sin(phi),
                            weight * density * 2. * M_PI * r / n_angles});
        }
    };
    if (where == Distribution::surface)
      add_circle(radius, 1.);
    else
      for (unsigned int q = 0; q < gauss.size(); ++q)
        add_circle(radius * gauss.point(q)[0], radius * gauss.weight(q));
    return result;
  }

  /** The integral of (x^2 + z^2)^(-m/2) along a line, times x^(m-1). */
  double
  along_axis(const unsigned int m)
  {
    return std::sqrt(M_PI) * std::tgamma((m - 1.) / 2.) / std::tgamma(m / 2.);
  }

  /** Energy per length by the sum over all pairs of points. */
  double
  exact(const InversePower &power,
        const SectionPair  &pair,
        const double        distance)
  {
    double energy = 0.;
    for (const SectionPoint &p :
         section(pair.radius_1, pair.density_1, pair.distribution))
      for (const SectionPoint &q :
           section(pair.radius_2, pair.density_2, pair.distribution))
        energy += p.weight * q.weight *
                  std::pow(std::hypot(distance + q.x - p.x, q.y - p.y),
                           1. - power.exponent);
    return energy * power.prefactor * along_axis(power.exponent);
  }

  /** Energy per length by the law, integrated over one of the fibers. */
  template <typename Law>
  double
  energy(const InversePower &power,
         const SectionPair  &pair,
         const double        distance)
  {
    const Law    law({power}, pair, {});
    const double radii = pair.radius_1 + pair.radius_2;
    boost::math::quadrature::exp_sinh<double> rule;
    return 2. * rule.integrate(
                  [&](const double z) {
                    return z < 1e100 ?
                             law(std::hypot(distance, z) - radii).value :
                             0.;
                  },
                  1e-13);
  }

  template <typename Law>
  double
  error(const InversePower &power,
        const SectionPair  &pair,
        const double        distance)
  {
    return std::abs(
      energy<Law>(power, pair, distance) / exact(power, pair, distance) - 1.);
  }
} // namespace



TEST(Multipole, IsRightToTheOrderOfItsTerms)
{
  for (const Distribution where : {Distribution::volume, Distribution::surface})
    for (const unsigned int m : {2u, 3u, 6u, 12u})
      {
        const SectionPair  pair  = {1., 2., 3., .5, where};
        const InversePower power = {m, -.7};

        // At twice the distance, a quarter and a sixteenth of the error.
        const double monopole =
          std::log2(error<Multipole<1>>(power, pair, 100.) /
                    error<Multipole<1>>(power, pair, 200.));
        const double quadrupole =
          std::log2(error<Multipole<2>>(power, pair, 100.) /
                    error<Multipole<2>>(power, pair, 200.));
        EXPECT_NEAR(monopole, 2., .1) << m;
        EXPECT_NEAR(quadrupole, 4., .1) << m;
      }
}



// The logarithm of the distance, the potential of a charged line, is harmonic:
// the mean over a circle or disk is the value at its center.
TEST(Multipole, IsExactForTheCoulombForceOfParallelCylinders)
{
  for (const Distribution where : {Distribution::volume, Distribution::surface})
    {
      const SectionPair pair     = {1., 2., 3., .5, where};
      const double      distance = 4.;
      double            force = 0., charge_1 = 0., charge_2 = 0.;
      for (const SectionPoint &p : section(1., 3., where))
        for (const SectionPoint &q : section(2., .5, where))
          {
            const double x = distance + q.x - p.x, y = q.y - p.y;
            force += p.weight * q.weight * 2. * x / (x * x + y * y);
          }
      for (const SectionPoint &p : section(1., 3., where))
        charge_1 += p.weight;
      for (const SectionPoint &q : section(2., .5, where))
        charge_2 += q.weight;

      const Multipole<1> monopole({{1, 1.}}, pair, {});
      const Multipole<2> quadrupole({{1, 1.}}, pair, {});
      EXPECT_NEAR(monopole(distance - 3.).value,
                  charge_1 * charge_2 / distance,
                  1e-12);
      EXPECT_EQ(monopole(distance - 3.).value, quadrupole(distance - 3.).value);
      EXPECT_NEAR(force, 2. * charge_1 * charge_2 / distance, 1e-6 * force);
    }
}



TEST(Multipole, AdmitsOverlapUpToCenterlinesThatMeet)
{
  const Multipole<1> law({{1, 1.}}, {1., 2., 1., 1.}, {});
  EXPECT_TRUE(law.admits(0.));
  EXPECT_TRUE(law.admits(-2.999));
  EXPECT_FALSE(law.admits(-3.));
  EXPECT_TRUE(std::isfinite(law(-2.999).second));
}
