// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors
//
// Error against CPU time of everything that computes the energy and the force
// of two crossing cylinders: the integral over both volumes (6D), its reduction
// to one dimension, and the laws with ever more points along the fibers.

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>

#include <setae/verification/cylinders.h>
#include <setae/verification/full_quadrature.h>

#include <limits>

#include "laws.h"
#include "results.h"
#include "straight_fibers.h"

namespace Setae
{
  namespace LawReport
  {
    namespace
    {
      const std::string plain_integral        = "6D plain";
      const std::string hierarchical_integral = "6D hierarchical";
      const std::string reduction             = "1D reduction";

      constexpr double          angle = 45.;
      const std::vector<double> gaps  = {.1, .01};

      /**
       * How many times cheaper the tabulated law must be than 6D as the papers
       * do it.
       */
      constexpr double smallest_ratio = 1e5;

      double
      radians()
      {
        return angle * M_PI / 180.;
      }

      References::EnergyAndForce
      reduced(const InversePower &power,
              const Place        &place,
              const double        tolerance)
      {
        return References::crossing_cylinders(power,
                                              sections_with(place.radius_2),
                                              place.gap,
                                              radians(),
                                              tolerance);
      }



      /** A straight fiber, long enough for an error of the energy of 1e-4. */
      SolidBody
      solid_cylinder(const Tensor<1, 3> &middle,
                     const Tensor<1, 3> &t,
                     const double        radius)
      {
        constexpr double                 length = 60.;
        const Tensor<1, 3>               half   = .5 * length * t;
        const std::vector<HermiteCell<>> line   = {
            {{{middle - half, t, middle + half, t}}, length}};
        return SolidBody(FiberChart(line, line, radius),
                         Distribution::volume,
                         MPI_COMM_SELF);
      }

      /** @param n_points Gauss points in each direction of the closest cells. */
      Interaction
      hierarchical(const PointPotential &potential,
                   const Place          &place,
                   const unsigned int    n_points)
      {
        const double distance = place.gap + 1. + place.radius_2;
        SolidBody    source   = solid_cylinder(Tensor<1, 3>({0., 0., distance}),
                                          Tensor<1, 3>({1., 0., 0.}),
                                          1.);
        SolidBody    target =
          solid_cylinder({},
                         Tensor<1, 3>(
                           {std::cos(radians()), std::sin(radians()), 0.}),
                         place.radius_2);
        FullQuadratureParameters parameters;
        parameters.tolerance    = 1e-15;
        parameters.max_n_points = n_points;
        const FullQuadrature result =
          full_quadrature(source, target, PointLaw(potential), parameters);
        return {result.value.energy, result.value.force[2]};
      }



      /** Points of a cylinder around the x-axis turned by @p turn about z. */
      std::vector<std::pair<Tensor<1, 3>, double>>
      sites(const double       turn,
            const double       height,
            const double       width,
            const double       radius,
            const unsigned int n_points)
      {
        const dealii::QGauss<1>                      gauss(n_points);
        std::vector<std::pair<Tensor<1, 3>, double>> result;
        for (const auto &[x, weight] : PeakRule(3, 4).nodes)
          for (unsigned int i = 0; i < n_points; ++i)
            for (unsigned int j = 0; j < n_points; ++j)
              {
                const double s = width * x, r = radius * gauss.point(i)[0];
                const double phi = 2. * M_PI * (j + .5) / n_points;
                const double y   = r * std::cos(phi);
                result.push_back(
                  {Tensor<1, 3>({s * std::cos(turn) - y * std::sin(turn),
                                 s * std::sin(turn) + y * std::cos(turn),
                                 height + r * std::sin(phi)}),
                   width * weight * radius * gauss.weight(i) * r * 2. * M_PI /
                     n_points});
              }
        return result;
      }

      /**
       * As in SSIP Sec. 7.1.1: polar coordinates, all pairs. @p n_points along
       * radius and circumference, and 24 graded ones along each fiber.
       */
      Interaction
      plain(const PointPotential &potential,
            const Place          &place,
            const unsigned int    n_points)
      {
        const double radii = 1. + place.radius_2;
        const double width = peak_width(place.gap, radii) / std::sin(radians());
        const PointLaw law(potential);
        const auto     targets =
          sites(radians(), 0., width, place.radius_2, n_points);
        Interaction sum;
        for (const auto &[r1, w1] :
             sites(0., place.gap + radii, width, 1., n_points))
          for (const auto &[r2, w2] : targets)
            {
              const Tensor<1, 3> d = r1 - r2;
              const auto         f = law(d.norm_square());
              sum += (w1 * w2) * Interaction{f.value, -f.first_over_r * d[2]};
            }
        return sum;
      }



