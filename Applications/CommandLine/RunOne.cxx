// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "RunOne.h"

#include "BoneVolume.h"
#include "ExitCode.h"
#include "FileChecks.h"
#include "FilterOptions.h"
#include "Interruption.h"
#include "JsonReport.h"
#include "OutputFiles.h"
#include "Page.h"
#include "Picture.h"
#include "ProgressBar.h"
#include "StageClock.h"
#include "Summary.h"
#include "SurfaceFiles.h"
#include "SurfaceFormat.h"
#include "VtkMessages.h"
#include "WrittenProof.h"

#include "vtkNew.h"
#include "vtkPointData.h"

#include <algorithm>
#include <filesystem>

namespace bonedecimate
{
namespace
{
/// What is proved holds for the files only if they are read with the coordinates that were proved.
Options OptionsOf(const Arguments& arguments)
{
  Options options = arguments.Options;
  const auto isSingle = [](const std::string& path) { return !HoldsDoubles(FormatOf(path)); };
  const bool isLimited = (!options.ToleranceArrayName.empty() || !arguments.Regions.empty()) &&
    options.Mode != Mode::Thesis;
  if ((options.PromisesError() || isLimited) &&
    (isSingle(arguments.Output) ||
      std::any_of(arguments.Also.begin(), arguments.Also.end(), isSingle)))
  {
    options.OutputPointsPrecision = PointsPrecision::Single;
  }
  return options;
}

/// A bone on its way; the verbs are in the order of RunOne().
class BoneRun
{
public:
  explicit BoneRun(const Arguments& arguments)
    : Asked(arguments)
    , Path(arguments.Inputs[0])
    , Subject(SubjectOf(arguments, arguments.Inputs[0], arguments.Output))
    , Volume(IsVolume(arguments.Inputs[0]))
  {
    if (!this->Volume)
    {
      CheckFile(this->Path);
    }
  }

  void Read()
  {
    const StageClock watch;
    if (this->Volume)
    {
      const BoneSurface bone = ExtractBoneSurface(this->Path, *this->Asked.Iso,
        this->Asked.TakesLabels ? LabelPolicy::AsIntensities : LabelPolicy::Refuse);
      if (!bone.Surface)
      {
        Refuse(this->Path, bone.Problem);
      }
      this->Input = bone.Surface;
      this->VoxelSize = bone.VoxelSize;
      if (!bone.Note.empty())
      {
        this->Subject.Warnings.push_back(bone.Note);
      }
    }
    else
    {
      const LoadedSurface loaded = ReadSurface(this->Path);
      this->Input = loaded.Surface;
      this->Subject.Warnings = loaded.Warnings;
    }
    if (!this->Asked.Reference.empty())
    {
      this->Reference = ReadSurface(this->Asked.Reference).Surface;
      this->Filter->SetReferenceData(this->Reference);
    }
    this->Subject.SecondsRead = watch.Seconds();
  }

  void Decimate()
  {
    Options options = OptionsOf(this->Asked);
    options.VoxelSize = options.VoxelSize == 0.0 ? this->VoxelSize : options.VoxelSize;
    ApplyOptions(options, this->Filter);
    this->TakeRegions();
    this->Filter->SetMeasureInputDistances(this->WantsDistances());
    vtkNew<ProgressBar> bar;
    bar->SetShown(!this->Asked.Quiet);
    bar->SetTags(this->Asked.HasTags);
    this->Filter->AddObserver(vtkCommand::ProgressEvent, bar);
    this->Filter->SetInputData(this->Input);
    TakeVtkMessages();
    this->Filter->Update();
    bar->Clear();
    StopIfInterrupted();
    const VtkMessages messages = TakeVtkMessages();
    this->AcceptProof(messages);
    this->AcceptMessages(messages);
  }

  void WriteSurfaces(OutputFiles& files)
  {
    const StageClock watch;
    for (StagedFile& file : files.Surfaces)
    {
      const vtkSmartPointer<vtkPolyData> readBack =
        WriteSurface(this->Filter->GetOutput(), file.GetTemporary(), file.GetTarget());
      this->ProveFile(readBack, file.GetTarget());
      const std::string loss = LossText(this->Filter->GetOutput(), file.GetTarget());
      if (!loss.empty())
      {
        this->Notes.push_back(loss);
      }
    }
    if (files.Heatmap)
    {
      WriteSurface(
        this->Filter->GetOutput(1), files.Heatmap->GetTemporary(), files.Heatmap->GetTarget());
    }
    this->Subject.OutputBytes =
      static_cast<std::int64_t>(std::filesystem::file_size(files.Surfaces.front().GetTemporary()));
    this->Subject.SecondsWrite = watch.Seconds();
    this->Subject.SecondsTotal = this->Whole.Seconds();
  }

  void Draw(OutputFiles& files)
  {
    if (!files.Picture)
    {
      return;
    }
    PictureSubject picture;
    picture.Before = this->Filter->GetOutput(1);
    picture.After = this->Filter->GetOutput();
    picture.DistanceArrayName = this->Filter->GetInputDistanceArrayName();
    picture.Title = this->Subject.Input;
    picture.IsInPatientCoordinates = this->Volume;
    this->PictureProblem = WritePicture(picture, files.Picture->GetTemporary());
    TakeVtkMessages(); // whatever VTK said about a missing display is in the problem
    if (!this->PictureProblem.empty())
    {
      this->Subject.Warnings.push_back("the picture could not be drawn: " + this->PictureProblem);
    }
  }

