// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkBoneDecimateLevels.h"

#include "FilterProgress.h"
#include "LabelMapArrays.h"
#include "LabelMapOfRun.h"
#include "NamedArrays.h"
#include "Run/Input/LabelMapInput.h"
#include "Run/Levels.h"
#include "Run/RunWarnings.h"
#include "RunState.h"
#include "SurfaceArrays.h"
#include "SurfaceConversion.h"

#include "vtkCellArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <functional>
#include <limits>

vtkStandardNewMacro(vtkBoneDecimateLevels);

//------------------------------------------------------------------------------
struct vtkBoneDecimateLevels::Internals
{
  bonedecimate::Levels Levels;
  bonedecimate::Report Report;       // of the run that was recorded
  vtkWeakPointer<vtkPolyData> Input; // what they are of, as it was then
  vtkMTimeType InputTime = 0;
  vtkWeakPointer<vtkImageData> Map; // null: none
  vtkMTimeType MapTime = 0;
  vtkWeakPointer<vtkPolyData> Reference; // null: none
  vtkMTimeType ReferenceTime = 0;
  bonedecimate::NamedArrays Arrays; // arrays of the input, until the levels are there
  bonedecimate::ConvertedSurface ReferenceSurface; // the reference, until the levels are there
  bonedecimate::CellLabels Labels;
  bonedecimate::LabelMapOfRun LabelMap;
  vtkSmartPointer<vtkUnsignedCharArray> InputLog; // null: a run
  vtkSmartPointer<vtkUnsignedCharArray> Written;

  bonedecimate::RunInputs Inputs() const
  {
    bonedecimate::RunInputs inputs = this->Arrays.Inputs();
    inputs.LabelMap = this->LabelMap.Known();
    const bool isThere = this->Reference != nullptr;
    inputs.Reference = isThere ? &this->ReferenceSurface.Surface : nullptr;
    inputs.LeftOut = isThere ? &this->ReferenceSurface.LeftOut : inputs.LeftOut;
    return inputs;
  }

  const bonedecimate::LevelMark* Mark(int mark) const
  {
    const std::vector<bonedecimate::LevelMark>& marks = this->Levels.Log().Marks;
    const bool isThere = mark >= 0 && mark < static_cast<int>(marks.size());
    return isThere ? &marks[static_cast<std::size_t>(mark)] : nullptr;
  }
};

namespace
{
bonedecimate::NumberRange TriangleRange()
{
  return { 0.0, VTK_INT_MAX, true, "triangles" };
}
}

vtkBoneDecimateLevels::vtkBoneDecimateLevels()
  : Internal(new Internals)
{
  this->SetNumberOfInputPorts(3);
  this->AddLabelMapPort();
}

vtkBoneDecimateLevels::~vtkBoneDecimateLevels() = default;

//------------------------------------------------------------------------------
/// The next update records anew.
void vtkBoneDecimateLevels::Forget()
{
  this->Internal->Levels = bonedecimate::Levels();
  this->Internal->Written = nullptr;
  this->Modified();
}

//------------------------------------------------------------------------------
/// No level depends on the number of threads.
void vtkBoneDecimateLevels::OptionChanged(const std::string& name)
{
  if (name != "NumberOfThreads")
  {
    this->Forget();
  }
}

//------------------------------------------------------------------------------
void vtkBoneDecimateLevels::SetNumberOfTriangles(int triangles)
{
  this->Rejected().SetNumber(
    this, "NumberOfTriangles", TriangleRange(), triangles, this->NumberOfTriangles);
}

//------------------------------------------------------------------------------
void vtkBoneDecimateLevels::SetLevelError(double millimeters)
{
  this->Rejected().SetNumber(this, "LevelError", { 0.0, bonedecimate::MaxNumber, false, "mm" },
    millimeters, this->LevelError);
}

//------------------------------------------------------------------------------
void vtkBoneDecimateLevels::SetLog(vtkUnsignedCharArray* log)
{
  this->Internal->InputLog = log;
  this->Forget();
}

//------------------------------------------------------------------------------
vtkUnsignedCharArray* vtkBoneDecimateLevels::GetLog()
{
  if (!this->Internal->Written)
  {
    this->Internal->Written = vtkSmartPointer<vtkUnsignedCharArray>::New();
    if (this->Internal->Levels.IsOpen())
    {
      const std::vector<unsigned char> bytes = bonedecimate::WriteLog(this->Internal->Levels.Log());
      this->Internal->Written->SetNumberOfValues(static_cast<vtkIdType>(bytes.size()));
      std::copy(bytes.begin(), bytes.end(), this->Internal->Written->GetPointer(0));
    }
  }
  return this->Internal->Written;
}

//------------------------------------------------------------------------------
int vtkBoneDecimateLevels::GetNumberOfMarks() const
{
  return static_cast<int>(this->Internal->Levels.Log().Marks.size());
}

//------------------------------------------------------------------------------
int vtkBoneDecimateLevels::GetMarkTriangles(int mark) const
{
  const bonedecimate::LevelMark* found = this->Internal->Mark(mark);
  return found ? found->Triangles : 0;
}

