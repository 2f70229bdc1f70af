// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkBoneDecimateLevels.h"

#include "FilterProgress.h"
#include "Levels.h"
#include "RejectedValues.h"
#include "SurfaceArrays.h"
#include "SurfaceConversion.h"

#include "vtkCellArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <limits>

vtkStandardNewMacro(vtkBoneDecimateLevels);

//------------------------------------------------------------------------------
struct vtkBoneDecimateLevels::Internals
{
  bonedecimate::Levels Levels;
  vtkWeakPointer<vtkPolyData> Input; // what they are of, as it was then
  vtkMTimeType InputTime = 0;
  vtkSmartPointer<vtkUnsignedCharArray> Given; // null: a run
  vtkSmartPointer<vtkUnsignedCharArray> Written;
  bonedecimate::RejectedValues Rejected;

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
  this->SetNumberOfInputPorts(2);
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
void vtkBoneDecimateLevels::SetMode(int mode)
{
  if (this->Internal->Rejected.SetOption(this, "Mode", mode, this->Mode))
  {
    this->Forget();
  }
}

//------------------------------------------------------------------------------
void vtkBoneDecimateLevels::SetCoarsestNumberOfTriangles(int triangles)
{
  if (this->Internal->Rejected.SetNumber(this, "CoarsestNumberOfTriangles", TriangleRange(),
        triangles, this->CoarsestNumberOfTriangles))
  {
    this->Forget();
  }
}

//------------------------------------------------------------------------------
void vtkBoneDecimateLevels::SetMaximumError(double millimetres)
{
  if (this->Internal->Rejected.SetOption(this, "MaximumError", millimetres, this->MaximumError))
  {
    this->Forget();
  }
}

//------------------------------------------------------------------------------
void vtkBoneDecimateLevels::SetAllowLargeError(bool allow)
{
  if (this->AllowLargeError != allow)
  {
    this->AllowLargeError = allow;
    this->Forget();
  }
}

//------------------------------------------------------------------------------
void vtkBoneDecimateLevels::SetMeasureErrors(bool measure)
{
  if (this->MeasureErrors != measure)
  {
    this->MeasureErrors = measure;
    this->Forget();
  }
}

//------------------------------------------------------------------------------
void vtkBoneDecimateLevels::SetNumberOfThreads(int threads)
{
  this->Internal->Rejected.SetOption(this, "NumberOfThreads", threads, this->NumberOfThreads);
}

//------------------------------------------------------------------------------
void vtkBoneDecimateLevels::SetNumberOfTriangles(int triangles)
{
  this->Internal->Rejected.SetNumber(
    this, "NumberOfTriangles", TriangleRange(), triangles, this->NumberOfTriangles);
}

//------------------------------------------------------------------------------
void vtkBoneDecimateLevels::SetLevelError(double millimeters)
{
  this->Internal->Rejected.SetNumber(this, "LevelError",
    { 0.0, bonedecimate::LargestNumber, false, "mm" }, millimeters, this->LevelError);
}

//------------------------------------------------------------------------------
std::string vtkBoneDecimateLevels::GetRejectedValue(const std::string& property) const
{
  return this->Internal->Rejected.Of(property);
}

vtkMTimeType vtkBoneDecimateLevels::GetMTime()
{
  return this->Internal->Rejected.MTime(this->Superclass::GetMTime());
}

//------------------------------------------------------------------------------
void vtkBoneDecimateLevels::SetLog(vtkUnsignedCharArray* log)
{
  this->Internal->Given = log;
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
int vtkBoneDecimateLevels::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == 1)
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
  if (this->Internal->Rejected.Report(this) || !this->Prepare(input))
  {
    return 0;
  }
  return !this->Internal->Levels.IsOpen() ||
      this->Fill(vtkPolyData::GetData(inputVector[1]), output)
    ? 1
    : 0;
}

//------------------------------------------------------------------------------
/// Levels of the input as it is now; closed ones if it has no triangles. False if it or the log was refused.
bool vtkBoneDecimateLevels::Prepare(vtkPolyData* input)
{
  Internals& mine = *this->Internal;
  if (mine.Levels.IsOpen() && mine.Input == input && mine.InputTime == input->GetMTime())
  {
    return true;
  }
  mine.Levels = bonedecimate::Levels();
  mine.Written = nullptr;
  mine.Input = input;
  mine.InputTime = input->GetMTime();
  return mine.Given ? this->OpenLog(input) : this->Record(input);
}

