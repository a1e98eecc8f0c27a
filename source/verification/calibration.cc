// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <setae/laws/all.h>
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

        /**
         * The integral of energies and forces over the lateral distance.
         *
         * @param law Value and derivative with respect to the gap.
         * @param weight A function of the lateral distance.
         */
        template <typename Law, typename Weight>
        EnergyAndForce
        integrate(const Law &law, const Weight &weight) const
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
          return {from_zero([&](const double x) {
                    return weight(x) * law(gap(x)).value;
                  }),
                  from_zero([&](const double x) {
                    return -weight(x) * law(gap(x)).first * cosine(x);
                  })};
        }

      private:
        double contact, smallest, d;
      };



      /** A law of the gap: along one of two parallel lines, over all pairs of
       * points of two crossing ones. */
      template <typename Law>
      EnergyAndForce
      over_both_fibers(const Law            &law,
                       const StraightFibers &fibers,
                       const double          gap)
      {
        const double sine = std::sin(fibers.angle);
        return Connection(fibers.sections, gap)
          .integrate(law, [&](const double lateral) {
            return fibers.angle == 0. ? 2. : 2. * pi * lateral / sine;
          });
      }



      /** A law of gap and angle: a value, or along the source that crosses. */
      template <typename Law>
      EnergyAndForce
      over_source(const Law            &law,
                  const StraightFibers &fibers,
                  const double          gap)
      {
        const double cosine = std::cos(fibers.angle);
        const auto   at_gap = [&](const double g) {
          const GapAngleDerivatives p = law(g, cosine);
          return GapDerivatives{p.value, p.g, p.gg};
        };
        if (fibers.angle == 0.)
          return {{at_gap(gap).value, 0.}, {-at_gap(gap).first, 0.}};
        const double sine = std::sin(fibers.angle);
        return Connection(fibers.sections, gap).integrate(at_gap, [&](double) {
          return 2. / sine;
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
        const Law of_power({power}, fibers.sections, GapRange());
        if constexpr (Law::depends_on == Invariants::gap)
          result = over_both_fibers(of_power, fibers, gap);
        else if constexpr (Law::depends_on == Invariants::gap_angle)
          result = over_source(of_power, fibers, gap);
        else
          AssertThrow(false,
                      ExcInput("The law '" + law + "' cannot be calibrated."));
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
