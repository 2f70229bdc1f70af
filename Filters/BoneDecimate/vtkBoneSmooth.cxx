// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkBoneSmooth.h"

#include "FilterProgress.h"
#include "LabelArrays.h"
#include "LabelMapArrays.h"
#include "LabelMapOfRun.h"
#include "Pieces.h"
#include "RunState.h"
#include "SurfaceConversion.h"

#include "vtkCellData.h"
#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <optional>

vtkStandardNewMacro(vtkBoneSmooth);

namespace
{
using namespace bonedecimate;

/// The options of a run that removes nothing.
Options OptionsOfRun(const Options& requested)
{
  Options options = requested;
  options.Mode = Mode::Fast;
  options.TargetReduction = 0.0;
  options.TargetReductionIsExplicit = true;
  options.AutomaticSmoothing = options.Smoothing == 0.0;
  return options;
}

bool WritesSingle(const Options& options, bool inputIsSingle)
{
  const PointsPrecision precision = options.OutputPointsPrecision;
  return precision == PointsPrecision::Single ||
    (precision == PointsPrecision::Default && inputIsSingle);
}

/// Nothing if the array of that name does not suit.
std::optional<Labels> LabelsNamed(
  const std::string& name, vtkPolyData* input, const ConvertedSurface& converted)
{
  vtkDataArray* cells = input->GetCellData()->GetArray(name.c_str());
  vtkDataArray* array = cells ? cells : input->GetPointData()->GetArray(name.c_str());
  return ReadLabels(input, converted, array,
    cells ? vtkDataObject::FIELD_ASSOCIATION_CELLS : vtkDataObject::FIELD_ASSOCIATION_POINTS);
}
}

vtkBoneSmooth::vtkBoneSmooth()
{
  this->AddLabelMapPort();
}

vtkBoneSmooth::~vtkBoneSmooth() = default;

/// The surface and what the named arrays say of it.
struct vtkBoneSmooth::InputArrays
{
  ConvertedSurface Converted;
  std::optional<std::vector<double>> Tolerances;
  std::optional<bonedecimate::Labels> Labels;
};

//------------------------------------------------------------------------------
/// False if the input lacks an array that is named.
bool vtkBoneSmooth::ReadArrays(vtkPolyData* input, InputArrays& arrays)
{
  const Options& options = this->State->Options;
  arrays.Converted = ToSurface(input, options.NumberOfThreads);
  if (input->GetNumberOfPoints() == 0)
  {
    return true;
  }
  if (!options.ToleranceArrayName.empty())
  {
    arrays.Tolerances =
      ReadNumbers(input->GetPointData()->GetArray(options.ToleranceArrayName.c_str()));
    if (!arrays.Tolerances)
    {
      vtkErrorMacro(<< "the input has no point array '" << options.ToleranceArrayName
                    << "' of one component");
      return false;
    }
  }
  if (!options.LabelArrayName.empty())
  {
    arrays.Labels = LabelsNamed(options.LabelArrayName, input, arrays.Converted);
    if (!arrays.Labels)
    {
      vtkErrorMacro(<< "the input has no cell or point array '" << options.LabelArrayName
                    << "' of whole numbers");
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
/// False if the input was rejected.
bool vtkBoneSmooth::Accept(const std::vector<std::string>& warnings)
{
  const Report& report = this->State->Report;
  const std::string problem = InputMessage(report);
  if (report.Status == InputStatus::NoTriangles)
  {
    vtkWarningMacro(<< problem);
  }
  else if (report.Status != InputStatus::Good && report.Status != InputStatus::Empty)
  {
    vtkErrorMacro(<< problem);
    return false;
  }
  this->Warn(warnings);
  this->Warn(InputWarnings(report));
  const std::string contradiction = ProofMessage(report);
  if (!contradiction.empty())
  {
    vtkErrorMacro(<< contradiction);
  }
  return true;
}

//------------------------------------------------------------------------------
int vtkBoneSmooth::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (RequestedPiece(outputVector).Pieces > 1)
  {
    vtkErrorMacro(<< "vtkBoneSmooth is for one process alone: vtkPBoneDecimate with Smoothing and "
                     "TargetReduction 0 smooths the parts of a surface together");
    return 0;
  }
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  InputArrays arrays;
  if (this->ReportRejectedValues() || !this->ReadArrays(input, arrays))
  {
    return 0;
  }
  const Options options = OptionsOfRun(this->State->Options);
  const ConvertedSurface& converted = arrays.Converted;
  const LabelMapOfRun map =
    ReadLabelMapOfRun(input, converted, this->GetLabelMapRequest(inputVector), options);
  if (!map.Problem.empty())
  {
    vtkErrorMacro(<< map.Problem);
    return 0;
  }
  RunInputs inputs = { converted.IsSingle, NeedsOrigins(input, options) };
  inputs.LabelMap = map.Known();
  inputs.Tolerances = arrays.Tolerances ? &*arrays.Tolerances : nullptr;
  inputs.Labels = arrays.Labels ? &*arrays.Labels : nullptr;
  Result result = Decimate(
    converted.Surface, options,
    [this](double fraction) { return bonedecimate::GoesOn(*this, fraction); }, inputs);
  std::vector<std::string> warnings = map.CompareWithMap(converted.Surface, options, result);
  warnings.insert(warnings.end(), converted.Warnings.begin(), converted.Warnings.end());
  this->State->Keep(result.Report);
  if (!this->Accept(warnings))
  {
    return 0;
  }
  FillOutput(result, converted, options, WritesSingle(options, converted.IsSingle), input,
    vtkPolyData::GetData(outputVector, 0));
  if (map.Known() != nullptr)
  {
    PassLabelMapArrays(map.Source, result.BoundaryLabels, vtkPolyData::GetData(outputVector, 0));
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkBoneSmooth::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
