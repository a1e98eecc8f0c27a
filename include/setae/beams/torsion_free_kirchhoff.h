// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_beams_torsion_free_kirchhoff_h
#define setae_beams_torsion_free_kirchhoff_h

#include <deal.II/base/exceptions.h>
#include <deal.II/base/tensor.h>

#include <setae/base/local_system.h>
#include <setae/kinematics/hermite.h>

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace Setae
{
  using dealii::Tensor;

  /** Stiffness of an isotropic cross-section. */
  struct SectionStiffness
  {
    double axial;   ///< EA [force]
    double bending; ///< EI [force length^2]
  };

  /** Stress resultants of a cross-section. */
  struct SectionForces
  {
    double       axial_force;    ///< along the tangent [force]
    Tensor<1, 3> bending_moment; ///< axial vector in space [force length]
  };



  /**
   * Strain energy of one cell of a shear-rigid fiber without torsion (Meier,
   * Popp, Wall, CMAME 290 (2015) 314-341), in the centerline r = r_0 + u alone.
   * With ' = d/ds along the initial arc length s, J = |dr_0/dx| and ds = J dx,
   * @f[ \Pi = \frac{EA}{2} \int \varepsilon_h^2 \,ds
   *         + \frac{EI}{2} \int |\kappa - \kappa_0|^2 \,ds, \qquad
   *     \varepsilon = |r'| - 1, \qquad
   *     \kappa = \frac{r' \times r''}{|r'|^2}. @f]
   *
   * Against membrane locking, @f$\varepsilon_h@f$ is the parabola through
   * @f$\varepsilon@f$ at x = 0, 1/2, 1 ('minimally constrained strains'); its
   * energy is integrated exactly. The curvature is integrated with Gauss
   * points. The displacement goes in, not the position: both the axial strain
   * and the insensitivity to translations then come without cancellation.
   *
   * Nodes converge with order four in the length of the cells, whatever the
   * slenderness. Between the nodes this holds as well, except that points slide
   * along the tangent by an error of order three once the cells are shorter
   * than the radius.
   *
   * A fiber that is straight initially may move in space. With initial
   * curvature the difference of the two vectors of curvature is objective for
   * motion in the plane of the fiber only, so the caller must see to it that
   * initially curved fibers are plane and stay in their plane.
   *
   * A cell with |r'| = 0 at an evaluation point has no tangent, hence no
   * curvature: every evaluation throws ExcCollapsedCell there, in Release mode,
   * too, and likewise for a displacement that is not finite. A cell that a
   * large Newton step has turned inside out is legal and goes unnoticed.
   */
  class TorsionFreeKirchhoff
  {
  public:
    static constexpr const char *name = "torsion-free Kirchhoff-Love";

    static std::string
    description();

    /**
     * The derivatives of the centerline cannot be told from round-off if they
     * are this much shorter than in the initial configuration.
     */
    static constexpr double smallest_stretch = 1e-12;

    DeclExceptionMsg(ExcCollapsedCell,
                     "The centerline of a cell has no tangent: the cell has "
                     "collapsed, or its displacement is not finite. Smaller "
                     "load steps may help.");

    DeclExceptionMsg(ExcDegenerateReference,
                     "The initial centerline of a cell must have a tangent "
                     "everywhere, but its derivative vanishes or is not "
                     "finite.");

    DeclExceptionMsg(ExcLengthScales,
                     "A displacement and the initial centerline of its cell "
                     "must have the same length scale h.");

    DeclExceptionMsg(ExcInvalidStiffness,
                     "The axial and the bending stiffness of a cross-section "
                     "must be finite and not negative.");

    /**
     * @p reference is the initial curve r_0 of the cell. Two Gauss points for
     * the energy of bending are the least that leave no deformation of the cell
     * without energy, and keep the order of convergence. Measured on a fiber
     * bent to a full circle by 16 cells, the error with 2, 3 and 4 points is
     * 2.0, 1.03 and 1.000 times that with exact integration.
     */
    TorsionFreeKirchhoff(const HermiteCell<>    &reference,
                         const SectionStiffness &stiffness,
                         const unsigned int      n_gauss_points = 4);

    /**
     * The energy [force length] alone, on any number type that has a square
     * root and compares with a double. With the types of Sacado, include
     * deal.II/differentiation/ad.h first.
     */
    template <typename Number>
    Number
    energy(const HermiteCell<Number> &displacement) const;

    /**
     * Add energy [force length], gradient and Hessian in the coefficients of
     * the displacement, as far as @p request goes. The Hessian is symmetric to
     * the last bit.
     */
    void
    add(const HermiteCell<> &displacement,
        const Request        request,
        LocalSystem<12>     &local) const;

    /**
     * @f$N = EA\,\varepsilon_h@f$ and @f$M = EI\,(\kappa-\kappa_0)@f$ at the
     * reference coordinate @p x in [0,1].
     */
    SectionForces
    section_forces(const HermiteCell<> &displacement, const double x) const;

  private:
    // Strains do not see a translation, so d2 - d1, t1, t2 say all there is to
    // say about a cell; the shape functions of d1 are minus those of d2.
    static constexpr unsigned int n_shapes = 3;

    template <typename Number>
    using Shape = std::array<Number, n_shapes>;

    /** A place on the cell with what does not depend on the displacement. */
    struct Site
    {
      Site(const HermiteCell<> &reference, const double x);

      Shape<double> first, second; // d/dx and d^2/dx^2 of the shape functions
      Tensor<1, 3>  first_0, second_0; // the same of the initial curve
      double        J;
    };

    /** A Gauss point of the energy of bending. */
    struct GaussSite : Site
    {
      GaussSite(const HermiteCell<> &reference,
                const double         x,
                const double         stiffness);

      Tensor<1, 3> curvature_0; // J kappa_0
      double       stiffness;   // EI w / J, to go with curvatures times J
    };

    template <typename Number>
    struct AxialStrain
    {
      Tensor<1, 3, Number> derivative; // r_x
      Number               length;     // |r_x|
      Number               value;
    };

    /** Curvature times J as a function of a = r_x and b = r_xx. */
    template <typename Number>
    struct Curvature
    {
      Tensor<1, 3, Number> a, b;
      Number               square; // |a|^2
      Tensor<1, 3, Number> value;  // a x b / |a|^2
    };

    /** Gradient and, for p <= q, Hessian in d2 - d1, t1, t2. */
    struct ReducedSystem
    {
      Shape<Tensor<1, 3>>        gradient;
      Shape<Shape<Tensor<2, 3>>> hessian;
    };

    template <typename Number>
    static Shape<Tensor<1, 3, Number>>
    reduce(const HermiteCell<Number> &cell);

    template <typename Number>
    Shape<Tensor<1, 3, Number>>
    reduce_displacement(const HermiteCell<Number> &displacement) const;

    template <typename Number>
    static Tensor<1, 3, Number>
    combine(const Shape<double>               &shape,
            const Shape<Tensor<1, 3, Number>> &coefficients);

    template <typename Number>
    static AxialStrain<Number>
    axial_strain(const Site                        &site,
                 const Shape<Tensor<1, 3, Number>> &displacement);

    template <typename Number>
    static Curvature<Number>
    curvature(const Site                        &site,
              const Shape<Tensor<1, 3, Number>> &displacement);

    /** Throw if a derivative with this square is none. */
    template <typename Number>
    static void
    check_tangent(const Number &square, const double J);

    double
    add_membrane(const Shape<Tensor<1, 3>> &displacement,
                 const Request              request,
                 ReducedSystem             &system) const;

    double
    add_bending(const Shape<Tensor<1, 3>> &displacement,
                const Request              request,
                ReducedSystem             &system) const;

    HermiteCell<>          reference;
    SectionStiffness       stiffness;
    std::array<Site, 3>    strain_sites;
    Tensor<2, 3>           strain_energy_matrix; // EA int L_i L_k ds
    std::vector<GaussSite> gauss_sites;
  };



  // ------------------------------- the energy ------------------------------

  template <typename Number>
  Number
  TorsionFreeKirchhoff::energy(const HermiteCell<Number> &displacement) const
  {
    const Shape<Tensor<1, 3, Number>> u = reduce_displacement(displacement);

    Number twice_the_energy = 0.;

    std::array<Number, 3> strain;
    for (unsigned int i = 0; i < 3; ++i)
      strain[i] = axial_strain(strain_sites[i], u).value;
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int k = 0; k < 3; ++k)
        twice_the_energy += strain_energy_matrix[i][k] * strain[i] * strain[k];

    for (const GaussSite &site : gauss_sites)
      {
        const Curvature<Number> k = curvature(site, u);
        for (unsigned int c = 0; c < 3; ++c)
          {
            const Number change = k.value[c] - site.curvature_0[c];
            twice_the_energy += site.stiffness * change * change;
          }
      }
    return 0.5 * twice_the_energy;
  }



  template <typename Number>
  auto
  TorsionFreeKirchhoff::reduce(const HermiteCell<Number> &cell)
    -> Shape<Tensor<1, 3, Number>>
  {
    const auto &[d1, t1, d2, t2] = cell.coefficients;
    return {{d2 - d1, t1, t2}};
  }



  template <typename Number>
  auto
  TorsionFreeKirchhoff::reduce_displacement(
    const HermiteCell<Number> &displacement) const
    -> Shape<Tensor<1, 3, Number>>
  {
    Assert(displacement.h == reference.h, ExcLengthScales());
    return reduce(displacement);
  }



  template <typename Number>
  Tensor<1, 3, Number>
  TorsionFreeKirchhoff::combine(const Shape<double>               &shape,
                                const Shape<Tensor<1, 3, Number>> &coefficients)
  {
    Tensor<1, 3, Number> result;
    for (unsigned int c = 0; c < 3; ++c)
      result[c] = shape[0] * coefficients[0][c] +
                  shape[1] * coefficients[1][c] + shape[2] * coefficients[2][c];
    return result;
  }



  template <typename Number>
  void
  TorsionFreeKirchhoff::check_tangent(const Number &square, const double J)
  {
    // Written such that not-a-number does not pass, either.
    AssertThrow(square > smallest_stretch * smallest_stretch * J * J &&
                  square < std::numeric_limits<double>::infinity(),
                ExcCollapsedCell());
  }



  template <typename Number>
  auto
  TorsionFreeKirchhoff::axial_strain(
    const Site                        &site,
    const Shape<Tensor<1, 3, Number>> &displacement) -> AxialStrain<Number>
  {
    using std::sqrt;
    const Tensor<1, 3, Number> u_x = combine(site.first, displacement);

    AxialStrain<Number> strain;
    Number              square = 0., square_change = 0.;
    for (unsigned int c = 0; c < 3; ++c)
      {
        strain.derivative[c] = site.first_0[c] + u_x[c];
        square += strain.derivative[c] * strain.derivative[c];
        square_change += (2. * site.first_0[c] + u_x[c]) * u_x[c];
      }
    check_tangent(square, site.J);

    strain.length = sqrt(square);
    // |r'| - 1 = (|r'|^2 - |r_0'|^2) / (|r'| + 1), free of cancellation
    strain.value = square_change / (site.J * (strain.length + site.J));
    return strain;
  }



  template <typename Number>
  auto
  TorsionFreeKirchhoff::curvature(
    const Site                        &site,
    const Shape<Tensor<1, 3, Number>> &displacement) -> Curvature<Number>
  {
    Curvature<Number> k;
    k.a = combine(site.first, displacement);
    k.b = combine(site.second, displacement);

    k.square = 0.;
    for (unsigned int c = 0; c < 3; ++c)
      {
        k.a[c] += site.first_0[c];
        k.b[c] += site.second_0[c];
        k.square += k.a[c] * k.a[c];
      }
    check_tangent(k.square, site.J);

    for (unsigned int c = 0; c < 3; ++c)
      {
        const unsigned int d = (c + 1) % 3, e = (c + 2) % 3;
        k.value[c] = (k.a[d] * k.b[e] - k.a[e] * k.b[d]) / k.square;
      }
    return k;
  }
} // namespace Setae

#endif
