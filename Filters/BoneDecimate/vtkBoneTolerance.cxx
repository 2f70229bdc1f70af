// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkBoneTolerance.h"

#include "CellVisits.h"
#include "NamedArrays.h"
#include "PointChoice.h"
#include "RejectedValues.h"
#include "Run/Input/FeaturePoints.h"
#include "SurfaceConversion.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkImplicitFunction.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSelection.h"

#include <algorithm>
#include <cmath>
#include <vector>

vtkStandardNewMacro(vtkBoneTolerance);
vtkCxxSetObjectMacro(vtkBoneTolerance, ImplicitFunction, vtkImplicitFunction);

//------------------------------------------------------------------------------
struct vtkBoneTolerance::Internals
{
  std::vector<int> Labels;
  bonedecimate::PointChoice Chosen; // of the run

  bool Counts(double value) const
  {
    return this->Labels.empty()
      ? value != 0.0
      : std::any_of(this->Labels.begin(), this->Labels.end(),
          [value](int label) { return value == static_cast<double>(label); });
  }
};

namespace
{
/// Negative is no limit.
bonedecimate::NumberRange ToleranceRange()
{
  return { -bonedecimate::MaxNumber, bonedecimate::MaxNumber, false, "mm" };
}

/// The id of the first value that is NaN or beyond 1e30 in absolute value; -1 if there is none.
vtkIdType FirstBadTolerance(vtkDataArray* tolerances)
{
  for (vtkIdType i = 0; i < tolerances->GetNumberOfTuples(); ++i)
  {
    if (!bonedecimate::IsInRange(ToleranceRange(), tolerances->GetComponent(i, 0)))
    {
      return i;
    }
  }
  return -1;
}

/// The smaller of two tolerances; a negative one limits nothing.
double SmallerOf(double a, double b)
{
  return a < 0.0 ? b : b < 0.0 ? a : std::min(a, b);
}

/// Whether there is one number for each of `count` points or cells.
bool HasOneForEach(vtkDataArray* array, vtkIdType count)
{
  return array && array->GetNumberOfComponents() == 1 && array->GetNumberOfTuples() == count;
}

/// The first cell with a point id out of range; -1 if there is none.
vtkIdType FirstBadCell(vtkPolyData* surface)
{
  vtkIdType bad = -1;
  vtkIdType firstCell = 0;
  for (vtkCellArray* cells :
    { surface->GetVerts(), surface->GetLines(), surface->GetPolys(), surface->GetStrips() })
  {
    const auto visit = [&](vtkIdType cell, vtkIdType npts, const vtkIdType* ids)
    {
      if (bad < 0 && bonedecimate::HasWrongId(npts, ids, surface->GetNumberOfPoints()))
      {
        bad = cell;
      }
    };
    bonedecimate::VisitCells(cells, firstCell, visit);
    firstCell += cells ? cells->GetNumberOfCells() : 0;
  }
  return bad;
}
}

vtkBoneTolerance::vtkBoneTolerance()
  : Internal(new Internals)
{
  this->SetNumberOfInputPorts(2);
}

vtkBoneTolerance::~vtkBoneTolerance()
{
  this->SetImplicitFunction(nullptr);
}

//------------------------------------------------------------------------------
void vtkBoneTolerance::SetChoice(int choice)
{
  this->Rejected().SetNumber(
    this, "Choice", { EVERYTHING, UNLIMITED, true, {} }, choice, this->Choice);
}

void vtkBoneTolerance::SetFoldAngle(double degrees)
{
  this->Rejected().SetNumber(
    this, "FoldAngle", { 0.0, 180.0, false, "degrees" }, degrees, this->FoldAngle);
}

void vtkBoneTolerance::SetInsideTolerance(double millimeters)
{
  this->Rejected().SetNumber(
    this, "InsideTolerance", ToleranceRange(), millimeters, this->InsideTolerance);
}

void vtkBoneTolerance::SetOutsideTolerance(double millimeters)
{
  this->Rejected().SetNumber(
    this, "OutsideTolerance", ToleranceRange(), millimeters, this->OutsideTolerance);
}

void vtkBoneTolerance::SetFeather(double millimeters)
{
  this->Rejected().SetNumber(
    this, "Feather", { 0.0, bonedecimate::MaxNumber, false, "mm" }, millimeters, this->Feather);
}

//------------------------------------------------------------------------------
void vtkBoneTolerance::AddLabel(int label)
{
  this->Internal->Labels.push_back(label);
  this->Modified();
}

