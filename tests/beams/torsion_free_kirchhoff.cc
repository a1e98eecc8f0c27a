// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/lapack_full_matrix.h>
#include <deal.II/lac/vector.h>

#include <deal.II/physics/transformations.h>

#include <gtest/gtest.h>

#include <setae/beams/torsion_free_kirchhoff.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "../nested_sacado.h"

using namespace Setae;

namespace
{
  constexpr double epsilon = std::numeric_limits<double>::epsilon();

  // A cell of length one bends with EI = 1.
  SectionStiffness
  stiffness_of(const double slenderness)
  {
    return {4. * slenderness * slenderness, 1.};
  }

  // The Hermite interpolant of an arc along the x-axis; straight if angle = 0.
  HermiteCell<>
  arc(const double angle, const double length, const double h = 1.)
  {
    const double chord =
      angle == 0. ? length : 2. * length / angle * std::sin(angle / 2.);

    HermiteCell<> cell;
    cell.h               = h;
    cell.coefficients[1] = Tensor<1, 3>({length / h, 0., 0.});
    cell.coefficients[2] =
      chord * Tensor<1, 3>({std::cos(angle / 2.), std::sin(angle / 2.), 0.});
    cell.coefficients[3] =
      length / h * Tensor<1, 3>({std::cos(angle), std::sin(angle), 0.});
    return cell;
  }

  HermiteCell<>
  straight_cell()
  {
    return arc(0., 1.);
  }

  HermiteCell<>
  operator-(HermiteCell<> a, const HermiteCell<> &b)
  {
    for (unsigned int i = 0; i < 4; ++i)
      a.coefficients[i] -= b.coefficients[i];
    return a;
  }

  Tensor<1, 3>
  random_vector(std::mt19937 &random)
  {
    std::uniform_real_distribution<double> number(-1., 1.);
    return Tensor<1, 3>({number(random), number(random), number(random)});
  }

  Tensor<2, 3>
  random_rotation(std::mt19937 &random)
  {
    const Tensor<1, 3> axis = random_vector(random);
    return dealii::Physics::Transformations::Rotations::rotation_matrix_3d(
      Tensor<1, 3>(axis / axis.norm()), 3. * random_vector(random)[0]);
  }

  HermiteCell<>
  perturb(HermiteCell<> cell, const double size, std::mt19937 &random)
  {
    for (Tensor<1, 3> &coefficient : cell.coefficients)
      coefficient += size * random_vector(random);
    return cell;
  }

  HermiteCell<>
  move(HermiteCell<>       cell,
       const Tensor<2, 3> &rotation,
       const Tensor<1, 3> &translation = {})
  {
    for (Tensor<1, 3> &coefficient : cell.coefficients)
      coefficient = rotation * coefficient;
    cell.coefficients[0] += translation;
    cell.coefficients[2] += translation;
    return cell;
  }

  LocalSystem<12>
  evaluate(const TorsionFreeKirchhoff &beam,
           const HermiteCell<>        &displacement,
           const Request               request = Request::tangent)
  {
    LocalSystem<12> local;
    beam.add(displacement, request, local);
    return local;
  }

  LocalSystem<12>
  evaluate_with_sacado(const TorsionFreeKirchhoff &beam,
                       const HermiteCell<>        &displacement)
  {
    HermiteCell<NestedFad<12>> u;
    u.h = displacement.h;
    for (unsigned int i = 0; i < 12; ++i)
      u.coefficients[i / 3][i % 3] =
        variable<12>(i, displacement.coefficients[i / 3][i % 3]);
    return local_system<12>(beam.energy(u));
  }

  double
  largest(const std::array<double, 12> &values)
  {
    double result = 0.;
    for (const double value : values)
      result = std::max(result, std::abs(value));
    return result;
  }

  // Differences relative to the largest entry; membrane and bending are tested
  // one by one, too, so that neither hides behind the other.
  void
  expect_equal(const LocalSystem<12> &a, const LocalSystem<12> &b)
  {
    constexpr double tolerance = 1e-12;
    EXPECT_NEAR(a.energy, b.energy, tolerance * std::abs(b.energy));

    double largest_entry = 0.;
    for (const auto &row : b.tangent)
      largest_entry = std::max(largest_entry, largest(row));
    for (unsigned int i = 0; i < 12; ++i)
      {
        EXPECT_NEAR(a.residual[i],
                    b.residual[i],
                    tolerance * largest(b.residual));
        for (unsigned int j = 0; j < 12; ++j)
          {
            EXPECT_NEAR(a.tangent[i][j],
                        b.tangent[i][j],
                        tolerance * largest_entry);
            EXPECT_EQ(a.tangent[i][j], a.tangent[j][i]);
          }
      }
  }
} // namespace



