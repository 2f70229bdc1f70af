// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RejectedValues.h
 * @brief Properties of a filter whose last value was outside the range: the filter fails to update
 * until they get another.
 */
#ifndef BoneDecimate_RejectedValues_h
#define BoneDecimate_RejectedValues_h

#include "Options/NumberRange.h"
#include "Options/OptionTable.h"

#include "vtkObject.h"
#include "vtkTimeStamp.h"

#include <map>
#include <string>

namespace bonedecimate
{
class RejectedValues
{
public:
  /// Notes what is wrong with a value of a property, in one sentence, as an error event of the
  /// filter; an empty sentence is a valid value.
  /// @returns Whether the value is valid.
  bool Check(vtkObject* filter, const std::string& property, const std::string& problem)
  {
    const bool wasRejected = this->Sentences.erase(property) > 0;
    if (!problem.empty())
    {
      this->Sentences[property] = problem;
      vtkErrorWithObjectMacro(filter, << problem);
    }
    if (wasRejected || !problem.empty())
    {
      filter->Modified(); // the next update must run: to fail, or not to fail any more
    }
    return problem.empty();
  }

  /// Gives a member its value, if that is valid.
  /// @returns Whether the member changed.
  template <typename Type>
  bool Set(vtkObject* filter, const char* property, const std::string& problem, const Type& value,
    Type& member)
  {
    const bool changes = this->Check(filter, property, problem) && member != value;
    if (changes)
    {
      member = value;
      filter->Modified();
    }
    return changes;
  }

  /// Sets a number that has a range of its own.
  template <typename Type>
  bool SetNumber(
    vtkObject* filter, const char* property, const NumberRange& range, Type value, Type& member)
  {
    return this->Set(filter, property, CheckNumber(property, range, value), value, member);
  }

  /// Sets a property that is an option of the table.
  template <typename Type>
  bool SetOption(vtkObject* filter, const char* property, Type value, Type& member)
  {
    return this->Set(filter, property, CheckOption(*FindOption(property), value), value, member);
  }

  /// The sentence of a property; empty if its last value was valid.
  std::string Of(const std::string& property) const
  {
    const auto found = this->Sentences.find(property);
    return found == this->Sentences.end() ? std::string() : found->second;
  }

  bool AreThere() const { return !this->Sentences.empty(); }

  /// An error event of the filter for each rejected value.
  /// @returns Whether there are any.
  bool Report(vtkObject* filter) const
  {
    for (const auto& rejected : this->Sentences)
    {
      vtkErrorWithObjectMacro(filter, << rejected.second);
    }
    return this->AreThere();
  }

  /// The time of change of the filter: now, as long as there is a rejected value. VTK does not run
  /// a filter again that failed and has not changed since, and the second update would fail
  /// silently.
  vtkMTimeType MTime(vtkMTimeType own) const
  {
    vtkTimeStamp now;
    now.Modified();
    return this->Sentences.empty() ? own : now.GetMTime();
  }

private:
  std::map<std::string, std::string> Sentences; // by property
};
}

#endif
