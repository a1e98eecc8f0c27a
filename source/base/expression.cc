// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <deal.II/base/function_parser.h>
#include <deal.II/base/utilities.h>

#include <setae/base/exceptions.h>
#include <setae/base/expression.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <set>
#include <sstream>

namespace Setae
{
  using namespace dealii;

  namespace
  {
    std::array<Expression, 3>
    split(const std::string &parameter,
          const std::string &text,
          const std::string &variables,
          const Constants   &constants)
    {
      const auto parts = Utilities::split_string_list(text, ';');
      AssertThrow(parts.size() == 3,
                  ExcParameter(parameter,
                               text,
                               "three formulas, separated by ';'"));
      return {{Expression(parameter, parts[0], variables, constants),
               Expression(parameter, parts[1], variables, constants),
               Expression(parameter, parts[2], variables, constants)}};
    }


    /** A number as it is shown in messages. */
    std::string
    as_text(const double value)
    {
      std::ostringstream text;
      text << std::setprecision(12) << (std::isnan(value) ? NAN : value);
      return text.str();
    }

    bool
    is_part_of_name(const char c)
    {
      return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
    }

    /** All names in a formula; parts of numbers such as 'e' are no names. */
    std::vector<std::string>
    names_in(const std::string &text)
    {
      std::vector<std::string> names;
      std::string              word;
      for (const char c : text + ' ')
        if (is_part_of_name(c) || (c == '.' && !word.empty()))
          word += c;
        else
          {
            if (!word.empty() &&
                !std::isdigit(static_cast<unsigned char>(word[0])))
              names.push_back(word);
            word.clear();
          }
      return names;
    }

    /**
     * muParser takes '0,04*s' for two formulas and returns the last one: commas
     * may stand only between the arguments of a function.
     */
    void
    check_commas(const std::string &parameter, const std::string &text)
    {
      std::vector<bool> is_call; // of each parenthesis that is open
      char              previous = ' ';
      for (const char c : text)
        {
          if (c == '(')
            is_call.push_back(is_part_of_name(previous));
          else if (c == ')' && !is_call.empty())
            is_call.pop_back();
          AssertThrow(c != ',' || (!is_call.empty() && is_call.back()),
                      ExcParameter(parameter,
                                   text,
                                   "a formula without a comma outside a "
                                   "function call; decimals are written with "
                                   "a point"));
          if (c != ' ' && c != '\t')
            previous = c;
        }
    }

    /** muParser takes 'if(t=0.5,1,2)' for an assignment to t. */
    void
    check_assignments(const std::string &parameter, const std::string &text)
    {
      const std::string before = "=<>!";
      for (std::size_t i = text.find('='); i != std::string::npos;
           i             = text.find('=', i + 1))
        {
                      const bool is_comparison =
                        (i > 0 && before.find(text[i - 1]) != std::string::npos) ||
                        (i + 1 < text.size() && text[i + 1] == '=');
                      AssertThrow(is_comparison,
                      ExcParameter(parameter,
                                   text,
                                   "a formula without '=', which assigns; "
                                               "'==' compares"));
        }
    }


    /**
     * FunctionParser prints five lines on std::cerr before it throws; what the
     * exception becomes here says it all.
     */
    class SilentErrors
    {
    public:
      SilentErrors()
        : buffer(std::cerr.rdbuf(nullptr))
      {}

      ~SilentErrors()
      {
        std::cerr.rdbuf(buffer);
      }

    private:
      std::streambuf *buffer;
    };
  } // namespace



  std::vector<std::string>
  split_at_commas(const std::string &text)
  {
    std::vector<std::string> parts(1);
    int                      depth = 0;
    for (const char c : text)
      {
        depth += (c == '(') - (c == ')');
        if (c == ',' && depth == 0)
          parts.emplace_back();
        else
          parts.back() += c;
      }
    for (std::string &part : parts)
      part = Utilities::trim(part);
    return parts;
  }



