// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Options/OptionTable.h"
#include "RejectionWalk.h"
#include "VtkSurfaces.h"

#include "vtkBoneDecimate.h"
#include "vtkBoneDecimateLevels.h"
#include "vtkBoneErrorSearch.h"
#include "vtkNew.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <sstream>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
/// A numeric property of the filter by the name that the table has for it.
struct Number
{
  std::string Name;
  std::function<void(vtkBoneDecimate*, double)> Set;
  std::function<double(vtkBoneDecimate*)> Get;
};

struct Text
{
  std::string Name;
  std::function<void(vtkBoneDecimate*, const std::string&)> Set;
  std::function<std::string(vtkBoneDecimate*)> Get;
};

struct PropertyLists
{
  template <typename Class, typename Value>
  void Add(const char* name, void (Class::*set)(Value), Value (Class::*get)() const)
  {
    this->Numbers.push_back({ name,
      [set](vtkBoneDecimate* filter, double value) { (filter->*set)(static_cast<Value>(value)); },
      [get](vtkBoneDecimate* filter) { return static_cast<double>((filter->*get)()); } });
  }

  template <typename Class>
  void Add(
    const char* name, void (Class::*set)(const std::string&), std::string (Class::*get)() const)
  {
    this->Texts.push_back(
      { name, [set](vtkBoneDecimate* filter, const std::string& text) { (filter->*set)(text); },
        [get](vtkBoneDecimate* filter) { return (filter->*get)(); } });
  }

  std::vector<Number> Numbers;
  std::vector<Text> Texts;
};

/// The Set and Get methods of each row: it does not compile if one is missing.
const PropertyLists& Properties()
{
  static const PropertyLists properties = []
  {
    PropertyLists lists;
#define BONEDECIMATE_OPTION(Type, Name, Default, Traits, Sentence)                                 \
  lists.Add(#Name, &vtkBoneDecimate::Set##Name, &vtkBoneDecimate::Get##Name);
#include "Options/OptionRows.def"
#undef BONEDECIMATE_OPTION
    return lists;
  }();
  return properties;
}

const std::vector<Number>& Numbers()
{
  return Properties().Numbers;
}

const std::vector<Text>& Texts()
{
  return Properties().Texts;
}

const OptionInfo& Row(const std::string& name)
{
  return *FindOption(name);
}

bool IsSwitch(const OptionInfo& info)
{
  return std::holds_alternative<bool>(GetOption(Options{}, info));
}

double DefaultOf(const OptionInfo& info)
{
  const OptionValue value = GetOption(Options{}, info);
  if (const bool* on = std::get_if<bool>(&value))
  {
    return *on ? 1.0 : 0.0;
  }
  const int* whole = std::get_if<int>(&value);
  return whole ? *whole : std::get<double>(value);
}

/// Within the range and not the default; the default itself where there is no other.
double AnotherValue(const OptionInfo& info)
{
  if (std::string(info.Name) == "KeepVoxels")
  {
    return 0.0; // On needs the grid of a label map
  }
  const double value = DefaultOf(info);
  const double less =
    std::holds_alternative<double>(GetOption(Options{}, info)) ? value / 2 : value - 1;
  return value > info.Minimum ? less : std::min(info.Maximum, value + 1);
}

std::string Printed(vtkBoneDecimate* filter)
{
  std::ostringstream stream;
  filter->Print(stream);
  return stream.str();
}
}

TEST(Properties, AreReadAndSetByTheirNames)
{
  const vtkNew<vtkBoneDecimate> filter;
  for (const OptionInfo& info : OptionTable())
  {
    ASSERT_TRUE(filter->HasOption(info.Name)) << info.Name;
    EXPECT_EQ(filter->GetOptionAsText(info.Name), OptionText(Options{}, info)) << info.Name;
  }
  EXPECT_TRUE(filter->SetOptionFromText("MaximumError", "0.5"));
  EXPECT_EQ(filter->GetMaximumError(), 0.5);
  ErrorTexts errors(filter);
  EXPECT_FALSE(filter->SetOptionFromText("MaximumError", "-1"));
  EXPECT_EQ(filter->GetMaximumError(), 0.5);
  EXPECT_FALSE(filter->SetOptionFromText("NoSuchOption", "1"));
  EXPECT_EQ(errors.Texts.size(), 2U);
}

