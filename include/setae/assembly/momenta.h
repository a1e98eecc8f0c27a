// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_assembly_momenta_h
#define setae_assembly_momenta_h

#include <deal.II/base/tensor.h>

namespace Setae
{
  /** What moves with the mass of the fibers, summed over all of them. */
  struct Momenta
  {
    double               kinetic_energy = 0.; ///< [energy]
    dealii::Tensor<1, 3> linear;              ///< [mass length/time]
    dealii::Tensor<1, 3> angular; ///< about the origin [mass length^2/time]
  };
} // namespace Setae

#endif
