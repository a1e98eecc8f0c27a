// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_tests_random_vectors_h
#define setae_tests_random_vectors_h

#include <deal.II/base/tensor.h>

#include <random>

namespace Setae
{
  using dealii::Tensor;

  /** With normally distributed components. */
  inline Tensor<1, 3>
  random_vector(std::mt19937 &random)
  {
    std::normal_distribution<double> normal;
    Tensor<1, 3>                     result;
    for (unsigned int c = 0; c < 3; ++c)
      result[c] = normal(random);
    return result;
  }

  inline Tensor<1, 3>
  random_direction(std::mt19937 &random)
  {
    const Tensor<1, 3> v = random_vector(random);
    return v / v.norm();
  }

  inline Tensor<1, 3>
  random_normal_to(const Tensor<1, 3> &v, std::mt19937 &random)
  {
    const Tensor<1, 3> e = cross_product_3d(v, random_vector(random));
    return e / e.norm();
  }
} // namespace Setae

#endif
