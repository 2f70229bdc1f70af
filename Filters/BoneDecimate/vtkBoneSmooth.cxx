// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkBoneSmooth.h"

#include "FilterProgress.h"
#include "LabelMapArrays.h"
#include "LabelMapOfRun.h"
#include "NamedArrays.h"
#include "PassedNames.h"
#include "Pieces.h"
#include "Run/RunWarnings.h"
#include "RunState.h"
#include "SurfaceConversion.h"

#include "vtkCellData.h"
#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <functional>
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
}

vtkBoneSmooth::vtkBoneSmooth()
{
  this->AddLabelMapPort();
}

vtkBoneSmooth::~vtkBoneSmooth() = default;

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
  const std::string contradiction = ProofMessage(report);
  if (!contradiction.empty())
  {
    vtkErrorMacro(<< contradiction);
    this->ErrorCode = NOT_PROVED;
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
  if (this->ReportRejectedValues())
  {
    return 0;
  }
  const NamedArrays arrays = ReadNamedArrays(input, this->State->Options);
  if (!arrays.Problem.empty())
  {
    vtkErrorMacro(<< arrays.Problem);
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
  RunInputs inputs = arrays.Inputs();
  inputs.WantsOrigins = NeedsOrigins(input, options);
  inputs.LabelMap = map.Known();
  bonedecimate::FilterProgress progress(*this, "Smoothing the surface");
  Result result = Decimate(converted.Surface, options, std::ref(progress), inputs);
  std::vector<std::string> warnings = map.CompareWithMap(converted.Surface, options, result);
  warnings.insert(warnings.end(), converted.Warnings.begin(), converted.Warnings.end());
  this->State->Keep(result.Report);
  const std::vector<std::string> ofRun =
    RunWarnings(converted.Surface, result.Report, options.NumberOfThreads);
  warnings.insert(warnings.end(), ofRun.begin(), ofRun.end());
  if (!this->Accept(warnings))
  {
    return 0;
  }
  this->Warn(ArrayWarnings(input, options));
  FillOutput(result, converted, options, options.WritesSingle(converted.IsSingle), input,
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
