// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkBoneDecimate.h"

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
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkVersionMacros.h"

vtkStandardNewMacro(vtkBoneDecimate);

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

vtkBoneDecimate::vtkBoneDecimate()
  : Prepared(new bonedecimate::RegionCache)
{
  this->SetNumberOfInputPorts(2);
  this->AddLabelMapPort();
  this->SetNumberOfOutputPorts(2);
}

vtkBoneDecimate::~vtkBoneDecimate() = default;

//------------------------------------------------------------------------------
void vtkBoneDecimate::ForgetTargetReduction()
{
  this->State->Rejected.Check(this, "TargetReduction", {});
  bonedecimate::Options& options = this->State->Options;
  if (options.TargetReductionIsExplicit)
  {
    options.TargetReduction = bonedecimate::Options().TargetReduction;
    options.TargetReductionIsExplicit = false;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
double vtkBoneDecimate::LargestErrorOf(double voxelSize) const
{
  const bonedecimate::Options& options = this->State->Options;
  return options.MaxError(options.VoxelSize > 0.0 ? options.VoxelSize : voxelSize);
}

//------------------------------------------------------------------------------
bool vtkBoneDecimate::EndsAtReduction(bool isLimited) const
{
  return this->State->Options.EndsAtReduction(isLimited);
}

//------------------------------------------------------------------------------
bool vtkBoneDecimate::Prunes() const
{
  return this->State->Options.Prunes();
}

//------------------------------------------------------------------------------
void vtkBoneDecimate::CopyOptions(const vtkBoneDecimate& from)
{
  this->State->Options = from.State->Options;
  this->State->Rejected = from.State->Rejected;
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-const-cast): VTK's getter is not const
  auto& source = const_cast<vtkBoneDecimate&>(from);
  vtkInformation* arrays = source.GetInformation();
  if (arrays->Has(INPUT_ARRAYS_TO_PROCESS()))
  {
    this->GetInformation()->CopyEntry(arrays, INPUT_ARRAYS_TO_PROCESS(), 1);
  }
  else
  {
    this->GetInformation()->Remove(INPUT_ARRAYS_TO_PROCESS());
  }
  this->SetKeepPrepared(from.GetKeepPrepared());
  this->Modified();
}

//------------------------------------------------------------------------------
bool vtkBoneDecimate::HasInputArray(int index)
{
  const bonedecimate::Options& options = this->State->Options;
  const std::string& name =
    index == LABEL_ARRAY ? options.LabelArrayName : options.ToleranceArrayName;
  vtkInformationVector* chosen = this->GetInformation()->Get(INPUT_ARRAYS_TO_PROCESS());
  return !name.empty() ||
    (chosen && index < chosen->GetNumberOfInformationObjects() &&
      chosen->GetInformationObject(index)->Has(vtkDataObject::FIELD_ASSOCIATION()));
}

//------------------------------------------------------------------------------
vtkDataArray* vtkBoneDecimate::GetInputArray(int index, vtkPolyData* input, int& association)
{
  const bonedecimate::Options& options = this->State->Options;
  const std::string& name =
    index == LABEL_ARRAY ? options.LabelArrayName : options.ToleranceArrayName;
  if (name.empty())
  {
    return this->HasInputArray(index) ? this->GetInputArrayToProcess(index, input, association)
                                      : nullptr;
  }
  vtkDataArray* cells =
    index == LABEL_ARRAY ? input->GetCellData()->GetArray(name.c_str()) : nullptr;
  association =
    cells ? vtkDataObject::FIELD_ASSOCIATION_CELLS : vtkDataObject::FIELD_ASSOCIATION_POINTS;
  return cells ? cells : input->GetPointData()->GetArray(name.c_str());
}

//------------------------------------------------------------------------------
vtkDataArray* vtkBoneDecimate::GetPointTolerances(vtkPolyData* input)
{
  int association = -1;
  vtkDataArray* array = this->GetInputArray(TOLERANCE_ARRAY, input, association);
  return association == vtkDataObject::FIELD_ASSOCIATION_POINTS ? array : nullptr;
}

//------------------------------------------------------------------------------
/// Results do not depend on it, so the filter is not modified.
void vtkBoneDecimate::SetKeepPrepared(bool keep)
{
  if (keep != this->GetKeepPrepared())
  {
    this->Prepared = keep ? std::make_shared<bonedecimate::RegionCache>() : nullptr;
  }
}

bool vtkBoneDecimate::GetKeepPrepared() const
{
  return this->Prepared != nullptr;
}

void vtkBoneDecimate::ReleasePrepared()
{
  if (this->Prepared)
  {
    this->Prepared->Release();
  }
}

vtkTypeInt64 vtkBoneDecimate::GetPreparedMemory() const
{
  return this->Prepared ? static_cast<vtkTypeInt64>(this->Prepared->Bytes()) : 0;
}

//------------------------------------------------------------------------------
void vtkBoneDecimate::SetReferenceData(vtkPolyData* reference)
{
  this->SetInputData(1, reference);
}

//------------------------------------------------------------------------------
void vtkBoneDecimate::SetReferenceConnection(vtkAlgorithmOutput* reference)
{
  this->SetInputConnection(1, reference);
}

//------------------------------------------------------------------------------
int vtkBoneDecimate::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == 1)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return this->Superclass::FillInputPortInformation(port, info);
}

