// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <setae/solvers/convergence.h>

#include <algorithm>
#include <sstream>

namespace Setae
{
  Convergence::Convergence(const NewtonParameters &parameters,
                           const NonlinearSystem  &system)
    : parameters(parameters)
    , length_scale(system.length_scale())
    , increment_tolerance(parameters.increment_tolerance > 0. ?
                            parameters.increment_tolerance :
                            parameters.relative_increment_tolerance *
                              length_scale)
  {}



  double
  Convergence::residual_tolerance(const Evaluation &evaluation) const
  {
    const double tolerance =
      parameters.residual_tolerance > 0. ?
        parameters.residual_tolerance :
        parameters.relative_residual_tolerance * evaluation.force_scale;
    return std::max(tolerance, evaluation.round_off);
  }



  bool
  Convergence::is_reached(const Evaluation &evaluation,
                          const double      increment_norm,
                          const bool        is_cut)
  {
    constexpr double largest_round_off = 1e-4; // of the length scale
    constexpr double stagnation        = .5;

    const bool is_round_off =
      !is_cut && evaluation.residual_norm <= evaluation.round_off &&
      increment_norm >= stagnation * last_increment &&
      increment_norm <= largest_round_off * length_scale;
    last_increment = increment_norm;
    return has_small_residual(evaluation) &&
           (increment_norm <= increment_tolerance || is_round_off);
  }



  std::string
  Convergence::distance(const Evaluation &evaluation) const
  {
    std::ostringstream text;
    text << "residual " << evaluation.residual_norm << " of at most "
         << residual_tolerance(evaluation) << ", increment " << last_increment
         << " of at most " << increment_tolerance;
    return text.str();
  }
} // namespace Setae
