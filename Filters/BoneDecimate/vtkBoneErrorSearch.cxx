// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkBoneErrorSearch.h"

#include "FilterProgress.h"
#include "LabelMapArrays.h"
#include "LabelMapOfRun.h"
#include "NamedArrays.h"
#include "PassedNames.h"
#include "Run/ErrorSearch.h"
#include "Run/RunWarnings.h"
#include "RunState.h"
#include "SurfaceConversion.h"

#include "vtkDoubleArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkTable.h"
#include "vtkTypeInt64Array.h"

#include <functional>
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

/// Empty if it is null.
bonedecimate::ConvertedSurface ReferenceOf(vtkPolyData* data)
{
  return data != nullptr ? bonedecimate::ToSurface(data, 0) : bonedecimate::ConvertedSurface();
}

void FillSurface(const bonedecimate::Result& result,
  const bonedecimate::ConvertedSurface& converted, const bonedecimate::Options& options,
  const bonedecimate::LabelMapOfRun& map, vtkPolyData* input, vtkPolyData* output)
{
  bonedecimate::FillOutput(result, converted, options, converted.IsSingle, input, output);
  if (map.Known() != nullptr)
  {
    bonedecimate::PassLabelMapArrays(map.Source, result.BoundaryLabels, output);
  }
}

/// @param isCurve Whether there is no number of triangles to reach.
std::vector<std::string> WarningsOfSearch(
  const bonedecimate::ErrorSearchResult& found, const bonedecimate::Options& options, bool isCurve)
{
  return found.Best >= 0 || isCurve
    ? std::vector<std::string>()
    : std::vector<std::string>{ "no run kept its limits with " +
        std::to_string(options.TargetNumberOfTriangles) +
        " triangles or fewer; the output is that of the last run, with " +
        std::to_string(found.Found.Report.Output.Faces) };
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
  if (!trials.empty() && trials.front().ChangedVoxels >= 0)
  {
    AddColumn<vtkTypeInt64Array>(
      table, "ChangedVoxels", "voxels", trials, [](const Trial& t) { return t.ChangedVoxels; });
  }
}
}

//------------------------------------------------------------------------------
vtkBoneErrorSearch::vtkBoneErrorSearch()
  : SmallestError(std::numeric_limits<double>::quiet_NaN())
{
  this->SetNumberOfInputPorts(2);
  this->AddLabelMapPort();
  this->SetNumberOfOutputPorts(2);
}

vtkBoneErrorSearch::~vtkBoneErrorSearch() = default;

//------------------------------------------------------------------------------
std::string vtkBoneErrorSearch::OptionProblem(
  const bonedecimate::Options& changed, const std::string& name) const
{
  const auto proves = [](const bonedecimate::ModeInfo& row) { return row.ProvesError(); };
  const bonedecimate::ModeInfo& info = bonedecimate::FindMode(changed.Mode);
  return name != "Mode" || proves(info) ? std::string()
                                        : "Mode takes one of " +
      bonedecimate::ModeNamesWhere(proves) + ", not " + info.Name + ", which proves nothing";
}

//------------------------------------------------------------------------------
void vtkBoneErrorSearch::SetRelativePrecision(double ratio)
{
  this->Rejected().SetNumber(
    this, "RelativePrecision", { 0.001, 0.5 }, ratio, this->RelativePrecision);
}

//------------------------------------------------------------------------------
void vtkBoneErrorSearch::AddError(double millimeters)
{
  const bonedecimate::NumberRange range = { 0.0, bonedecimate::MaxNumber, false, "mm" };
  if (millimeters > 0.0 && bonedecimate::IsInRange(range, millimeters))
  {
    this->Errors.push_back(millimeters);
    this->Modified();
  }
  else
  {
    this->Rejected().Check(this, "Error",
      "Error takes a number above 0 and at most 1e30 mm, not " +
        bonedecimate::SentenceNumber(millimeters));
  }
}

//------------------------------------------------------------------------------
void vtkBoneErrorSearch::RemoveAllErrors()
{
  this->Rejected().Check(this, "Error", {});
  if (!this->Errors.empty())
  {
    this->Errors.clear();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkBoneErrorSearch::SetReferenceData(vtkPolyData* reference)
{
  this->SetInputData(1, reference);
}

//------------------------------------------------------------------------------
void vtkBoneErrorSearch::SetReferenceConnection(vtkAlgorithmOutput* reference)
{
  this->SetInputConnection(1, reference);
}

//------------------------------------------------------------------------------
int vtkBoneErrorSearch::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == 1)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return this->Superclass::FillInputPortInformation(port, info);
}

