// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SentFields.h"

#include "LabelMaps/LabelFields.h"

#include "vtkDataArray.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"
#include "vtkVariant.h"

#include <cstdint>
#include <string>

namespace bonedecimate::volume
{
namespace
{
constexpr std::int64_t MostLabels = 1 << 20; // of what a damaged file can announce

struct ArrayShape
{
  std::int64_t Tuples = 0;
  int Components = 0; ///< 0: there is no array.
  int Type = VTK_DOUBLE;
};

void SendNumbers(vtkDataArray* array, Pipe& pipe)
{
  ArrayShape shape;
  if (array && array->GetNumberOfTuples() <= MostLabels && array->GetNumberOfComponents() <= 4)
  {
    shape = { array->GetNumberOfTuples(), array->GetNumberOfComponents(), array->GetDataType() };
  }
  pipe.Send(&shape, sizeof(shape));
  for (std::int64_t i = 0; i < shape.Tuples * shape.Components; ++i)
  {
    const std::int64_t label = array->GetVariantValue(i).ToTypeInt64();
    const double number =
      array->GetComponent(i / shape.Components, static_cast<int>(i % shape.Components));
    pipe.Send(&number, sizeof(number));
    pipe.Send(&label, sizeof(label));
  }
}

bool ReceiveNumbers(Pipe& pipe, const char* name, vtkFieldData* fields)
{
  ArrayShape shape;
  if (!pipe.Receive(&shape, sizeof(shape)))
  {
    return false;
  }
  if (shape.Components == 0)
  {
    return true;
  }
  const auto array = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(shape.Type));
  array->SetName(name);
  array->SetNumberOfComponents(shape.Components);
  array->SetNumberOfTuples(shape.Tuples);
  for (std::int64_t i = 0; i < shape.Tuples * shape.Components; ++i)
  {
    double number = 0.0;
    std::int64_t label = 0;
    if (!pipe.Receive(&number, sizeof(number)) || !pipe.Receive(&label, sizeof(label)))
    {
      return false;
    }
    array->SetComponent(i / shape.Components, static_cast<int>(i % shape.Components), number);
    const bool isReal = shape.Type == VTK_FLOAT || shape.Type == VTK_DOUBLE;
    if (!isReal)
    {
      array->SetVariantValue(i, vtkVariant(label)); // a double is not exact beyond 2^53
    }
  }
  fields->AddArray(array);
  return true;
}
}

void SendLabelFields(vtkFieldData* fields, Pipe& pipe)
{
  for (const char* name : LabelNumberNames)
  {
    SendNumbers(fields->GetArray(name), pipe);
  }
  auto* const names = vtkStringArray::SafeDownCast(fields->GetAbstractArray(LabelNamesName));
  const std::int64_t count =
    names && names->GetNumberOfValues() <= MostLabels ? names->GetNumberOfValues() : 0;
  pipe.Send(&count, sizeof(count));
  for (std::int64_t i = 0; i < count; ++i)
  {
    pipe.SendText(names->GetValue(i));
  }
}

bool ReceiveLabelFields(Pipe& pipe, vtkFieldData* fields)
{
  for (const char* name : LabelNumberNames)
  {
    if (!ReceiveNumbers(pipe, name, fields))
    {
      return false;
    }
  }
  std::int64_t count = 0;
  bool isComplete = pipe.Receive(&count, sizeof(count));
  const auto names = vtkSmartPointer<vtkStringArray>::New();
  names->SetName(LabelNamesName);
  for (std::int64_t i = 0; isComplete && i < count; ++i)
  {
    std::string text;
    isComplete = pipe.ReceiveText(text);
    names->InsertNextValue(text);
  }
  if (isComplete && count > 0)
  {
    fields->AddArray(names);
  }
  return isComplete;
}
}
