// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_tests_beams_cantilever_h
#define setae_tests_beams_cantilever_h

#include <deal.II/lac/lapack_full_matrix.h>
#include <deal.II/lac/vector.h>

#include <setae/beams/torsion_free_kirchhoff.h>

#include <algorithm>

namespace Setae::Test
{
  /** What acts on the free end of a cantilever; both keep their direction. */
  struct TipLoad
  {
    Tensor<1, 3> force;  // [force]
    Tensor<1, 3> moment; // [force length]
  };



  /**
   * A straight fiber along the x-axis, without a mesh: clamped at the origin,
   * loaded at the other end, solved by Newton's method with a dense matrix. The
   * clamp holds the position and the direction of the tangent, not the stretch.
   */
  class Cantilever
  {
  public:
    Cantilever(const unsigned int      n_cells,
               const double            length,
               const SectionStiffness &stiffness,
               const unsigned int      n_gauss_points = 4)
      : n_cells(n_cells)
      , h(length / n_cells)
      , beam(reference(0), stiffness, n_gauss_points)
      , u(6 * (n_cells + 1))
    {}

    /**
     * Find the equilibrium nearest to the last one. Returns the number of
     * Newton steps; throws if they do not converge.
     */
    unsigned int
    solve(const TipLoad &load)
    {
      for (unsigned int step = 1; step <= 100; ++step)
        {
          assemble(load);
          matrix.compute_lu_factorization();
          matrix.solve(residual);
          u -= residual;
          if (residual.linfty_norm() < 1e-9 * h)
            return step;
        }
      AssertThrow(false, dealii::ExcMessage("Newton's method fails."));
      return 0;
    }

    /** Position at the arc length @p s of the initial fiber. */
    Tensor<1, 3>
    position(const double s) const
    {
      const unsigned int cell =
        std::min(static_cast<unsigned int>(s / h), n_cells - 1);
      const double x = s / h - cell;
      return reference(cell).position(x) + displacement(cell).position(x);
    }

  private:
    HermiteCell<>
    reference(const unsigned int cell) const
    {
      HermiteCell<> result;
      result.h                  = h;
      result.coefficients[0][0] = cell * h;
      result.coefficients[1][0] = 1.;
      result.coefficients[2][0] = (cell + 1) * h;
      result.coefficients[3][0] = 1.;
      return result;
    }

    HermiteCell<>
    displacement(const unsigned int cell) const
    {
      HermiteCell<> result;
      result.h = h;
      for (unsigned int i = 0; i < 12; ++i)
        result.coefficients[i / 3][i % 3] = u[6 * cell + i];
      return result;
    }

    void
    assemble(const TipLoad &load)
    {
      matrix.reinit(u.size());
      residual.reinit(u.size());
      for (unsigned int cell = 0; cell < n_cells; ++cell)
        {
          LocalSystem<12> local;
          beam.add(displacement(cell), Request::tangent, local);
          for (unsigned int i = 0; i < 12; ++i)
            {
              residual[6 * cell + i] += local.residual[i];
              for (unsigned int j = 0; j < 12; ++j)
                matrix(6 * cell + i, 6 * cell + j) += local.tangent[i][j];
            }
        }
      add_tip_load(load);

      for (const unsigned int i : {0, 1, 2, 4, 5})
        {
          residual[i] = 0.;
          for (unsigned int j = 0; j < u.size(); ++j)
            matrix(i, j) = matrix(j, i) = (i == j ? 1. : 0.);
        }
    }

    // A moment M does the work M . (t x dt) = dr' . (M x r') / |r'|^2.
    void
    add_tip_load(const TipLoad &load)
    {
      const unsigned int d = u.size() - 6, t = u.size() - 3;
      Tensor<1, 3>       a({1., 0., 0.});
      for (unsigned int c = 0; c < 3; ++c)
        a[c] += u[t + c];
      const double       A     = a.norm_square();
      const Tensor<1, 3> m_x_a = cross_product_3d(load.moment, a);
      for (unsigned int c = 0; c < 3; ++c)
        {
          residual[d + c] -= load.force[c];
          residual[t + c] -= m_x_a[c] / A;

          Tensor<1, 3> da;
          da[c]                     = 1.;
          const Tensor<1, 3> column = cross_product_3d(load.moment, da) / A -
                                      (2. * a[c] / (A * A)) * m_x_a;
          for (unsigned int e = 0; e < 3; ++e)
            matrix(t + e, t + c) -= column[e];
        }
    }

    const unsigned int               n_cells;
    const double                     h;
    const TorsionFreeKirchhoff       beam;
    dealii::Vector<double>           u, residual;
    dealii::LAPACKFullMatrix<double> matrix;
  };
} // namespace Setae::Test

#endif
