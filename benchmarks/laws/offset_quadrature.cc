// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors
//
// The force between a section and a straight fiber by integration of the law of
// offset disks along the fiber, with the numbers of the ISSIP paper: what the
// cutoff costs (Fig. 14), the error over the points and their order (Fig. 20)
// and over the gap (Fig. 21).

#include <deal.II/base/quadrature_lib.h>

#include <setae/laws/disk_cylinder.h>
#include <setae/laws/offset_disks.h>
#include <setae/verification/quadrature.h>

#include <fstream>
#include <iostream>

#include "../comparison.h"
#include "curve.h"

namespace Setae
{
  namespace LawReport
  {
    namespace
    {
      const PointPotential potential = {{6, -1e-7}, {12, 5e-25}};
      const SectionPair    sections  = {.02, .02, 1., 1.};
      constexpr double     R         = .02;

      /** The paper's choices: cutoff radius, interval and points per length. */
      constexpr double cutoff = .05, half_interval = .03, density = 3200.;

      const OffsetDisks  issip(potential, sections, {});
      const DiskCylinder infinite_fiber(potential, sections, {});

      double
      force_density(const double offset, const double gap)
      {
        return -issip(offset, gap).g;
      }

      /** The composite rule with @p order Gauss points in each interval. */
      double
      force_by_quadrature(const double       gap,
                          const double       half_length,
                          const unsigned int order,
                          const unsigned int n_points)
      {
        const dealii::QGauss<1> gauss(order);
        const unsigned int      n      = n_points / order;
        const double            length = 2. * half_length / n;
        double                  sum    = 0.;
        for (unsigned int i = 0; i < n; ++i)
          for (unsigned int q = 0; q < order; ++q)
            sum += length * gauss.weight(q) *
                   force_density(length * (i + gauss.point(q)[0]) - half_length,
                                 gap);
        return sum;
      }

      double
      exact_force(const double gap, const double half_length)
      {
        return 2. * References::integrate_peak(
                      [&](const double offset) {
                        return force_density(offset, gap);
                      },
                      0.,
                      half_length,
                      0.,
                      gap,
                      1e-10)
                      .value;
      }

      /** What is left out beyond the cutoff radius, relative. */
      double
      cutoff_error(const double gap, const double radius)
      {
        const double half_length =
          std::sqrt(radius * radius - std::pow(gap + 2. * R, 2));
        return std::abs(
          exact_force(gap, half_length) / -infinite_fiber(gap, 1.).g - 1.);
      }

      double
      quadrature_error(const double       gap,
                       const unsigned int order,
                       const unsigned int n_points)
      {
        return std::abs(
          force_by_quadrature(gap, half_interval, order, n_points) /
            exact_force(gap, half_interval) -
          1.);
      }



      void
      write_csv(const std::string &file_name)
      {
        std::ofstream csv(file_name);
        csv << "figure,line,x,error\n";
        for (const double gap : {4e-4, 8e-4, 1e-3, 1.5e-3, 2e-3})
          for (double c = .0425; c < .0801; c += .0025)
            csv << "cutoff," << gap << ',' << c / R << ','
                << cutoff_error(gap, c) << '\n';
        for (const unsigned int order : {1, 2, 3, 4, 5})
          for (unsigned int n = 800; n <= 12800; n += 200)
            {
              const unsigned int n_points = 2. * half_interval * n;
              csv << "points," << order << ',' << n << ','
                  << quadrature_error(9e-4, order, n_points / order * order)
                  << '\n';
            }
        for (double gap = 8e-4; gap < 1.0005e-3; gap += 2.5e-6)
          csv << "gap,1," << gap << ','
              << quadrature_error(gap, 1, 2. * half_interval * density) << '\n';
      }



      Comparison
      compare()
      {
        Comparison comparison;
        for (const double gap : {8e-4, 9e-4, 1e-3})
          comparison.add(
            {"cutoff 2.5 R: error of the force, gap " + short_text(gap),
             4e-4,
             cutoff_error(gap, cutoff),
             Requirement::at_most(7e-4)});
        comparison.add({"the same, gap 0.002 (published: larger)",
                        Comparison::none,
                        cutoff_error(2e-3, cutoff)});

        const unsigned int n = 2. * half_interval * density;
        comparison.add({"midpoint rule, 3200 points per length, gap 0.0009",
                        3.4e-5,
                        quadrature_error(9e-4, 1, n),
                        Requirement::within(3.4e-5, 5e-7)});
        for (const unsigned int order : {2, 3, 4, 5})
          comparison.add(
            {"the same points in Gauss rules of order " + std::to_string(order),
             Comparison::none,
             quadrature_error(9e-4, order, n)});
        const auto absolute_error = [&](const double gap) {
          return quadrature_error(gap, 1, n) *
                 std::abs(exact_force(gap, half_interval));
        };
        comparison.add({"its absolute error at gap 0.0008 over that at 0.001",
                        Comparison::none,
                        absolute_error(8e-4) / absolute_error(1e-3),
                        Requirement::at_least(1.)});

        const auto time = [&](const double radius) {
          const double half_length =
            std::sqrt(radius * radius - std::pow(9e-4 + 2. * R, 2));
          return timed([&] {
                   return force_by_quadrature(9e-4,
                                              half_length,
                                              1,
                                              2. * half_length * density);
                 })
            .second;
        };
        comparison.add(
          {"CPU time with a cutoff of 4 R over 2.5 R (points: 2.3)",
           Comparison::none,
           time(4. * R) / time(2.5 * R)});
        return comparison;
      }
    } // namespace
  }   // namespace LawReport
} // namespace Setae



int
main()
{
  using namespace Setae::LawReport;
  try
    {
      write_csv("offset_quadrature.csv");
      const Setae::Comparison comparison = compare();
      comparison.print(std::cout);
      return comparison.succeeds() ? 0 : 1;
    }
  catch (const std::exception &error)
    {
      std::cerr << error.what() << std::endl;
      return 1;
    }
}
