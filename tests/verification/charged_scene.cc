// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

// A scene of charges on the surfaces of two fibers, verified by the full
// quadrature: four-dimensional, against the exact energies of charged surfaces.

#include <gtest/gtest.h>

#include <setae/verification/charged_surfaces.h>
#include <setae/verification/verification.h>

#include <string>

using namespace Setae;

namespace
{
  constexpr double length = 8., gap = .5;

  constexpr SectionPair sections = {1., 1., .7, 2.};

  Verification
  verify_charges(const std::string &second_centerline)
  {
    const std::string fiber =
      "\nset length = 8\nset radius = 1\nset cells = 4\n";
    const Scene scene =
      Scene::read("set coordinates = x, y, z\n"
                  "set verification = full 6D quadrature\n"
                  "subsection full 6D quadrature\nset tolerance = 1e-4\nend\n"
                  "subsection fibers\nset names = first, second\n"
                  "subsection first\nset centerline = s - 4; 0; 0" +
                    fiber +
                    "set surface density = 0.7\nend\n"
                    "subsection second\nset centerline = " +
                    second_centerline + fiber +
                    "set surface density = 2\nend\nend\n"
                    "subsection interactions\nset names = charge\n"
                    "subsection charge\nset law = monopole\n"
                    "set source = first\nset target = second\n"
                    "set exponents = 1\nset prefactors = 1\n"
                    "set distribution = surface\nset integration segments = 8\n"
                    "set integration tolerance = 0\n"
                    "end\nend\n",
                  "charged.prm");
    const FiberSystem fibers(scene, MPI_COMM_SELF);
    State             state;
    state.displacement = fibers.initial;
    state.current      = fibers.initial;
    return verify(fibers, state).at(0);
  }
} // namespace



TEST(ChargedScene, FullQuadratureIsTheEnergyOfParallelSurfaces)
{
  const Verification v     = verify_charges("s - 4; 0; 2.5");
  const double       exact = References::energy_of_parallel_surfaces(
                         {1, 1.}, sections, gap, {length, length}, 1e-7)
                         .value;
  EXPECT_LT(v.full.error, 1e-4);
  EXPECT_NEAR(v.full.value.energy, exact, 1e-4 * exact);
}



TEST(ChargedScene, FullQuadratureAndMonopolesAreThoseOfCrossingSurfaces)
{
  const Verification v  = verify_charges("0; s - 4; 2.5");
  const auto         of = [](const auto &reference) {
    return reference(InversePower{1, 1.},
                     sections,
                     gap,
                     .5 * M_PI,
                     length,
                     length,
                     1e-7)
      .value;
  };
  const double exact     = of(References::energy_of_crossing_surfaces);
  const double monopoles = of(References::energy_of_crossing_monopoles);
  EXPECT_LT(v.full.error, 1e-4);
  EXPECT_NEAR(v.full.value.energy, exact, 1e-4 * exact);
  EXPECT_NEAR(v.without_cutoff.energy, monopoles, 1e-6 * monopoles);
}
