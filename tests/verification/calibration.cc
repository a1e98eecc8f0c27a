// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

// Fitted prefactors: the exact force at the gap they are fitted at, and the
// factors that are known.

#include <setae/base/exceptions.h>
#include <setae/laws/disk_disk.h>
#include <setae/scene.h>
#include <setae/verification/calibration.h>

#include <cmath>
#include <fstream>
#include <iomanip>
#include <sstream>

#include "agreement.h"

using namespace Setae;
using namespace Setae::References;

namespace
{
  constexpr double         pi            = M_PI;
  const PointPotential     lennard_jones = {{6, -1e-7}, {12, 5e-25}};
  constexpr StraightFibers parallel      = {{.02, .03, 1.5, .8}, 0.};
  constexpr StraightFibers crossing      = {{.02, .03, 1.5, .8}, .3 * pi};
} // namespace



TEST(Calibration, GivesTheExactForceAtItsGap)
{
  for (const std::string law : {"disk-disk", "disk-cylinder", "quadrupole"})
    for (const StraightFibers &fibers : {parallel, crossing})
      for (const double gap : {1e-5, 1e-3, .1})
        {
          const auto fitted = fit(law, lennard_jones, fibers, gap);
          ASSERT_EQ(fitted.size(), 2);
          for (unsigned int i = 0; i < 2; ++i)
            {
              EXPECT_EQ(fitted[i].exponent, lennard_jones[i].exponent);
              expect_agreement(by_law(law,
                                      {fitted[i].exponent, fitted[i].prefactor},
                                      fibers,
                                      gap)
                                 .force,
                               exact(lennard_jones[i], fibers, gap).force,
                               1e-12);
            }
        }
}



// SBIP eq. 17 is exact for parallel fibers as the gap closes, and too strong by
// the square root of (R1+R2)/(R1 cos^2 alpha+R2) for crossing ones.
TEST(Calibration, OfTheSectionBeamLawIsKnownAsTheGapCloses)
{
  const double c          = std::cos(crossing.angle);
  const double too_strong = std::sqrt(.05 / (.02 * c * c + .03));
  for (const auto &fitted : fit("disk-cylinder", lennard_jones, parallel, 1e-8))
    EXPECT_NEAR(fitted.factor, 1., 2e-6);
  for (const auto &fitted : fit("disk-cylinder", lennard_jones, crossing, 1e-8))
    EXPECT_NEAR(fitted.factor, 1. / too_strong, 1e-5);
}



// The law of two disks grows faster than the truth by the square root of the
// gap.
TEST(Calibration, OfTheSectionSectionLawHoldsAtOneGapOnly)
{
  for (unsigned int i = 0; i < 2; ++i)
    EXPECT_NEAR(fit("disk-disk", lennard_jones, parallel, 4e-7)[i].factor /
                  fit("disk-disk", lennard_jones, parallel, 1e-7)[i].factor,
                2.,
                1e-3);
}



// What the section-beam laws for every angle promise: the closed form as the
// gap closes, the table within its tolerance at every gap.
TEST(Calibration, OfTheLawsForEveryAngleIsOne)
{
  for (const StraightFibers &fibers : {parallel, crossing})
    {
      for (const auto &fitted :
           fit("oriented-disk-cylinder", lennard_jones, fibers, 1e-9))
        EXPECT_NEAR(fitted.factor, 1., 1e-4);
      for (const double gap : {1e-7, 1e-4, 1e-2, .2})
        for (const auto &fitted :
             fit("tabulated-disk-cylinder", lennard_jones, fibers, gap))
          EXPECT_NEAR(fitted.factor, 1., 1e-3) << gap;
    }
}



TEST(Calibration, OfSectionsWithOffsetIsOneForParallelFibersAsTheGapCloses)
{
  for (const auto &fitted : fit("offset-disks", lennard_jones, parallel, 1e-8))
    EXPECT_NEAR(fitted.factor, 1., 2e-6);
  EXPECT_THROW(fit("offset-disks", lennard_jones, crossing, 1e-8), ExcInput);
}



TEST(Calibration, OfLawsAtLargeDistanceIsOneFarAway)
{
  for (const StraightFibers &fibers : {parallel, crossing})
    for (const auto &fitted : fit("monopole", lennard_jones, fibers, 100.))
      EXPECT_NEAR(fitted.factor, 1., 1e-4);
}



TEST(Calibration, ForcesOfLawsDoTheirWork)
{
  for (const std::string law :
       {"disk-disk", "disk-cylinder", "oriented-disk-cylinder"})
    for (const StraightFibers &fibers : {parallel, crossing})
      expect_work(
        [&](const double gap) {
          return by_law(law, {6, -1.}, fibers, gap);
        },
        1e-3,
        2e-3);
}



TEST(Calibration, RefusesWhatHasNoExactCounterpart)
{
  StraightFibers charged        = parallel;
  charged.sections.distribution = Distribution::surface;
  EXPECT_THROW(fit("monopole", lennard_jones, charged, .1), ExcInput);
  EXPECT_THROW(fit("monopole", {{1, 1.}}, parallel, .1), ExcInput);
  EXPECT_THROW(fit("penalty-contact", lennard_jones, parallel, .1), ExcInput);
}



TEST(Calibration, PrintsTheFactorsOfAScene)
{
  const std::string  name = std::string(SETAE_SCENES) + "/peeling_ssip.prm";
  std::ifstream      file(name);
  std::ostringstream text, printed;
  text << file.rdbuf();
  calibrate(Scene::read(text.str(), name), 1e-3, 0., printed);

  const StraightFibers fibers = {{.02, .02, 1., 1.}, 0.};
  for (const auto &fitted : fit("disk-disk", lennard_jones, fibers, 1e-3))
    {
      std::ostringstream line;
      line << std::fixed << std::setprecision(6) << fitted.factor;
      EXPECT_NE(printed.str().find(line.str()), std::string::npos)
        << printed.str();
    }
}
