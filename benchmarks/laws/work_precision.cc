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
              const double        gap,
              const double        tolerance)
      {
        return References::crossing_cylinders(
          power, equal_sections(), gap, radians(), tolerance);
      }



      /** A straight fiber, long enough for an error of the energy of 1e-4. */
      SolidBody
      solid_cylinder(const Tensor<1, 3> &middle, const Tensor<1, 3> &t)
      {
        constexpr double                 length = 60.;
        const Tensor<1, 3>               half   = .5 * length * t;
        const std::vector<HermiteCell<>> line   = {
            {{{middle - half, t, middle + half, t}}, length}};
        return SolidBody(FiberChart(line, line, 1.),
                         Distribution::volume,
                         MPI_COMM_SELF);
      }

      /** @param n_points Gauss points in each direction of the closest cells. */
      Interaction
      hierarchical(const PointPotential &potential,
                   const double          gap,
                   const unsigned int    n_points)
      {
        SolidBody source =
          solid_cylinder(Tensor<1, 3>({0., 0., gap + sum_of_radii}),
                         Tensor<1, 3>({1., 0., 0.}));
        SolidBody target = solid_cylinder(
          {}, Tensor<1, 3>({std::cos(radians()), std::sin(radians()), 0.}));
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
            const unsigned int n_points)
      {
        const dealii::QGauss<1>                      gauss(n_points);
        std::vector<std::pair<Tensor<1, 3>, double>> result;
        for (const auto &[x, weight] : PeakRule(3, 4).nodes)
          for (unsigned int i = 0; i < n_points; ++i)
            for (unsigned int j = 0; j < n_points; ++j)
              {
                const double s = width * x, r = gauss.point(i)[0];
                const double phi = 2. * M_PI * (j + .5) / n_points;
                const double y   = r * std::cos(phi);
                result.push_back(
                  {Tensor<1, 3>({s * std::cos(turn) - y * std::sin(turn),
                                 s * std::sin(turn) + y * std::cos(turn),
                                 height + r * std::sin(phi)}),
                   width * weight * gauss.weight(i) * r * 2. * M_PI /
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
            const double          gap,
            const unsigned int    n_points)
      {
        const double width =
          peak_width(gap, sum_of_radii) / std::sin(radians());
        const PointLaw law(potential);
        const auto     targets = sites(radians(), 0., width, n_points);
        Interaction    sum;
        for (const auto &[r1, w1] :
             sites(0., gap + sum_of_radii, width, n_points))
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
      methods(const PointPotential &potential)
      {
        std::vector<Method> result;
        for (const unsigned int n : {1, 2, 3, 4})
          result.push_back({hierarchical_integral,
                            [=](const Place &place) {
                              return hierarchical(potential, place.gap, n);
                            },
                            std::to_string(n)});
        for (const unsigned int n : {8, 16, 32})
          result.push_back(
            {plain_integral,
             [=](const Place &place) { return plain(potential, place.gap, n); },
             std::to_string(n)});
        for (const double tolerance : {1e-2, 1e-4, 1e-6, 1e-8})
          result.push_back(
            {reduction,
             [=](const Place &place) {
               return ExactPowers(
                        [&](const InversePower &power) {
                          return reduced(power, place.gap, tolerance);
                        },
                        false)(potential)
                 .value;
             },
             short_text(tolerance)});
        for_each_law(potential,
                     equal_sections(),
                     [&](const std::string &name, const auto &law) {
                       for (const auto &[n_points, range] : {std::pair{1, 2},
                                                             std::pair{1, 4},
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
                                                      sum_of_radii)(law, rule);
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
        for (const NamedPotential &potential :
             {van_der_waals(), lennard_jones()})
          for (const double gap : gaps)
            {
              const Place place = {"crossing cylinders at g/R = " +
                                     short_text(gap),
                                   potential.name,
                                   gap,
                                   angle};
              const Exact exact = ExactPowers(
                [&](const InversePower &power) {
                  return reduced(power, gap, 1e-10);
                },
                false)(potential.powers);
              results.add(place, exact, methods(potential.powers), true);
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
       * energy and force, for van der Waals; infinity if none do.
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
              error(row) <= largest_error)
            result = std::min(result, row.cpu_time);
        return result;
      }

      Comparison
      compare(const Results &results)
      {
        const std::string table = TabulatedDiskCylinder::name;
        Comparison        comparison;
        for (const Row &row : results.all())
          if (row.method == plain_integral && row.resolution == "32" &&
              row.place.potential == van_der_waals().name)
            comparison.add(
              {"g/R = " + short_text(row.place.gap) + ", error " +
                 short_text(error(row)) + ": CPU time of plain 6D over table",
               Comparison::none,
               row.cpu_time /
                 time_for(results, table, row.place.gap, error(row)),
               Requirement::at_least(smallest_ratio)});
        for (const double gap : gaps)
          for (const double error : {1e-1, 1e-2, 1e-3})
            {
              const std::string at = "g/R = " + short_text(gap) + ", error " +
                                     short_text(error) +
                                     ": CPU time of hierarchical 6D over ";
              const double time =
                time_for(results, hierarchical_integral, gap, error);
              for (const std::string &method : {table, reduction})
                comparison.add({at + method,
                                Comparison::none,
                                time / time_for(results, method, gap, error)});
            }
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
