// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

// The constants of the laws against theory and quadrature, and the derivatives
// of all laws against automatic ones.

#include <boost/math/quadrature/tanh_sinh.hpp>

#include <gtest/gtest.h>

#include <setae/laws/all.h>
#include <setae/laws/lennard_jones.h>

#include <cmath>
#include <limits>
#include <random>
#include <type_traits>
#include <vector>

#include "../nested_sacado.h"

using namespace Setae;

namespace
{
  constexpr double      pi       = M_PI;
  constexpr SectionPair sections = {.02, .05, 3., .7};
  constexpr GapRange    range    = {.01, .5, .8};

  /** What two sections share with their densities. */
  double
  densities(const SectionPair &pair)
  {
    return pair.density_1 * pair.density_2;
  }

  double
  reduced_radius(const SectionPair &pair)
  {
    return pair.radius_1 * pair.radius_2 / (pair.radius_1 + pair.radius_2);
  }

  /**
   * The potential r^-m between all points of two coplanar disks of radius one
   * at a gap, ISSIP eq. A6, as an integral over the distances t from the center
   * of the first disk and p between the points. Both are measured from their
   * smallest value and p on a logarithmic scale, as only p of the size of the
   * gap matters.
   */
  double
  energy_of_disks(const double m, const double gap)
  {
    const double d = 2. + gap;

    boost::math::quadrature::tanh_sinh<double> inner, outer;

    const auto chord_angle = [](const double r,
                                const double R,
                                const double distance,
                                const double a) {
      // The half angle of the arc of radius r around a point at `distance`
      // from the center of a disk of radius R; a = r - (distance - R).
      const double cosine = 1. - a * (2. * R - a) / (2. * r * distance);
      return std::acos(std::min(1., std::max(-1., cosine)));
    };
    const auto over_p = [&](const double t, const double p_min) {
      return inner.integrate(
        [&](const double log_ratio) {
          const double p = p_min * std::exp(log_ratio);
          const double a = p_min * std::expm1(log_ratio);
          return std::pow(p, 2. - m) * chord_angle(p, 1., t, a);
        },
        0.,
        std::log((p_min + 2.) / p_min),
        1e-11);
    };
    return 4. * outer.integrate(
                  [&](const double log_ratio) {
                    const double p_min = gap * std::exp(log_ratio);
                    const double t     = 1. + p_min;
                    const double a     = gap * std::expm1(log_ratio);
                    return p_min * t * chord_angle(t, 1., d, a) *
                           over_p(t, p_min);
                  },
                  0.,
                  std::log((gap + 2.) / gap),
                  1e-10);
  }
} // namespace



TEST(DiskCylinder, HasTheConstantsOfThePaper)
{
  constexpr double k = -2.5;
  EXPECT_NEAR(DiskCylinder::coefficient(6, k) / (pi * pi * k / 24.), 1., 1e-15);
  EXPECT_NEAR(DiskCylinder::coefficient(12, k) /
                (143. * pi * pi * k / (15. * std::pow(2., 14))),
              1.,
              1e-15);
  EXPECT_NEAR(DiskCylinder::coefficient(12, k) / (pi * pi * k),
              5.81868e-4,
              5e-10);
}



// A cylinder is a stack of disks: its potential is that of one disk with the
// power law that is left after the integral along the axis.
TEST(DiskCylinder, IsDiskDiskOfTheNextSmallerExponentWhenParallel)
{
  for (const double m : {6., 7., 8.5, 12., 20.})
    {
      const double along_axis =
        std::sqrt(pi) * std::tgamma((m - 1.) / 2.) / std::tgamma(m / 2.);
      const double expected = along_axis *
                              DiskDisk::coefficient(m - 1., 1., sections) /
                              densities(sections);
      const double actual = DiskCylinder::coefficient(m, 1.) *
                            std::sqrt(2. * reduced_radius(sections));
      EXPECT_NEAR(actual / expected, 1., 1e-14) << "m = " << m;
    }
}



