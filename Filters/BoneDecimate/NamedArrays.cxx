// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "NamedArrays.h"

#include "Base/Text.h"
#include "LabelArrays.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

namespace bonedecimate
{
namespace
{
std::optional<std::vector<double>> ReadNumbersNamed(
  const std::string& name, vtkPolyData* input, NamedArrays& arrays)
{
  if (name.empty())
  {
    return {};
  }
  std::optional<std::vector<double>> numbers =
    ReadNumbers(input->GetPointData()->GetArray(name.c_str()));
  if (!numbers && arrays.Problem.empty())
  {
    arrays.Problem = LackOfPointArray(input, " '" + name + "'");
  }
  return numbers;
}

void ReadLabelsNamed(const std::string& name, vtkPolyData* input, NamedArrays& arrays)
{
  arrays.LabelsOfCells = input->GetCellData()->GetArray(name.c_str());
  arrays.Labels = arrays.LabelsOfCells != nullptr
    ? ReadLabels(
        input, arrays.Converted, arrays.LabelsOfCells, vtkDataObject::FIELD_ASSOCIATION_CELLS)
    : ReadLabels(input, arrays.Converted, input->GetPointData()->GetArray(name.c_str()),
        vtkDataObject::FIELD_ASSOCIATION_POINTS);
  if (!arrays.Labels)
  {
    arrays.Problem = LackOfLabels(input, " '" + name + "'");
  }
}
}

RunInputs NamedArrays::Inputs() const
{
  RunInputs inputs;
  inputs.InputIsSingle = this->Converted.IsSingle;
  inputs.Tolerances = this->Tolerances ? &*this->Tolerances : nullptr;
  inputs.EdgeLengths = this->EdgeLengths ? &*this->EdgeLengths : nullptr;
  inputs.Labels = this->Labels ? &*this->Labels : nullptr;
  inputs.LeftOut = &this->Converted.LeftOut;
  return inputs;
}

//------------------------------------------------------------------------------
CellLabels NamedArrays::LabelsToCopy() const
{
  return this->LabelsOfCells != nullptr
    ? CellLabels{ this->LabelsOfCells, this->Converted.CellOfTriangle }
    : CellLabels();
}

//------------------------------------------------------------------------------
void CellLabels::Fill(const std::vector<Index>& triangles, vtkPolyData* surface) const
{
  if (!this->Array)
  {
    return;
  }
  const auto labels = vtkSmartPointer<vtkDataArray>::Take(this->Array->NewInstance());
  labels->SetName(this->Array->GetName());
  labels->SetNumberOfComponents(this->Array->GetNumberOfComponents());
  labels->SetNumberOfTuples(static_cast<vtkIdType>(triangles.size()));
  for (std::size_t i = 0; i < triangles.size(); ++i)
  {
    const auto triangle = static_cast<std::size_t>(triangles[i]);
    labels->SetTuple(static_cast<vtkIdType>(i), this->CellOfTriangle[triangle], this->Array);
  }
  surface->GetCellData()->AddArray(labels);
}

//------------------------------------------------------------------------------
std::string ListOfArrays(vtkFieldData* data)
{
  std::vector<std::string> names;
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* const array = data->GetAbstractArray(i);
    if (array->GetNumberOfComponents() == 1 && array->GetName() != nullptr)
    {
      names.emplace_back(array->GetName());
    }
  }
  return QuotedList(names);
}

//------------------------------------------------------------------------------
std::string LackOfPointArray(vtkPolyData* input, const std::string& name)
{
  return "the input has no point array" + name +
    " of one component (there are: " + ListOfArrays(input->GetPointData()) + ")";
}

//------------------------------------------------------------------------------
std::string LackOfLabels(vtkPolyData* input, const std::string& name)
{
  return "the input has no cell or point array" + name +
    " of whole numbers (of cells there are: " + ListOfArrays(input->GetCellData()) +
    "; of points: " + ListOfArrays(input->GetPointData()) + ")";
}

//------------------------------------------------------------------------------
NamedArrays ReadNamedArrays(vtkPolyData* input, const Options& options)
{
  NamedArrays arrays;
  arrays.Converted = ToSurface(input, options.NumberOfThreads);
  if (input->GetNumberOfPoints() == 0)
  {
    return arrays;
  }
  arrays.Tolerances = ReadNumbersNamed(options.ToleranceArrayName, input, arrays);
  arrays.EdgeLengths = ReadNumbersNamed(options.EdgeLengthArrayName, input, arrays);
  if (arrays.Problem.empty() && !options.LabelArrayName.empty())
  {
    ReadLabelsNamed(options.LabelArrayName, input, arrays);
  }
  return arrays;
}
}
