// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <setae/solvers/generalized_alpha.h>

#include <algorithm>

namespace Setae
{
  GeneralizedAlpha::Coefficients::Coefficients(const double rho_infinity)
    : Coefficients(rho_infinity, 1., (rho_infinity - 1.) / (rho_infinity + 1.))
  {}



  GeneralizedAlpha::Coefficients::Coefficients(const double rho_infinity,
                                               const double ratio,
                                               const double last_delay)
    : delay(last_delay / ratio)
  {
    const double rho =
      rho_infinity < 1. ? std::min({rho_infinity, ratio, 1. / ratio}) : 1.;
    alpha_m    = (2. * rho - 1.) / (rho + 1.);
    alpha_f    = rho / (rho + 1.);
    next_delay = (alpha_m - alpha_f - alpha_m * delay) / (1. - alpha_m);
    if (next_delay > 0.)
      {
        next_delay = 0.;
        alpha_m    = alpha_f / (1. - delay);
      }
    gamma = (.5 - delay) / (1. + next_delay - delay);
    beta  = .25 * (.5 + gamma) * (.5 + gamma);
  }



  GeneralizedAlpha::Coefficients
  GeneralizedAlpha::Coefficients::of_implicit_euler()
  {
    Coefficients result(0.);
    result.alpha_m = result.alpha_f = result.delay = result.next_delay = 0.;
    result.beta = result.gamma = 1.;
    result.is_euler            = true;
    return result;
  }
} // namespace Setae