//------------------------------------------------------------------------------
double vtkBoneDecimateLevels::GetMarkLargestDistance(int mark) const
{
  const bonedecimate::LevelMark* found = this->Internal->Mark(mark);
  return found ? found->Largest : std::numeric_limits<double>::quiet_NaN();
}

//------------------------------------------------------------------------------
double vtkBoneDecimateLevels::GetMarkMeanDistance(int mark) const
{
  const bonedecimate::LevelMark* found = this->Internal->Mark(mark);
  return found ? found->Mean : std::numeric_limits<double>::quiet_NaN();
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkBoneDecimateLevels::GetMarkChangedVoxels(int mark) const
{
  const std::vector<std::int64_t>& changed = this->Internal->Levels.ChangedVoxels();
  const bool isThere = mark >= 0 && mark < static_cast<int>(changed.size());
  return isThere ? changed[static_cast<std::size_t>(mark)] : -1;
}

//------------------------------------------------------------------------------
void vtkBoneDecimateLevels::SetReferenceData(vtkPolyData* reference)
{
  this->SetInputData(2, reference);
}

//------------------------------------------------------------------------------
void vtkBoneDecimateLevels::SetReferenceConnection(vtkAlgorithmOutput* reference)
{
  this->SetInputConnection(2, reference);
}

//------------------------------------------------------------------------------
int vtkBoneDecimateLevels::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == 1 || port == 2)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return this->Superclass::FillInputPortInformation(port, info);
}

//------------------------------------------------------------------------------
int vtkBoneDecimateLevels::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector, 0);
  if (this->ReportRejectedValues() ||
    !this->Prepare(
      input, vtkPolyData::GetData(inputVector[2]), this->GetLabelMapRequest(inputVector)))
  {
    return 0;
  }
  this->State->Keep(this->Internal->Report);
  return !this->Internal->Levels.IsOpen() ||
      this->Fill(input, vtkPolyData::GetData(inputVector[1]), output)
    ? 1
    : 0;
}

//------------------------------------------------------------------------------
/// Makes the levels of the input; there are none if it has no triangles. False if the input or the
/// log was rejected.
bool vtkBoneDecimateLevels::Prepare(
  vtkPolyData* input, vtkPolyData* reference, const bonedecimate::LabelMapRequest& request)
{
  Internals& mine = *this->Internal;
  const vtkMTimeType mapTime = request.Map != nullptr ? request.Map->GetMTime() : 0;
  const vtkMTimeType referenceTime = reference != nullptr ? reference->GetMTime() : 0;
  if (mine.Levels.IsOpen() && mine.Input == input && mine.InputTime == input->GetMTime() &&
    mine.Map == request.Map && mine.MapTime == mapTime && mine.Reference == reference &&
    mine.ReferenceTime == referenceTime)
  {
    return true;
  }
  mine.Levels = bonedecimate::Levels();
  mine.Written = nullptr;
  mine.Report = bonedecimate::Report();
  mine.Input = input;
  mine.InputTime = input->GetMTime();
  mine.Map = request.Map;
  mine.MapTime = mapTime;
  mine.Reference = reference;
  mine.ReferenceTime = referenceTime;
  const bool isPrepared = this->ReadArrays(input, reference, request) &&
    (mine.InputLog ? this->OpenLog() : this->Record());
  mine.Arrays = {};
  mine.ReferenceSurface = {};
  return isPrepared;
}