TEST(TorsionFreeKirchhoff, ResidualAndTangentAreDerivativesOfTheEnergy)
{
  std::mt19937 random(1);
  for (const double initial_angle : {0., 0.8})
    for (const double slenderness : {10., 100., 1e4})
      for (const auto &part : {SectionStiffness{1., 0.}, {0., 1.}, {1., 1.}})
        for (const double angle : {0., 0.3, 2.5})
          for (const double stretch : {0.5, 1., 2.})
            {
              const HermiteCell<> reference =
                move(perturb(arc(initial_angle, 1.), 0.02, random),
                     random_rotation(random));
              const HermiteCell<> current =
                move(perturb(arc(angle, stretch), 0.1, random),
                     random_rotation(random),
                     random_vector(random));
              const HermiteCell<> u = current - reference;

              SectionStiffness stiffness = stiffness_of(slenderness);
              stiffness.axial *= part.axial;
              stiffness.bending *= part.bending;
              const TorsionFreeKirchhoff beam(reference, stiffness);
              expect_equal(evaluate(beam, u), evaluate_with_sacado(beam, u));
            }
}



TEST(TorsionFreeKirchhoff, DeliversWhatIsRequestedAndAddsIt)
{
  std::mt19937               random(2);
  const TorsionFreeKirchhoff beam(straight_cell(), stiffness_of(10.));
  const HermiteCell<>        u = perturb({}, 0.3, random);

  LocalSystem<12> local = evaluate(beam, u);
  EXPECT_EQ(evaluate(beam, u, Request::energy).energy, local.energy);
  EXPECT_EQ(evaluate(beam, u, Request::energy).residual,
            LocalSystem<12>().residual);
  EXPECT_EQ(evaluate(beam, u, Request::residual).residual, local.residual);
  EXPECT_EQ(evaluate(beam, u, Request::residual).tangent,
            LocalSystem<12>().tangent);

  const LocalSystem<12> once = local;
  beam.add(u, Request::tangent, local);
  EXPECT_EQ(local.energy, 2. * once.energy);
  for (unsigned int i = 0; i < 12; ++i)
    EXPECT_EQ(local.residual[i], 2. * once.residual[i]);
  for (unsigned int i = 0; i < 144; ++i)
    EXPECT_EQ(local.tangent[i / 12][i % 12], 2. * once.tangent[i / 12][i % 12]);
}



TEST(TorsionFreeKirchhoff, RigidMotionsCauseNoStrain)
{
  std::mt19937 random(3);
  for (unsigned int i = 0; i < 50; ++i)
    {
      const HermiteCell<> reference =
        move(straight_cell(), random_rotation(random));
      const Tensor<1, 3>  translation = 10. * random_vector(random);
      const HermiteCell<> u =
        move(reference, random_rotation(random), translation) - reference;
      const TorsionFreeKirchhoff beam(reference, stiffness_of(1e4));

      // The displacement itself has round-off in proportion to its size.
      const double tolerance = 8. * epsilon * (1. + translation.norm());
      for (const double x : {0., 0.3, 1.})
        {
          const SectionForces forces = beam.section_forces(u, x);
          EXPECT_LT(std::abs(forces.axial_force),
                    stiffness_of(1e4).axial * tolerance);
          EXPECT_LT(forces.bending_moment.norm(), 12. * tolerance);
        }
    }
}



TEST(TorsionFreeKirchhoff, TranslationsAreExactlyNeutral)
{
  std::mt19937               random(4);
  const TorsionFreeKirchhoff beam(straight_cell(), stiffness_of(1e4));

  HermiteCell<> u;
  u.coefficients[0] = u.coefficients[2] = 1e6 * random_vector(random);
  EXPECT_EQ(evaluate(beam, u).energy, 0.);
  EXPECT_EQ(largest(evaluate(beam, u).residual), 0.);

  const LocalSystem<12> bent = evaluate(beam, perturb({}, 0.3, random));
  for (unsigned int c = 0; c < 3; ++c)
    {
      EXPECT_EQ(bent.residual[c] + bent.residual[6 + c], 0.);
      for (unsigned int j = 0; j < 12; ++j)
        EXPECT_EQ(bent.tangent[c][j] + bent.tangent[6 + c][j], 0.);
    }
}



