// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkBoneSmooth.h"

#include "FilterProgress.h"
#include "LabelArrays.h"
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

vtkBoneSmooth::vtkBoneSmooth() = default;

vtkBoneSmooth::~vtkBoneSmooth() = default;

//------------------------------------------------------------------------------
int vtkBoneSmooth::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (this->ReportRejectedValues())
  {
    return 0;
  }
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  const Options options = OptionsOfRun(this->State->Options);
  const ConvertedSurface converted = ToSurface(input, options.NumberOfThreads);
  RunInputs inputs = { converted.IsSingle, NeedsOrigins(input, options) };
  std::optional<std::vector<double>> tolerances;
  std::optional<Labels> labels;
  if (!options.ToleranceArrayName.empty() && input->GetNumberOfPoints() > 0)
  {
    tolerances = ReadNumbers(input->GetPointData()->GetArray(options.ToleranceArrayName.c_str()));
    if (!tolerances)
    {
      vtkErrorMacro(<< "the input has no point array '" << options.ToleranceArrayName
                    << "' of one component");
      return 0;
    }
    inputs.Tolerances = &*tolerances;
  }
  if (!options.LabelArrayName.empty() && input->GetNumberOfPoints() > 0)
  {
    labels = LabelsNamed(options.LabelArrayName, input, converted);
    if (!labels)
    {
      vtkErrorMacro(<< "the input has no cell or point array '" << options.LabelArrayName
                    << "' of whole numbers");
      return 0;
    }
    inputs.Labels = &*labels;
  }
  const Result result = Decimate(
    converted.Surface, options,
    [this](double fraction) { return bonedecimate::GoesOn(*this, fraction); }, inputs);
  this->State->Keep(result.Report);
  const InputStatus status = result.Report.Status;
  const std::string problem = InputMessage(result.Report);
  if (status == InputStatus::NoTriangles)
  {
    vtkWarningMacro(<< problem);
  }
  else if (status != InputStatus::Good && status != InputStatus::Empty)
  {
    vtkErrorMacro(<< problem);
    return 0;
  }
  this->Warn(converted.Warnings);
  this->Warn(InputWarnings(result.Report));
  FillOutput(result, converted, options, WritesSingle(options, converted.IsSingle), input,
    vtkPolyData::GetData(outputVector, 0));
  const std::string contradiction = ProofMessage(result.Report);
  if (!contradiction.empty())
  {
    vtkErrorMacro(<< contradiction);
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkBoneSmooth::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