TEST(Properties, OfLevelsAndSearchesAreThoseThatTheyUse)
{
  const vtkNew<vtkBoneDecimateLevels> levels;
  const vtkNew<vtkBoneErrorSearch> search;
  for (const char* name :
    { "Mode", "TargetNumberOfTriangles", "ToleranceArrayName", "LabelArrayName" })
  {
    EXPECT_TRUE(levels->HasOption(name) && search->HasOption(name)) << name;
  }
  for (const char* name : { "PruneSize", "MakeMaps" })
  {
    EXPECT_FALSE(levels->HasOption(name) || search->HasOption(name)) << name;
  }
  EXPECT_TRUE(levels->HasOption("MaximumError"));
  EXPECT_FALSE(search->HasOption("MaximumError"));
}

TEST(Properties, HaveTheDefaultsOfTheTable)
{
  vtkNew<vtkBoneDecimate> filter;
  for (const Number& number : Numbers())
  {
    EXPECT_EQ(number.Get(filter), DefaultOf(Row(number.Name))) << number.Name;
  }
  for (const Text& text : Texts())
  {
    EXPECT_EQ(text.Get(filter), std::get<std::string>(GetOption(Options{}, Row(text.Name))));
  }
}

TEST(Properties, HaveTheDefaultsOfTheirDocumentation)
{
  vtkNew<vtkBoneDecimate> filter;
  EXPECT_EQ(filter->GetMode(), vtkBoneDecimate::BALANCED);
  EXPECT_EQ(filter->GetTargetNumberOfTriangles(), 0);
  EXPECT_EQ(filter->GetTargetReduction(), 0.9);
  EXPECT_EQ(filter->GetMaximumError(), 0.0);
  EXPECT_FALSE(filter->GetAllowLargeError());
  EXPECT_TRUE(filter->GetIntersectionGuard());
  EXPECT_EQ(filter->GetNormalTolerance(), 0.95);
  EXPECT_TRUE(filter->GetMergePoints());
  EXPECT_TRUE(filter->GetMeasureDistances());
  EXPECT_FALSE(filter->GetMeasureInputDistances());
  EXPECT_TRUE(filter->GetProveResult());
  EXPECT_FALSE(filter->GetDiagnoseInput());
  EXPECT_EQ(filter->GetPruneSize() + filter->GetPruneArea() + filter->GetPruneVolume(), 0.0);
  EXPECT_EQ(filter->GetPruneTriangles(), 0);
  EXPECT_EQ(filter->GetTunnelSize(), 0.0);
  EXPECT_EQ(filter->GetNumberOfThreads(), 0);
  EXPECT_EQ(filter->GetOutputPointsPrecision(), vtkAlgorithm::DEFAULT_PRECISION);
}

TEST(Properties, KeepTheirValues)
{
  vtkNew<vtkBoneDecimate> filter;
  for (const Number& number : Numbers())
  {
    const double value = AnotherValue(Row(number.Name));
    number.Set(filter, value);
    EXPECT_EQ(number.Get(filter), value) << number.Name;
  }
  for (const Text& text : Texts())
  {
    text.Set(filter, text.Name + " of mine");
    EXPECT_EQ(text.Get(filter), text.Name + " of mine");
  }
}

TEST(Properties, ValuesOutsideTheirRangeAreRejectedUntilThereIsAValidOne)
{
  for (const Number& number : Numbers())
  {
    const OptionInfo& info = Row(number.Name);
    if (IsSwitch(info))
    {
      continue; // a bool is on or off
    }
    const bool isWhole = std::holds_alternative<int>(GetOption(Options{}, info));
    const vtkNew<vtkBoneDecimate> held;
    vtkBoneDecimate* filter = held;
    filter->SetInputData(Sphere(1));
    filter->MeasureDistancesOff();
    ExpectRejections(filter,
      { number.Name, AnotherValue(info),
        isWhole ? IntegersOutside(static_cast<int>(info.Minimum), static_cast<int>(info.Maximum))
                : NumbersOutside(info.Minimum, info.Maximum),
        [&](double value) { number.Set(filter, value); }, [&] { return number.Get(filter); },
        [&](const std::string& name) { return filter->GetRejectedValue(name); } });
  }
}

