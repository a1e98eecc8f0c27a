// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_base_integer_power_h
#define setae_base_integer_power_h

namespace Setae
{
  /** @p base to the power of @p n by repeated squaring, on any number type. */
  template <typename Number>
  Number
  integer_power(Number base, unsigned int n)
  {
    Number result = 1.;
    for (; n > 0; n /= 2, base *= Number(base))
      if (n % 2 == 1)
        result *= base;
    return result;
  }
} // namespace Setae

#endif
