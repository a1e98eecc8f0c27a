// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_interactions_resultant_h
#define setae_interactions_resultant_h

#include <deal.II/base/tensor.h>

#include <map>
#include <utility>

namespace Setae
{
  /** The interaction of two fibers as a whole. */
  struct Resultant
  {
    double               energy = 0.; ///< [energy]
    dealii::Tensor<1, 3> force;       ///< on the first one [force]
  };

  /** For each pair of fibers that interact, by index, the smaller one first. */
  using FiberPairResultants =
    std::map<std::pair<unsigned int, unsigned int>, Resultant>;
} // namespace Setae

#endif