  void Describe(OutputFiles& files)
  {
    if (files.Page)
    {
      PageSubject page;
      page.Name = this->Subject.Input;
      page.Result = this->Filter->GetOutput();
      page.Before = this->Filter->GetOutput(1);
      page.DistanceArrayName = this->Filter->GetInputDistanceArrayName();
      page.PictureFile =
        this->PictureProblem.empty() ? files.Picture->GetTemporary() : std::string();
      files.Page->WriteText(ComposePage(page));
    }
    if (files.Report)
    {
      files.Report->WriteText(ComposeJsonReport(this->Filter->GetOutput(), this->Subject));
    }
    files.KeepsPicture = files.KeepsPicture && this->PictureProblem.empty();
  }

  void Tell(const std::vector<std::string>& written)
  {
    if (!this->Asked.Quiet)
    {
      PrintSummary(this->Filter->GetOutput(), this->Subject, this->Notes, written);
    }
    if (!this->Asked.Picture.empty() && !this->PictureProblem.empty())
    {
      throw Failure(ExitCode::CouldNotWrite,
        "could not draw '" + this->Asked.Picture + "': " + this->PictureProblem +
          "; everything else is written");
    }
  }

  vtkPolyData* Result() { return this->Filter->GetOutput(); }

private:
  bool WantsDistances() const
  {
    return !this->Asked.Heatmap.empty() || !this->Asked.Picture.empty() ||
      !this->Asked.Page.empty();
  }

  void AcceptProof(const VtkMessages& messages) const
  {
    const std::string verdict = this->Filter->GetReportText("proof.verdict");
    if (verdict == "violated" || verdict == "undecided")
    {
      throw Failure(verdict == "violated" ? ExitCode::Violated : ExitCode::Undecided,
        "'" + BaseName(this->Path) + "': " +
          (messages.Errors.empty() ? verdict : messages.Errors.front()) + "; nothing was written");
    }
  }

  void ProveFile(vtkPolyData* readBack, const std::string& target)
  {
    if (this->Filter->GetReportText("proof.verdict").empty())
    {
      return;
    }
    ProvedRun run = { this->Input, this->Filter->GetOutput(),
      this->Filter->GetReportValue("proof.tolerance"), this->Filter->GetToleranceArrayName(),
      this->Filter->GetMergePoints(), this->Filter->GetNumberOfThreads() };
    if (this->Reference)
    {
      ProvedRun map = run;
      map.Tolerance = 0.0;
      run.Input = this->Reference;
      run.ToleranceArray.clear();
      if (!map.ToleranceArray.empty())
      {
        ProveWritten(map, readBack, target);
      }
    }
    this->Subject.ProvedFiles[BaseName(target)] = ProveWritten(run, readBack, target);
  }

  /// An array of tolerances from the regions, if there are any.
  void TakeRegions()
  {
    std::string name = this->Asked.Options.ToleranceArrayName;
    if (!name.empty() && !this->Input->GetPointData()->HasArray(name.c_str()))
    {
      Refuse(this->Path, "it has no point array '" + name + "'");
    }
    if (!this->Asked.Regions.empty())
    {
      if (name.empty())
      {
        name = "Tolerance";
        // A result of an earlier run still has that run's.
        vtkNew<vtkPolyData> without;
        without->ShallowCopy(this->Input);
        without->GetPointData()->RemoveArray(name.c_str());
        this->Input = without;
      }
      for (const std::string& region : IdleRegions(this->Input, this->Asked.Regions))
      {
        this->Subject.Warnings.push_back("no point of the surface lies in " + region);
      }
      this->Input = WithTolerances(this->Input, this->Asked.Regions, name);
      this->Filter->SetToleranceArrayName(name);
    }
  }

  void AcceptMessages(const VtkMessages& messages)
  {
    if (!messages.Errors.empty())
    {
      Refuse(this->Path, messages.Errors.front());
    }
    if (this->Filter->GetOutput()->GetNumberOfPolys() == 0)
    {
      Refuse(
        this->Path, messages.Warnings.empty() ? "it holds no triangle" : messages.Warnings.front());
    }
    this->Subject.Warnings.insert(
      this->Subject.Warnings.end(), messages.Warnings.begin(), messages.Warnings.end());
  }

  const Arguments& Asked;
  const std::string& Path;
  StageClock Whole;
  ReportSubject Subject;
  bool Volume;
  double VoxelSize = 0.0; // mm, of a volume
  vtkSmartPointer<vtkPolyData> Input;
  vtkSmartPointer<vtkPolyData> Reference; // null: none
  vtkNew<vtkBoneDecimate> Filter;
  std::vector<std::string> Notes;
  std::string PictureProblem;
};
}

vtkSmartPointer<vtkPolyData> RunOne(const Arguments& arguments)
{
  BoneRun run(arguments);
  OutputFiles files(arguments);
  run.Read();
  StopIfInterrupted();
  run.Decimate();
  run.WriteSurfaces(files);
  StopIfInterrupted();
  run.Draw(files);
  run.Describe(files);
  StopIfInterrupted();
  run.Tell(files.Commit());
  return run.Result();
}
}
