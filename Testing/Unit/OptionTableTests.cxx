// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Options/OptionTable.h"

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

/// Values of the option's own kind that it must reject, and one of another kind.
std::vector<OptionValue> ValuesOutside(const OptionInfo& info)
{
  const OptionValue value = GetOption(Options{}, info);
  std::vector<OptionValue> bad = { std::holds_alternative<bool>(value) ? OptionValue(2)
                                                                       : OptionValue(true) };
  if (std::holds_alternative<double>(value))
  {
    using ErrorLimits = std::numeric_limits<double>;
    bad.insert(bad.end(),
      { ErrorLimits::quiet_NaN(), ErrorLimits::infinity(), -ErrorLimits::infinity(),
        -ErrorLimits::max(), ErrorLimits::max(), std::nextafter(info.Minimum, -1.0),
        std::nextafter(info.Maximum, ErrorLimits::infinity()) });
  }
  if (std::holds_alternative<int>(value))
  {
    bad.insert(bad.end(), { std::numeric_limits<int>::min(), static_cast<int>(info.Minimum) - 1 });
    if (info.Maximum < std::numeric_limits<int>::max())
    {
      bad.insert(
        bad.end(), { std::numeric_limits<int>::max(), static_cast<int>(info.Maximum) + 1 });
    }
  }
  return bad;
}
}

TEST(OptionTable, RowsSetNoFieldButTheirOwn)
{
  for (const OptionInfo& info : OptionTable())
  {
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
  EXPECT_TRUE(std::get<bool>(GetOption(Options{}, Row("IntersectionGuard"))));
  EXPECT_TRUE(std::get<bool>(GetOption(Options{}, Row("MeasureDistances"))));
  EXPECT_FALSE(std::get<bool>(GetOption(Options{}, Row("MeasureInputDistances"))));
  for (const OptionInfo& info : OptionTable())
  {
    Options options;
    SetOption(options, info, GetOption(Options{}, info));
    EXPECT_EQ(GetOption(options, info), GetOption(Options{}, info)) << info.Name;
  }
}

TEST(OptionTable, RangesAreFinite)
{
  for (const OptionInfo& info : OptionTable())
  {
    EXPECT_LE(std::abs(info.Minimum), 1e30) << info.Name;
    EXPECT_LE(std::abs(info.Maximum), 1e30) << info.Name;
    EXPECT_LE(info.Minimum, info.Maximum) << info.Name;
  }
}

TEST(OptionTable, ValuesOutsideOfTheirRangeAreRejectedAndChangeNothing)
{
  for (const OptionInfo& info : OptionTable())
  {
    Options options;
    EXPECT_EQ(SetOption(options, info, AnotherValue(options, info)), "") << info.Name;
    const OptionValue before = GetOption(options, info);
    const bool wasExplicit = options.TargetReductionIsExplicit;
    for (const OptionValue& bad : ValuesOutside(info))
    {
      const std::string problem = SetOption(options, info, bad);
      EXPECT_EQ(problem.find(info.Name + " takes "), 0U) << info.Name << ": " << problem;
      EXPECT_EQ(CheckOption(info, bad), problem) << info.Name;
      EXPECT_EQ(GetOption(options, info), before) << info.Name << ": " << problem;
      EXPECT_EQ(options.TargetReductionIsExplicit, wasExplicit) << info.Name;
    }
  }
}

TEST(OptionTable, BothEndsOfARangeAreAccepted)
{
  for (const OptionInfo& info : OptionTable())
  {
    for (const double end : { info.Minimum, info.Maximum })
    {
      Options options;
      if (IsNumber(info) || !info.Choices.empty())
      {
        EXPECT_EQ(SetOption(options, info, ValueOf(info, end)), "") << info.Name;
        EXPECT_EQ(GetOption(options, info), ValueOf(info, end)) << info.Name;
      }
    }
  }
}

TEST(OptionTable, RejectedReductionsAreNotExplicit)
{
  Options options;
  EXPECT_NE(SetOption(options, Row("TargetReduction"), 1.5), "");
  EXPECT_FALSE(options.TargetReductionIsExplicit);
}

TEST(OptionTable, RejectionsAreOneSentenceWithRangeUnitAndValue)
{
  Options options;
  EXPECT_EQ(SetOption(options, Row("MaximumError"), -1.0),
    "MaximumError takes a number from 0 to 1e30 mm, not -1");
  EXPECT_EQ(SetOption(options, Row("MaximumError"), std::nan("")),
    "MaximumError takes a number from 0 to 1e30 mm, not NaN");
  EXPECT_EQ(SetOption(options, Row("MaximumError"), std::numeric_limits<double>::max()),
    "MaximumError takes a number from 0 to 1e30 mm, not 1.7976931348623157e308");
  EXPECT_EQ(SetOption(options, Row("TargetReduction"), -std::numeric_limits<double>::infinity()),
    "TargetReduction takes a number from 0 to 1, not -infinity");
  EXPECT_EQ(SetOption(options, Row("NumberOfThreads"), 1025),
    "NumberOfThreads takes a whole number from 0 to 1024 threads, not 1025");
  EXPECT_EQ(SetOption(options, Row("Mode"), 99),
    "Mode takes one of " + ModeNamesWhere([](const ModeInfo&) { return true; }) + ", not 99");
  EXPECT_EQ(SetOptionFromText(options, Row("MaximumError"), "-1"),
    "MaximumError takes a number from 0 to 1e30 mm, not -1");
  EXPECT_EQ(SetOptionFromText(options, Row("MaximumError"), "much"),
    "MaximumError takes a number from 0 to 1e30 mm, not 'much'");
  EXPECT_EQ(SetOptionFromText(options, Row("MergePoints"), "maybe"),
    "MergePoints takes on or off, not 'maybe'");
}

TEST(OptionTable, ValuesSurviveConversionToText)
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
  for (const double value : { 0.1, 1.0 / 3.0, 5e-324, 1e30, 123456789.125 })
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

TEST(OptionTable, InvalidTextIsRejectedWithTheNameAndChangesNothing)
{
  const std::vector<std::pair<std::string, std::string>> wrong = { { "MaximumError", "-1" },
    { "MaximumError", "nan" }, { "MaximumError", "inf" }, { "MaximumError", "" },
    { "MaximumError", "1 mm" }, { "MaximumError", "1e31" }, { "MaximumError", "1e999" },
    { "TargetReduction", "1.5" }, { "TargetReduction", "ninety" },
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
