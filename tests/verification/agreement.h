// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_tests_verification_agreement_h
#define setae_tests_verification_agreement_h

#include <gtest/gtest.h>

#include <setae/verification/quadrature.h>

namespace Setae
{
  /** Two ways to one number that share neither integral nor coordinates. */
  inline void
  expect_agreement(const References::Estimate &one,
                   const References::Estimate &other,
                   const double                tolerance = 1e-9)
  {
    EXPECT_NEAR(one.value / other.value, 1., tolerance);
  }



  inline void
  expect_agreement(const References::EnergyAndForce &one,
                   const References::EnergyAndForce &other,
                   const double                      tolerance = 1e-9)
  {
    expect_agreement(one.energy, other.energy, tolerance);
    expect_agreement(one.force, other.force, tolerance);
  }



  /**
   * The work of the force from the gap @p a to the gap @p b is the difference of
   * the energies.
   *
   * @param reference A function of the gap that returns energy and force.
   */
  template <typename Reference>
  void
  expect_work(const Reference &reference, const double a, const double b)
  {
    const References::Estimate work = References::integrate(
      [&](const double gap) { return reference(gap).force.value; }, a, b, 1e-9);
    EXPECT_NEAR((reference(a).energy.value - reference(b).energy.value) /
                  work.value,
                1.,
                2e-9);
  }
} // namespace Setae

#endif
