// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_assembly_inertia_h
#define setae_assembly_inertia_h

#include <setae/assembly/global_system.h>
#include <setae/assembly/momenta.h>

#include <vector>

namespace Setae
{
  /**
   * The inertia of the centerlines,
   * @f[ \int \rho A\,\delta r\cdot\ddot r\,ds, @f]
   * with the consistent mass matrix of the Hermite shape functions,
   * @f$m_{ab}=\int\rho A\,N_aN_b\,ds@f$ for each of the three coordinates. It is
   * constant.
   *
   * The sections of these fibers have no rotation of their own, so there is no
   * rotary inertia. It would lower the frequency of a bending wave of wave
   * number k by about @f$(kR)^2/8@f$ of itself, which is below what the
   * neglected shear does.
   */
  class Inertia
  {
  public:
    using Vector = dealii::TrilinosWrappers::MPI::Vector;

    explicit Inertia(const FiberSystem &fibers);

    /**
     * Add M @p rate to the residual [force] and @p factor M to the matrix.
     */
    void
    add(const Vector &rate, const double factor, GlobalSystem &system);

    /** M times a vector of locally owned entries. */
    Vector
    multiply(const Vector &vector);

    /** Kinetic energy and momenta of all fibers in @p state, on every rank. */
    Momenta
    momenta(const State &state, const Vector &velocity);

    /**
     * The initial velocities of the scene [length/time], with their derivatives
     * along the fiber in the tangents.
     *
     * @throws ExcParameter if a formula cannot be evaluated.
     */
    Vector
    initial_velocity() const;

  private:
    using CellMass = std::array<std::array<double, 4>, 4>;

    /** The coefficients of a cell of a vector that knows all entries. */
    std::array<Tensor<1, 3>, 4>
    coefficients(const Vector &everywhere, const unsigned int cell) const;

    const FiberSystem    &fibers;
    std::vector<CellMass> masses;     ///< of the owned cells [mass]
    Vector                everywhere; ///< a vector, on all ranks
  };
} // namespace Setae

#endif
