// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_laws_disk_overlap_h
#define setae_laws_disk_overlap_h

#include <cmath>

namespace Setae
{
  /**
   * The area over which two parallel disks face each other, as it counts for a
   * potential that sees it from a height: a smooth and positive function of the
   * distance y of their axes.
   *
   * The chord that the two circles have in common is
   * @f[ 2h = \frac1y\sqrt{(R_1+R_2-y)(R_1+R_2+y)(y-|R_1-R_2|)(y+|R_1-R_2|)}, @f]
   * and each disk contributes the segment @f$R^2(\vartheta-\sin\vartheta
   * \cos\vartheta)@f$ of half the angle @f$\vartheta@f$ beyond it. The two
   * factors that vanish where the disks begin to overlap and where one covers
   * the other are replaced by @f$\frac12(q+\sqrt{q^2+w^2})@f$ with a width w
   * for each; the second one together with its neighbor, because only their
   * product is smooth where the radii are equal.
   */
  template <typename Number>
  Number
  disk_overlap(const Number &y,
               const Number &radius_1,
               const double  radius_2,
               const Number &width,
               const Number &inner_width)
  {
    using std::atan;
    using std::sqrt;
    const auto softened = [&](const Number &q) -> Number {
      const Number root = sqrt(q * q + width * width);
      return q < 0. ? Number(.5 * width * width / (root - q)) :
                      Number(.5 * (root + q));
    };
    // theta - sin(theta) cos(theta) with u = cot(theta)
    const auto segment = [](const Number &u) -> Number {
      const Number sine_square = 1. / (1. + u * u), sine = sqrt(sine_square);
      if (u < 1.7)
        return .5 * M_PI - atan(u) - u * sine_square;
      constexpr unsigned int n_terms = 20; // sine^2 < 1/4
      Number                 sum     = 0.;
      for (unsigned int k = n_terms; k > 0; --k)
        sum =
          sine_square * ((k - .5) * (k + .5) / (k * (k + 1.5))) * (1. + sum);
      return 2. / 3. * sine_square * sine * (1. + sum);
    };

    const Number difference = radius_1 - radius_2, total = radius_1 + radius_2;
    const Number inner = y * y - difference * difference;
    const Number fringe =
      2. * inner_width * inner_width * (y * y + difference * difference);
    const Number root = sqrt(inner * inner + fringe);
    const Number chord =
      sqrt(softened(Number(total - y)) * (total + y) *
           (inner < 0. ? Number(.5 * fringe / (root - inner)) :
                         Number(.5 * (root + inner))));
    const Number square = radius_1 * radius_1, square_2 = radius_2 * radius_2;
    return square * segment(Number((y * y + square - square_2) / chord)) +
           square_2 * segment(Number((y * y + square_2 - square) / chord));
  }
} // namespace Setae

#endif
