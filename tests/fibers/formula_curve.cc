// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <gtest/gtest.h>

#include <setae/base/exceptions.h>
#include <setae/fibers/centerline.h>

#include <cmath>
#include <functional>
#include <limits>

using namespace Setae;

namespace
{
  FiberParameters
  fiber_along(const std::string &centerline,
              const double       length,
              const unsigned int n_cells)
  {
    FiberParameters fiber;
    fiber.name       = "rod";
    fiber.centerline = centerline;
    fiber.length     = length;
    fiber.n_cells    = n_cells;
    return fiber;
  }

  /** What is wrong with a centerline. */
  std::string
  refusal(const FiberParameters &fiber, const Constants &constants = {})
  {
    try
      {
        make_centerlines(fiber, constants);
      }
    catch (const ExcParameter &exception)
      {
        return reason(exception);
      }
    return "";
  }

  void
  expect_part(const std::string &text, const std::string &part)
  {
    EXPECT_NE(text.find(part), std::string::npos) << "'" << text << "'";
  }

  /** A curve of size 1 with its derivative, and the same as a formula. */
  struct Curve
  {
    std::string formula; ///< of r and the offset o, in units of s of 'length'
    std::function<Tensor<1, 3>(double)> derivative;
    double                              length;
    bool                                is_scaled; ///< s is a length, no angle
  };

  const std::vector<Curve> curves = {
    {"o + 0.6*s; o - 0.8*s; o",
     [](double) {
       return Tensor<1, 3>({.6, -.8, 0.});
     },
     1.,
     true},
    {"o + r*cos(s/r); o + r*sin(s/r); o",
     [](double s) {
       return Tensor<1, 3>({-std::sin(s), std::cos(s), 0.});
     },
     1.5707963267948966,
     true},
    {"o + r*cos(s/r); o + r*sin(s/r); o + 0.2*s",
     [](double s) {
       return Tensor<1, 3>({-std::sin(s), std::cos(s), .2});
     },
     6.,
     true},
    {"o + r*cos(s); o; o + 0.3*r*sin(s)",
     [](double s) {
       return Tensor<1, 3>({-std::sin(s), 0., .3 * std::cos(s)});
     },
     3.,
     false},
    {"o + s; o + r*exp(2*s/r); o",
     [](double s) {
       return Tensor<1, 3>({1., 2. * std::exp(2. * s), 0.});
     },
     1.,
     true}};
} // namespace



TEST(FormulaCurve, HasExactTangentsAtEverySizeAndPlace)
{
  constexpr unsigned int n = 16;
  for (const Curve &curve : curves)
    for (const double r : {1e-9, 6e-7, 1., 1e9})
      for (const double offset : {0., 1., 1e3, 2e4})
        {
          const double size = curve.is_scaled ? r : 1.;
          const auto fiber = fiber_along(curve.formula, curve.length * size, n);
          const Constants  constants = {{"r", r}, {"o", offset * r}};
          const Centerline line      = make_centerlines(fiber, constants).at(0);
          ASSERT_EQ(line.tangents.size(), n + 1);
          for (unsigned int i = 0; i <= n; ++i)
            {
              const Tensor<1, 3> exact = curve.derivative(curve.length * i / n);
              const double       h     = r * exact.norm() * curve.length / n;
              const double       bound =
                std::max(1e-10,
                         10. * std::numeric_limits<double>::epsilon() *
                           line.positions[i].norm() / h);
              EXPECT_LT((line.tangents[i] - exact / exact.norm()).norm(), bound)
                << curve.formula << ", r = " << r << ", offset " << offset
                << ", node " << i;
            }
        }
}



TEST(FormulaCurve, IsAskedWithinItsRangeOnly)
{
  // No number beyond the ends.
  const auto fiber =
    fiber_along("r*s; r*(s - s^2); if(s < 0 || s > 0.7, sqrt(-1), 0)", .7, 7);
  EXPECT_EQ(refusal(fiber, {{"r", 1.}}), "");
}



TEST(FormulaCurve, MayHaveAJumpOfCurvatureAtANode)
{
  // A straight part that goes over into an arc.
  const auto       fiber = fiber_along("if(s < 1, s, 1 + sin(s - 1)); "
                                       "if(s < 1, 0, 1 - cos(s - 1)); 0",
                                 2.,
                                 8);
  const Centerline line  = make_centerlines(fiber, {}).at(0);
  for (unsigned int i = 0; i <= 8; ++i)
    {
      const double angle = std::max(0., .25 * i - 1.);
      EXPECT_NEAR(line.tangents[i][0], std::cos(angle), 1e-10) << i;
      EXPECT_NEAR(line.tangents[i][1], std::sin(angle), 1e-10) << i;
    }
}



TEST(FormulaCurve, WithAKinkIsRefusedWithPlaceAndAngle)
{
  const std::string message =
    refusal(fiber_along("s; if(s < 1, 0, s - 1); 0", 2., 8));
  expect_part(message, "turns by 45 degrees at s = 1, (1, 0, 0)");
}



TEST(FormulaCurve, WithoutATangentIsRefusedAtEverySize)
{
  for (const std::string text : {"0; 1; 0", "0; s^2; 0", "0; r*sqrt(s/r); 0"})
    for (const double r : {1e-9, 1., 1e9})
      expect_part(refusal(fiber_along(text, 5. * r, 4), {{"r", r}}),
                  "a tangent at every s");
}



TEST(FormulaCurve, IsStraightOrCurvedAtEverySizeAndPlace)
{
  for (const double r : {1e-9, 1., 1e9})
    for (const double offset : {0., 2e4})
      {
        const Constants constants   = {{"r", r}, {"o", offset * r}};
        const auto      is_straight = [&](const std::string &text) {
          return make_centerlines(fiber_along(text, r, 8), constants)
            .at(0)
            .is_straight();
        };
        EXPECT_TRUE(is_straight("o + 0.6*s; o + 0.8*s; o"));
        // A sagitta of a millionth of the length.
        EXPECT_FALSE(is_straight("o + s; o; o + 4e-6*s*(r - s)/r"));
      }
}



TEST(FormulaCurve, WhoseCoordinatesLeaveNoDigitsIsRefused)
{
  expect_part(refusal(fiber_along("1e9; s; 0", 1., 8)), "nearer to the origin");
}



TEST(FormulaCurve, ThatComesBackIsARingAtEverySizeAndPlace)
{
  for (const double r : {1e-9, 1., 1e9})
    for (const double offset : {0., 1e3})
      {
        const auto fiber =
          fiber_along("o + r*cos(s); o + r*sin(s); o", 2. * M_PI, 12);
        std::vector<std::string> notices;
        const Centerline         ring =
          make_centerlines(fiber, {{"r", r}, {"o", offset * r}}, notices).at(0);
        EXPECT_TRUE(ring.closed);
        EXPECT_EQ(ring.n_cells(), 12u);
        ASSERT_EQ(ring.positions.size(), 12u);
        EXPECT_NEAR(ring.tangents[0][1], 1., 1e-10);
        ASSERT_EQ(notices.size(), 1u);
        expect_part(notices[0], "is a ring");
      }
}



TEST(FormulaCurve, ThatComesBackWithAKinkIsRefused)
{
  // A drop from (2, 1) to (2, -1): twice the arc tangent of one half.
  expect_part(refusal(fiber_along("sin(2*s); sin(s); 0", M_PI, 16)),
              "comes back to its start (0, 0, 0) turned by 53.1301 degrees");
  expect_part(refusal(fiber_along("cos(s); sin(s); 0", 2. * M_PI, 2)),
              "at least 3 cells");
}