  bool
  depends_on_copy(const std::string &text)
  {
    for (const std::string &name : names_in(text))
      if (name == "i" || name == "j" || name == "k")
        return true;
    return false;
  }



  Constants
  with_copy(Constants constants, const Constants &copy)
  {
    constants.insert(copy.begin(), copy.end());
    return constants;
  }



  Constants
  parse_constants(const std::string &parameter, const std::string &text)
  {
    Constants constants;
    if (Utilities::trim(text).empty())
      return constants;
    for (const std::string &entry : split_at_commas(text))
      {
        const auto        equal = entry.find('=');
        const std::string name  = Utilities::trim(entry.substr(0, equal));
        const std::set<std::string> reserved = {
          "", "s", "t", "i", "j", "k", "pi"};
        AssertThrow(equal != std::string::npos && reserved.count(name) == 0 &&
                      !std::isdigit(static_cast<unsigned char>(name[0])) &&
                      std::all_of(name.begin(), name.end(), is_part_of_name),
                    ExcParameter(parameter,
                                 text,
                                 "a list 'name = value, ...' with names other "
                                 "than s, t, i, j, k, pi, but has '" +
                                   entry + "'"));
        const double value = Expression(
          parameter, Utilities::trim(entry.substr(equal + 1)), "", constants)();
        AssertThrow(constants.emplace(name, value).second,
                    ExcParameter(parameter,
                                 text,
                                 "a list of different names, but has '" + name +
                                   "' twice"));
        // A name that muParser does not take makes every formula invalid.
        Expression(parameter, name, "", constants);
      }
    return constants;
  }



  Expression::Expression(const std::string &parameter,
                         const std::string &text,
                         const std::string &variables,
                         const Constants   &constants)
    : parameter(parameter)
    , text(text)
    , variables(Utilities::split_string_list(variables))
    , parser(std::make_unique<FunctionParser<2>>(1))
  {
    check_commas(parameter, text);
    check_assignments(parameter, text);

    Constants all = constants;
    all.emplace("pi", numbers::PI);
    for (const std::string name : {"i", "j", "k"})
      if (constants.count(name) > 0)
        copy += ", " + name + " = " + as_text(constants.at(name));

    std::string both = variables;
    for (unsigned int i = this->variables.size(); i < 2; ++i)
      both += (both.empty() ? "" : ",") + ("unused_" + std::to_string(i));
    try
      {
        const SilentErrors silence;
        parser->initialize(both, text, all);
        // muParser looks at a formula when it is evaluated first.
        parser->value(Point<2>());
      }
    catch (...) // muParser's own exception is no std::exception
      {
        std::string names = variables;
        for (const auto &[name, value] : all)
          names += (names.empty() ? "" : ", ") + name;
        AssertThrow(false,
                    ExcParameter(parameter,
                                 text,
                                 "a formula (muParser) of " + names));
      }
  }



  Expression::~Expression() = default;

  Expression::Expression(Expression &&) noexcept = default;



  double
  Expression::operator()(const double first, const double second) const
  {
    const double value = parser->value(Point<2>(first, second));
    AssertThrow(std::isfinite(value),
                ExcParameter(parameter,
                             text,
                             "a formula with finite values, but is " +
                               as_text(value) + place(first, second)));
    return value;
  }



  std::string
  Expression::place(const double first, const double second) const
  {
    std::string  result;
    const double values[] = {first, second};
    for (unsigned int i = 0; i < variables.size(); ++i)
      result += ", " + variables[i] + " = " + as_text(values[i]);
    result += copy;
    return result.empty() ? "" : " at " + result.substr(2);
  }



  VectorExpression::VectorExpression(const std::string &parameter,
                                     const std::string &text,
                                     const std::string &variables,
                                     const Constants   &constants)
    : components(split(parameter, text, variables, constants))
  {}



  Tensor<1, 3>
  VectorExpression::operator()(const double first, const double second) const
  {
    Tensor<1, 3> result;
    for (unsigned int c = 0; c < 3; ++c)
      result[c] = components[c](first, second);
    return result;
  }
} // namespace Setae