//------------------------------------------------------------------------------
double vtkBoneErrorSearch::GetSmallestError() const
{
  return this->IsOutdated() ? std::numeric_limits<double>::quiet_NaN() : this->SmallestError;
}

double vtkBoneErrorSearch::GetErrorTriedInVain() const
{
  return this->IsOutdated() ? 0.0 : this->ErrorTriedInVain;
}

//------------------------------------------------------------------------------
void vtkBoneErrorSearch::ForgetReport()
{
  this->Superclass::ForgetReport();
  this->SmallestError = std::numeric_limits<double>::quiet_NaN();
  this->ErrorTriedInVain = 0.0;
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
  if (this->ReportRejectedValues())
  {
    return 0;
  }
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* first = vtkPolyData::GetData(inputVector[1]);
  if (this->Errors.empty() && this->GetTargetNumberOfTriangles() == 0)
  {
    vtkErrorMacro(<< "there is neither a number of triangles nor an error");
    return 0;
  }
  bonedecimate::ErrorSearchOptions options;
  options.Run = this->State->Options;
  options.RelativePrecision = this->RelativePrecision;
  const bonedecimate::NamedArrays arrays = bonedecimate::ReadNamedArrays(input, options.Run);
  const bonedecimate::ConvertedSurface& converted = arrays.Converted;
  const bonedecimate::LabelMapOfRun map = bonedecimate::ReadLabelMapOfRun(
    input, converted, this->GetLabelMapRequest(inputVector), options.Run);
  if (!arrays.Problem.empty() || !map.Problem.empty())
  {
    vtkErrorMacro(<< (arrays.Problem.empty() ? map.Problem : arrays.Problem));
    return 0;
  }
  options.Inputs = arrays.Inputs();
  options.Inputs.WantsOrigins = arrays.Labels.has_value();
  options.Inputs.LabelMap = map.Known();
  const bonedecimate::ConvertedSurface reference = ReferenceOf(first);
  options.Inputs.Reference = first != nullptr ? &reference.Surface : nullptr;
  options.Inputs.LeftOut = first != nullptr ? &reference.LeftOut : options.Inputs.LeftOut;
  bonedecimate::FilterProgress progress(*this, "Searching for the smallest error");
  bonedecimate::ErrorSearchResult found = this->Errors.empty()
    ? bonedecimate::FindSmallestError(converted.Surface, options, std::ref(progress))
    : bonedecimate::FindErrorCurve(converted.Surface, this->Errors, options, std::ref(progress));
  this->Warn(map.CompareWithMap(converted.Surface, options.Run, found.Found));
  this->State->Keep(found.Found.Report);
  const std::string problem = bonedecimate::InputMessage(found.Found.Report);
  if (!problem.empty())
  {
    vtkErrorMacro(<< problem);
    return 0;
  }
  this->Warn(converted.Warnings);
  this->Warn(reference.Warnings);
  this->Warn(bonedecimate::ArrayWarnings(input, options.Run));
  this->Warn(
    bonedecimate::RunWarnings(converted.Surface, found.Found.Report, options.Run.NumberOfThreads));
  this->Warn(WarningsOfSearch(found, options.Run, !this->Errors.empty()));
  this->SmallestError = found.Best < 0 ? std::numeric_limits<double>::quiet_NaN()
                                       : found.Trials[static_cast<std::size_t>(found.Best)].Proved;
  this->ErrorTriedInVain = found.MaxFailedError;
  vtkPolyData* output = vtkPolyData::GetData(outputVector, 0);
  FillSurface(found.Found, converted, options.Run, map, input, output);
  FillTable(found.Trials, vtkTable::GetData(outputVector, 1));
  return 1;
}

//------------------------------------------------------------------------------
void vtkBoneErrorSearch::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "RelativePrecision: " << this->RelativePrecision << "\n";
  os << indent << "Errors: " << this->Errors.size() << "\n";
  os << indent << "SmallestError: " << this->SmallestError << " mm\n";
  os << indent << "ErrorTriedInVain: " << this->ErrorTriedInVain << " mm\n";
}
