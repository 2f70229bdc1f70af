// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RejectionWalk.h
 * @brief Sets hostile values of a property of any filter and looks at what becomes of them.
 */
#ifndef BoneDecimate_Testing_RejectionWalk_h
#define BoneDecimate_Testing_RejectionWalk_h

#include "vtkCommand.h"
#include "vtkExecutive.h"
#include "vtkPolyData.h"
#include "vtkPolyDataAlgorithm.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace bonedecimate::testsupport
{
/// A property of a filter.
struct CheckedProperty
{
  std::string Name;
  double Good; ///< A valid value, best another one than the default.
  std::vector<double> Bad;
  std::function<void(double)> Set;
  std::function<double()> Get;
  std::function<std::string(const std::string&)> GetRejectedValue;
};

/// NaN, infinities and what is next to both ends of a range.
inline std::vector<double> NumbersOutside(double least, double most)
{
  using Limits = std::numeric_limits<double>;
  return { Limits::quiet_NaN(), Limits::infinity(), -Limits::infinity(), -Limits::max(),
    Limits::max(), std::nextafter(least, -Limits::infinity()),
    std::nextafter(most, Limits::infinity()) };
}

/// Whole numbers that an int holds.
inline std::vector<double> IntegersOutside(int least, int most)
{
  using Limits = std::numeric_limits<int>;
  std::vector<double> bad = { static_cast<double>(Limits::min()), least - 1.0 };
  if (most < Limits::max())
  {
    bad.insert(bad.end(), { most + 1.0, static_cast<double>(Limits::max()) });
  }
  return bad;
}

/// The texts of a filter's error events.
class ErrorTexts
{
public:
  explicit ErrorTexts(vtkAlgorithm* filter)
    : Filter(filter)
  {
    filter->AddObserver(vtkCommand::ErrorEvent, this, &ErrorTexts::OnError);
    filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, this, &ErrorTexts::OnError);
  }

  int Count(const std::string& text) const
  {
    int count = 0;
    for (const std::string& message : this->Texts)
    {
      count += message.find(text) != std::string::npos ? 1 : 0;
    }
    return count;
  }

  std::vector<std::string> Texts;

private:
  void OnError(vtkObject* caller, unsigned long, void* text)
  {
    if (caller == this->Filter)
    {
      this->Texts.emplace_back(static_cast<const char*>(text));
    }
  }
  vtkAlgorithm* Filter;
};

/// The filter must have its inputs, and nothing may be wrong with it otherwise.
inline void ExpectRejections(vtkPolyDataAlgorithm* filter, const CheckedProperty& property)
{
  SCOPED_TRACE(property.Name);
  ErrorTexts errors(filter);
  property.Set(property.Good);
  for (const double bad : property.Bad)
  {
    SCOPED_TRACE(bad);
    errors.Texts.clear();
    property.Set(bad);
    const std::string sentence = property.GetRejectedValue(property.Name);
    EXPECT_EQ(sentence.find(property.Name + " takes "), 0U) << sentence;
    EXPECT_EQ(errors.Texts.size(), 1U);
    EXPECT_EQ(errors.Count(sentence), 1);
    EXPECT_EQ(property.Get(), property.Good) << "the value before stays";
    for (int times = 2; times < 4; ++times)
    {
      filter->Update();
      EXPECT_EQ(errors.Count(sentence), times) << "every update fails with the same sentence";
      EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
    }
    property.Set(property.Good);
    EXPECT_EQ(property.GetRejectedValue(property.Name), "");
    errors.Texts.clear();
    filter->Update();
    EXPECT_TRUE(errors.Texts.empty()) << errors.Texts.front();
    EXPECT_GT(filter->GetOutput()->GetNumberOfPoints(), 0) << "a valid value mends it";
  }
  filter->RemoveObservers(vtkCommand::ErrorEvent);
  filter->GetExecutive()->RemoveObservers(vtkCommand::ErrorEvent);
}
}

#endif
