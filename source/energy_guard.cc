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
    , conserves_energy(dynamics.integrator == "energy-conserving")
  {}



  void
  EnergyGuard::start(const MotionReport &motion, const Evaluation &evaluation)
  {
    first_balance  = motion.balance();
    first_energies = evaluation.energies;
    last_gain      = 0.;
    largest        = largest_energy(motion, evaluation);
  }



  double
  EnergyGuard::gain(const MotionReport &motion) const
  {
    const double created =
      motion.balance() + motion.numerical_dissipation - first_balance;
    return (conserves_energy ? std::abs(created) : created) -
           std::min(motion.numerical_dissipation, 0.);
  }



  double
  EnergyGuard::largest_energy(const MotionReport &motion,
                              const Evaluation   &evaluation) const
  {
    double sum = motion.momenta.kinetic_energy + motion.dissipation;
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



  double
  EnergyGuard::measure(const MotionReport &motion,
                       const Evaluation   &evaluation,
                       const double        path) const
  {
    if (bound == 0.)
      return 0.;
    const double created = gain(motion) - last_gain;
    if (created <= round_off(motion, evaluation) + evaluation.round_off * path)
      return 0.;
    const double left = bound * largest_energy(motion, evaluation) - last_gain;
    return left > 0. ? created / (.5 * left) :
                       std::numeric_limits<double>::infinity();
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
    last_gain = gain(motion);
    largest   = largest_energy(motion, evaluation);
  }



  std::string
  EnergyGuard::reason(const MotionReport &motion,
                      const Evaluation   &evaluation) const
  {
    std::ostringstream text;
    text << "the time integration has created an energy of " << gain(motion)
         << ", " << gain(motion) - last_gain
         << " of it in this step, where 'dynamics/largest energy gain' allows "
         << bound << " of the largest energy, "
         << largest_energy(motion, evaluation);
    return text.str();
  }
} // namespace Setae
