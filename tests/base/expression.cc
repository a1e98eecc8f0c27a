// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <gtest/gtest.h>

#include <setae/base/entries.h>
#include <setae/base/exceptions.h>

using namespace Setae;

namespace
{
  /** What the exception says, or nothing if there is none. */
  template <typename Action>
  std::string
  message_of(const Action &action)
  {
    try
      {
        action();
      }
    catch (const std::exception &exception)
      {
        return reason(exception);
      }
    return "";
  }

  std::string
  message_of_formula(const std::string &text, const double t = 0.)
  {
    return message_of([&] {
      Expression("loads/weight/force",
                 text,
                 "s,t",
                 {{"l", 5.}, {"i", 2.}, {"j", 0.}, {"k", 0.}})(.5, t);
    });
  }

  void
  expect_part(const std::string &text, const std::string &part)
  {
    EXPECT_NE(text.find(part), std::string::npos) << text;
  }
} // namespace



TEST(Expression, HasCommasBetweenArgumentsOnly)
{
  for (const std::string text : {"0,04*s", "(0,04)*s", "max(1, 2)*0,5", "1,"})
    expect_part(message_of_formula(text), "comma outside a function call");
  for (const std::string text :
       {"max(s, t)", "if (s < 1, max(s, (t + 1)), 2)", "(max(1, 2) + 3)*s"})
    EXPECT_EQ(message_of_formula(text), "");
}



TEST(Expression, ComparesAndDoesNotAssign)
{
  for (const std::string text : {"if(t=0.5, 1, 2)", "s = 3", "l=1"})
    expect_part(message_of_formula(text), "'==' compares");
  for (const std::string text :
       {"if(t == 0.5, 1, 2)", "s <= 1", "s >= l", "s != t", "s<1 && t>=0"})
    EXPECT_EQ(message_of_formula(text), "");
}



TEST(Expression, SaysWhereItIsNotFinite)
{
  const std::string message = message_of_formula("l/(t - 0.25)", .25);
  expect_part(message, "'loads/weight/force'");
  expect_part(message, "'l/(t - 0.25)'");
  expect_part(message, "is inf at s = 0.5, t = 0.25, i = 2, j = 0, k = 0");
  expect_part(message_of_formula("sqrt(-s)"), "is nan at s = 0.5");
}



TEST(Constants, MayHaveArgumentsButNoDecimalComma)
{
  const Constants constants =
    parse_constants("constants", "l = 5, R = max(l/250, 0.01), n = 2*l");
  EXPECT_EQ(constants.size(), 3u);
  EXPECT_EQ(constants.at("R"), .02);
  EXPECT_EQ(constants.at("n"), 10.);
  for (const std::string text : {"l = 0,5", "l", "l = 1, l = 2", "2l = 1"})
    EXPECT_NE(message_of([&] { parse_constants("constants", text); }), "")
      << text;
}



TEST(Entries, TakeAFormulaForANumberUnderTheSameBounds)
{
  double              length = 1.;
  unsigned int        cells  = 1;
  std::vector<double> prefactors;
  Entries             prm;
  prm.constants = {{"l", 5.}, {"k6", -2.}};
  using namespace dealii::Patterns;
  prm.add_parameter("length", length, "", Double(0.));
  prm.add_parameter("cells", cells, "", Integer(1));
  prm.add_parameter("prefactors", prefactors, "", List(Double(), 0));

  prm.set("length", std::string("2*l"));
  EXPECT_EQ(length, 10.);
  prm.set("length", std::string("1e-3"));
  EXPECT_EQ(length, 1e-3);
  prm.set("cells", std::string("l/0.1"));
  EXPECT_EQ(cells, 50u);
  prm.set("prefactors", std::string("k6, max(1, l), 3"));
  EXPECT_EQ(prefactors, (std::vector<double>{-2., 5., 3.}));
  prm.set("prefactors", std::string(""));
  EXPECT_TRUE(prefactors.empty());

  for (const std::string text : {"-l", "l*q", "0,5", "1/0", "nan", "inf", ""})
    EXPECT_NE(message_of([&] { prm.set("length", text); }), "") << text;
  for (const std::string text : {"l/2", "0*l", "2.5"})
    EXPECT_NE(message_of([&] { prm.set("cells", text); }), "") << text;
}
