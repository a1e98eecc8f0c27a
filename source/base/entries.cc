// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <setae/base/entries.h>
#include <setae/base/exceptions.h>

#include <cmath>
#include <cstdlib>
#include <iomanip>
#include <optional>
#include <sstream>

namespace Setae
{
  using namespace dealii;

  namespace
  {
    /** What needs no parser, if @p text is no formula. */
    std::optional<double>
    plain_number(const std::string &text)
    {
      if (text.empty() ||
          text.find_first_not_of("0123456789.eE+- ") != std::string::npos)
        return {};
      char        *end   = nullptr;
      const double value = std::strtod(text.c_str(), &end);
      if (*end != '\0' || !std::isfinite(value))
        return {};
      return value;
    }
  } // namespace



  NumberPattern::NumberPattern(const PatternBase &values,
                               const Constants   &constants)
    : pattern(values.clone())
    , constants(constants)
  {
    const auto *list          = dynamic_cast<const Patterns::List *>(&values);
    is_list                   = list != nullptr;
    const PatternBase &number = is_list ? list->get_base_pattern() : values;
    is_integer = dynamic_cast<const Patterns::Integer *>(&number) != nullptr;
  }



  bool
  NumberPattern::match(const std::string &text) const
  {
    try
      {
        std::ostringstream plain;
        plain << std::setprecision(17);
        const std::vector<double> numbers = values(text);
        for (unsigned int i = 0; i < numbers.size(); ++i)
          plain << (i == 0 ? "" : ", ") << numbers[i];
        return pattern->match(plain.str());
      }
    catch (const ExcParameter &)
      {
        return false;
      }
  }



  std::vector<double>
  NumberPattern::values(const std::string &text) const
  {
    std::vector<double> result;
    if (is_list && Utilities::trim(text).empty())
      return result;
    for (const std::string &part :
         is_list ? split_at_commas(text) : std::vector<std::string>{text})
      {
        const std::optional<double> plain = plain_number(part);
        double                      value =
          plain ? *plain : Expression("number", part, "", constants)();
        // A quotient such as 5/0.1 is an integer up to round-off only.
        if (is_integer &&
            std::abs(value - std::round(value)) <= 1e-9 * std::abs(value))
          value = std::round(value);
        result.push_back(value);
      }
    return result;
  }



  std::string
  NumberPattern::description(const OutputStyle style) const
  {
    const std::string text = pattern->description(style);
    const std::size_t end  = text.rfind(']');
    return end == std::string::npos ?
             text + " or a formula" :
             text.substr(0, end) + ", or a formula" + text.substr(end);
  }



  std::unique_ptr<Patterns::PatternBase>
  NumberPattern::clone() const
  {
    return std::make_unique<NumberPattern>(*pattern, constants);
  }
} // namespace Setae
