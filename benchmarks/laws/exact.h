// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_benchmarks_laws_exact_h
#define setae_benchmarks_laws_exact_h

#include <setae/laws/point_potential.h>
#include <setae/verification/quadrature.h>

#include <cmath>
#include <functional>
#include <map>
#include <utility>

#include "interaction.h"

namespace Setae
{
  namespace LawReport
  {
    /** The number to be reached. */
    struct Exact
    {
      Interaction value;
      Interaction error; ///< estimated, absolute

      /**
       * What relative errors refer to: the sum of the magnitudes of all powers
       * of the potential, because that of Lennard-Jones passes through zero. It
       * has the sign of the value, so that what is too strong has a positive
       * error.
       */
      Interaction scale;

      double cpu_time = 0.; ///< [s]
    };



    /**
     * Exact numbers of several potentials at one place: each power is
     * integrated once.
     */
    class ExactPowers
    {
    public:
      /** @param of_power One of the References at this place. */
      ExactPowers(std::function<
                    References::EnergyAndForce(const InversePower &)> of_power,
                  const bool                                          with_time)
        : of_power(std::move(of_power))
        , with_time(with_time)
      {}

      Exact
      operator()(const PointPotential &potential)
      {
        Exact result;
        for (const auto &[exponent, prefactor] : potential)
          {
            if (known.find(exponent) == known.end())
              known[exponent] = timed(
                [&, m = exponent] {
                  return of_power({m, 1.});
                },
                with_time);
            const auto &[pair, time] = known[exponent];
            const Interaction value  = {prefactor * pair.energy.value,
                                        prefactor * pair.force.value};
            result.value += value;
            result.scale += {std::abs(value.energy), std::abs(value.force)};
            result.error += std::abs(prefactor) *
                            Interaction{pair.energy.error, pair.force.error};
            result.cpu_time += time;
          }
        result.scale.energy =
          std::copysign(result.scale.energy, result.value.energy);
        result.scale.force =
          std::copysign(result.scale.force, result.value.force);
        return result;
      }

    private:
      const std::function<References::EnergyAndForce(const InversePower &)>
                 of_power;
      const bool with_time;
      std::map<unsigned int, std::pair<References::EnergyAndForce, double>>
        known;
    };
  } // namespace LawReport
} // namespace Setae

#endif
