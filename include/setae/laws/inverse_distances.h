// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_laws_inverse_distances_h
#define setae_laws_inverse_distances_h

#include <setae/base/integer_power.h>
#include <setae/base/law_derivatives.h>

#include <utility>
#include <vector>

namespace Setae
{
  /**
   * A sum of inverse powers of the distance d of two centerlines,
   * @f$\sum_i a_i\, d^{-n_i}@f$ with @f$d=g+R_1+R_2@f$, as a function of the
   * gap g: the form of the laws for large distances.
   */
  class InverseDistances
  {
  public:
    struct Term
    {
      double       coefficient;
      unsigned int n;
    };

    InverseDistances(std::vector<Term> terms, const double sum_of_radii)
      : terms(std::move(terms))
      , sum_of_radii(sum_of_radii)
    {}

    /** Whether the function is defined at @p gap: up to centerlines that meet. */
    bool
    admits(const double gap) const
    {
      return gap + sum_of_radii > 0.;
    }

    /** The value alone, on any number type. */
    template <typename Number>
    Number
    value(const Number &gap) const
    {
      const Number inverse = 1. / (gap + sum_of_radii);
      Number       sum     = 0.;
      for (const Term &term : terms)
        sum += term.coefficient * integer_power(inverse, term.n);
      return sum;
    }

    /** Value and derivatives. */
    GapDerivatives
    derivatives(const double gap) const
    {
      const double   inverse = 1. / (gap + sum_of_radii);
      GapDerivatives sum;
      for (const Term &term : terms)
        {
          const double value =
            term.coefficient * integer_power(inverse, term.n);
          sum.value += value;
          sum.first -= term.n * value * inverse;
          sum.second += term.n * (term.n + 1.) * value * inverse * inverse;
        }
      return sum;
    }

  private:
    std::vector<Term> terms;
    double            sum_of_radii;
  };
} // namespace Setae

#endif
