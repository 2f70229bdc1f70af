// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "OptionTable.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

using namespace bonedecimate;

namespace
{
const OptionInfo& Row(const std::string& name)
{
  const OptionInfo* info = FindOption(name);
  EXPECT_NE(info, nullptr) << name;
  return *info;
}

bool IsNumber(const OptionInfo& info)
{
  const OptionValue value = GetOption(Options{}, info);
  return info.Choices.empty() &&
    (std::holds_alternative<int>(value) || std::holds_alternative<double>(value));
}

/// A number as a value of the option's own kind.
OptionValue ValueOf(const OptionInfo& info, double number)
{
  if (std::holds_alternative<int>(GetOption(Options{}, info)))
  {
    return static_cast<int>(number);
  }
  return number;
}

/// A value other than the current one.
OptionValue AnotherValue(const Options& options, const OptionInfo& info)
{
  const OptionValue value = GetOption(options, info);
  if (const bool* on = std::get_if<bool>(&value))
  {
    return !*on;
  }
  if (const int* number = std::get_if<int>(&value))
  {
    return *number == static_cast<int>(info.Maximum) ? static_cast<int>(info.Minimum) : *number + 1;
  }
  if (const double* number = std::get_if<double>(&value))
  {
    return *number * 0.5 + 0.0625;
  }
  return std::get<std::string>(value) + "2";
}
}

TEST(OptionTable, HasEveryFieldOfOptionsExactlyOnce)
{
  // Setting any row changes what that row alone reads, so no two rows stand for one field; and the
  // sizes add up to those of the struct, so that a new field without a row is noticed.
  std::size_t bytes = sizeof(bool); // TargetReductionIsExplicit, which is not an option
  for (const OptionInfo& info : OptionTable())
  {
    bytes +=
      std::visit([](auto field) { return sizeof(std::declval<Options&>().*field); }, info.Field);
    if (info.Minimum == info.Maximum && !info.Choices.empty())
    {
      continue; // a choice of one
    }
    Options options;
    SetOption(options, info, AnotherValue(options, info));
    for (const OptionInfo& other : OptionTable())
    {
      EXPECT_EQ(GetOption(options, other) != GetOption(Options{}, other), other.Name == info.Name)
        << info.Name << " and " << other.Name;
    }
  }
  EXPECT_LE(bytes, sizeof(Options));
  EXPECT_LT(sizeof(Options) - bytes, sizeof(std::string)) << "a field of Options has no row";
}

TEST(OptionTable, NamesFlagsAndSentencesAreThereAndUnique)
{
  std::set<std::string> names;
  std::set<std::string> flags;
  for (const OptionInfo& info : OptionTable())
  {
    EXPECT_TRUE(names.insert(info.Name).second) << info.Name;
    EXPECT_TRUE(info.Flag.empty() || flags.insert(info.Flag).second) << info.Flag;
    ASSERT_FALSE(info.Sentence.empty()) << info.Name;
    EXPECT_EQ(info.Sentence.back(), '.') << info.Name;
    EXPECT_EQ(FindOption(info.Name), &info);
  }
  EXPECT_EQ(FindOption("NoSuchOption"), nullptr);
}

TEST(OptionTable, DefaultsAreThoseOfTheStructAndWithinTheRange)
{
  EXPECT_EQ(std::get<int>(GetOption(Options{}, Row("TargetNumberOfTriangles"))), 0);
  EXPECT_EQ(std::get<double>(GetOption(Options{}, Row("TargetReduction"))), 0.9);
  EXPECT_EQ(std::get<double>(GetOption(Options{}, Row("MaximumError"))), 0.0);
  EXPECT_EQ(std::get<double>(GetOption(Options{}, Row("NormalTolerance"))), 0.95);
  EXPECT_TRUE(std::get<bool>(GetOption(Options{}, Row("MergePoints"))));
  EXPECT_TRUE(std::get<bool>(GetOption(Options{}, Row("KeepClearance"))));
  EXPECT_TRUE(std::get<bool>(GetOption(Options{}, Row("MeasureDistances"))));
  EXPECT_FALSE(std::get<bool>(GetOption(Options{}, Row("MeasureInputDistances"))));
  for (const OptionInfo& info : OptionTable())
  {
    Options options;
    SetOption(options, info, GetOption(Options{}, info));
    EXPECT_EQ(GetOption(options, info), GetOption(Options{}, info)) << info.Name;
  }
}

TEST(OptionTable, NumbersAreClampedToTheirRange)
{
  for (const OptionInfo& info : OptionTable())
  {
    if (!IsNumber(info))
    {
      continue;
    }
    Options options;
    SetOption(options, info, ValueOf(info, -5.0));
    EXPECT_EQ(GetOption(options, info), ValueOf(info, info.Minimum)) << info.Name;
    SetOption(options, info, ValueOf(info, info.Maximum));
    EXPECT_EQ(GetOption(options, info), ValueOf(info, info.Maximum)) << info.Name;
    if (info.Maximum <= 1024.0)
    {
      SetOption(options, info, ValueOf(info, info.Maximum + 5.0));
      EXPECT_EQ(GetOption(options, info), ValueOf(info, info.Maximum)) << info.Name;
    }
  }
}