//------------------------------------------------------------------------------
bool vtkBoneDecimateLevels::OpenLog(vtkPolyData* input)
{
  bonedecimate::EditLog log;
  vtkUnsignedCharArray* given = this->Internal->Given;
  bonedecimate::LogStatus status = bonedecimate::ReadLog(
    given->GetPointer(0), static_cast<std::size_t>(given->GetNumberOfValues()), log);
  if (status == bonedecimate::LogStatus::Good)
  {
    status =
      this->Internal->Levels.Open(bonedecimate::ToSurface(input, this->NumberOfThreads).Surface,
        std::move(log), this->NumberOfThreads);
  }
  if (status != bonedecimate::LogStatus::Good)
  {
    vtkErrorMacro(<< bonedecimate::LogMessage(status));
  }
  return status == bonedecimate::LogStatus::Good;
}

//------------------------------------------------------------------------------
bool vtkBoneDecimateLevels::Record(vtkPolyData* input)
{
  const bonedecimate::ConvertedSurface converted =
    bonedecimate::ToSurface(input, this->NumberOfThreads);
  for (const std::string& warning : converted.Warnings)
  {
    vtkWarningMacro(<< warning);
  }
  bonedecimate::Options options;
  options.Mode = static_cast<bonedecimate::Mode>(this->Mode);
  options.TargetNumberOfTriangles = this->CoarsestNumberOfTriangles;
  options.MaximumError = this->MaximumError;
  options.AllowLargeError = this->AllowLargeError;
  options.MeasureDistances = this->MeasureErrors;
  options.NumberOfThreads = this->NumberOfThreads;
  const bonedecimate::Result run = bonedecimate::RecordLevels(
    converted.Surface, options,
    [this](double fraction) { return bonedecimate::GoesOn(*this, fraction); }, converted.IsSingle,
    this->Internal->Levels);
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
  for (const std::string& warning : bonedecimate::InputWarnings(run.Report))
  {
    vtkWarningMacro(<< warning);
  }
  const std::string contradiction = bonedecimate::ProofMessage(run.Report);
  if (!contradiction.empty())
  {
    vtkErrorMacro(<< contradiction);
  }
  if (run.Report.Stop == bonedecimate::StopReason::Aborted)
  {
    this->Internal->Input = nullptr; // the next update begins again
  }
  return true;
}

//------------------------------------------------------------------------------
/// In collapses.
int vtkBoneDecimateLevels::LevelWanted() const
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
bool vtkBoneDecimateLevels::Fill(vtkPolyData* other, vtkPolyData* output)
{
  const bonedecimate::Levels& levels = this->Internal->Levels;
  const int level = this->LevelWanted();
  const std::optional<bonedecimate::Level> found = other
    ? levels.AtOn(bonedecimate::ToSurface(other, this->NumberOfThreads).Surface, level)
    : levels.At(level);
  if (!found)
  {
    vtkErrorMacro(<< "the second input has other triangles than the first, or points that are not "
                     "finite or beyond 1e30 mm");
    return false;
  }
  output->SetPoints(
    bonedecimate::ToPoints(found->Surface.Points, levels.Log().IsSingle, this->NumberOfThreads));
  output->SetPolys(bonedecimate::ToCells(found->Surface.Triangles, this->NumberOfThreads));
  return true;
}

//------------------------------------------------------------------------------
void vtkBoneDecimateLevels::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Mode: " << this->Mode << "\n";
  os << indent << "CoarsestNumberOfTriangles: " << this->CoarsestNumberOfTriangles << "\n";
  os << indent << "MaximumError: " << this->MaximumError << " mm\n";
  os << indent << "AllowLargeError: " << this->AllowLargeError << "\n";
  os << indent << "MeasureErrors: " << this->MeasureErrors << "\n";
  os << indent << "NumberOfThreads: " << this->NumberOfThreads << "\n";
  os << indent << "NumberOfTriangles: " << this->NumberOfTriangles << "\n";
  os << indent << "LevelError: " << this->LevelError << " mm\n";
  os << indent << "NumberOfMarks: " << this->GetNumberOfMarks() << "\n";
}
