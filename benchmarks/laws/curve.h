// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_benchmarks_laws_curve_h
#define setae_benchmarks_laws_curve_h

#include <setae/base/exceptions.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include "interaction.h"

namespace Setae
{
  namespace LawReport
  {
    /** What is computed: a line of a figure, and a place on it. */
    struct Place
    {
      std::string configuration;
      std::string potential;
      double      gap;            ///< over R
      double      angle     = 0.; ///< degrees
      double      offset    = 0.; ///< along the fibers, over R
      double      curvature = 0.; ///< times R
      double      radius_2  = 1.; ///< of the target, over R

      /** Whether the gap is a power of ten; CPU times are measured there. */
      bool
      is_decade() const
      {
        const double exponent = std::log10(gap);
        return std::abs(exponent - std::round(exponent)) < 1e-9;
      }
    };



    /** An evaluation of a method. */
    struct Row
    {
      Place       place;
      std::string method;
      std::string resolution;
      Interaction value;
      double      energy_error; ///< relative; so below
      double      force_error;
      double      cpu_time; ///< [s], or not a number
    };

    /** Rows that differ in gap, angle or offset only, in their order. */
    using Curve = std::vector<Row>;

    /** The largest error among the rows with gaps in a closed interval. */
    inline double
    largest_error(const Curve &curve,
                  const double first_gap,
                  const double last_gap,
                  double Row::*error = &Row::energy_error)
    {
      AssertThrow(!curve.empty(), ExcInput("A method has not been tried."));
      double result = 0.;
      for (const Row &row : curve)
        if (row.place.gap >= first_gap && row.place.gap <= last_gap)
          // NaN is larger than everything
          if (!(std::abs(row.*error) <= result))
            result = std::abs(row.*error);
      return result;
    }

    /** The row with the gap that is nearest to @p gap. */
    inline const Row &
    nearest(const Curve &curve, const double gap)
    {
      AssertThrow(!curve.empty(), ExcInput("A method has not been tried."));
      return *std::min_element(curve.begin(),
                               curve.end(),
                               [&](const Row &a, const Row &b) {
                                 return std::abs(std::log(a.place.gap / gap)) <
                                        std::abs(std::log(b.place.gap / gap));
                               });
    }

    /** The exponent of the gap, or of gap + @p shift, between two gaps. */
    inline double
    slope(const Curve &curve,
          const double first_gap,
          const double last_gap,
          const double shift = 0.)
    {
      const Row a = nearest(curve, first_gap), b = nearest(curve, last_gap);
      return std::log(b.value.energy / a.value.energy) /
             std::log((b.place.gap + shift) / (a.place.gap + shift));
    }

    /** The largest relative difference of two energies. */
    inline double
    largest_difference(const Curve &first, const Curve &second)
    {
      double result = 0.;
      for (unsigned int i = 0; i < first.size(); ++i)
        result =
          std::max(result,
                   std::abs(first[i].value.energy / second.at(i).value.energy -
                            1.));
      return result;
    }



    /** @p n_per_decade numbers in each decade, powers of ten among them. */
    inline std::vector<double>
    decades(const int first, const int last, const int n_per_decade)
    {
      std::vector<double> result;
      for (int i = first * n_per_decade; i <= last * n_per_decade; ++i)
        result.push_back(std::pow(10., double(i) / n_per_decade));
      return result;
    }

    /** Two digits. */
    inline std::string
    short_text(const double value)
    {
      if (std::isnan(value))
        return "-";
      std::ostringstream stream;
      stream << std::setprecision(2) << value;
      return stream.str();
    }

    /** The columns of a table over the gap: its powers of ten. */
    inline std::string
    gap_column(const Place &place)
    {
      return place.is_decade() ? "g/R = " + short_text(place.gap) : "";
    }
  } // namespace LawReport
} // namespace Setae

#endif