TEST(OptionTable, InfinityIsClampedAndNotANumberBecomesTheDefault)
{
  Options options;
  SetOption(options, Row("MaximumError"), std::numeric_limits<double>::infinity());
  EXPECT_TRUE(std::isfinite(options.MaximumError));
  SetOption(options, Row("TargetReduction"), -std::numeric_limits<double>::infinity());
  EXPECT_EQ(options.TargetReduction, 0.0);
  SetOption(options, Row("TargetReduction"), std::nan(""));
  EXPECT_EQ(options.TargetReduction, Options{}.TargetReduction);
}

TEST(OptionTable, ChoicesAreClampedToWhatThereIs)
{
  Options options;
  SetOption(options, Row("Mode"), 7);
  EXPECT_EQ(options.Mode, Mode::Accurate);
  SetOption(options, Row("OutputPointsPrecision"), -3);
  EXPECT_EQ(options.OutputPointsPrecision, PointsPrecision::Single);
  SetOption(options, Row("OutputPointsPrecision"), 12);
  EXPECT_EQ(options.OutputPointsPrecision, PointsPrecision::Default);
}

TEST(OptionTable, ValuesSurviveTheWayThroughText)
{
  for (const OptionInfo& info : OptionTable())
  {
    Options changed;
    SetOption(changed, info, AnotherValue(changed, info));
    Options read;
    EXPECT_EQ(SetOptionFromText(read, info, OptionText(changed, info)), "") << info.Name;
    EXPECT_EQ(GetOption(read, info), GetOption(changed, info)) << info.Name;
  }
}

TEST(OptionTable, DecimalsReadBackTheSameBitForBit)
{
  for (const double value : { 0.1, 1.0 / 3.0, 5e-324, 1.7976931348623157e308, 123456789.125 })
  {
    Options options;
    options.MaximumError = value;
    Options read;
    EXPECT_EQ(
      SetOptionFromText(read, Row("MaximumError"), OptionText(options, Row("MaximumError"))), "");
    EXPECT_EQ(read.MaximumError, value);
  }
  Options options;
  EXPECT_EQ(OptionText(options, Row("TargetReduction")), "0.9");
}

TEST(OptionTable, TextThatIsWrongIsRefusedWithTheNameAndChangesNothing)
{
  const std::vector<std::pair<std::string, std::string>> wrong = { { "MaximumError", "-1" },
    { "MaximumError", "nan" }, { "MaximumError", "inf" }, { "MaximumError", "" },
    { "MaximumError", "1 mm" }, { "TargetReduction", "1.5" }, { "TargetReduction", "ninety" },
    { "TargetNumberOfTriangles", "2.5" }, { "TargetNumberOfTriangles", "3000000000" },
    { "NumberOfThreads", "1025" }, { "MergePoints", "maybe" }, { "Mode", "Magic" }, { "Mode", "" },
    { "OutputPointsPrecision", "2" } };
  for (const auto& [name, text] : wrong)
  {
    Options options;
    const std::string complaint = SetOptionFromText(options, Row(name), text);
    EXPECT_NE(complaint.find(name), std::string::npos) << name << " '" << text << "'";
    EXPECT_EQ(GetOption(options, Row(name)), GetOption(Options{}, Row(name))) << name;
    EXPECT_FALSE(options.TargetReductionIsExplicit);
  }
}

TEST(OptionTable, SwitchesAndChoicesReadInAnyCase)
{
  Options options;
  EXPECT_EQ(SetOptionFromText(options, Row("MergePoints"), "OFF"), "");
  EXPECT_FALSE(options.MergePoints);
  EXPECT_EQ(SetOptionFromText(options, Row("MergePoints"), "True"), "");
  EXPECT_TRUE(options.MergePoints);
  EXPECT_EQ(SetOptionFromText(options, Row("OutputPointsPrecision"), "double"), "");
  EXPECT_EQ(options.OutputPointsPrecision, PointsPrecision::Double);
}

TEST(OptionTable, OnlySettingTheReductionMakesItExplicit)
{
  for (const OptionInfo& info : OptionTable())
  {
    Options options;
    SetOption(options, info, GetOption(options, info));
    EXPECT_EQ(options.TargetReductionIsExplicit, info.Name == "TargetReduction") << info.Name;
  }
}

TEST(OptionTable, MarkdownHasOneLineForEachOption)
{
  const std::string page = OptionTableMarkdown();
  std::size_t lines = 0;
  for (const char c : page)
  {
    lines += c == '\n' ? 1 : 0;
  }
  EXPECT_EQ(lines, OptionTable().size() + 2);
  for (const OptionInfo& info : OptionTable())
  {
    EXPECT_NE(page.find("| `" + info.Name + "` |"), std::string::npos) << info.Name;
    EXPECT_NE(page.find(info.Sentence), std::string::npos) << info.Name;
  }
}
