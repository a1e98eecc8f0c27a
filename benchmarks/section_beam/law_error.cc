// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

// The relative errors of energy and force of two crossing or almost parallel
// cylinders by every section-beam law, over gaps, angles, radii and exponents.
// The tabulated law must be right to 0.1% everywhere.

#include <setae/laws/disk_cylinder.h>
#include <setae/laws/section_quadrature.h>
#include <setae/laws/tabulated_disk_cylinder.h>

#include <chrono>
#include <cstdio>

#include "cylinders.h"

using namespace Setae;
using namespace Setae::Cylinders;

namespace
{
  constexpr double degree = M_PI / 180.;

  struct Worst
  {
    double energy = 0., force = 0.;

    void
    see(const EnergyAndForce &actual, const double energy, const double force)
    {
      this->energy =
        std::max(this->energy, std::abs(actual.energy / energy - 1.));
      this->force = std::max(this->force, std::abs(actual.force / force - 1.));
    }

    void
    see(const Worst &other)
    {
      energy = std::max(energy, other.energy);
      force  = std::max(force, other.force);
    }
  };

  struct Laws
  {
    Laws(const unsigned int m, const double R1, const double R2)
      : sections{R1, R2, 1., 1.}
      , disk_cylinder({{m, 1.}}, sections, {})
      , oriented({{m, 1.}}, sections, {})
      , few({{m, 1.}}, sections, {}, {2, 5, 0.})
      , some({{m, 1.}}, sections, {}, {4, 9, 0.})
      , many({{m, 1.}}, sections, {}, {12, 24, 0.})
      , tabulated({{m, 1.}}, sections, {}, {})
    {}

    SectionPair           sections;
    DiskCylinder          disk_cylinder;
    OrientedDiskCylinder  oriented;
    SectionQuadrature     few, some, many;
    TabulatedDiskCylinder tabulated;
  };
} // namespace

int
main()
{
  const char *names[] = {"disk-cylinder",
                         "oriented-disk-cylinder",
                         "section-quadrature 2 x 5",
                         "section-quadrature 4 x 9",
                         "section-quadrature 12 x 24",
                         "tabulated-disk-cylinder"};
  Worst       of_table;

  for (const unsigned int m : {6, 12})
    for (const double ratio : {.1, .3, 1., 3., 10.})
      {
        const auto                  start = std::chrono::steady_clock::now();
        const TabulatedDiskCylinder table({{m, 1.}},
                                          {1., ratio, 1., 1.},
                                          {},
                                          {});
        const std::chrono::duration<double> build =
          std::chrono::steady_clock::now() - start;
        const Laws laws(m, 1., ratio);

        std::printf("m = %u, R2/R1 = %g, table built in %.2f s\n"
                    "largest error of energy / force in %%, by g/R1\n%27s",
                    m,
                    ratio,
                    build.count(),
                    "");
        const double gaps[] = {1e-6, 1e-5, 1e-4, 1e-3, .01, .1, 1., 10.};
        for (const double gap : gaps)
          std::printf("%14g", gap);
        std::printf("\n");

        Worst worst[6][8];
        for (unsigned int g = 0; g < 8; ++g)
          for (const double angle :
               {.1, 1., 5., 15., 30., 45., 60., 75., 85., 89., 90.})
            {
              const double a = angle * degree, radii = 1. + ratio;
              const auto [energy, force] = crossing(m, 1., ratio, gaps[g], a);
              const auto sbip =
                [&](const double gap, const double c, const double) {
                  const GapAngleDerivatives f = laws.disk_cylinder(gap, c);
                  return GapAngleTiltDerivatives{f.value, f.g, f.c};
                };
              worst[0][g].see(crossing_by_law(sbip, radii, gaps[g], a),
                              energy,
                              force);
              worst[1][g].see(crossing_by_law(laws.oriented, radii, gaps[g], a),
                              energy,
                              force);
              worst[5][g].see(
                crossing_by_law(laws.tabulated, radii, gaps[g], a),
                energy,
                force);
              // The quadratures are slow: three angles.
              if (angle != 5. && angle != 45. && angle != 90.)
                continue;
              unsigned int i = 2;
              for (const SectionQuadrature *law :
                   {&laws.few, &laws.some, &laws.many})
                worst[i++][g].see(crossing_by_law(*law, radii, gaps[g], a),
                                  energy,
                                  force);
            }
        for (unsigned int i = 0; i < 6; ++i)
          {
            std::printf("%-27s", names[i]);
            for (unsigned int g = 0; g < 8; ++g)
              std::printf("%7.3f/%6.3f",
                          100. * worst[i][g].energy,
                          100. * worst[i][g].force);
            std::printf("\n");
          }
        for (unsigned int g = 0; g < 8; ++g)
          of_table.see(worst[5][g]);
        std::printf("\n");
      }
  std::printf("tabulated-disk-cylinder: largest error of the energy %.3f%%, of "
              "the force %.3f%%\n",
              100. * of_table.energy,
              100. * of_table.force);
  return of_table.energy < 1e-3 && of_table.force < 1e-3 ? 0 : 1;
}
