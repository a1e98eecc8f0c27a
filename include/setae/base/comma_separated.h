// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_base_comma_separated_h
#define setae_base_comma_separated_h

#include <sstream>
#include <string>
#include <vector>

namespace Setae
{
  /** Numbers as the text of a list, for messages. */
  template <typename Number>
  std::string
  comma_separated(const std::vector<Number> &numbers)
  {
    std::ostringstream text;
    for (unsigned int i = 0; i < numbers.size(); ++i)
      text << (i == 0 ? "" : ", ") << numbers[i];
    return text.str();
  }
} // namespace Setae

#endif
