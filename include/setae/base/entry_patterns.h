// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_base_entry_patterns_h
#define setae_base_entry_patterns_h

#include <deal.II/base/patterns.h>

#include <limits>

namespace Setae
{
  /** What entries of a .prm file have in common. */
  namespace EntryPatterns
  {
    inline constexpr double infinity = std::numeric_limits<double>::max();

    inline dealii::Patterns::Double
    non_negative()
    {
      return dealii::Patterns::Double(0., infinity);
    }

    inline dealii::Patterns::Integer
    positive_integer()
    {
      return dealii::Patterns::Integer(1);
    }

    /** Any number of names. */
    inline dealii::Patterns::List
    names()
    {
      return dealii::Patterns::List(dealii::Patterns::Anything(),
                                    0,
                                    std::numeric_limits<int>::max());
    }
  } // namespace EntryPatterns
} // namespace Setae

#endif
