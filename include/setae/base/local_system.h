// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_base_local_system_h
#define setae_base_local_system_h

#include <array>

namespace Setae
{
  /**
   * What an evaluation has to deliver; each entry includes those before it.
   */
  enum class Request
  {
    energy,
    residual,
    tangent
  };



  /**
   * Energy [energy], its gradient and its Hessian with respect to the @p n
   * degrees of freedom of a cell (n = 12) or of a pair of cells (n = 24, source
   * first). The index of shape function @p a and coordinate @p c of a cell is
   * 3 a + c.
   */
  template <unsigned int n>
  struct LocalSystem
  {
    double                               energy   = 0.;
    std::array<double, n>                residual = {};
    std::array<std::array<double, n>, n> tangent  = {};

    /**
     * Set to zero what an evaluation of @p request writes, and nothing else.
     */
    void
    reset(const Request request)
    {
      energy = 0.;
      if (request >= Request::residual)
        residual = {};
      if (request >= Request::tangent)
        tangent = {};
    }

    /**
     * Add @p factor times a 3 by 3 block to the tangent matrix.
     */
    template <typename Block>
    void
    add_block(const unsigned int row,
              const unsigned int column,
              const double       factor,
              const Block       &block)
    {
      for (unsigned int c = 0; c < 3; ++c)
        for (unsigned int e = 0; e < 3; ++e)
          tangent[row + c][column + e] += factor * block[c][e];
    }

    /**
     * Copy the lower triangle of the tangent matrix to the upper one.
     */
    void
    symmetrize()
    {
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = 0; j < i; ++j)
          tangent[j][i] = tangent[i][j];
    }
  };
} // namespace Setae

#endif
