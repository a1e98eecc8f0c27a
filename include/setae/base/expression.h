// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_base_expression_h
#define setae_base_expression_h

#include <deal.II/base/tensor.h>

#include <array>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace dealii
{
  template <int dim>
  class FunctionParser;
}

namespace Setae
{
  using dealii::Tensor;

  /** Named numbers that may stand in an expression. */
  using Constants = std::map<std::string, double>;

  /**
   * "name = value, ..." with expressions of earlier names as values.
   *
   * @throws ExcParameter if an entry is none, or its name cannot be used.
   */
  Constants
  parse_constants(const std::string &parameter, const std::string &text);

  /** @p constants, and the numbers i, j, k of a copy. */
  Constants
  with_copy(Constants constants, const Constants &copy);

  /** The parts of @p text between commas that are not in parentheses. */
  std::vector<std::string>
  split_at_commas(const std::string &text);

  /** Whether one of the names i, j, k stands in the formula @p text. */
  bool
  depends_on_copy(const std::string &text);



  /**
   * A formula of up to two variables, for example an arc length and the time.
   */
  class Expression
  {
  public:
    /**
     * @param parameter The full name of the parameter, for messages.
     * @param text The formula, in the language of muParser.
     * @param variables The names of one or two variables, "s" or "s,t"; none
     * for a formula of the constants only.
     * @param constants Further names that may be used.
     *
     * @throws ExcParameter if the formula cannot be parsed, has a comma outside
     * a function call (where muParser would take what follows) or assigns.
     */
    Expression(const std::string &parameter,
               const std::string &text,
               const std::string &variables,
               const Constants   &constants);
    ~Expression();
    Expression(Expression &&) noexcept;

    /**
     * @throws ExcParameter with the variables and the numbers of the copy if
     * the value is not finite.
     */
    double
    operator()(const double first = 0., const double second = 0.) const;

  private:
    std::string
    place(const double first, const double second) const;

    std::string                                parameter;
    std::string                                text;
    std::vector<std::string>                   variables;
    std::string                                copy; ///< ", i = 0, ..." or ""
    std::unique_ptr<dealii::FunctionParser<2>> parser;
  };



  /** Three formulas, separated by ';'. */
  class VectorExpression
  {
  public:
    /** @copydoc Expression::Expression */
    VectorExpression(const std::string &parameter,
                     const std::string &text,
                     const std::string &variables,
                     const Constants   &constants);

    Tensor<1, 3>
    operator()(const double first, const double second = 0.) const;

  private:
    std::array<Expression, 3> components;
  };
} // namespace Setae

#endif
