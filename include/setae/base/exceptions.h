// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_base_exceptions_h
#define setae_base_exceptions_h

#include <deal.II/base/exceptions.h>

#include <exception>
#include <sstream>
#include <string>

namespace Setae
{
  /**
   * A parameter whose value cannot be used: its name with all sections, the
   * value as it was read and what is allowed.
   */
  DeclException3(ExcParameter,
                 std::string,
                 std::string,
                 std::string,
                 << "The parameter '" << arg1 << "' has the value '" << arg2
                 << "', but must be " << arg3 << '.');

  /**
   * @throws ExcParameter unless @p condition holds.
   */
  template <typename Value>
  void
  require(const bool         condition,
          const std::string &parameter,
          const Value       &value,
          const std::string &allowed)
  {
    if (condition)
      return;
    std::ostringstream text;
    text << value;
    AssertThrow(false, ExcParameter(parameter, text.str(), allowed));
  }

  /** What @p exception says, in one line. */
  std::string
  one_line(const std::exception &exception);

  /** The same without a full stop, to stand in a sentence. */
  std::string
  reason(const std::exception &exception);

  /** Anything else a user can put right, in one sentence. */
  DeclException1(ExcInput, std::string, << arg1);

  /** A run that cannot go on: what happened and where, in one sentence. */
  DeclException1(ExcRun, std::string, << arg1);
} // namespace Setae

#endif