TEST(DiskCylinder, IsTheVanDerWaalsEnergyOfParallelCylinders)
{
  constexpr double   C = 1.3, gap = 1e-5;
  const DiskCylinder law({{6, -C}}, sections, {});
  const double       A = pi * pi * densities(sections) * C;
  const double       expected =
    -A / 24. * std::sqrt(2. * reduced_radius(sections)) * std::pow(gap, -1.5);
  EXPECT_NEAR(law(gap, 1.).value / expected, 1., 1e-13);
  EXPECT_NEAR(law(gap, -1.).value / expected, 1., 1e-13);
}



// The relative errors at finite gaps are those of theory: 0.02%, 0.2%, 1.8% for
// m = 6 and 0.4% for m = 12 at g/R = 0.01.
TEST(DiskCylinder, ApproachesTheExactEnergyOfParallelCylinders)
{
  const auto relative_error = [](const unsigned int m, const double gap) {
    const double along_axis =
      std::sqrt(pi) * std::tgamma((m - 1.) / 2.) / std::tgamma(m / 2.);
    const double exact = along_axis * energy_of_disks(m - 1., gap);
    return DiskCylinder({{m, 1.}}, SectionPair(), {})(gap, 1.).value / exact -
           1.;
  };
  EXPECT_NEAR(relative_error(6, 1e-4), 2e-4, 5e-5);
  EXPECT_NEAR(relative_error(6, 1e-3), 2e-3, 5e-4);
  EXPECT_NEAR(relative_error(6, 1e-2), .018, 5e-4);
  EXPECT_NEAR(relative_error(12, 1e-2), .004, 5e-4);
  EXPECT_NEAR(relative_error(12, 1e-1), .038, 5e-4);
}



TEST(DiskCylinder, DependsOnTheAngleAsThePaper)
{
  const DiskCylinder law({{6, -1.}}, sections, {});
  const double       R1 = sections.radius_1, R2 = sections.radius_2;
  EXPECT_NEAR(law(.1, 0.).value / law(.1, 1.).value,
              std::sqrt((R1 + R2) / R2),
              1e-14);
  EXPECT_NEAR(law(.1, .5).value / law(.1, 1.).value,
              std::sqrt((R1 + R2) / (.25 * R1 + R2)),
              1e-14);
}



TEST(DiskDisk, HasTheConstantOfThePaperForEveryExponent)
{
  const double R1 = sections.radius_1, R2 = sections.radius_2, k = -.3;
  for (const double m : {4., 5., 6., 9.5, 12., 24., 60.})
    {
      const double expected =
        k * densities(sections) * 2. * pi / ((m - 2.) * (m - 2.)) *
        std::sqrt(2. * R1 * R2 / (R1 + R2)) * std::tgamma(m - 3.5) *
        std::tgamma((m - 1.) / 2.) /
        (std::tgamma(m - 2.) * std::tgamma(m / 2. - 1.));
      EXPECT_NEAR(DiskDisk::coefficient(m, k, sections) / expected, 1., 1e-13)
        << "m = " << m;
    }
}



TEST(DiskDisk, ApproachesTheExactEnergyOfCoplanarDisks)
{
  for (const unsigned int m : {6, 8, 12})
    {
      const DiskDisk law({{m, 1.}}, SectionPair(), {});
      double         last = 1.;
      for (const double gap : {1e-2, 1e-3, 1e-4})
        {
          const double error =
            std::abs(law(gap).value / energy_of_disks(m, gap) - 1.);
          EXPECT_LT(error, 2.5 * gap) << "m = " << m;
          EXPECT_LT(error, .12 * last) << "m = " << m;
          last = error;
        }
    }
}



