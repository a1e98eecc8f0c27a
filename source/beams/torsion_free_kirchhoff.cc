// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <deal.II/base/quadrature_lib.h>

#include <setae/beams/torsion_free_kirchhoff.h>

namespace Setae
{
  namespace
  {
    // The axial strain is interpolated from its values here.
    constexpr std::array<double, 3> strain_positions = {{0., 0.5, 1.}};

    std::array<double, 3>
    parabolas(const double x)
    {
      return {{(1. - x) * (1. - 2. * x), 4. * x * (1. - x), x * (2. * x - 1.)}};
    }

    // From d2 - d1, t1, t2 back to the coefficients of a cell.
    constexpr std::array<unsigned int, Hermite::n_shapes> reduced_index = {
      {0, 1, 0, 2}};
    constexpr std::array<double, Hermite::n_shapes> reduced_sign = {
      {-1., 1., 1., 1.}};

    std::array<double, 3>
    reduce_shapes(const std::array<double, Hermite::n_shapes> &shape)
    {
      return {{shape[2], shape[1], shape[3]}};
    }



    /**
     * The Hessian of c/2 |k - k_0|^2 in a and b, with k = a x b / A, A = |a|^2
     * and the moment m = c (k - k_0). From
     *   dk = (da x b + a x db) / A - 2 (a . da) k / A
     * the part c dk . dk of Gauss and Newton and the part m . d2k together,
     * products of vectors multiplied out.
     */
    struct BendingHessian
    {
      BendingHessian(const Tensor<1, 3> &a,
                     const Tensor<1, 3> &b,
                     const double        A,
                     const Tensor<1, 3> &k,
                     const Tensor<1, 3> &m,
                     const double        c)
      {
        const double A2 = A * A, mk = m * k;

        const Tensor<1, 3> q = (-2. / A2) * cross_product_3d(b, c * k + m);
        aa = outer_product(q + ((4. * c * (k * k) + 8. * mk) / A2) * a, a) +
             outer_product(a, q) - outer_product((c / A2) * b, b);

        const double ab_product = c * (a * b) / A2;
        ab                      = outer_product(a,
                           (2. * ab_product / A) * a - (c / A2) * b -
                             (2. / A2) * cross_product_3d(m, a));

        bb = outer_product((-c / A2) * a, a);

        for (unsigned int i = 0; i < 3; ++i)
          {
            aa[i][i] += c * (b * b) / A2 - 2. * mk / A;
            ab[i][i] -= ab_product;
            bb[i][i] += c / A;

            // - da . (m x db) / A
            const unsigned int j = (i + 1) % 3, l = (i + 2) % 3;
            ab[i][j] += m[l] / A;
            ab[i][l] -= m[j] / A;
          }
      }

      Tensor<2, 3> aa, ab, bb;
    };
  } // namespace



  TorsionFreeKirchhoff::Site::Site(const HermiteCell<> &reference,
                                   const double         x)
    : first(reduce_shapes(Hermite::shape_derivatives(x, reference.h)))
    , second(reduce_shapes(Hermite::shape_second_derivatives(x, reference.h)))
    , first_0(combine(first, reduce(reference)))
    , second_0(combine(second, reduce(reference)))
    , J(first_0.norm())
  {
    AssertThrow(J > 0. && std::isfinite(J), ExcDegenerateReference());
  }



  TorsionFreeKirchhoff::GaussSite::GaussSite(const HermiteCell<> &reference,
                                             const double         x,
                                             const double         stiffness)
    : Site(reference, x)
    , curvature_0(curvature(*this, Shape<Tensor<1, 3>>()).value)
    , stiffness(stiffness / J)
  {}



  std::string
  TorsionFreeKirchhoff::description()
  {
    return "shear-rigid fiber with axial strain and isotropic bending, without "
           "torsion; initially straight, or plane and staying in its plane";
  }



  TorsionFreeKirchhoff::TorsionFreeKirchhoff(const HermiteCell<>    &reference,
                                             const SectionStiffness &stiffness,
                                             const unsigned int n_gauss_points)
    : reference(reference)
    , stiffness(stiffness)
    , strain_sites{{{reference, strain_positions[0]},
                    {reference, strain_positions[1]},
                    {reference, strain_positions[2]}}}
  {
    AssertThrow(stiffness.axial >= 0. && std::isfinite(stiffness.axial) &&
                  stiffness.bending >= 0. && std::isfinite(stiffness.bending),
                ExcInvalidStiffness());
    Assert(n_gauss_points >= 2, dealii::ExcLowerRange(n_gauss_points, 2));

    // Exact where J is a polynomial of degree 5 or less: on straight cells J is
    // constant or, with a graded parametrization, quadratic.
    const dealii::QGauss<1> rule(5);
    for (unsigned int q = 0; q < rule.size(); ++q)
      {
        const double x = rule.point(q)[0];
        const auto   L = parabolas(x);
        const double weight =
          stiffness.axial * rule.weight(q) * Site(reference, x).J;
        for (unsigned int i = 0; i < 3; ++i)
          for (unsigned int k = 0; k < 3; ++k)
            strain_energy_matrix[i][k] += weight * L[i] * L[k];
      }

    const dealii::QGauss<1> gauss(n_gauss_points);
    gauss_sites.reserve(n_gauss_points);
    for (unsigned int q = 0; q < n_gauss_points; ++q)
      gauss_sites.emplace_back(reference,
                               gauss.point(q)[0],
                               stiffness.bending * gauss.weight(q));
  }



