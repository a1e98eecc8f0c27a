// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_assembly_external_work_h
#define setae_assembly_external_work_h

#include <deal.II/base/exceptions.h>

#include <vector>

namespace Setae
{
  /**
   * Something from outside that works on the fibers: a force and the coordinate
   * along which it acts, their product an energy. For a term whose energy
   * depends on time through a formula, @f$\Pi=\sum_i p_i(t)e_i(X)@f$, the
   * coordinate is p and the force e; for a force without potential they are
   * what their names say.
   */
  struct ExternalWork
  {
    double force, coordinate;
  };



  /**
   * The work of the mean forces between two states, both in the same order
   * [energy].
   */
  inline double
  work_between(const std::vector<ExternalWork> &first,
               const std::vector<ExternalWork> &second)
  {
    AssertDimension(first.size(), second.size());
    double result = 0.;
    for (unsigned int i = 0; i < first.size(); ++i)
      result += .5 * (first[i].force + second[i].force) *
                (second[i].coordinate - first[i].coordinate);
    return result;
  }
} // namespace Setae

#endif
