// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_tests_interactions_line_pair_h
#define setae_tests_interactions_line_pair_h

// Pairs of cells with sites on both, for the tests of double integrals.

#include <deal.II/base/quadrature_lib.h>

#include <random>
#include <vector>

#include "cell_pair.h"

namespace Setae
{
  inline std::vector<LineSite>
  sites(const HermiteCell<> &cell, const unsigned int n)
  {
    std::vector<LineSite> result;
    evaluate_sites(dealii::QGauss<1>(n), cell, cell, result);
    return result;
  }

  /** Two cells and the sites on them, whose weights stay as they are. */
  struct Configuration
  {
    explicit Configuration(const CellPair &cells, const unsigned int n = 3)
      : cells(cells)
      , source_sites(sites(cells.source, n))
      , target_sites(sites(cells.target, n + 1))
    {}

    CellPair              cells;
    std::vector<LineSite> source_sites, target_sites;

    /** The same sites on moved cells. */
    Configuration
    with(const CellPair &moved) const
    {
      Configuration result = *this;
      result.cells         = moved;
      for (LineSite &s : result.source_sites)
        {
          s.r   = moved.source.combine(s.N);
          s.r_x = moved.source.combine(s.N_x);
        }
      for (LineSite &s : result.target_sites)
        {
          s.r   = moved.target.combine(s.N);
          s.r_x = moved.target.combine(s.N_x);
        }
      return result;
    }
  };



  /**
   * Two random cells that are closest, at the given distance, at the first site
   * of the source and the second of the target.
   */
  inline Configuration
  random_configuration(std::mt19937      &random,
                       const double       bend,
                       const double       distance,
                       const unsigned int n = 3)
  {
    CellPair cells;
    cells.source    = random_cell(random_direction(random), .4, bend, random);
    cells.target    = random_cell(random_direction(random), .5, bend, random);
    const double x  = dealii::QGauss<1>(n).point(0)[0];
    const double xi = dealii::QGauss<1>(n + 1).point(1)[0];
    move_to(cells.source,
            x,
            cells.target.position(xi) +
              distance * random_normal_to(cells.target.derivative(xi), random));
    return Configuration(cells, n);
  }
} // namespace Setae

#endif