// Along two parallel cylinders the gap of the sections grows as s^2/(2d): the
// integral diverges as g^(4-m), faster than the g^(9/2-m) of the cylinders.
TEST(DiskDisk, IsTooStrongWhenIntegratedOverParallelCylinders)
{
  constexpr double                           gap = 1e-6, d = 2. + gap;
  boost::math::quadrature::tanh_sinh<double> quadrature;
  for (const unsigned int m : {6, 12})
    {
      const DiskDisk law({{m, 1.}}, SectionPair(), {});
      const double   half = quadrature.integrate(
        [&](const double u) {
          // s = sqrt(g d) sinh(u), and the gap without cancellation
          const double s    = std::sqrt(gap * d) * std::sinh(u);
          const double ds   = std::sqrt(gap * d) * std::cosh(u);
          const double more = s * s / (d + std::sqrt(d * d + s * s));
          return law(gap + more).value * ds;
        },
        0.,
        20.,
        1e-12);
      const double expected = law(gap).value * std::sqrt(2. * d * gap) *
                              std::sqrt(pi) * std::tgamma(m - 4.) /
                              std::tgamma(m - 3.5);
      EXPECT_NEAR(2. * half / expected, 1., 5e-6) << "m = " << m;
      EXPECT_GT(2. * half,
                100. *
                  DiskCylinder({{m, 1.}}, SectionPair(), {})(gap, 1.).value);
    }
}



TEST(LennardJones, HasTheEquilibriumGapAndForceThatItIsMadeFrom)
{
  constexpr double     gap = 2e-3, force = -.37;
  const PointPotential potential =
    lennard_jones_of_cylinders(gap, force, sections);
  ASSERT_EQ(potential.size(), 2u);
  EXPECT_EQ(potential[0].exponent, 6u);
  EXPECT_EQ(potential[1].exponent, 12u);
  EXPECT_LT(potential[0].prefactor, 0.);
  EXPECT_GT(potential[1].prefactor, 0.);

  const DiskCylinder law(potential, sections, {});
  const double       gap_minimum = std::pow(17. / 5., 1. / 6.) * gap;
  EXPECT_NEAR(law(gap, 1.).g, 0., 1e-12 * std::abs(force));
  EXPECT_NEAR(-law(gap_minimum, 1.).g, force, 1e-13 * std::abs(force));
  EXPECT_NEAR(law(gap_minimum, 1.).gg, 0., 1e-12 * std::abs(force) / gap);
  EXPECT_GT(-law(1.01 * gap_minimum, 1.).g, force);
  EXPECT_GT(-law(.99 * gap_minimum, 1.).g, force);

  // theory, sections 7 and 9
  const double k6 = potential[0].prefactor, k12 = potential[1].prefactor;
  EXPECT_NEAR(gap / std::pow(-k12 / k6, 1. / 6.), .64170, 5e-6);
  EXPECT_NEAR(force / (densities(sections) *
                       std::sqrt(2. * reduced_radius(sections)) * k6 *
                       std::pow(-k6 / k12, 5. / 12.)),
              .7927,
              5e-5);
}



// All laws without offset, in the whole range: regularized, plain, switched
// off.

namespace
{
  /** Gaps over 13 decades, spread evenly on a logarithmic scale. */
  std::vector<double>
  many_gaps(const double smallest = 1e-12)
  {
    std::mt19937                           random(1);
    std::uniform_real_distribution<double> exponent(std::log10(smallest), 1.);
    std::vector<double>                    gaps;
    for (unsigned int i = 0; i < 1000; ++i)
      gaps.push_back(std::pow(10., exponent(random)));
    return gaps;
  }

  /**
   * The laws of a gap, with or without an angle; those of an offset or a tilt
   * are tested in offset_disks.cc and contact_laws.cc.
   */
  template <typename List, typename... Kept>
  struct OfGapAndAngle;

  template <typename... Kept>
  struct OfGapAndAngle<TypeList<>, Kept...>
  {
    using type = testing::Types<Kept...>;
  };

  template <typename Law, typename... Others, typename... Kept>
  struct OfGapAndAngle<TypeList<Law, Others...>, Kept...>
    : std::conditional_t<Law::depends_on == Invariants::gap_offset ||
                           Law::depends_on == Invariants::gap_angle_tilt,
                         OfGapAndAngle<TypeList<Others...>, Kept...>,
                         OfGapAndAngle<TypeList<Others...>, Kept..., Law>>
  {};

  template <typename Law>
  class LawDerivatives : public testing::Test
  {
  protected:
    static constexpr bool has_angle = std::is_invocable_v<Law, double, double>;

    static PointPotential
    potential(const SectionPair &pair)
    {
      return lennard_jones_of_cylinders(.03, -1., pair);
    }