//------------------------------------------------------------------------------
/// Reads the surface, its arrays, its label map and the reference. False if they do not suit each
/// other.
bool vtkBoneDecimateLevels::ReadArrays(
  vtkPolyData* input, vtkPolyData* reference, const bonedecimate::LabelMapRequest& request)
{
  Internals& mine = *this->Internal;
  const bonedecimate::Options& options = this->State->Options;
  mine.Arrays = bonedecimate::ReadNamedArrays(input, options);
  mine.LabelMap = bonedecimate::ReadLabelMapOfRun(input, mine.Arrays.Converted, request, options);
  const std::string& problem =
    mine.Arrays.Problem.empty() ? mine.LabelMap.Problem : mine.Arrays.Problem;
  if (!problem.empty())
  {
    vtkErrorMacro(<< problem);
    return false;
  }
  mine.Labels = mine.Arrays.LabelsToCopy();
  if (reference != nullptr)
  {
    mine.ReferenceSurface = bonedecimate::ToSurface(reference, options.NumberOfThreads);
  }
  const bool hasCurves =
    mine.Arrays.Labels.has_value() || bonedecimate::HasSeveralPairs(mine.LabelMap.Known());
  if (!mine.InputLog && hasCurves)
  {
    vtkWarningMacro(<< "curves between labels do not change in a recorded run: levels have more "
                       "triangles than results of vtkBoneDecimate");
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkBoneDecimateLevels::OpenLog()
{
  bonedecimate::EditLog log;
  vtkUnsignedCharArray* bytes = this->Internal->InputLog;
  bonedecimate::LogStatus status = bonedecimate::ReadLog(
    bytes->GetPointer(0), static_cast<std::size_t>(bytes->GetNumberOfValues()), log);
  if (status == bonedecimate::LogStatus::Good)
  {
    Internals& mine = *this->Internal;
    const bonedecimate::Surface& surface = mine.Arrays.Converted.Surface;
    status = mine.Levels.Open(surface, std::move(log), this->GetNumberOfThreads(), mine.Inputs());
    bonedecimate::FilterProgress progress(*this, "Comparing voxels");
    if (status == bonedecimate::LogStatus::Good &&
      !mine.Levels.CompareVoxels(surface, std::ref(progress)))
    {
      mine.Input = nullptr; // aborted: the next update begins again
    }
  }
  if (status != bonedecimate::LogStatus::Good)
  {
    vtkErrorMacro(<< bonedecimate::LogMessage(status));
  }
  return status == bonedecimate::LogStatus::Good;
}

//------------------------------------------------------------------------------
bool vtkBoneDecimateLevels::Record()
{
  Internals& mine = *this->Internal;
  const bonedecimate::ConvertedSurface& converted = mine.Arrays.Converted;
  this->Warn(converted.Warnings);
  this->Warn(mine.ReferenceSurface.Warnings);
  bonedecimate::FilterProgress progress(*this, "Recording levels");
  bonedecimate::Result run = bonedecimate::RecordLevels(
    converted.Surface, this->State->Options, std::ref(progress), mine.Inputs(), mine.Levels);
  this->Warn(mine.LabelMap.CompareWithMap(converted.Surface, this->State->Options, run));
  mine.Report = run.Report;
  const bonedecimate::InputStatus status = run.Report.Status;
  if (status == bonedecimate::InputStatus::NoTriangles)
  {
    vtkWarningMacro(<< bonedecimate::InputMessage(run.Report));
  }
  else if (status != bonedecimate::InputStatus::Good && status != bonedecimate::InputStatus::Empty)
  {
    vtkErrorMacro(<< bonedecimate::InputMessage(run.Report));
    return false;
  }
  this->Warn(
    bonedecimate::RunWarnings(converted.Surface, run.Report, this->State->Options.NumberOfThreads));
  const std::string contradiction = bonedecimate::ProofMessage(run.Report);
  if (!contradiction.empty())
  {
    vtkErrorMacro(<< contradiction);
    this->ErrorCode = NOT_PROVED;
  }
  if (run.Report.Stop == bonedecimate::StopReason::Aborted)
  {
    this->Internal->Input = nullptr; // the next update begins again
  }
  else if (status == bonedecimate::InputStatus::Good && !mine.Levels.IsOpen())
  {
    vtkErrorMacro(<< "the log of the run does not replay");
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
/// In collapses.
int vtkBoneDecimateLevels::SelectedLevel() const
{
  const bonedecimate::Levels& levels = this->Internal->Levels;
  int level = levels.NumberOfCollapses();
  if (this->NumberOfTriangles > 0)
  {
    level = std::min(level, static_cast<int>(levels.ByTriangles(this->NumberOfTriangles)));
  }
  if (this->LevelError > 0.0)
  {
    level = std::min(level, static_cast<int>(levels.ByError(this->LevelError)));
  }
  return level;
}

//------------------------------------------------------------------------------
bool vtkBoneDecimateLevels::Fill(vtkPolyData* input, vtkPolyData* other, vtkPolyData* output)
{
  const bonedecimate::Levels& levels = this->Internal->Levels;
  const int level = this->SelectedLevel();
  const std::optional<bonedecimate::Level> found = other
    ? levels.AtOn(bonedecimate::ToSurface(other, this->GetNumberOfThreads()).Surface, level)
    : levels.At(level);
  if (!found)
  {
    vtkErrorMacro(<< "the second input has other triangles than the first, or points that are not "
                     "finite or beyond 1e30 mm");
    return false;
  }
  output->SetPoints(bonedecimate::ToPoints(
    found->Surface.Points, levels.Log().IsSingle, this->GetNumberOfThreads()));
  output->SetPolys(bonedecimate::ToCells(found->Surface.Triangles, this->GetNumberOfThreads()));
  const bonedecimate::LabelMapSource* map = this->Internal->LabelMap.Known();
  if (map != nullptr && !other)
  {
    bonedecimate::CopyLabelMapFields(input, output);
    bonedecimate::PassLabelMapArrays(*map, levels.BoundaryLabelsAt(level), output);
  }
  this->Internal->Labels.Fill(levels.InputTrianglesAt(level), output);
  return true;
}

//------------------------------------------------------------------------------
void vtkBoneDecimateLevels::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfTriangles: " << this->NumberOfTriangles << "\n";
  os << indent << "LevelError: " << this->LevelError << " mm\n";
  os << indent << "NumberOfMarks: " << this->GetNumberOfMarks() << "\n";
}
