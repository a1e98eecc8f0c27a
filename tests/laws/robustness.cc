// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

// Every law of PotentialLaws over 10^5 configurations: gaps down to 10^-12 of
// the smaller radius and up to 10^6 of the larger one, radii up to 10^4 apart,
// all angles, tilts and offsets with their limits, regularized and not. The
// energy has the sign of the potential and decays with the gap, and energy and
// derivatives are numbers. Where fibers overlap the force may have any sign. A
// quadrature is taken with few points, for time; a table with its usual
// tolerance.

#include <gtest/gtest.h>

#include <setae/laws/all.h>

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <vector>

using namespace Setae;

namespace
{
  template <typename List>
  struct TestedLaws;

  template <typename... Laws>
  struct TestedLaws<TypeList<Laws...>>
  {
    using type = testing::Types<Laws...>;
  };

  /** What a law says of a configuration. */
  struct Answer
  {
    double energy, by_gap;
    double by_offset = 0.; ///< or by the cosine: negative as of two parts
    double all;            ///< a sum of all derivatives, for their finiteness
  };

  /** @p n numbers from @p begin to @p end, evenly spread in their logarithm. */
  std::vector<double>
  logarithmic(const double begin, const double end, const unsigned int n)
  {
    std::vector<double> result(n);
    for (unsigned int i = 0; i < n; ++i)
      result[i] = begin * std::pow(end / begin, i / (n - 1.));
    return result;
  }

  /** Cosines from 1 to 0 and below, with the limits and what is next to them.
   */
  std::vector<double>
  cosines(const unsigned int n)
  {
    std::vector<double> result = {1., 0., -1., 1e-12, 1e-6, 1. - 1e-12};
    for (const double angle : {1e-6, 1e-3})
      {
        result.push_back(std::cos(angle));
        result.push_back(-std::sin(angle));
      }
    for (unsigned int i = 1; i <= n; ++i)
      result.push_back((i % 2 == 0 ? 1. : -1.) *
                       std::cos(.5 * M_PI * i / (n + 1.)));
    return result;
  }

  template <typename Law>
  class EveryLaw : public testing::Test
  {
  protected:
    static constexpr Invariants invariants = Law::depends_on;

    /** How many gaps make 10^5 configurations of twenty laws. */
    static constexpr unsigned int n_gaps =
      invariants == Invariants::gap            ? 5000 :
      invariants == Invariants::gap_angle_tilt ? 20 :
                                                 200;

    /**
     * The radius of which 10^-12 is a gap: the smaller one. A quadrature over
     * the source resolves no gap that its radius does not.
     */
    static double
    resolved(const double smaller_radius)
    {
      return std::is_same_v<Law, SectionQuadrature> ? 1. : smaller_radius;
    }

    /** The second and the third argument of the law at a gap. */
    struct Argument
    {
      double first, second;
    };

    static std::vector<Argument>
    arguments(const double gap)
    {
      std::vector<Argument> result = {{0., 0.}};
      if constexpr (invariants == Invariants::gap_angle)
        for (const double c : cosines(20))
          result.push_back({c, 0.});
      else if constexpr (invariants == Invariants::gap_offset)
        for (const double ratio : logarithmic(1e-12, 1e6, 25))
          result.push_back({(ratio > 1. ? -1. : 1.) * ratio * gap, 0.});
      else if constexpr (invariants == Invariants::gap_angle_tilt)
        for (const double c : cosines(8))
          for (const double part : cosines(6))
            result.push_back({c, part * std::sqrt(1. - c * c)});
      return result;
    }