void vtkBoneTolerance::RemoveAllLabels()
{
  if (!this->Internal->Labels.empty())
  {
    this->Internal->Labels.clear();
    this->Modified();
  }
}

int vtkBoneTolerance::GetNumberOfLabels() const
{
  return static_cast<int>(this->Internal->Labels.size());
}

int vtkBoneTolerance::GetLabel(int index) const
{
  return index >= 0 && index < this->GetNumberOfLabels()
    ? this->Internal->Labels[static_cast<std::size_t>(index)]
    : 0;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkBoneTolerance::GetMTime()
{
  const vtkMTimeType own = this->Superclass::GetMTime();
  return this->ImplicitFunction ? std::max(own, this->ImplicitFunction->GetMTime()) : own;
}

//------------------------------------------------------------------------------
int vtkBoneTolerance::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == 0)
  {
    return this->Superclass::FillInputPortInformation(port, info);
  }
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkSelection");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

//------------------------------------------------------------------------------
int vtkBoneTolerance::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (this->ReportRejectedValues())
  {
    return 0;
  }
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkDataObject* selection = vtkDataObject::GetData(inputVector[1]);
  const std::string problem = this->Problem(input, selection);
  if (!problem.empty())
  {
    vtkErrorMacro(<< problem);
    return 0;
  }
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  output->ShallowCopy(input);
  if (!this->Choose(input, selection))
  {
    vtkErrorMacro(<< "the implicit function is NaN at a point of the surface");
    output->Initialize();
    return 0;
  }
  this->Lower(output);
  return 1;
}

//------------------------------------------------------------------------------
/// What is missing; empty if nothing is.
std::string vtkBoneTolerance::Problem(vtkPolyData* input, vtkDataObject* selection) const
{
  const std::string& name = this->ChoiceArrayName;
  const std::string& result = this->ToleranceArrayName;
  if (this->Feather > 0.0 && (this->InsideTolerance < 0.0 || this->OutsideTolerance < 0.0))
  {
    return "a feather goes from one tolerance to another: neither may be negative (no limit)";
  }
  if (const vtkIdType bad = FirstBadCell(input); bad >= 0)
  {
    return "cell " + std::to_string(bad) + " has a point id out of range";
  }
  const vtkIdType points = input->GetNumberOfPoints();
  if (input->GetPointData()->HasArray(result.c_str()))
  {
    vtkDataArray* before = input->GetPointData()->GetArray(result.c_str());
    const bool suits = HasOneForEach(before, points);
    const vtkIdType bad = suits ? FirstBadTolerance(before) : -1;
    if (!suits || bad >= 0)
    {
      return "the point array '" + result + "' is there and " +
        (suits ? "its value of point " + std::to_string(bad) + " is NaN or beyond 1e30 mm"
               : "has not one number for each point");
    }
  }
  if (this->Choice == POINT_ARRAY &&
    !HasOneForEach(input->GetPointData()->GetArray(name.c_str()), points))
  {
    return "the input has no point array '" + name + "' of one number for each point (there are: " +
      bonedecimate::ListOfArrays(input->GetPointData()) + ")";
  }
  if (this->Choice == CELL_ARRAY &&
    !HasOneForEach(input->GetCellData()->GetArray(name.c_str()), input->GetNumberOfCells()))
  {
    return "the input has no cell array '" + name + "' of one number for each cell (there are: " +
      bonedecimate::ListOfArrays(input->GetCellData()) + ")";
  }
  if (this->Choice == SELECTION && !selection)
  {
    return "there is no selection on input port 1";
  }
  return this->Choice == IMPLICIT_FUNCTION && !this->ImplicitFunction
    ? "there is no implicit function"
    : "";
}

