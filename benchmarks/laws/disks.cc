// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors
//
// Two disks in one plane or at a right angle, energy per length squared over
// the gap: SSIP Fig. 8 and 10a. The laws of two sections against the exact
// energy, and what the quadrature over both disks costs.

#include <deal.II/base/quadrature_lib.h>

#include <setae/base/integer_power.h>
#include <setae/verification/disks.h>

#include "laws.h"
#include "results.h"

namespace Setae
{
  namespace LawReport
  {
    namespace
    {
      const std::string in_plane      = "disks in one plane",
                        perpendicular = "perpendicular disks";
      const std::string reduction     = "2D/3D reduction";

      using dealii::Tensor;
      const Tensor<1, 3> x_axis({1., 0., 0.}), y_axis({0., 1., 0.}),
        z_axis({0., 0., 1.});

      /**
       * The plain quadrature over both disks, in polar coordinates and with
       * equally many points along radius and circumference, as in SSIP Sec.
       * 7.1.1.
       */
      class FullQuadrature
      {
      public:
        FullQuadrature(const PointPotential &potential, const unsigned int n)
          : potential(potential)
        {
          const dealii::QGauss<1> gauss(n);
          for (unsigned int i = 0; i < n; ++i)
            for (unsigned int j = 0; j < n; ++j)
              {
                const double r   = gauss.point(i)[0];
                const double phi = 2. * M_PI * (j + .5) / n;
                sites.push_back({r * std::cos(phi),
                                 r * std::sin(phi),
                                 gauss.weight(i) * r * 2. * M_PI / n});
              }
        }

        Interaction
        operator()(const Place &place) const
        {
          const bool  turned = place.configuration == perpendicular;
          Interaction sum;
          for (const Site &source : sites)
            {
              const double x = place.gap + sum_of_radii + source.x;
              for (const Site &target : sites)
                {
                  const double dx = x - target.x;
                  const double dy = turned ? source.y : source.y - target.y;
                  const double dz = turned ? target.y : 0.;
                  const double inverse = 1. / (dx * dx + dy * dy + dz * dz);
                  const double weight  = source.weight * target.weight;
                  for (const auto &[m, k] : potential)
                    {
                      const double energy =
                        weight * k * integer_power(inverse, m / 2);
                      sum += {energy, m * energy * inverse * dx};
                    }
                }
            }
          return sum;
        }

      private:
        struct Site
        {
          double x, y, weight;
        };

        PointPotential    potential;
        std::vector<Site> sites;
      };



      /** The source at x = gap + 2, the target at the origin. */
      References::EnergyAndForce
      exact_disks(const Place &place, const InversePower &power)
      {
        if (place.configuration == in_plane)
          return References::coplanar_disks(power, equal_sections(), place.gap);
        return References::disks(power,
                                 equal_sections(),
                                 {(place.gap + sum_of_radii) * x_axis, z_axis},
                                 {Tensor<1, 3>(), y_axis},
                                 x_axis,
                                 1e-6);
      }

      std::vector<Method>
      methods(const PointPotential &potential)
      {
        std::vector<Method> result;
        for (const unsigned int n : {16, 32})
          result.push_back({"4D",
                            FullQuadrature(potential, n),
                            std::to_string(n) + "^4 points"});
        for_each_law(potential,
                     equal_sections(),
                     [&](const std::string &name, const auto &law) {
                       if constexpr (std::decay_t<decltype(law)>::depends_on ==
                                     Invariants::gap)
                         result.push_back(
                           {name, [=](const Place &place) {
                              const GapDerivatives f = law(place.gap);
                              return Interaction{f.value, -f.first};
                            }});
                     });
        return result;
      }

      Results
      evaluate()
      {
        Results results;
        for (const std::string &configuration : {in_plane, perpendicular})
          for (const double gap : decades(-3, 2, 2))
            {
              Place       place = {configuration,
                                   "",
                                   gap,
                             configuration == perpendicular ? 90. : 0.};
              ExactPowers powers(
                [&](const InversePower &power) {
                  return exact_disks(place, power);
                },
                place.is_decade());
              for (const NamedPotential &potential : short_range_potentials())
                {
                  place.potential   = potential.name;
                  const Exact exact = powers(potential.powers);
                  results.add_exact(place, exact, reduction);
                  results.add(place,
                              exact,
                              methods(potential.powers),
                              place.is_decade());
                }
            }
        return results;
      }

      Comparison
      compare(const Results &results)
      {
        const auto vdw = [&](const std::string &configuration,
                             const std::string &method) {
          return results.curve(configuration, van_der_waals().name, method);
        };
        Comparison  comparison;
        const Curve small = vdw(in_plane, DiskDisk::name),
                    large = vdw(in_plane, Multipole<1>::name);
        // The printed bounds hold if errors are relative to the law.
        const double small_error = largest_error(small, 0., .1),
                     large_error = largest_error(large, 10., 200.);
        comparison.add({"SSIP, small gaps: largest error, g/R <= 0.1",
                        Comparison::none,
                        small_error});
        comparison.add({"the same relative to the law",
                        .08,
                        small_error / (1. + small_error),
                        Requirement::at_most(.08)});
        comparison.add({"SSIP, large gaps: largest error, g/R >= 10",
                        Comparison::none,
                        large_error});
        comparison.add({"the same relative to the law",
                        .07,
                        large_error / (1. - large_error),
                        Requirement::at_most(.07)});
        comparison.add(
          {"quadrupole: largest error, g/R >= 10",
           Comparison::none,
           largest_error(vdw(in_plane, Multipole<2>::name), 10., 200.),
           Requirement::at_most(.07)});
        for (const auto &[configuration, exponent] :
             {std::pair{in_plane, -2.5}, std::pair{perpendicular, -2.}})
          {
            const Curve exact = vdw(configuration, reduction);
            comparison.add({configuration + ": exponent of the gap, g/R = 1e-3",
                            exponent,
                            slope(exact, 1e-3, 3e-3),
                            Requirement::within(exponent, .03)});
            comparison.add(
              {configuration + ": exponent of the distance, g/R = 100",
               -6.,
               slope(exact, 30., 100., sum_of_radii),
               Requirement::within(-6., .03)});
          }
        for (const double gap : {1e-1, 1e-2, 1e-3})
          comparison.add(
            {"SSIP, perpendicular: energy over the exact one, g/R = " +
               short_text(gap),
             Comparison::none,
             1. +
               nearest(vdw(perpendicular, DiskDisk::name), gap).energy_error});
        return comparison;
      }
    } // namespace
  }   // namespace LawReport
} // namespace Setae



int
main()
{
  using namespace Setae::LawReport;
  return report("disks", evaluate, compare, gap_column);
}