    static Answer
    answer(const Law &law, const double gap, const Argument &at)
    {
      if constexpr (invariants == Invariants::gap)
        {
          const GapDerivatives f = law(gap);
          return {f.value, f.first, 0., f.second};
        }
      else if constexpr (invariants == Invariants::gap_angle)
        {
          const GapAngleDerivatives f = law(gap, at.first);
          return {f.value, f.g, f.c * at.first, f.c + f.gg + f.gc + f.cc};
        }
      else if constexpr (invariants == Invariants::gap_offset)
        {
          const OffsetGapDerivatives f = law(at.first, gap);
          return {f.value, f.g, f.o * at.first, f.o + f.oo + f.og + f.gg};
        }
      else
        {
          const GapAngleTiltDerivatives f = law(gap, at.first, at.second);
          return {f.value,
                  f.g,
                  0.,
                  f.c + f.t + f.gg + f.gc + f.gt + f.cc + f.ct + f.tt};
        }
    }

    /** Whether energy and force are those of a potential of this @p sign. */
    static testing::AssertionResult
    is_right(const Law &law, const int sign, const double gap)
    {
      if (!law.admits(gap))
        return testing::AssertionFailure() << "not admitted at the gap " << gap;
      for (const Argument &at : arguments(std::abs(gap)))
        {
          const Answer f = answer(law, gap, at);
          // Also false for what is not a number.
          if (!(sign * f.energy > 0. && (gap <= 0. || sign * f.by_gap < 0.) &&
                (gap <= 0. || sign * f.by_offset <= 0.) &&
                std::isfinite(f.all)))
            return testing::AssertionFailure()
                   << "gap " << gap << ", arguments " << at.first << ' '
                   << at.second << ": " << f.energy << ' ' << f.by_gap << ' '
                   << f.by_offset << ' ' << f.all;
        }
      return testing::AssertionSuccess();
    }
  };

  using CoarseTable = EveryLaw<TabulatedDiskCylinder>;

  TYPED_TEST_SUITE(EveryLaw, typename TestedLaws<PotentialLaws>::type);
} // namespace



TYPED_TEST(EveryLaw, IsANumberOfTheRightSignInEveryConfiguration)
{
  unsigned int n_configurations = 0;
  for (const double R2 : {1e-4, .01, 1., 100., 1e4})
    for (const unsigned int exponent : {TypeParam::smallest_exponent, 12u})
      for (const double regularization : {0., 1e-3})
        {
          const double      small = std::min(1., R2), large = std::max(1., R2);
          const SectionPair sections = {1., R2, 1., 1.};
          const int         sign     = exponent == 12 ? 1 : -1;
          const GapRange    range    = {regularization * small};
          const LawAccuracy accuracy = {2, 5};
          const auto law = make_law<TypeParam>({{exponent, double(sign)}},
                                               sections,
                                               range,
                                               accuracy);
          SCOPED_TRACE(testing::Message()
                       << "R2 " << R2 << ", m " << exponent
                       << ", regularization " << range.regularization);
          for (const double gap : logarithmic(1e-12 * this->resolved(small),
                                              1e6 * large,
                                              this->n_gaps))
            {
              ASSERT_TRUE(this->is_right(law, sign, gap));
              n_configurations += this->arguments(gap).size();
            }

          // Overlap, up to the center of a section on the surface of the other
          // fiber; plain laws at a small gap do not admit it.
          if (TypeParam::is_long_range || regularization > 0.)
            for (const double part : {0., 1e-12, 1e-3, .1, .5, .9, .99})
              ASSERT_TRUE(this->is_right(law, sign, -part * small));
          else
            EXPECT_FALSE(law.admits(0.) || law.admits(-.1 * small));
        }
  EXPECT_GE(n_configurations, 100000u);
}

// Its table may be coarser than its error can be small.
TEST_F(CoarseTable, HasTheRightSign)
{
  using Law = TabulatedDiskCylinder;
  for (const double R2 : {1e-4, .01, 1., 100., 1e4})
    for (const unsigned int exponent : {6u, 12u})
      {
        const auto law =
          make_law<Law>({{exponent, 1.}}, {1., R2, 1., 1.}, {}, {2, 5, .1});
        for (const double gap :
             logarithmic(1e-12 * std::min(1., R2), 1e6 * std::max(1., R2), 60))
          ASSERT_TRUE(is_right(law, 1, gap))
            << "R2 " << R2 << ", m " << exponent;
      }
}
