// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkBoneErrorSearch.h"

#include "ErrorSearch.h"
#include "FilterProgress.h"
#include "RejectedValues.h"
#include "SurfaceConversion.h"

#include "vtkDoubleArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkTable.h"
#include "vtkTypeInt64Array.h"

#include <limits>

vtkStandardNewMacro(vtkBoneErrorSearch);

namespace
{
template <typename Array, typename Get>
void AddColumn(vtkTable* table, const char* name, const char* unit,
  const std::vector<bonedecimate::ErrorTrial>& trials, const Get& get)
{
  vtkNew<Array> column;
  column->SetName(name);
  column->SetComponentName(0, unit);
  for (const bonedecimate::ErrorTrial& trial : trials)
  {
    column->InsertNextValue(get(trial));
  }
  table->AddColumn(column);
}

void FillTable(const std::vector<bonedecimate::ErrorTrial>& trials, vtkTable* table)
{
  using Trial = bonedecimate::ErrorTrial;
  AddColumn<vtkDoubleArray>(
    table, "MaximumError", "mm", trials, [](const Trial& t) { return t.MaximumError; });
  AddColumn<vtkTypeInt64Array>(
    table, "Triangles", "triangles", trials, [](const Trial& t) { return t.Triangles; });
  AddColumn<vtkDoubleArray>(
    table, "ProvedError", "mm", trials, [](const Trial& t) { return t.Proved; });
  AddColumn<vtkTypeInt64Array>(
    table, "Reached", "", trials, [](const Trial& t) { return t.IsReached ? 1 : 0; });
  AddColumn<vtkDoubleArray>(
    table, "Seconds", "s", trials, [](const Trial& t) { return t.Seconds; });
}
}

//------------------------------------------------------------------------------
vtkBoneErrorSearch::vtkBoneErrorSearch()
  : SmallestError(std::numeric_limits<double>::quiet_NaN())
  , Rejected(new bonedecimate::RejectedValues)
{
  this->SetNumberOfOutputPorts(2);
}

vtkBoneErrorSearch::~vtkBoneErrorSearch() = default;

//------------------------------------------------------------------------------
void vtkBoneErrorSearch::SetMode(int mode)
{
  const std::string problem = bonedecimate::CheckOption(*bonedecimate::FindOption("Mode"), mode);
  const bool isThesis = mode == static_cast<int>(bonedecimate::Mode::Thesis);
  this->Rejected->Set(this, "Mode",
    isThesis ? "Mode takes one of Fast, Balanced, Accurate, not Thesis, which proves nothing"
             : problem,
    mode, this->Mode);
}

//------------------------------------------------------------------------------
void vtkBoneErrorSearch::SetTargetNumberOfTriangles(int triangles)
{
  this->Rejected->SetOption(
    this, "TargetNumberOfTriangles", triangles, this->TargetNumberOfTriangles);
}

//------------------------------------------------------------------------------
void vtkBoneErrorSearch::SetRelativePrecision(double share)
{
  this->Rejected->SetNumber(
    this, "RelativePrecision", { 0.001, 0.5 }, share, this->RelativePrecision);
}

//------------------------------------------------------------------------------
void vtkBoneErrorSearch::SetNumberOfThreads(int threads)
{
  this->Rejected->SetOption(this, "NumberOfThreads", threads, this->NumberOfThreads);
}

//------------------------------------------------------------------------------
std::string vtkBoneErrorSearch::GetRejectedValue(const std::string& property) const
{
  return this->Rejected->Of(property);
}

vtkMTimeType vtkBoneErrorSearch::GetMTime()
{
  return this->Rejected->MTime(this->Superclass::GetMTime());
}

//------------------------------------------------------------------------------
void vtkBoneErrorSearch::AddError(double millimetres)
{
  const bonedecimate::NumberRange range = { 0.0, bonedecimate::LargestNumber, false, "mm" };
  if (millimetres > 0.0 && bonedecimate::IsInRange(range, millimetres))
  {
    this->Errors.push_back(millimetres);
    this->Modified();
  }
  else
  {
    this->Rejected->Check(this, "Error",
      "Error takes a number above 0 and at most 1e30 mm, not " +
        bonedecimate::NumberText(millimetres));
  }
}

//------------------------------------------------------------------------------
void vtkBoneErrorSearch::RemoveAllErrors()
{
  this->Rejected->Check(this, "Error", {});
  if (!this->Errors.empty())
  {
    this->Errors.clear();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkTable* vtkBoneErrorSearch::GetTrials()
{
  return vtkTable::SafeDownCast(this->GetOutputDataObject(1));
}

//------------------------------------------------------------------------------
int vtkBoneErrorSearch::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 1 ? "vtkTable" : "vtkPolyData");
  return 1;
}

//------------------------------------------------------------------------------
int vtkBoneErrorSearch::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (this->Rejected->Report(this))
  {
    return 0;
  }
  if (this->Errors.empty() && this->TargetNumberOfTriangles == 0)
  {
    vtkErrorMacro(<< "neither a number of triangles nor errors were given");
    return 0;
  }
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  const bonedecimate::ConvertedSurface converted =
    bonedecimate::ToSurface(input, this->NumberOfThreads);
  bonedecimate::ErrorSearchOptions options;
  options.Run.Mode = static_cast<bonedecimate::Mode>(this->Mode);
  options.Run.TargetNumberOfTriangles = this->TargetNumberOfTriangles;
  options.Run.NumberOfThreads = this->NumberOfThreads;
  options.Run.AllowLargeError = this->AllowLargeError;
  options.RelativePrecision = this->RelativePrecision;
  options.InputIsSingle = converted.IsSingle;
  const auto monitor = [this](double fraction) { return bonedecimate::GoesOn(*this, fraction); };
  const bonedecimate::ErrorSearchResult found = this->Errors.empty()
    ? bonedecimate::FindSmallestError(converted.Surface, options, monitor)
    : bonedecimate::FindErrorCurve(converted.Surface, this->Errors, options, monitor);
  const std::string problem = bonedecimate::InputMessage(found.Found.Report);
  if (!problem.empty())
  {
    vtkErrorMacro(<< problem);
    return 0;
  }
  for (const std::string& warning : bonedecimate::InputWarnings(found.Found.Report))
  {
    vtkWarningMacro(<< warning);
  }
  this->SmallestError = found.Best < 0 ? std::numeric_limits<double>::quiet_NaN()
                                       : found.Trials[static_cast<std::size_t>(found.Best)].Proved;
  this->ErrorTriedInVain = found.TriedInVain;
  bonedecimate::FillOutput(found.Found, converted, options.Run, converted.IsSingle, input,
    vtkPolyData::GetData(outputVector, 0));
  FillTable(found.Trials, vtkTable::GetData(outputVector, 1));
  return 1;
}

//------------------------------------------------------------------------------
void vtkBoneErrorSearch::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Mode: " << this->Mode << "\n";
  os << indent << "TargetNumberOfTriangles: " << this->TargetNumberOfTriangles << "\n";
  os << indent << "RelativePrecision: " << this->RelativePrecision << "\n";
  os << indent << "AllowLargeError: " << this->AllowLargeError << "\n";
  os << indent << "NumberOfThreads: " << this->NumberOfThreads << "\n";
  os << indent << "Errors: " << this->Errors.size() << "\n";
  os << indent << "SmallestError: " << this->SmallestError << " mm\n";
  os << indent << "ErrorTriedInVain: " << this->ErrorTriedInVain << " mm\n";
}
