// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_interactions_line_sites_h
#define setae_interactions_line_sites_h

#include <deal.II/base/quadrature.h>

#include <setae/kinematics/hermite.h>

#include <limits>
#include <vector>

namespace Setae
{
  /**
   * A quadrature point of a fiber: where it is, the direction of the curve
   * there and what is needed to distribute its force to the cell.
   */
  struct LineSite
  {
    double                x;      ///< reference coordinate on the cell
    std::array<double, 4> N, N_x; ///< shape functions and derivatives
    Tensor<1, 3>          r, r_x; ///< position, derivative [length]
    double                weight; ///< initial arc length [length]
  };

  /** The vector from @p target to @p source, for double_sum(). */
  inline Tensor<1, 3>
  connect(const LineSite &source, const LineSite &target)
  {
    return source.r - target.r;
  }



  /**
   * Append the sites of @p rule on the part from @p begin to @p end, in the
   * reference coordinate, of a cell, given by its initial and its @p current
   * curve.
   */
  inline void
  append_sites(const dealii::Quadrature<1> &rule,
               const double                 begin,
               const double                 end,
               const HermiteCell<>         &initial,
               const HermiteCell<>         &current,
               std::vector<LineSite>       &sites)
  {
    for (unsigned int q = 0; q < rule.size(); ++q)
      {
        LineSite &s = sites.emplace_back();
        s.x         = begin + (end - begin) * rule.point(q)[0];
        s.N         = Hermite::shape_values(s.x, current.h);
        s.N_x       = Hermite::shape_derivatives(s.x, current.h);
        s.r         = current.combine(s.N);
        s.r_x       = current.combine(s.N_x);
        s.weight =
          (end - begin) * rule.weight(q) * initial.combine(s.N_x).norm();
      }
  }



  /**
   * The sites of @p rule on a whole cell. Writes into @p sites to save
   * allocations.
   */
  inline void
  evaluate_sites(const dealii::Quadrature<1> &rule,
                 const HermiteCell<>         &initial,
                 const HermiteCell<>         &current,
                 std::vector<LineSite>       &sites)
  {
    sites.clear();
    append_sites(rule, 0., 1., initial, current, sites);
  }



  /**
   * What an evaluation saw of the gaps: the smallest one and where on the
   * source it is.
   */
  struct GapReport
  {
    double       smallest = std::numeric_limits<double>::infinity();
    unsigned int source   = 0;  ///< source cell
    unsigned int target   = 0;  ///< target cell
    double       x        = 0.; ///< reference coordinate on the source cell

    void
    see(const GapReport &other)
    {
      if (other.smallest < smallest)
        *this = other;
    }
  };



  /**
   * A force per length [force/length] at a point of a centerline, for output.
   */
  struct SiteForce
  {
    Tensor<1, 3> position;
    Tensor<1, 3> force;
    double       gap;
  };
} // namespace Setae

#endif
