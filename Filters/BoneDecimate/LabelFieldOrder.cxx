// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "LabelFieldOrder.h"

#include "LabelMapArrays.h"

#include "vtkAbstractArray.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"

namespace bonedecimate
{
namespace
{
void AppendEmptyRow(vtkAbstractArray* array)
{
  if (auto* numbers = vtkDataArray::SafeDownCast(array))
  {
    const std::vector<double> zeros(
      static_cast<std::size_t>(numbers->GetNumberOfComponents()), 0.0);
    numbers->InsertNextTuple(zeros.data());
  }
  else if (auto* texts = vtkStringArray::SafeDownCast(array))
  {
    texts->InsertNextValue("");
  }
}

/// The rows of the array for the values, which are numbered in ofRows.
void AddOrdered(vtkAbstractArray* array, vtkDataArray* ofRows,
  const std::vector<std::int64_t>& values, vtkFieldData* output)
{
  const auto ordered = vtkSmartPointer<vtkAbstractArray>::Take(array->NewInstance());
  ordered->SetName(array->GetName());
  ordered->SetNumberOfComponents(array->GetNumberOfComponents());
  for (const std::int64_t value : values)
  {
    vtkIdType row = 0;
    while (row < ofRows->GetNumberOfTuples() && LabelIn(ofRows, row, 0) != value)
    {
      ++row;
    }
    if (row < ofRows->GetNumberOfTuples())
    {
      ordered->InsertNextTuple(row, array);
    }
    else
    {
      AppendEmptyRow(ordered);
    }
  }
  output->AddArray(ordered);
}
}

//------------------------------------------------------------------------------
void OrderLabelFields(vtkFieldData* image, const LabelMapSource& source, vtkFieldData* output)
{
  vtkDataArray* values = image->GetArray(LabelValuesName);
  if (!values || values->GetNumberOfComponents() != 1)
  {
    return;
  }
  for (const char* name : { "LabelNames", "LabelColors" })
  {
    vtkAbstractArray* array = image->GetAbstractArray(name);
    if (array && array->GetNumberOfTuples() == values->GetNumberOfTuples())
    {
      AddOrdered(array, values, source.Values, output);
    }
  }
}
}