  void
  TorsionFreeKirchhoff::add(const HermiteCell<> &displacement,
                            const Request        request,
                            LocalSystem<12>     &local) const
  {
    const Shape<Tensor<1, 3>> u = reduce_displacement(displacement);
    ReducedSystem             system;

    // If one of them throws, local has not been touched.
    const double membrane_energy = add_membrane(u, request, system);
    const double bending_energy  = add_bending(u, request, system);

    local.energy += membrane_energy + bending_energy;

    if (request >= Request::residual)
      for (unsigned int a = 0; a < Hermite::n_shapes; ++a)
        for (unsigned int c = 0; c < 3; ++c)
          local.residual[3 * a + c] +=
            reduced_sign[a] * system.gradient[reduced_index[a]][c];

    if (request >= Request::tangent)
      for (unsigned int a = 0; a < Hermite::n_shapes; ++a)
        for (unsigned int b = 0; b < Hermite::n_shapes; ++b)
          {
            const unsigned int p = reduced_index[a], q = reduced_index[b];
            const double       sign = reduced_sign[a] * reduced_sign[b];
            for (unsigned int c = 0; c < 3; ++c)
              for (unsigned int d = 0; d < 3; ++d)
                local.tangent[3 * a + c][3 * b + d] +=
                  sign * (3 * p + c <= 3 * q + d ? system.hessian[p][q][c][d] :
                                                   system.hessian[q][p][d][c]);
          }
  }



  // d eps = t . du_x / J  and  d2 eps = du_x . (I - t t^T) du_x / (|r_x| J)
  double
  TorsionFreeKirchhoff::add_membrane(const Shape<Tensor<1, 3>> &displacement,
                                     const Request              request,
                                     ReducedSystem             &system) const
  {
    std::array<AxialStrain<double>, 3> axial;
    Tensor<1, 3>                       strain;
    for (unsigned int i = 0; i < 3; ++i)
      {
        axial[i]  = axial_strain(strain_sites[i], displacement);
        strain[i] = axial[i].value;
      }
    const Tensor<1, 3> force  = strain_energy_matrix * strain;
    const double       energy = 0.5 * (force * strain);
    if (request == Request::energy)
      return energy;

    std::array<Shape<Tensor<1, 3>>, 3> derivative; // of each strain
    for (unsigned int i = 0; i < 3; ++i)
      {
        const Tensor<1, 3> g =
          axial[i].derivative / (axial[i].length * strain_sites[i].J);
        for (unsigned int p = 0; p < n_shapes; ++p)
          {
            derivative[i][p] = strain_sites[i].first[p] * g;
            system.gradient[p] += force[i] * derivative[i][p];
          }
      }
    if (request == Request::residual)
      return energy;

    for (unsigned int i = 0; i < 3; ++i)
      {
        const Shape<double> &shape = strain_sites[i].first;
        const Tensor<1, 3>   t     = axial[i].derivative / axial[i].length;
        const double         geometric =
          force[i] / (axial[i].length * strain_sites[i].J);
        for (unsigned int q = 0; q < n_shapes; ++q)
          {
            Tensor<1, 3> v = (-geometric * shape[q]) * t;
            for (unsigned int k = 0; k < 3; ++k)
              v += (strain_energy_matrix[i][k] / strain_sites[i].J) *
                   derivative[k][q];
            Tensor<2, 3> column = outer_product(t, v);
            for (unsigned int c = 0; c < 3; ++c)
              column[c][c] += geometric * shape[q];
            for (unsigned int p = 0; p <= q; ++p)
              system.hessian[p][q] += shape[p] * column;
          }
      }
    return energy;
  }



  double
  TorsionFreeKirchhoff::add_bending(const Shape<Tensor<1, 3>> &displacement,
                                    const Request              request,
                                    ReducedSystem             &system) const
  {
    double energy = 0.;
    for (const GaussSite &site : gauss_sites)
      {
        const Curvature<double> k      = curvature(site, displacement);
        const Tensor<1, 3>      change = k.value - site.curvature_0;
        const Tensor<1, 3>      moment = site.stiffness * change;
        energy += 0.5 * (moment * change);
        if (request == Request::energy)
          continue;

        const Tensor<1, 3> gradient_a =
          (cross_product_3d(k.b, moment) - 2. * (moment * k.value) * k.a) /
          k.square;
        const Tensor<1, 3> gradient_b =
          cross_product_3d(moment, k.a) / k.square;
        for (unsigned int p = 0; p < n_shapes; ++p)
          system.gradient[p] +=
            site.first[p] * gradient_a + site.second[p] * gradient_b;
        if (request == Request::residual)
          continue;

        const BendingHessian H(
          k.a, k.b, k.square, k.value, moment, site.stiffness);
        const Tensor<2, 3> ba = transpose(H.ab);
        for (unsigned int q = 0; q < n_shapes; ++q)
          {
            const Tensor<2, 3> column_a =
              site.first[q] * H.aa + site.second[q] * H.ab;
            const Tensor<2, 3> column_b =
              site.first[q] * ba + site.second[q] * H.bb;
            for (unsigned int p = 0; p <= q; ++p)
              system.hessian[p][q] +=
                site.first[p] * column_a + site.second[p] * column_b;
          }
      }
    return energy;
  }



  SectionForces
  TorsionFreeKirchhoff::section_forces(const HermiteCell<> &displacement,
                                       const double         x) const
  {
    const Shape<Tensor<1, 3>>   u      = reduce_displacement(displacement);
    const std::array<double, 3> L      = parabolas(x);
    double                      strain = 0.;
    for (unsigned int i = 0; i < 3; ++i)
      strain += L[i] * axial_strain(strain_sites[i], u).value;

    const GaussSite    site(reference, x, stiffness.bending);
    const Tensor<1, 3> change = curvature(site, u).value - site.curvature_0;
    return {stiffness.axial * strain, site.stiffness * change};
  }
} // namespace Setae
