// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "CertifyRun.h"

#include "Arguments/InputArguments.h"
#include "BoneVolume.h"
#include "CertificateFinding.h"
#include "CertificatePage.h"
#include "Files/FileNames.h"
#include "Files/StagedFile.h"
#include "Files/SurfaceFiles.h"
#include "Formats/FileChecks.h"
#include "Formats/FileFrame.h"
#include "LeftOutOfReader.h"
#include "Picture.h"
#include "PlainText.h"
#include "Report/JsonReport.h"
#include "Report/PageSurfaces.h"
#include "ReportFields.h"
#include "Runs/FilterRun.h"
#include "Runs/SlabSource.h"
#include "Terminal/ProgressDisplay.h"

#include "vtkPointData.h"

namespace bonedecimate
{
CertifyRun::CertifyRun(const CertifyArguments& arguments)
  : Requested(arguments)
{
}

//------------------------------------------------------------------------------
void CertifyRun::Read()
{
  if (this->Requested.HasReference())
  {
    this->ReadReference();
  }
  const MillimeterSurface result =
    ReadInput(this->Requested.Result(), this->Requested.Unit, this->Warnings);
  this->ResultAsRead = result.Surface;
  this->Result = this->InFrame(this->Frame, "reference");
  this->ReportOfResult = ReportFields(result.InFile).Text("proof.sentence");
  this->Filter->SetInputData(1, this->Result);
}

//------------------------------------------------------------------------------
std::string CertifyRun::Json() const
{
  const CertificateSubject subject = { this->Requested.HasReference() ? this->Requested.Files[0]
                                                                      : std::string(),
    this->Requested.Result(), this->Requested.Map.Path, this->Requested.Tolerance,
    this->Requested.ToleranceArray, this->Requested.Unit.Name,
    this->Voxels ? this->Voxels->Json() : nlohmann::ordered_json(), this->Warnings,
    this->ReportOfResult, this->Requested.Settings, this->Requested.Iso };
  return ComposeJsonCertificate(
    this->Requested.HasReference() ? this->Filter->GetReportAsJson() : std::string(), subject);
}

//------------------------------------------------------------------------------
void CertifyRun::CompareVoxels()
{
  if (!this->Requested.Map.Path.empty())
  {
    this->Voxels.emplace();
    this->WereVoxelsStopped = !this->Voxels->Compare(this->InFrame("LPS", "label map"),
      this->Requested.Result(), this->Requested.Map, this->Requested.Threads, this->Warnings);
  }
  if (this->WereVoxelsStopped)
  {
    this->Voxels.reset();
    this->Warnings.push_back("stopped before the voxels were compared");
  }
}

//------------------------------------------------------------------------------
void CertifyRun::Compare()
{
  if (!this->Requested.HasReference())
  {
    return;
  }
  if (this->Requested.Tolerance)
  {
    this->Filter->SetTolerance(*this->Requested.Tolerance);
  }
  this->Filter->SetToleranceArrayName(this->Requested.ToleranceArray);
  this->Filter->SetTightBounds(!this->Requested.FirstProof);
  this->Filter->SetRelativeGap(this->Requested.Gap);
  this->Filter->SetMeasureBoundaries(!this->Requested.WithoutBoundaries);
  this->Filter->SetMeasureMeans(!this->Requested.WithoutMeans);
  this->Filter->SetMeanPrecision(this->Requested.Precision);
  this->Filter->SetNumberOfThreads(this->Requested.Threads);
  if (this->Requested.Page.empty())
  {
    this->Filter->SetSignedDistanceArrayName({}); // only the page has distances of points
  }
  const bool hasFile = !this->Requested.Json.empty() || !this->Requested.Page.empty();
  this->Filter->SetMeasureSurfaces(
    hasFile || !(this->Requested.Quiet || this->Requested.FirstProof));
  const Progress progress =
    this->Requested.Quiet || this->Requested.IsOneOfSeveral ? Progress::Hidden : Progress::Bar;
  this->Filter->SetFollowBounds(ProgressDisplay::IsBar(progress));
  const VtkMessages messages = UpdateUntilInterrupted(
    this->Filter, progress, "proving", [this] { return this->BoundsSoFar(); });
  const std::string problem = this->Filter->GetReportText("problem");
  if (!messages.Errors.empty() || !problem.empty())
  {
    throw Failure(ExitCode::InputRejected,
      "'" + this->Requested.Files[0] + "' and '" + this->Requested.Files[1] +
        "' were rejected: " + (messages.Errors.empty() ? problem : messages.Errors.front()));
  }
  AcceptMessages(messages, this->Requested.Files[1], this->Warnings, this->Requested.Unit);
}

//------------------------------------------------------------------------------
void CertifyRun::Reserve()
{
  if (!this->Requested.Page.empty())
  {
    this->Page.emplace(this->Requested.Page);
  }
  if (!this->Requested.Json.empty())
  {
    this->Certificate.emplace(this->Requested.Json);
  }
}

//------------------------------------------------------------------------------
void CertifyRun::Write()
{
  if (this->Page)
  {
    StagedFile picture(this->Requested.Page + ".png"); // never committed: the page holds it
    this->WritePage(*this->Page, picture);
    this->Page->Flush();
  }
  if (this->Certificate)
  {
    this->Certificate->WriteText(this->Json());
    this->Certificate->Flush();
  }
  for (std::optional<StagedFile>* file : { &this->Page, &this->Certificate })
  {
    if (*file)
    {
      (*file)->Commit();
    }
  }
}

//------------------------------------------------------------------------------
void CertifyRun::WritePage(StagedFile& page, StagedFile& picture)
{
  PairSubject pair;
  vtkSmartPointer<vtkPolyData> result;
  std::string pictureFile;
  if (this->Requested.HasReference() && !this->Filter->GetWasStopped())
  {
    const char* const distance = "Distance";
    const std::string array = this->Filter->GetSignedDistanceArrayName();
    pair.Before = WithoutSigns(this->Filter->GetOutput(0), array, distance);
    result = WithoutSigns(this->Filter->GetOutput(1), array, distance);
    pair.Result = result;
    pair.DistanceArrayName = pair.ResultDistanceArrayName = distance;
    pair.Reduce = ReduceForPage;
    pair.Frame = this->Frame;
    PictureSubject drawn;
    drawn.Before = pair.Before;
    drawn.After = pair.Result;
    drawn.DistanceArrayName = distance;
    drawn.Title = PlainText(BaseName(this->Requested.Result()));
    drawn.Frame = this->Frame;
    drawn.Names = { "Reference", "Result" };
    const std::string certificate = this->Json();
    const ReportFields report(certificate);
    drawn.Triangles = { report.Number("reference.triangles"), report.Number("result.triangles") };
    drawn.Tolerance = this->Requested.Tolerance.value_or(0.0);
    drawn.Mark = MarkOfCertificate(certificate);
    const std::string problem = WritePicture(drawn, picture.GetTemporary());
    TakeVtkMessages(); // whatever VTK said about a missing display is in the problem
    pictureFile = problem.empty() ? picture.GetTemporary() : std::string();
    if (!problem.empty())
    {
      this->Warnings.push_back("the picture could not be drawn: " + problem);
    }
  }
  page.WriteText(ComposeCertificatePage(this->Json(), pair, pictureFile));
}

//------------------------------------------------------------------------------
ExitCode CertifyRun::Code() const
{
  if (this->Filter->GetWasStopped() || this->WereVoxelsStopped)
  {
    return ExitCode::Interrupted;
  }
  if (this->Voxels && this->Voxels->IsViolated())
  {
    return ExitCode::Violated;
  }
  switch (this->Filter->GetStatus())
  {
    case vtkBoneSurfaceDistance::VIOLATED:
      return ExitCode::Violated;
    case vtkBoneSurfaceDistance::UNDECIDED:
      return ExitCode::Undecided;
    default:
      return ExitCode::Done;
  }
}

//------------------------------------------------------------------------------
void CertifyRun::ReadReference()
{
  const std::string& file = this->Requested.Files[0];
  if (this->Requested.Iso)
  {
    this->ReadScan(file);
    return;
  }
  const MillimeterSurface reference = ReadInput(file, this->Requested.Unit, this->Warnings);
  NeedPointArray(reference.Surface, this->Requested.ToleranceArray, file);
  this->Frame = FrameOf(reference.Surface);
  this->Filter->SetInputData(0, reference.Surface);
}

//------------------------------------------------------------------------------
void CertifyRun::ReadScan(const std::string& file)
{
  const BoneSurface bone = ExtractBoneSurface(
    file, *this->Requested.Iso, LabelPolicy::Reject, this->Requested.Map.GetSpacing());
  if (!bone.Surface)
  {
    Reject(file, bone.Problem);
  }
  if (!bone.Note.empty())
  {
    this->Warnings.push_back(bone.Note);
  }
  if (bone.Padding > 0)
  {
    AddLeftOutOfReader(PaddingLeftOut(bone.Padding), bone.Surface);
  }
  this->Frame = "LPS";
  this->Filter->SetInputData(0, bone.Surface);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> CertifyRun::InFrame(const std::string& frame, const std::string& owner)
{
  const std::string& own = FrameOf(this->ResultAsRead);
  if (own.empty() || frame.empty() || own == frame)
  {
    return this->ResultAsRead;
  }
  this->Warnings.push_back("the axes of '" + BaseName(this->Requested.Result()) + "' are " + own +
    ", those of the " + owner + " " + frame + ": the result was turned to the " + owner);
  return TurnedAboutZ(this->ResultAsRead);
}

//------------------------------------------------------------------------------
std::string CertifyRun::LeftOut(int entry) const
{
  return this->Filter->GetReportText("left_out." + std::to_string(entry) + ".sentence");
}

//------------------------------------------------------------------------------
bool CertifyRun::CoversWhatWasLeftOut() const
{
  const double tolerance = this->Requested.Tolerance.value_or(0.0);
  for (int i = 0; !this->LeftOut(i).empty(); ++i)
  {
    if (!(this->Value("left_out." + std::to_string(i) + ".distance") <= tolerance))
    {
      return false;
    }
  }
  return true;
}
}