TEST(TorsionFreeKirchhoff, EnergyAndForcesMoveWithTheCell)
{
  std::mt19937 random(5);
  for (const double slenderness : {10., 1e4})
    for (unsigned int i = 0; i < 20; ++i)
      {
        const TorsionFreeKirchhoff beam(straight_cell(),
                                        stiffness_of(slenderness));
        const HermiteCell<>        current = perturb(arc(1., 1.2), 0.1, random);
        const Tensor<2, 3>         rotation = random_rotation(random);
        const HermiteCell<>        moved =
          move(current, rotation, random_vector(random));

        const LocalSystem<12> before =
          evaluate(beam, current - straight_cell());
        const LocalSystem<12> after = evaluate(beam, moved - straight_cell());
        EXPECT_NEAR(after.energy, before.energy, 1e-13 * before.energy);
        for (unsigned int a = 0; a < 4; ++a)
          {
            Tensor<1, 3> f_before, f_after;
            for (unsigned int c = 0; c < 3; ++c)
              {
                f_before[c] = before.residual[3 * a + c];
                f_after[c]  = after.residual[3 * a + c];
              }
            EXPECT_LT((f_after - rotation * f_before).norm(),
                      1e-13 * largest(before.residual));
          }
      }
}



TEST(TorsionFreeKirchhoff, InitialCurvatureIsObjectiveInItsPlaneOnly)
{
  const HermiteCell<>        reference = arc(0.8, 1.);
  const TorsionFreeKirchhoff beam(reference, stiffness_of(100.));
  const auto energy_of_half_turn = [&](const Tensor<1, 3> &axis) {
    const Tensor<2, 3> rotation =
      dealii::Physics::Transformations::Rotations::rotation_matrix_3d(axis,
                                                                      M_PI);
    return evaluate(beam, move(reference, rotation) - reference).energy;
  };

  EXPECT_EQ(evaluate(beam, {}).energy, 0.);
  EXPECT_EQ(largest(evaluate(beam, {}).residual), 0.);
  EXPECT_LT(energy_of_half_turn(Tensor<1, 3>({0., 0., 1.})), 1e-24);
  // As documented: half a turn about an axis in the plane inverts kappa_0.
  EXPECT_NEAR(energy_of_half_turn(Tensor<1, 3>({1., 0., 0.})),
              0.5 * 1.6 * 1.6,
              0.01);
}



TEST(TorsionFreeKirchhoff, PureStretchIsExact)
{
  const SectionStiffness     stiffness = stiffness_of(100.);
  const TorsionFreeKirchhoff beam(straight_cell(), stiffness);
  for (const double strain : {-0.5, -1e-12, 1e-15, 1e-12, 1e-3, 1.})
    {
      HermiteCell<> u;
      u.coefficients[1][0] = u.coefficients[2][0] = u.coefficients[3][0] =
        strain;
      const double exact = 0.5 * stiffness.axial * strain * strain;
      EXPECT_NEAR(evaluate(beam, u).energy, exact, 1e-14 * exact);
      const SectionForces forces = beam.section_forces(u, 0.3);
      EXPECT_NEAR(forces.axial_force,
                  stiffness.axial * strain,
                  1e-14 * stiffness.axial * std::abs(strain));
      EXPECT_EQ(forces.bending_moment.norm(), 0.);
    }
}



TEST(TorsionFreeKirchhoff, EnergyOfAnArcConverges)
{
  // A straight fiber of length 1, bent by 2 rad.
  const auto energy = [](const unsigned int      n_cells,
                         const SectionStiffness &stiffness) {
    const double               h         = 1. / n_cells;
    const HermiteCell<>        reference = arc(0., h, h);
    const TorsionFreeKirchhoff beam(reference, stiffness);
    return n_cells * evaluate(beam, arc(2. * h, h, h) - reference).energy;
  };

  const auto bending_error = [&](const unsigned int n_cells) {
    return std::abs(energy(n_cells, {0., 1.}) - 0.5 * 2. * 2.);
  };
  EXPECT_NEAR(std::log2(bending_error(8) / bending_error(16)), 4., 0.05);
  EXPECT_NEAR(std::log2(bending_error(16) / bending_error(32)), 4., 0.05);

  const SectionStiffness membrane = {1., 0.};
  EXPECT_NEAR(std::log2(energy(4, membrane) / energy(8, membrane)), 8., 0.1);
  EXPECT_NEAR(std::log2(energy(8, membrane) / energy(16, membrane)), 8., 0.1);
}



