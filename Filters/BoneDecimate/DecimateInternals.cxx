// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "DecimateInternals.h"

#include "FilterProgress.h"
#include "LabelArrays.h"
#include "LabelMapArrays.h"
#include "LabelMapOfRun.h"
#include "NamedArrays.h"
#include "Partition/Regions/RegionCache.h"
#include "PassedNames.h"
#include "Run/Report/ReportCells.h"
#include "Run/RunWarnings.h"
#include "RunInput.h"
#include "RunState.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <functional>

namespace
{
/// Fills both outputs. @param map Label map of the input; null: not known.
void FillOutputs(const bonedecimate::Result& result,
  const bonedecimate::ConvertedSurface& converted, const bonedecimate::Options& options,
  const bonedecimate::LabelMapSource* map, vtkPolyData* input, vtkInformationVector* outputs)
{
  vtkPolyData* output = vtkPolyData::GetData(outputs, 0);
  bonedecimate::FillOutput(
    result, converted, options, options.WritesSingle(converted.IsSingle), input, output);
  if (map != nullptr)
  {
    bonedecimate::PassLabelMapArrays(*map, result.BoundaryLabels, output);
  }
  bonedecimate::FillInputCopy(result, options, input, vtkPolyData::GetData(outputs, 1));
}

/// What a report of a part says: its size and its options are made from those of the whole, except
/// the mode, which decides what there is to report.
bonedecimate::Report ReportOfPart(bonedecimate::Report report)
{
  const auto mode = report.Requested.Mode;
  report.Size = {};
  report.Requested = {};
  report.Requested.Mode = mode;
  return report;
}
}

vtkBoneDecimate::Internals::Internals(vtkBoneDecimate* filter)
  : Prepared(std::make_shared<bonedecimate::RegionCache>())
  , Filter(filter)
{
}

vtkBoneDecimate::Internals::~Internals() = default;

//------------------------------------------------------------------------------
double vtkBoneDecimate::Internals::LargestErrorOf(double voxelSize) const
{
  const bonedecimate::Options& options = this->Filter->State->Options;
  return options.MaxError(options.VoxelSize > 0.0 ? options.VoxelSize : voxelSize);
}

//------------------------------------------------------------------------------
bool vtkBoneDecimate::Internals::EndsAtReduction(bool isLimited) const
{
  return this->Filter->State->Options.EndsAtReduction(isLimited);
}

//------------------------------------------------------------------------------
bool vtkBoneDecimate::Internals::Prunes() const
{
  return this->Filter->State->Options.Prunes();
}

//------------------------------------------------------------------------------
void vtkBoneDecimate::Internals::CopyOptions(const vtkBoneDecimate& from)
{
  this->Filter->State->Options = from.State->Options;
  this->Filter->Rejected() = from.Rejected();
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-const-cast): VTK's getter is not const
  auto& source = const_cast<vtkBoneDecimate&>(from);
  vtkInformation* arrays = source.GetInformation();
  if (arrays->Has(INPUT_ARRAYS_TO_PROCESS()))
  {
    this->Filter->GetInformation()->CopyEntry(arrays, INPUT_ARRAYS_TO_PROCESS(), 1);
  }
  else
  {
    this->Filter->GetInformation()->Remove(INPUT_ARRAYS_TO_PROCESS());
  }
  this->Filter->SetKeepPrepared(from.GetKeepPrepared());
  this->Filter->Modified();
}

//------------------------------------------------------------------------------
bool vtkBoneDecimate::Internals::HasInputArray(int index)
{
  const bonedecimate::Options& options = this->Filter->State->Options;
  const std::string& name =
    index == LABEL_ARRAY ? options.LabelArrayName : options.ToleranceArrayName;
  vtkInformationVector* chosen = this->Filter->GetInformation()->Get(INPUT_ARRAYS_TO_PROCESS());
  return !name.empty() ||
    (chosen && index < chosen->GetNumberOfInformationObjects() &&
      chosen->GetInformationObject(index)->Has(vtkDataObject::FIELD_ASSOCIATION()));
}