      /** All methods with the number of their points or their tolerance. */
      std::vector<Method>
      methods(const PointPotential &potential, const double radius_2)
      {
        std::vector<Method> result;
        for (const unsigned int n : {1, 2, 3, 4})
          result.push_back({hierarchical_integral,
                            [=](const Place &place) {
                              return hierarchical(potential, place, n);
                            },
                            std::to_string(n)});
        for (const unsigned int n : {8, 16, 32})
          result.push_back(
            {plain_integral,
             [=](const Place &place) { return plain(potential, place, n); },
             std::to_string(n)});
        for (const double tolerance : {1e-2, 1e-4, 1e-6, 1e-8})
          result.push_back(
            {reduction,
             [=](const Place &place) {
               return ExactPowers(
                        [&](const InversePower &power) {
                          return reduced(power, place, tolerance);
                        },
                        false)(potential)
                 .value;
             },
             short_text(tolerance)});
        for_each_law(potential,
                     sections_with(radius_2),
                     [&](const std::string &name, const auto &law) {
                       for (const auto &[n_points, range] : {std::pair{1, 2},
                                                             std::pair{1, 3},
                                                             std::pair{1, 4},
                                                             std::pair{2, 2},
                                                             std::pair{2, 3},
                                                             std::pair{2, 4},
                                                             std::pair{3, 5},
                                                             std::pair{5, 8}})
                         {
                           const PeakRule rule(n_points, range);
                           result.push_back(
                             {name,
                              [=](const Place &place) {
                                return CrossingFibers(place.gap,
                                                      radians(),
                                                      1. + radius_2)(law, rule);
                              },
                              std::to_string(rule.nodes.size())});
                         }
                     });
        return result;
      }

      Results
      evaluate()
      {
        Results results;
        for (const NamedPotential &potential : short_range_potentials())
          for (const double radius_2 : {1., .3, 3.})
            for (const double gap : gaps)
              {
                // Other radii once only
                if (radius_2 != 1. &&
                    (potential.name != van_der_waals().name || gap != gaps[0]))
                  continue;
                const Place place = {"crossing cylinders: R2/R1 = " +
                                       short_text(radius_2) +
                                       " at g/R = " + short_text(gap),
                                     potential.name,
                                     gap,
                                     angle,
                                     0.,
                                     0.,
                                     radius_2};
                const Exact exact = ExactPowers(
                  [&](const InversePower &power) {
                    return reduced(power, place, 1e-10);
                  },
                  false)(potential.powers);
                results.add(place,
                            exact,
                            methods(potential.powers, radius_2),
                            true);
              }
        return results;
      }

      double
      error(const Row &row)
      {
        return std::max(std::abs(row.energy_error), std::abs(row.force_error));
      }

      /**
       * The CPU time of a method with the fewest points that reach an error of
       * energy and force, for van der Waals and equal radii; infinity if none
       * do.
       */
      double
      time_for(const Results     &results,
               const std::string &method,
               const double       gap,
               const double       largest_error)
      {
        double result = std::numeric_limits<double>::infinity();
        for (const Row &row : results.all())
          if (row.method == method && row.place.gap == gap &&
              row.place.potential == van_der_waals().name &&
              row.place.radius_2 == 1. && error(row) <= largest_error)
            result = std::min(result, row.cpu_time);
        return result;
      }

      Comparison
      compare(const Results &results)
      {
        const std::string table = TabulatedDiskCylinder::name;
        Comparison        comparison;
        const auto        over = [&](const std::string &method,
                              const std::string &cheaper,
                              const double       gap,
                              const double       error,
                              const Requirement &requirement) {
          comparison.add({"g/R = " + short_text(gap) + ", error " +
                            short_text(error) + ": CPU time of " + method +
                            " over " + cheaper,
                          Comparison::none,
                          time_for(results, method, gap, error) /
                            time_for(results, cheaper, gap, error),
                          requirement});
        };

        // Both at the error that the plain quadrature reaches
        for (const Row &row : results.all())
          if (row.method == plain_integral && row.resolution == "32" &&
              row.place.potential == van_der_waals().name &&
              row.place.radius_2 == 1.)
            {
              over(plain_integral,
                   table,
                   row.place.gap,
                   error(row),
                   Requirement::at_least(smallest_ratio));
              over(hierarchical_integral, table, row.place.gap, error(row), {});
            }
        for (const double gap : gaps)
          for (const double error : {1e-2, 1e-3})
            for (const std::string &cheaper : {table, reduction})
              over(hierarchical_integral, cheaper, gap, error, {});
        return comparison;
      }

      std::string
      column(const Place & /*place*/)
      {
        return "error";
      }
    } // namespace
  }   // namespace LawReport
} // namespace Setae



int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  using namespace Setae::LawReport;
  return report("work_precision", evaluate, compare, column);
}
