// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <setae/base/derivative.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace Setae
{
  using dealii::Tensor;

  namespace
  {
    using Curve = std::function<Tensor<1, 3>(double)>;

    struct Estimate
    {
      Tensor<1, 3> value;
      double       error = std::numeric_limits<double>::infinity();
    };

    /** Where in an interval the derivative is wanted. */
    enum class Place
    {
      start,
      middle,
      end
    };

    /** The derivative of the Chebyshev polynomial T_k on [-1, 1]. */
    double
    slope(const unsigned int k, const Place place)
    {
      const double odd = k % 2 == 1 ? 1. : -1.;
      if (place == Place::middle)
        return k % 2 == 0 ? 0. : (k % 4 == 1 ? 1. : -1.) * k;
      return (place == Place::start ? odd : 1.) * k * k;
    }

    /**
     * The derivative at @p s from @p n_points values in an interval of length
     * @p width around it or beside it: that of the Chebyshev series whose terms
     * are cut off where they are lost in round-off. The other values then
     * average round-off, as in a least squares fit.
     */
    Estimate
    estimate_in(const Curve       &curve,
                const double       s,
                const Place        place,
                const double       width,
                const unsigned int n_points,
                const double       lower,
                const double       upper)
    {
      constexpr double eps  = std::numeric_limits<double>::epsilon();
      const double     at_s = place == Place::start  ? -1. :
                              place == Place::middle ? 0. :
                                                       1.;

      const Tensor<1, 3>        origin  = curve(s);
      double                    largest = origin.norm(), change = 0.;
      std::vector<Tensor<1, 3>> values(n_points);
      for (unsigned int j = 0; j < n_points; ++j)
        {
          const double x =
            s + .5 * width * (std::cos(M_PI * (j + .5) / n_points) - at_s);
          const Tensor<1, 3> value = curve(std::clamp(x, lower, upper));
          values[j]                = value - origin;
          largest                  = std::max(largest, value.norm());
          change                   = std::max(change, values[j].norm());
        }

      std::vector<Tensor<1, 3>> terms(n_points);
      for (unsigned int k = 1; k < n_points; ++k)
        for (unsigned int j = 0; j < n_points; ++j)
          terms[k] += (2. / n_points *
                       std::cos(M_PI * (k * (2 * j + 1) % (4 * n_points)) /
                                (2. * n_points))) *
                      values[j];

      // Round-off of values and abscissas, or what the last terms show of it or
      // of a curve that they do not resolve.
      const unsigned int last    = 3 * n_points / 4;
      double             squares = 0.;
      for (unsigned int k = last; k < n_points; ++k)
        squares += terms[k].norm() * terms[k].norm();
      const double noise =
        std::max(.5 * eps * (largest + std::abs(s) * change / width) *
                   std::sqrt(2. / n_points),
                 std::sqrt(squares / (n_points - last)));

      unsigned int n_terms = last;
      while (n_terms > 1 && terms[n_terms - 1].norm() < 4. * noise)
        --n_terms;
      Estimate result;
      squares = 0.;
      for (unsigned int k = 1; k < n_terms; ++k)
        {
          result.value += slope(k, place) * terms[k];
          squares += slope(k, place) * slope(k, place);
        }
      const double cut_off = std::max(std::abs(slope(n_terms, place)),
                                      std::abs(slope(n_terms + 1, place)));
      result.value         = 2. / width * result.value;
      result.error = 2. / width * noise * (std::sqrt(squares) + 4. * cut_off);
      return result;
    }

    /** The best of intervals that are halved, beginning with @p width. */
    Estimate
    best_estimate(const Curve &curve,
                  const double s,
                  const Place  place,
                  const double width,
                  const double lower,
                  const double upper)
    {
      constexpr unsigned int n_halvings = 16;

      // A derivative at an end amplifies round-off more.
      const unsigned int n_points = place == Place::middle ? 32 : 128;

      Estimate best;
      for (unsigned int k = 0; k <= n_halvings; ++k)
        {
          const Estimate estimate = estimate_in(curve,
                                                s,
                                                place,
                                                std::ldexp(width, -int(k)),
                                                n_points,
                                                lower,
                                                upper);
          if (estimate.error < best.error)
            best = estimate;
          if (best.error <= 1e-12 * best.value.norm() ||
              estimate.error > 3. * best.error)
            break;
        }
      return best;
    }
  } // namespace



  SidedDerivatives
  differentiate_within(const Curve &curve,
                       const double s,
                       const double lower,
                       const double upper,
                       const double spacing)
  {
    const double room_left  = std::min(spacing, s - lower);
    const double room_right = std::min(spacing, upper - s);
    const double end        = std::min(8. * spacing, upper - lower);
    const auto   from       = [&](const Place place, const double width) {
      return best_estimate(curve, s, place, width, lower, upper);
    };

    if (room_left <= 1e-6 * spacing)
      {
        const Estimate right = from(Place::start, end);
        return {right.value, right.value, right.error};
      }
    if (room_right <= 1e-6 * spacing)
      {
        const Estimate left = from(Place::end, end);
        return {left.value, left.value, left.error};
      }
    const Estimate both =
      from(Place::middle, 2. * std::min(room_left, room_right));
    const double round_off =
      10. * std::numeric_limits<double>::epsilon() * curve(s).norm() / spacing;
    if (both.error <= std::max(1e-10 * both.value.norm(), round_off))
      return {both.value, both.value, both.error};

    const Estimate left  = from(Place::end, room_left);
    const Estimate right = from(Place::start, room_right);
    const double   error = std::max(left.error, right.error);
    if (both.error <= error)
      return {both.value, both.value, both.error};
    return {left.value, right.value, error};
  }
} // namespace Setae