//------------------------------------------------------------------------------
/// Reports that the input lacks an array.
void vtkBoneDecimate::RejectArray(int index)
{
  const bonedecimate::Options& options = this->State->Options;
  const std::string& name =
    index == LABEL_ARRAY ? options.LabelArrayName : options.ToleranceArrayName;
  const std::string quoted =
    name.empty() ? " for index " + std::to_string(index) : " '" + name + "'";
  vtkErrorMacro(<< "the input has no "
                << (index == LABEL_ARRAY ? "cell or point array" : "point array") << quoted
                << (index == LABEL_ARRAY ? " of whole numbers" : " of one component"));
}

//------------------------------------------------------------------------------
/// False if an array does not suit; the reason has been reported.
bool vtkBoneDecimate::ReadInput(vtkPolyData* input, vtkPolyData* reference,
  const bonedecimate::LabelMapRequest& map, RunInput& read)
{
  const bonedecimate::Options& options = this->State->Options;
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
    this->RejectArray(hasTolerances && !read.Tolerances ? TOLERANCE_ARRAY : LABEL_ARRAY);
    return false;
  }
  if (const std::string& name = options.EdgeLengthArrayName; isFilled && !name.empty())
  {
    read.EdgeLengths = bonedecimate::ReadNumbers(input->GetPointData()->GetArray(name.c_str()));
    if (!read.EdgeLengths)
    {
      vtkErrorMacro(<< bonedecimate::LackOfPointArray(name));
      return false;
    }
  }
  read.Map = bonedecimate::ReadLabelMapOfRun(input, read.Converted, map, options);
  if (!read.Map.Problem.empty())
  {
    vtkErrorMacro(<< read.Map.Problem);
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
int vtkBoneDecimate::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  RunInput read;
  if (this->ReportRejectedValues() ||
    !this->ReadInput(
      input, vtkPolyData::GetData(inputVector[1]), this->GetLabelMapRequest(inputVector), read))
  {
    return 0;
  }
  const bonedecimate::Options& options = this->State->Options;
  bonedecimate::Result result = bonedecimate::Decimate(
    read.Converted.Surface, options, [this](double fraction) { return this->GoesOn(fraction); },
    read.Inputs);
  this->ProveContinuedPart(read, result);
  this->Warn(read.Map.CompareWithMap(read.Converted.Surface, options, result));
  bonedecimate::NameCells(read.Converted, result.Report);
  this->State->Keep(this->Part ? ReportOfPart(result.Report) : result.Report);
  if (!this->Accept(bonedecimate::InputMessage(result.Report)))
  {
    return 0;
  }
  this->Warn(read.Converted.Warnings);
  this->Warn(read.Reference.Warnings);
  this->Warn(bonedecimate::ArrayWarnings(input, options));
  // A part has boundaries of its own.
  this->Warn(this->Part
      ? bonedecimate::InputWarnings(this->State->Report)
      : bonedecimate::RunWarnings(read.Converted.Surface, result.Report, options.NumberOfThreads));
  FillOutputs(result, read.Converted, options, read.Inputs.LabelMap, input, outputVector);
  const bool isContinued = this->Part && this->Part->Part.Reference != nullptr;
  if (const std::string contradiction = bonedecimate::ProofMessage(result.Report);
      !contradiction.empty() && !isContinued) // what is not proved there is not used
  {
    vtkErrorMacro(<< contradiction);
  }
  return 1;
}

//------------------------------------------------------------------------------
/// False if the input was rejected. An empty input is valid; one without triangles is a warning.
bool vtkBoneDecimate::Accept(const std::string& problem)
{
  switch (this->State->Report.Status)
  {
    case bonedecimate::InputStatus::Good:
    case bonedecimate::InputStatus::Empty:
      return true;
    case bonedecimate::InputStatus::NoTriangles:
      vtkWarningMacro(<< problem);
      return true;
    default:
      vtkErrorMacro(<< problem);
      return false;
  }
}

//------------------------------------------------------------------------------
bool vtkBoneDecimate::GoesOn(double fraction)
{
  const bool goesOn = bonedecimate::GoesOn(*this, fraction);
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 0)
  if (!goesOn)
  {
    this->SetAbortOutput(false); // the output is a valid surface and stays
  }
#endif
  return goesOn;
}

//------------------------------------------------------------------------------
void vtkBoneDecimate::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "KeepPrepared: " << (this->GetKeepPrepared() ? "On" : "Off") << "\n";
  os << indent << "PreparedMemory: " << this->GetPreparedMemory() << " bytes\n";
}
