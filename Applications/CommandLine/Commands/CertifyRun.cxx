// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "CertifyRun.h"

#include "Arguments/InputArguments.h"
#include "BoneVolume.h"
#include "CertificatePage.h"
#include "Figures/BoundText.h"
#include "Files/FileNames.h"
#include "Files/StagedFile.h"
#include "Files/SurfaceFiles.h"
#include "Formats/FileChecks.h"
#include "Formats/FileFrame.h"
#include "LeftOutOfReader.h"
#include "NumberText.h"
#include "Picture.h"
#include "PlainText.h"
#include "Report/JsonReport.h"
#include "Report/PageSurfaces.h"
#include "ReportFields.h"
#include "Runs/FilterRun.h"
#include "Runs/SlabSource.h"
#include "Terminal/ProgressDisplay.h"

#include "vtkPointData.h"

#include <cmath>
#include <iostream>

namespace bonedecimate
{
namespace
{
constexpr int DecimalsOfLine = 6;
constexpr int DecimalsOfProgress = 4;
}

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
  else
  {
    this->Frame = "LPS"; // of label maps
  }
  const MillimeterSurface result =
    ReadInput(this->Requested.Result(), this->Requested.Unit, this->Warnings);
  this->Result = this->InFrameOfReference(result.Surface);
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
    this->Voxels->Compare(this->Result, this->Requested.Result(), this->Requested.Map,
      this->Requested.Threads, this->Warnings);
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
  const bool hasFile = !this->Requested.Json.empty() || !this->Requested.Page.empty();
  this->Filter->SetMeasureSurfaces(
    hasFile || !(this->Requested.Quiet || this->Requested.FirstProof));
  const Progress progress = this->Requested.Quiet ? Progress::Hidden : Progress::Bar;
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
std::string CertifyRun::BoundsSoFar() const
{
  const double upper = this->Filter->GetUpperBound();
  return std::isnan(upper) ? std::string()
                           : LowerBoundText(this->Filter->GetLowerBound(), DecimalsOfProgress) +
      " to " + UpperBoundText(upper, DecimalsOfProgress) + " mm";
}

//------------------------------------------------------------------------------
void CertifyRun::Write()
{
  if (!this->Requested.Page.empty())
  {
    StagedFile page(this->Requested.Page);
    StagedFile picture(this->Requested.Page + ".png"); // never committed: the page holds it
    this->WritePage(page, picture);
    page.Commit();
  }
  if (!this->Requested.Json.empty())
  {
    WriteTextFile(this->Requested.Json, this->Json());
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
void CertifyRun::Tell()
{
  if (this->Requested.Quiet)
  {
    return;
  }
  if (this->Requested.HasReference())
  {
    this->TellDistance();
  }
  if (this->Voxels)
  {
    this->Voxels->Print();
  }
  if (!this->ReportOfResult.empty())
  {
    std::cout << "report in the file   " << PlainText(this->ReportOfResult) << "\n";
  }
  PrintWarnings(this->Warnings);
}

//------------------------------------------------------------------------------
std::string CertifyRun::Line() const
{
  const std::string status = this->Filter->GetStatusAsString();
  const std::string stopped = this->Filter->GetReportText("stopped");
  return LowerBoundText(this->Filter->GetLowerBound(), DecimalsOfLine) + " to " +
    UpperBoundText(this->Filter->GetUpperBound(), DecimalsOfLine) + " mm" +
    (this->Filter->GetStatus() == vtkBoneSurfaceDistance::NOT_ASKED ? "" : ", " + status) +
    (stopped.empty() ? "" : ", " + stopped);
}

//------------------------------------------------------------------------------
ExitCode CertifyRun::Code() const
{
  if (this->Filter->GetWasStopped())
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
void CertifyRun::TellDistance() const
{
  if (this->Filter->GetWasStopped())
  {
    std::cout << this->Filter->GetReportText("stopped") << "\n";
  }
  std::cout << "distance             "
            << LowerBoundText(this->Filter->GetLowerBound(), DecimalsOfRounding) << " to "
            << UpperBoundText(this->Filter->GetUpperBound(), DecimalsOfRounding)
            << " mm, two-sided\n";
  this->TellDirection("reference_to_result", "reference -> result  ");
  this->TellDirection("result_to_reference", "result -> reference  ");
  const std::string boundaries = this->Filter->GetReportText("boundaries");
  this->TellDirection("boundary_reference_to_result", "boundary ref -> res  ");
  this->TellDirection("boundary_result_to_reference", "boundary res -> ref  ");
  if (boundaries == "reference_only" || boundaries == "result_only")
  {
    std::cout << "boundaries           only the "
              << (boundaries == "result_only" ? "result" : "reference") << " has some\n";
  }
  if (const double components = this->Value("result.components"); !std::isnan(components))
  {
    const auto count = [this](const char* name) { return GroupedText(this->Value(name)); };
    std::cout << "components           " << count("result.components") << ", the reference has "
              << count("reference.components") << "\n"
              << "triangles            " << count("result.triangles") << ", the reference has "
              << count("reference.triangles") << "\n";
  }
  for (int i = 0; !this->LeftOut(i).empty(); ++i)
  {
    std::cout << "left out             " << PlainText(this->LeftOut(i)) << "\n";
  }
  this->TellStatus();
  std::cout << "seconds              " << FixedText(this->Value("seconds"), 2) << "\n";
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
vtkSmartPointer<vtkPolyData> CertifyRun::InFrameOfReference(vtkPolyData* result)
{
  const std::string& frame = FrameOf(result);
  if (frame.empty() || this->Frame.empty() || frame == this->Frame)
  {
    return result;
  }
  this->Warnings.push_back("the axes of '" + BaseName(this->Requested.Result()) + "' are " + frame +
    ", those of the reference " + this->Frame + ": the result was turned to the reference");
  return TurnedAboutZ(result);
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

//------------------------------------------------------------------------------
void CertifyRun::TellDirection(const std::string& path, const std::string& words) const
{
  const double lower = this->Value(path + ".lower");
  if (std::isnan(lower))
  {
    return;
  }
  std::cout << words << LowerBoundText(lower, DecimalsOfRounding) << " to "
            << UpperBoundText(this->Value(path + ".upper"), DecimalsOfRounding) << " mm";
  const auto triangle = static_cast<long long>(this->Value(path + ".triangle"));
  if (triangle >= 0)
  {
    std::cout << " at (" << FixedText(this->Value(path + ".x"), 4) << ", "
              << FixedText(this->Value(path + ".y"), 4) << ", "
              << FixedText(this->Value(path + ".z"), 4) << "), triangle " << triangle;
  }
  std::cout << "\n";
  const double mean = this->Value(path + ".mean");
  if (!std::isnan(mean))
  {
    std::cout << "                     mean " << FixedText(mean, 6) << " +- "
              << FixedText(this->Value(path + ".mean_error"), 6) << ", RMS "
              << FixedText(this->Value(path + ".rms"), 6) << " +- "
              << FixedText(this->Value(path + ".rms_error"), 6) << " mm\n";
  }
}

//------------------------------------------------------------------------------
std::string CertifyRun::StatusText() const
{
  const std::string word = this->Filter->GetStatusAsString();
  return word +
    (this->Filter->GetStatus() == vtkBoneSurfaceDistance::VIOLATED       ? ", not <= "
        : this->Filter->GetStatus() == vtkBoneSurfaceDistance::UNDECIDED ? " whether <= "
                                                                         : " <= ");
}

//------------------------------------------------------------------------------
void CertifyRun::TellStatus() const
{
  const std::string map = this->Requested.ToleranceArray.empty()
    ? ""
    : "the map '" + this->Requested.ToleranceArray + "'";
  const std::string number =
    this->Requested.Tolerance ? FixedText(*this->Requested.Tolerance, 6) + " mm" : "";
  if (this->Filter->GetStatus() != vtkBoneSurfaceDistance::NOT_ASKED)
  {
    std::cout << "tolerance            " << this->StatusText() << map
              << (map.empty() || number.empty() ? "" : " and ") << number
              << (this->CoversWhatWasLeftOut() ? "" : ", but for what was left out") << "\n";
  }
}
}