    /** The law at a gap and, if it has one, an angle. */
    static GapAngleDerivatives
    by_hand(const Law &law, const double gap, const double cosine)
    {
      if constexpr (has_angle)
        return law(gap, cosine);
      else
        {
          (void)cosine;
          const GapDerivatives d = law(gap);
          return {d.value, d.first, 0., d.second, 0., 0.};
        }
    }

    static GapAngleDerivatives
    by_sacado(const Law &law, const double gap, const double cosine)
    {
      const auto   g = variable<2>(0, gap), c = variable<2>(1, cosine);
      NestedFad<2> energy;
      if constexpr (has_angle)
        energy = law.energy(g, c);
      else
        energy = law.energy(g);
      const LocalSystem<2> s = local_system<2>(energy);
      return {s.energy,
              s.residual[0],
              s.residual[1],
              s.tangent[0][0],
              s.tangent[0][1],
              s.tangent[1][1]};
    }

    /** Sizes of the derivatives, from terms that do not cancel. */
    static GapAngleDerivatives
    sizes(const SectionPair &pair, const double gap)
    {
      PointPotential positive = potential(pair);
      for (InversePower &power : positive)
        power.prefactor = std::abs(power.prefactor);
      const double clipped =
        Law::is_long_range ? gap : std::max(gap, range.regularization);
      const auto plain = by_hand(Law(positive, pair, GapRange()), clipped, 0.);

      // expansion below, switch above, and the angle where it matters most
      const double x     = clipped - gap;
      const double width = range.cutoff - range.cutoff_begin;
      const double gg    = plain.gg + 60. * plain.value / (width * width);
      const double g     = -plain.g + x * gg + 2. * plain.value / width;
      const double v     = plain.value + x * g;
      const double ratio = 1. + pair.radius_1 / pair.radius_2;
      return {
        v, g, std::sqrt(ratio) * v, gg, std::sqrt(ratio) * g, 3. * ratio * v};
    }
  };

  TYPED_TEST_SUITE(LawDerivatives, typename OfGapAndAngle<PotentialLaws>::type);
} // namespace



TYPED_TEST(LawDerivatives, AreThoseOfTheEnergy)
{
  std::vector<double> gaps = many_gaps();
  for (const double gap : many_gaps(1e-3))
    {
      gaps.push_back(-.1 * gap);
      gaps.push_back(range.cutoff_begin +
                     (range.cutoff - range.cutoff_begin) * gap / 10.);
    }

  std::mt19937                           random(2);
  std::uniform_real_distribution<double> any(-1., 1.);
  for (const SectionPair &pair :
       {sections, SectionPair{.001, 1., 1., 1.}, SectionPair{1., .001, 1., 1.}})
    {
      const TypeParam law(this->potential(pair), pair, range);
      for (const double gap : gaps)
        if (law.admits(gap))
          for (const double cosine : {any(random), 0., 1., -1.})
            {
              const auto       a = this->by_hand(law, gap, cosine);
              const auto       b = this->by_sacado(law, gap, cosine);
              const auto       s = this->sizes(pair, gap);
              constexpr double e = 2e-14;
              EXPECT_NEAR(a.value, b.value, e * s.value)
                << gap << ' ' << cosine;
              EXPECT_NEAR(a.g, b.g, e * s.g) << gap << ' ' << cosine;
              EXPECT_NEAR(a.c, b.c, e * s.c) << gap << ' ' << cosine;
              EXPECT_NEAR(a.gg, b.gg, e * s.gg) << gap << ' ' << cosine;
              EXPECT_NEAR(a.gc, b.gc, e * s.gc) << gap << ' ' << cosine;
              EXPECT_NEAR(a.cc, b.cc, e * s.cc) << gap << ' ' << cosine;
            }
    }
}



TYPED_TEST(LawDerivatives, EndAtTheCutoff)
{
  const TypeParam law(this->potential(sections), sections, range);
  EXPECT_EQ(law.cutoff(), range.cutoff);
  EXPECT_NE(this->by_hand(law, .99 * range.cutoff, .3).gg, 0.);
  EXPECT_EQ(this->by_hand(law, range.cutoff, .3).value, 0.);
  EXPECT_EQ(this->by_hand(law, range.cutoff, .3).gg, 0.);
}
