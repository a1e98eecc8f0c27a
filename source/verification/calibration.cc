// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <setae/laws/all.h>
#include <setae/laws/parallel_fibers.h>
#include <setae/verification/calibration.h>
#include <setae/verification/cylinders.h>

#include <cmath>
#include <limits>

namespace Setae
{
  namespace References
  {
    namespace
    {
      constexpr double pi       = M_PI;
      constexpr double infinity = std::numeric_limits<double>::infinity();

      /** At a lateral distance from the shortest connection of the axes. */
      class Connection
      {
      public:
        Connection(const SectionPair &sections, const double gap)
          : contact(sections.radius_1 + sections.radius_2)
          , smallest(gap)
          , d(contact + gap)
        {}

        double
        gap(const double lateral) const
        {
          return (smallest * (contact + d) + lateral * lateral) /
                 (std::hypot(d, lateral) + contact);
        }

        /** The derivative of that gap with respect to the smallest one. */
        double
        cosine(const double lateral) const
        {
          return d / std::hypot(d, lateral);
        }

        /** One over the distance of the axes there. */
        double
        inverse(const double lateral) const
        {
          return 1. / std::hypot(d, lateral);
        }

        /** t1.n of a source that crosses at an angle with this sine. */
        double
        tilt(const double lateral, const double sine) const
        {
          return sine * lateral / std::hypot(d, lateral);
        }

        /**
         * The integral over the lateral distance of the energy that @p law gives
         * there with its derivative with respect to the smallest gap.
         */
        template <typename LawThere>
        EnergyAndForce
        integrate(const LawThere &law) const
        {
          const auto from_zero = [this](const Function &f) {
            return integrate_peak(f,
                                  0.,
                                  infinity,
                                  0.,
                                  std::sqrt(2. * smallest * d),
                                  default_tolerance,
                                  100. * d);
          };
          return {from_zero([&](const double x) { return law(x).value; }),
                  from_zero([&](const double x) { return -law(x).first; })};
        }

      private:
        double contact, smallest, d;
      };



      /** A law of the gap, over all pairs of points of two crossing lines. */
      template <typename Law>
      EnergyAndForce
      over_both_fibers(const Law            &law,
                       const StraightFibers &fibers,
                       const double          gap)
      {
        const Connection connection(fibers.sections, gap);
        const double     sine = std::sin(fibers.angle);
        return connection.integrate([&](const double lateral) {
          const double         weight = 2. * pi * lateral / sine;
          const GapDerivatives p      = law(connection.gap(lateral));
          return GapDerivatives{weight * p.value,
                                weight * p.first * connection.cosine(lateral),
                                0.};
        });
      }



      /**
       * A law of gap and angle, and tilt if it knows it, along the source that
       * crosses.
       */
      template <typename Law>
      EnergyAndForce
      over_source(const Law            &law,
                  const StraightFibers &fibers,
                  const double          gap)
      {
        const Connection connection(fibers.sections, gap);
        const double     cosine = std::cos(fibers.angle),
                     sine       = std::sin(fibers.angle);
        const auto there        = [&](const double lateral) {
          const double g = connection.gap(lateral);
          if constexpr (Law::depends_on == Invariants::gap_angle_tilt)
            {
              // The tilt is inverse to the distance, of which the smallest one
              // d is a leg.
              const double tilt    = connection.tilt(lateral, sine);
              const auto   p       = law(g, cosine, tilt);
              const double along_d = connection.cosine(lateral);
              return GapDerivatives{
                p.value,
                along_d * (p.g - p.t * tilt * connection.inverse(lateral)),
                0.};
            }
          else
            {
              const GapAngleDerivatives p = law(g, cosine);
              return GapDerivatives{p.value,
                                    p.g * connection.cosine(lateral),
                                    0.};
            }
        };
        return connection.integrate([&](const double lateral) {
          const GapDerivatives p = there(lateral);
          return GapDerivatives{2. / sine * p.value, 2. / sine * p.first, 0.};
        });
      }
    } // namespace



    EnergyAndForce
    exact(const InversePower   &power,
          const StraightFibers &fibers,
          const double          gap)
    {
      AssertThrow(fibers.sections.distribution == Distribution::volume,
                  ExcInput("Only points in the volume of the fibers have an "
                           "exact energy to compare with."));
      return fibers.angle == 0. ?
               parallel_cylinders(power, fibers.sections, gap) :
               crossing_cylinders(power, fibers.sections, gap, fibers.angle);
    }



    EnergyAndForce
    by_law(const std::string    &law,
           const InversePower   &power,
           const StraightFibers &fibers,
           const double          gap)
    {
      EnergyAndForce result;
      PotentialLaws::dispatch(law, [&](auto tag) {
        using Law = typename decltype(tag)::type;
        const Law of_power =
          make_law<Law>({power}, fibers.sections, GapRange());
        if (fibers.angle == 0.)
          {
            const SectionPair   &sections = fibers.sections;
            const ParallelFibers parallel =
              parallel_fibers(of_power,
                              sections.radius_1 + sections.radius_2,
                              gap);
            result = {{parallel.energy, 0.}, {parallel.force, 0.}};
          }
        else if constexpr (Law::depends_on == Invariants::gap)
          result = over_both_fibers(of_power, fibers, gap);
        else if constexpr (Law::depends_on == Invariants::gap_offset)
          {
            AssertThrow(false,
                        ExcInput("The law '" + law +
                                 "' can be calibrated for parallel fibers "
                                 "only."));
          }
        else
          result = over_source(of_power, fibers, gap);
      });
      return result;
    }



    std::vector<FittedPrefactor>
    fit(const std::string    &law,
        const PointPotential &potential,
        const StraightFibers &fibers,
        const double          gap)
    {
      std::vector<FittedPrefactor> result;
      for (const InversePower &power : potential)
        {
          AssertThrow(power.exponent >= 6,
                      ExcInput("A prefactor is fitted for exponents of at "
                               "least 6, not " +
                               std::to_string(power.exponent) + "."));
          const InversePower unit   = {power.exponent, 1.};
          const double       factor = exact(unit, fibers, gap).force.value /
                                by_law(law, unit, fibers, gap).force.value;
          result.push_back({power.exponent, factor, factor * power.prefactor});
        }
      return result;
    }
  } // namespace References
} // namespace Setae
