// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_laws_inverse_powers_h
#define setae_laws_inverse_powers_h

#include <setae/base/integer_power.h>
#include <setae/base/law_derivatives.h>

#include <cmath>
#include <utility>
#include <vector>

namespace Setae
{
  /**
   * A sum of inverse half-integer powers of the gap,
   * @f$\sum_i a_i\, g^{-(n_i+1/2)}@f$: the common form of all small-gap laws of
   * circular sections. It is evaluated with one square root and integer powers.
   */
  class InversePowers
  {
  public:
    struct Term
    {
      double       coefficient;
      unsigned int n;
    };

    explicit InversePowers(std::vector<Term> terms)
      : terms(std::move(terms))
    {}

    /** The value alone, on any number type; @p gap must be positive. */
    template <typename Number>
    Number
    value(const Number &gap) const
    {
      using std::sqrt;
      const Number inverse = 1. / gap;
      Number       sum     = 0.;
      for (const Term &term : terms)
        sum += term.coefficient * integer_power(inverse, term.n);
      return sum * sqrt(inverse);
    }

    /** Value and derivatives; @p gap must be positive. */
    GapDerivatives
    derivatives(const double gap) const
    {
      const double   inverse = 1. / gap;
      const double   root    = std::sqrt(inverse);
      GapDerivatives sum;
      for (const Term &term : terms)
        {
          const double p = term.n + .5;
          const double value =
            term.coefficient * integer_power(inverse, term.n) * root;
          sum.value += value;
          sum.first -= p * value * inverse;
          sum.second += p * (p + 1.) * value * inverse * inverse;
        }
      return sum;
    }

  private:
    std::vector<Term> terms;
  };
} // namespace Setae

#endif