//------------------------------------------------------------------------------
/// False if the implicit function cannot tell.
bool vtkBoneTolerance::Choose(vtkPolyData* input, vtkDataObject* selection) const
{
  Internals& own = *this->Internal;
  const auto counts = [&own](double value) { return own.Counts(value); };
  const char* name = this->ChoiceArrayName.c_str();
  switch (this->Choice)
  {
    case POINT_ARRAY:
      own.Chosen =
        bonedecimate::ChoosePoints(input->GetPointData()->GetArray(name), counts, this->Inverted);
      break;
    case CELL_ARRAY:
      own.Chosen = bonedecimate::ChooseCells(
        input, input->GetCellData()->GetArray(name), counts, this->Inverted);
      break;
    case SELECTION:
      own.Chosen = bonedecimate::ChooseBySelection(
        input, vtkSelection::SafeDownCast(selection), this->Inverted);
      break;
    case IMPLICIT_FUNCTION:
      return this->ChooseByFunction(input);
    case FOLDS:
    case BOUNDARIES:
      this->ChooseLines(input);
      break;
    case UNLIMITED:
      this->ChooseUnlimited(input);
      break;
    default:
      own.Chosen.assign(static_cast<std::size_t>(input->GetNumberOfPoints()), !this->Inverted);
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkBoneTolerance::ChooseUnlimited(vtkPolyData* input) const
{
  vtkDataArray* before = input->GetPointData()->GetArray(this->ToleranceArrayName.c_str());
  const bool all = before == nullptr;
  this->Internal->Chosen.assign(
    static_cast<std::size_t>(input->GetNumberOfPoints()), all != this->Inverted);
  if (!all)
  {
    this->Internal->Chosen = bonedecimate::ChoosePoints(
      before, [](double tolerance) { return tolerance < 0.0; }, this->Inverted);
  }
}

//------------------------------------------------------------------------------
bool vtkBoneTolerance::ChooseByFunction(vtkPolyData* input) const
{
  bonedecimate::PointChoice& chosen = this->Internal->Chosen;
  chosen.clear();
  for (vtkIdType i = 0; i < input->GetNumberOfPoints(); ++i)
  {
    const double value = this->ImplicitFunction->FunctionValue(input->GetPoint(i));
    if (std::isnan(value))
    {
      return false;
    }
    chosen.push_back((value <= 0.0) != this->Inverted);
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkBoneTolerance::ChooseLines(vtkPolyData* input) const
{
  const bonedecimate::ConvertedSurface converted = bonedecimate::ToSurface(input, 1);
  bonedecimate::PointChoice& chosen = this->Internal->Chosen;
  chosen = this->Choice == BOUNDARIES ? bonedecimate::PointsOnBoundaries(converted.Surface)
                                      : bonedecimate::PointsOnFolds(converted.Surface,
                                          std::cos(vtkMath::RadiansFromDegrees(this->FoldAngle)));
  if (this->Inverted)
  {
    chosen.flip();
  }
}

//------------------------------------------------------------------------------
/// The array of the output: what this choice allows or, where that is less, what was there before.
void vtkBoneTolerance::Lower(vtkPolyData* output) const
{
  const bonedecimate::PointChoice& chosen = this->Internal->Chosen;
  const std::string& name = this->ToleranceArrayName;
  vtkDataArray* before = output->GetPointData()->GetArray(name.c_str());
  std::vector<double> distances; // mm
  if (this->Feather > 0.0)
  {
    distances = bonedecimate::DistancesToChosen(output, chosen, this->Feather);
  }
  vtkNew<vtkDoubleArray> tolerances;
  tolerances->SetName(name.c_str());
  tolerances->SetComponentName(0, "mm");
  tolerances->SetNumberOfTuples(output->GetNumberOfPoints());
  for (std::size_t i = 0; i < chosen.size(); ++i)
  {
    double tolerance = chosen[i] ? this->InsideTolerance : this->OutsideTolerance;
    if (!distances.empty())
    {
      const double ratio = distances[i] / this->Feather;
      tolerance = (1.0 - ratio) * this->InsideTolerance + ratio * this->OutsideTolerance;
    }
    const auto id = static_cast<vtkIdType>(i);
    tolerances->SetValue(
      id, before ? SmallerOf(before->GetComponent(id, 0), tolerance) : tolerance);
  }
  output->GetPointData()->AddArray(tolerances);
}

//------------------------------------------------------------------------------
void vtkBoneTolerance::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Choice: " << this->Choice << "\n";
  os << indent << "ChoiceArrayName: " << this->ChoiceArrayName << "\n";
  os << indent << "Labels:";
  for (const int label : this->Internal->Labels)
  {
    os << " " << label;
  }
  os << "\n";
  os << indent << "ImplicitFunction: " << this->ImplicitFunction << "\n";
  os << indent << "FoldAngle: " << this->FoldAngle << " degrees\n";
  os << indent << "Inverted: " << this->Inverted << "\n";
  os << indent << "InsideTolerance: " << this->InsideTolerance << " mm\n";
  os << indent << "OutsideTolerance: " << this->OutsideTolerance << " mm\n";
  os << indent << "Feather: " << this->Feather << " mm\n";
  os << indent << "ToleranceArrayName: " << this->ToleranceArrayName << "\n";
}
