// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <deal.II/base/function_parser.h>
#include <deal.II/base/utilities.h>

#include <setae/base/exceptions.h>
#include <setae/base/expression.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <set>

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



  Constants
  parse_constants(const std::string &parameter, const std::string &text)
  {
    Constants constants;
    for (const std::string &entry : Utilities::split_string_list(text, ','))
      {
        const auto sides = Utilities::split_string_list(entry, '=');
        const std::set<std::string> reserved = {
          "", "s", "t", "i", "j", "k", "pi"};
        AssertThrow(sides.size() == 2 && reserved.count(sides[0]) == 0,
                    ExcParameter(parameter,
                                 text,
                                 "a list 'name = value, ...' with names other "
                                 "than s, t, i, j, k, pi"));
        constants[sides[0]] =
          Expression(parameter, sides[1], "unused", constants)(0.);
      }
    return constants;
  }



  Expression::Expression(const std::string &parameter,
                         const std::string &text,
                         const std::string &variables,
                         const Constants   &constants)
    : parameter(parameter)
    , text(text)
    , parser(std::make_unique<FunctionParser<2>>(1))
  {
    const bool has_two =
      std::count(variables.begin(), variables.end(), ',') == 1;
    Constants all = constants;
    all.emplace("pi", numbers::PI);
    try
      {
        const SilentErrors silence;
        parser->initialize(has_two ? variables : variables + ",unused_2",
                           text,
                           all);
        // muParser looks at a formula when it is evaluated first.
        parser->value(Point<2>());
      }
    catch (...) // muParser's own exception is no std::exception
      {
        std::string names = variables == "unused" ? "" : variables;
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
                             "a formula with finite values, but is not at " +
                               Utilities::to_string(first)));
    return value;
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