TEST(Properties, BothEndsOfTheirRangeAreValid)
{
  vtkNew<vtkBoneDecimate> filter;
  for (const Number& number : Numbers())
  {
    const OptionInfo& info = Row(number.Name);
    for (const double end : { info.Minimum, info.Maximum })
    {
      number.Set(filter, end);
      EXPECT_EQ(number.Get(filter), end) << number.Name;
      EXPECT_EQ(filter->GetRejectedValue(number.Name), "") << number.Name;
    }
  }
}

TEST(Properties, AnotherPropertyDoesNotMendARejectedOne)
{
  vtkNew<vtkBoneDecimate> filter;
  ErrorTexts errors(filter);
  filter->SetInputData(Sphere(1));
  filter->SetMaximumError(-1.0);
  filter->SetMode(17);
  filter->SetTargetReduction(0.5);
  filter->SetModeToFast();
  errors.Texts.clear();
  filter->Update();
  EXPECT_EQ(errors.Texts.size(), 1U);
  EXPECT_EQ(errors.Count("MaximumError takes a number from 0 to 1e30 mm, not -1"), 1);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
}

TEST(Properties, MarkTheFilterModifiedOnlyWhenTheyChange)
{
  vtkNew<vtkBoneDecimate> filter;
  // Setting the default reduction makes it a requested one, which is a change.
  filter->SetTargetReduction(filter->GetTargetReduction());
  for (const Number& number : Numbers())
  {
    const vtkMTimeType before = filter->GetMTime();
    number.Set(filter, number.Get(filter));
    EXPECT_EQ(filter->GetMTime(), before) << number.Name << " set to what it was";
    const double other = AnotherValue(Row(number.Name));
    const bool isAnother = other != number.Get(filter);
    number.Set(filter, other);
    EXPECT_EQ(filter->GetMTime() > before, isAnother) << number.Name;
  }
  for (const Text& text : Texts())
  {
    const vtkMTimeType before = filter->GetMTime();
    text.Set(filter, text.Get(filter));
    EXPECT_EQ(filter->GetMTime(), before) << text.Name << " set to what it was";
    text.Set(filter, "another");
    EXPECT_GT(filter->GetMTime(), before) << text.Name;
  }
}

TEST(Properties, SwitchesHaveOnAndOff)
{
  vtkNew<vtkBoneDecimate> filter;
  filter->IntersectionGuardOff();
  EXPECT_FALSE(filter->GetIntersectionGuard());
  filter->IntersectionGuardOn();
  EXPECT_TRUE(filter->GetIntersectionGuard());
  filter->MergePointsOff();
  filter->MeasureDistancesOff();
  filter->MeasureInputDistancesOn();
  EXPECT_FALSE(filter->GetMergePoints());
  EXPECT_FALSE(filter->GetMeasureDistances());
  EXPECT_TRUE(filter->GetMeasureInputDistances());
  filter->MergePointsOn();
  filter->MeasureDistancesOn();
  filter->MeasureInputDistancesOff();
  EXPECT_TRUE(filter->GetMergePoints());
  EXPECT_TRUE(filter->GetMeasureDistances());
  EXPECT_FALSE(filter->GetMeasureInputDistances());
}

TEST(PrintSelf, PrintsEveryRowOfTheTableWithItsValueAndUnit)
{
  vtkNew<vtkBoneDecimate> filter;
  Options requested;
  for (const Number& number : Numbers())
  {
    const OptionInfo& info = Row(number.Name);
    number.Set(filter, AnotherValue(info));
    SetOptionFromText(requested, info,
      IsSwitch(info)           ? (AnotherValue(info) > 0 ? "on" : "off")
        : info.Choices.empty() ? std::to_string(AnotherValue(info))
                               : info.Choices[static_cast<std::size_t>(AnotherValue(info))]);
  }
  for (const OptionInfo& info : OptionTable())
  {
    const std::string unit = info.Unit.empty() ? "" : " " + info.Unit;
    const std::string line = info.Name + ": " + OptionText(requested, info) + unit + "\n";
    EXPECT_NE(Printed(filter).find(line), std::string::npos) << line << Printed(filter);
  }
}

TEST(PrintSelf, SaysWhyTheLastRunEnded)
{
  vtkNew<vtkBoneDecimate> filter;
  EXPECT_NE(Printed(filter).find(filter->GetStopReasonAsString()), std::string::npos);
}
