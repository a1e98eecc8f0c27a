// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_base_entries_h
#define setae_base_entries_h

#include <deal.II/base/parameter_handler.h>

#include <setae/base/expression.h>

#include <type_traits>

namespace Setae
{
  /**
   * The pattern of an entry whose numbers may be formulas of constants. A
   * formula matches if its value does.
   */
  class NumberPattern : public dealii::Patterns::PatternBase
  {
  public:
    /** @param values The pattern of a number or of a list of numbers. */
    NumberPattern(const dealii::Patterns::PatternBase &values,
                  const Constants                     &constants);

    bool
    match(const std::string &text) const override;

    std::string
    description(const OutputStyle style = Machine) const override;

    std::unique_ptr<dealii::Patterns::PatternBase>
    clone() const override;

    /** @throws ExcParameter if @p text has a formula that cannot be evaluated.
     */
    std::vector<double>
    values(const std::string &text) const;

  private:
    std::unique_ptr<dealii::Patterns::PatternBase> pattern;
    Constants                                      constants;
    bool                                           is_list, is_integer;
  };



  /**
   * ParameterHandler with numbers that may be formulas: whatever adds a number
   * or a list of numbers to it reads '2*R' as well as '0.04', under the same
   * pattern. What is printed are the formulas.
   */
  class Entries : public dealii::ParameterHandler
  {
  public:
    /** The names that may stand in the numbers that are added next. */
    Constants constants;

    /** Where the texts of the numbers that are added next are kept, if any. */
    std::map<std::string, std::string> *texts = nullptr;

    /** As ParameterHandler::add_parameter. */
    template <typename Value>
    void
    add_parameter(const std::string                   &entry,
                  Value                               &value,
                  const std::string                   &documentation,
                  const dealii::Patterns::PatternBase &pattern =
                    *dealii::Patterns::Tools::Convert<Value>::to_pattern())
    {
      if constexpr (is_number<Value> || is_list_of_numbers<Value>::value)
        {
          const NumberPattern numbers(pattern, constants);
          declare_entry(
            entry,
            dealii::Patterns::Tools::Convert<Value>::to_string(value, pattern),
            numbers,
            documentation);
          add_action(
            entry,
            [&value,
             texts   = this->texts,
             numbers = std::shared_ptr<PatternBase>(numbers.clone()),
             entry](const std::string &text) {
              assign(static_cast<const NumberPattern &>(*numbers).values(text),
                     value);
              if (texts != nullptr)
                (*texts)[entry] = text;
            });
        }
      else
        ParameterHandler::add_parameter(entry, value, documentation, pattern);
    }

  private:
    using PatternBase = dealii::Patterns::PatternBase;

    template <typename Value>
    static constexpr bool is_number =
      std::is_arithmetic_v<Value> && !std::is_same_v<Value, bool>;

    template <typename Value>
    struct is_list_of_numbers : std::false_type
    {};

    template <typename Value>
    struct is_list_of_numbers<std::vector<Value>>
      : std::bool_constant<is_number<Value>>
    {};

    template <typename Value>
    static void
    assign(const std::vector<double> &numbers, Value &value)
    {
      if constexpr (is_number<Value>)
        value = static_cast<Value>(numbers.at(0));
      else
        value.assign(numbers.begin(), numbers.end());
    }
  };
} // namespace Setae

#endif
