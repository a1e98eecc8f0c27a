// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <boost/math/special_functions/beta.hpp>

#include <setae/laws/flat_end.h>

#include <algorithm>

namespace Setae
{
  namespace
  {
    /** H of a disk that touches at the gap and is not inclined. */
    double
    H_of_gap(const double gap, const double R)
    {
      return gap * (gap + 2. * R) / (2. * (gap + R));
    }

    /** F((7-m)/2, (6-m)/2; 2; x), which ends because one of both is an integer.
     */
    std::vector<double>
    hypergeometric_polynomial(const unsigned int m)
    {
      const double        a = (7. - m) / 2., b = (6. - m) / 2.;
      std::vector<double> result;
      double              term = 1.;
      for (unsigned int k = 0; term != 0.; ++k)
        {
          result.push_back(term);
          term *= (a + k) * (b + k) / ((2. + k) * (1. + k));
        }
      return result;
    }

    /**
     * The width w of disk_overlap() over the height z with which two disks that
     * just touch from the side have the right energy: for an overlap that grows
     * as s^(3/2), (w/2)^(3/2) is the mean of s^(3/2) over the density
     * @f$\int_z^\infty(\zeta^2+s^2)^{(1-m)/2}d\zeta@f$.
     */
    double
    overlap_softness(const double m)
    {
      using boost::math::beta;
      const double mean = .5 * beta(1.25, .5 * m - 1.75) * (m - 3.) /
                          ((m - 4.5) * beta(.5, .5 * m - 1.));
      return 2. * std::pow(mean, 2. / 3.);
    }

    /**
     * The mean of s over the density
     * @f$\int_z^\infty(\zeta^2+s^2)^{-m/2}d\zeta@f$ in the plane, over z: by how
     * much two disks one above the other miss each other.
     */
    double
    mean_width(const double m)
    {
      return .5 * boost::math::beta(1.5, .5 * m - 1.5) * (m - 2.) * (m - 3.) /
             (m - 4.);
    }

    /** A point that sees a wedge of 90 degrees at 45 degrees, over a half-space
     * at the same distance. */
    double
    part_of_wedge(const double m)
    {
      return std::pow(2., .5 * (m - 3.)) *
             boost::math::ibeta(.5 * m - 1., .5, .5);
    }
  } // namespace



  FlatEnd::FlatEnd(const InversePower &power,
                   const SectionPair  &sections,
                   const GapRange     &range)
    : m(power.exponent)
    , R1(sections.radius_1)
    , R2(sections.radius_2)
    , polynomial(hypergeometric_polynomial(m))
    , fringe_width(mean_width(m))
    , softness(overlap_softness(m))
    , thinness(2. * (m - 1.) / ((m - 2.) * (m - 3.)))
    , wedge(part_of_wedge(m))
    , held(H_of_gap(range.regularization, R1))
    , powers(InversePowers(
               {{power.prefactor * sections.density_1 * sections.density_2 *
                   2. * M_PI / ((m - 2.) * (m - 3.)) * M_PI * R1 * R1 *
                   std::pow(2., 4.5 - m),
                 m - 5}}),
             H_of_gap(range.regularization, R1))
    , cutoff(range.cutoff_begin, range.cutoff)
  {
    line_of_points = power.prefactor * sections.density_1 * sections.density_2 *
                     M_PI * M_PI * R1 * R1 * R2 * R2 / (m - 1.);
  }



  double
  FlatEnd::clearance(const Pose<double> &pose) const
  {
    const auto of = [](const Direction<double> &at) {
      return at.D - std::sqrt(std::max(at.W, 0.));
    };
    double                  result = of(of_cap(pose));
    double                  share, gate;
    const Direction<double> at = edge(pose, share, gate);
    if (at.D > 0.)
      result = std::max(result, of(at));
    return result;
  }
} // namespace Setae