//------------------------------------------------------------------------------
vtkDataArray* vtkBoneDecimate::Internals::GetInputArray(
  int index, vtkPolyData* input, int& association)
{
  const bonedecimate::Options& options = this->Filter->State->Options;
  const std::string& name =
    index == LABEL_ARRAY ? options.LabelArrayName : options.ToleranceArrayName;
  if (name.empty())
  {
    return this->HasInputArray(index)
      ? this->Filter->GetInputArrayToProcess(index, input, association)
      : nullptr;
  }
  vtkDataArray* cells =
    index == LABEL_ARRAY ? input->GetCellData()->GetArray(name.c_str()) : nullptr;
  association =
    cells ? vtkDataObject::FIELD_ASSOCIATION_CELLS : vtkDataObject::FIELD_ASSOCIATION_POINTS;
  return cells ? cells : input->GetPointData()->GetArray(name.c_str());
}

//------------------------------------------------------------------------------
vtkDataArray* vtkBoneDecimate::Internals::GetPointTolerances(vtkPolyData* input)
{
  int association = -1;
  vtkDataArray* array = this->GetInputArray(TOLERANCE_ARRAY, input, association);
  return association == vtkDataObject::FIELD_ASSOCIATION_POINTS ? array : nullptr;
}

//------------------------------------------------------------------------------
/// Reports that the input lacks an array.
void vtkBoneDecimate::Internals::RejectArray(vtkPolyData* input, int index)
{
  const bool isLabels = index == LABEL_ARRAY;
  const bonedecimate::Options& options = this->Filter->State->Options;
  std::string name = isLabels ? options.LabelArrayName : options.ToleranceArrayName;
  vtkInformation* chosen = this->Filter->GetInputArrayInformation(index);
  if (name.empty() && chosen->Has(vtkDataObject::FIELD_NAME()))
  {
    name = chosen->Get(vtkDataObject::FIELD_NAME());
  }
  name = name.empty() ? " for index " + std::to_string(index) : " '" + name + "'";
  vtkErrorWithObjectMacro(
    this->Filter, << (isLabels ? bonedecimate::LackOfLabels(input, name)
                               : bonedecimate::LackOfPointArray(input, name)));
}

//------------------------------------------------------------------------------
/// False if an array does not suit; the reason has been reported.
bool vtkBoneDecimate::Internals::ReadInput(vtkPolyData* input, vtkPolyData* reference,
  const bonedecimate::LabelMapRequest& map, RunInput& read)
{
  const bonedecimate::Options& options = this->Filter->State->Options;
  const bool isFilled = input->GetNumberOfPoints() > 0;
  const bool hasTolerances = isFilled && this->HasInputArray(TOLERANCE_ARRAY);
  const bool hasLabels = isFilled && this->HasInputArray(LABEL_ARRAY);
  read.Converted = bonedecimate::ToSurface(input, options.NumberOfThreads);
  if (hasTolerances)
  {
    read.Tolerances = bonedecimate::ReadNumbers(this->GetPointTolerances(input));
  }
  if (hasLabels)
  {
    int association = -1;
    vtkDataArray* array = this->GetInputArray(LABEL_ARRAY, input, association);
    read.Labels = bonedecimate::ReadLabels(input, read.Converted, array, association);
  }
  if ((hasTolerances && !read.Tolerances) || (hasLabels && !read.Labels))
  {
    this->RejectArray(input, hasTolerances && !read.Tolerances ? TOLERANCE_ARRAY : LABEL_ARRAY);
    return false;
  }
  if (const std::string& name = options.EdgeLengthArrayName; isFilled && !name.empty())
  {
    read.EdgeLengths = bonedecimate::ReadNumbers(input->GetPointData()->GetArray(name.c_str()));
    if (!read.EdgeLengths)
    {
      vtkErrorWithObjectMacro(
        this->Filter, << bonedecimate::LackOfPointArray(input, " '" + name + "'"));
      return false;
    }
  }
  read.Map = bonedecimate::ReadLabelMapOfRun(input, read.Converted, map, options);
  if (!read.Map.Problem.empty())
  {
    vtkErrorWithObjectMacro(this->Filter, << read.Map.Problem);
    return false;
  }
  if (reference != nullptr)
  {
    read.Reference = bonedecimate::ToSurface(reference, options.NumberOfThreads);
  }
  read.Inputs = { read.Converted.IsSingle, bonedecimate::NeedsOrigins(input, options),
    hasTolerances ? &*read.Tolerances : nullptr,
    reference != nullptr ? &read.Reference.Surface : nullptr, hasLabels ? &*read.Labels : nullptr };
  read.Inputs.EdgeLengths = read.EdgeLengths ? &*read.EdgeLengths : nullptr;
  read.Inputs.LeftOut = reference != nullptr ? &read.Reference.LeftOut : &read.Converted.LeftOut;
  read.Inputs.LabelMap = read.Map.Known();
  read.Inputs.Part = this->Part ? &this->Part->Part : nullptr;
  read.Prepared = this->Prepared; // an observer may drop it
  read.Inputs.Regions = read.Prepared.get();
  return true;
}