TEST(TorsionFreeKirchhoff, MomentOfAnArcIsProportionalToItsCurvature)
{
  // Cubic curves have their best curvature at the two Gauss points.
  const double x = 0.5 - 0.5 / std::sqrt(3.);
  for (const double initial_angle : {0., 0.1})
    {
      const HermiteCell<>        reference = arc(initial_angle, 1.);
      const TorsionFreeKirchhoff beam(reference, {100., 3.});
      const SectionForces        forces =
        beam.section_forces(arc(-0.2, 1.) - reference, x);
      EXPECT_NEAR(forces.bending_moment[0], 0., 1e-15);
      EXPECT_NEAR(forces.bending_moment[1], 0., 1e-15);
      EXPECT_NEAR(forces.bending_moment[2], 3. * (-0.2 - initial_angle), 1e-4);
    }
}



// In the plane, 8 degrees of freedom are 3 rigid motions, 3 axial strains and 2
// that bend the cell without strain, also if the cell is curved. With the axial
// strain at each of 4 Gauss points it would be 4 and 1, too few to bend freely.
TEST(TorsionFreeKirchhoff, CurvedCellKeepsTwoModesOfPureBending)
{
  const auto eigenvalues = [](const SectionStiffness &stiffness) {
    const TorsionFreeKirchhoff       beam(arc(0.8, 1.), stiffness);
    const LocalSystem<12>            local = evaluate(beam, {});
    dealii::LAPACKFullMatrix<double> in_plane(8);
    for (unsigned int i = 0; i < 8; ++i)
      for (unsigned int j = 0; j < 8; ++j)
        in_plane(i, j) = local.tangent[i / 2 * 3 + i % 2][j / 2 * 3 + j % 2];

    dealii::FullMatrix<double> vectors;
    dealii::Vector<double>     values;
    in_plane.compute_eigenvalues_symmetric(
      -1., 100. * (stiffness.axial + stiffness.bending), 0., values, vectors);
    return values;
  };

  const auto soft = eigenvalues({4e4, 1.}), stiff = eigenvalues({4e8, 1.});
  ASSERT_EQ(soft.size(), 8);
  ASSERT_EQ(stiff.size(), 8);
  for (unsigned int i = 0; i < 3; ++i)
    EXPECT_NEAR(stiff[i], 0., 4e8 * 10. * epsilon);
  for (unsigned int i = 3; i < 5; ++i)
    {
      EXPECT_GT(stiff[i], 0.1);
      EXPECT_NEAR(soft[i], stiff[i], 1e-2 * stiff[i]);
    }
  for (unsigned int i = 5; i < 8; ++i)
    EXPECT_NEAR(stiff[i], 1e4 * soft[i], 1e-2 * stiff[i]);
}



TEST(TorsionFreeKirchhoff, CollapsedCellsAreReported)
{
  const TorsionFreeKirchhoff beam(straight_cell(), stiffness_of(100.));
  const auto                 expect_report = [&](const HermiteCell<> &u) {
    EXPECT_THROW(evaluate(beam, u, Request::energy),
                 TorsionFreeKirchhoff::ExcCollapsedCell);
    EXPECT_THROW(evaluate(beam, u), TorsionFreeKirchhoff::ExcCollapsedCell);
    EXPECT_THROW(beam.energy(u), TorsionFreeKirchhoff::ExcCollapsedCell);
    EXPECT_THROW(beam.section_forces(u, 0.),
                 TorsionFreeKirchhoff::ExcCollapsedCell);
  };

  expect_report(HermiteCell<>() - straight_cell());

  HermiteCell<> u;
  u.coefficients[1][0] = -1.;
  expect_report(u);
  u.coefficients[1][0] = -1. + 1e-14;
  expect_report(u);
  u.coefficients[1][0] = std::numeric_limits<double>::quiet_NaN();
  expect_report(u);
  u.coefficients[1][0] = std::numeric_limits<double>::infinity();
  expect_report(u);

  u.coefficients[1][0] = -1. + 1e-6;
  EXPECT_TRUE(std::isfinite(evaluate(beam, u).energy));
}



TEST(TorsionFreeKirchhoff, BadInputIsReported)
{
  EXPECT_THROW(TorsionFreeKirchhoff(HermiteCell<>(), stiffness_of(100.)),
               TorsionFreeKirchhoff::ExcDegenerateReference);
  EXPECT_THROW(TorsionFreeKirchhoff(straight_cell(), {-1., 1.}),
               TorsionFreeKirchhoff::ExcInvalidStiffness);
}
