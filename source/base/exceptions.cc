// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <setae/base/exceptions.h>

#include <new>

namespace Setae
{
  std::string
  one_line(const std::exception &exception)
  {
    std::ostringstream text;
    if (const auto *own =
          dynamic_cast<const dealii::ExceptionBase *>(&exception))
      own->print_info(text);
    else if (dynamic_cast<const std::bad_alloc *>(&exception))
      text << "There is not enough memory (" << exception.what() << ").";
    else
      text << exception.what();

    std::istringstream words(text.str());
    std::string        line, word;
    while (words >> word)
      line += (line.empty() ? "" : " ") + word;
    return line;
  }



  std::string
  reason(const std::exception &exception)
  {
    std::string line = one_line(exception);
    while (!line.empty() && line.back() == '.')
      line.pop_back();
    return line;
  }
} // namespace Setae