//------------------------------------------------------------------------------
int vtkBoneDecimate::Internals::Run(vtkPolyData* input, vtkPolyData* reference,
  const bonedecimate::LabelMapRequest& map, vtkInformationVector* outputs)
{
  RunInput read;
  if (!this->ReadInput(input, reference, map, read))
  {
    return 0;
  }
  const bonedecimate::Options& options = this->Filter->State->Options;
  bonedecimate::FilterProgress progress(*this->Filter, "Simplifying the surface");
  bonedecimate::Result result =
    bonedecimate::Decimate(read.Converted.Surface, options, std::ref(progress), read.Inputs);
  this->ProveContinuedPart(read, result);
  this->Filter->Warn(read.Map.CompareWithMap(read.Converted.Surface, options, result));
  bonedecimate::NameCells(read.Converted, result.Report);
  this->Filter->State->Keep(this->Part ? ReportOfPart(result.Report) : result.Report);
  if (!this->Accept(bonedecimate::InputMessage(result.Report)))
  {
    return 0;
  }
  this->Filter->Warn(read.Converted.Warnings);
  this->Filter->Warn(read.Reference.Warnings);
  this->Filter->Warn(bonedecimate::ArrayWarnings(input, options));
  // A part has boundaries of its own.
  this->Filter->Warn(this->Part
      ? bonedecimate::InputWarnings(this->Filter->State->Report)
      : bonedecimate::RunWarnings(read.Converted.Surface, result.Report, options.NumberOfThreads));
  FillOutputs(result, read.Converted, options, read.Inputs.LabelMap, input, outputs);
  const bool isContinued = this->Part && this->Part->Part.Reference != nullptr;
  if (const std::string contradiction = bonedecimate::ProofMessage(result.Report);
      !contradiction.empty() && !isContinued) // what is not proved there is not used
  {
    vtkErrorWithObjectMacro(this->Filter, << contradiction);
    this->Filter->ErrorCode = NOT_PROVED;
  }
  return 1;
}

//------------------------------------------------------------------------------
/// False if the input was rejected. An empty input is valid; one without triangles is a warning.
bool vtkBoneDecimate::Internals::Accept(const std::string& problem)
{
  switch (this->Filter->State->Report.Status)
  {
    case bonedecimate::InputStatus::Good:
    case bonedecimate::InputStatus::Empty:
      return true;
    case bonedecimate::InputStatus::NoTriangles:
      vtkWarningWithObjectMacro(this->Filter, << problem);
      return true;
    default:
      vtkErrorWithObjectMacro(this->Filter, << problem);
      return false;
  }
}
