// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <setae/energy_guard.h>
#include <setae/scene.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace Setae
{
  EnergyGuard::EnergyGuard(const DynamicsParameters &dynamics,
                           const bool                has_potential)
    : bound(has_potential ? dynamics.largest_energy_gain : 0.)
    , loss_factor(dynamics.integrator == "energy-conserving" ? 1. : 20.)
    , can_repeat(dynamics.integrator != "IDA")
  {}



  void
  EnergyGuard::start(const MotionReport &motion, const Evaluation &evaluation)
  {
    first_balance  = motion.balance();
    first_energies = evaluation.energies;
    last_gain      = 0.;
    is_first       = true;
    last_loss      = 0.;
    largest        = largest_energy(motion, evaluation);
  }



  double
  EnergyGuard::created(const MotionReport &motion) const
  {
    return motion.balance() + motion.numerical_dissipation - first_balance;
  }



  double
  EnergyGuard::moved_by_supports(const MotionReport &motion)
  {
    return motion.support_work != 0. ? motion.numerical_dissipation : 0.;
  }



  double
  EnergyGuard::gain(const MotionReport &motion) const
  {
    const double least =
      is_first ? moved_by_supports(motion) : least_dissipation;
    return created(motion) +
           std::max(std::min(least, 0.) - motion.numerical_dissipation, 0.);
  }



  double
  EnergyGuard::largest_energy(const MotionReport &motion,
                              const Evaluation   &evaluation) const
  {
    double sum = motion.momenta.kinetic_energy + motion.dissipation +
                 (can_repeat ? 0. : std::abs(motion.total_energy));
    for (unsigned int i = 0; i < evaluation.energies.size(); ++i)
      sum += std::abs(evaluation.energies[i] - first_energies[i]);
    return std::max(largest, sum);
  }



  double
  EnergyGuard::round_off(const MotionReport &motion,
                         const Evaluation   &evaluation)
  {
    constexpr double accuracy = 1e3 * std::numeric_limits<double>::epsilon();
    double           sum      = motion.momenta.kinetic_energy;
    for (const double energy : evaluation.energies)
      sum += std::abs(energy);
    return accuracy * sum;
  }



  EnergyGuard::Parts
  EnergyGuard::parts(const MotionReport &motion,
                     const Evaluation   &evaluation,
                     const double        path) const
  {
    const double noise =
      round_off(motion, evaluation) + evaluation.round_off * path;
    const double allowed = bound * largest_energy(motion, evaluation);
    const auto   part    = [noise](const double change, const double left) {
      return change <= noise ? 0. :
                  left > 0.       ? change / (.5 * left) :
                                    std::numeric_limits<double>::infinity();
    };
    const double loss = -created(motion);
    return {part(gain(motion) - last_gain, allowed - last_gain),
            part(loss - last_loss, loss_factor * allowed - last_loss)};
  }



  double
  EnergyGuard::measure(const MotionReport &motion,
                       const Evaluation   &evaluation,
                       const double        path) const
  {
    if (bound == 0.)
      return 0.;
    const Parts parts = this->parts(motion, evaluation, path);
    return std::max(parts.gain, parts.loss);
  }



  bool
  EnergyGuard::is_exceeded(const MotionReport &motion,
                           const Evaluation   &evaluation) const
  {
    return bound > 0. &&
           gain(motion) > bound * largest_energy(motion, evaluation) +
                            round_off(motion, evaluation);
  }



  void
  EnergyGuard::accept(const MotionReport &motion, const Evaluation &evaluation)
  {
    if (is_first)
      least_dissipation = moved_by_supports(motion);
    is_first  = false;
    last_gain = gain(motion);
    last_loss = -created(motion);
    largest   = largest_energy(motion, evaluation);
  }



  std::string
  EnergyGuard::reason(const MotionReport &motion,
                      const Evaluation   &evaluation) const
  {
    const Parts        parts   = this->parts(motion, evaluation, 0.);
    const bool         is_gain = parts.gain >= parts.loss;
    std::ostringstream text;
    text << "the time integration has " << (is_gain ? "created" : "lost")
         << " an energy of " << (is_gain ? gain(motion) : -created(motion))
         << ", "
         << (is_gain ? gain(motion) - last_gain : -created(motion) - last_loss)
         << " of it in this step, where 'dynamics/largest energy gain' allows "
         << bound * (is_gain ? 1. : loss_factor) << " of the largest energy, "
         << largest_energy(motion, evaluation);
    return text.str();
  }
} // namespace Setae
