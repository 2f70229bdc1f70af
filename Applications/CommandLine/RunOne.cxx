// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "RunOne.h"

#include "BoneVolume.h"
#include "BoundText.h"
#include "ExitCode.h"
#include "FileChecks.h"
#include "FileRounding.h"
#include "FilterOptions.h"
#include "Interruption.h"
#include "JsonReport.h"
#include "OutputFiles.h"
#include "Page.h"
#include "Picture.h"
#include "ProgressBar.h"
#include "ReportFields.h"
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
#include <iterator>

namespace bonedecimate
{
namespace
{
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
      const MillimeterSurface loaded = ReadInMillimeters(this->Path, this->Asked.Unit);
      this->Input = loaded.Surface;
      this->InputInFile = loaded.InFile;
      this->IsSingle = loaded.IsSingle();
      this->Subject.Warnings = loaded.Warnings;
    }
    if (!this->Asked.Reference.empty())
    {
      this->Reference = ReadInMillimeters(this->Asked.Reference, this->Asked.Unit).Surface;
      this->Filter->SetReferenceData(this->Reference);
    }
    this->Subject.SecondsRead = watch.Seconds();
  }

  void Decimate()
  {
    Options options = OptionsForFiles(this->Asked);
    if (options.ErrorPreset != ErrorPreset::NoPreset && options.VoxelSize == 0.0)
    {
      options.VoxelSize = this->VoxelSize;
    }
    this->LeaveRoom(options);
    ApplyOptions(options, this->Filter);
    this->TakeRegions();
    this->Filter->SetMeasureInputDistances(this->WantsDistances());
    vtkNew<ProgressBar> bar;
    bar->SetShown(!this->Asked.Quiet);
    bar->SetTags(this->Asked.HasTags);
    this->Filter->AddObserver(vtkCommand::ProgressEvent, bar);
    this->Filter->SetInputData(this->InputWithRoom());
    TakeVtkMessages();
    this->Filter->Update();
    bar->Clear();
    StopIfInterrupted();
    const VtkMessages messages = TakeVtkMessages();
    this->AcceptProof(messages);
    this->AcceptMessages(messages);
    this->TakeResult();
  }

  void WriteSurfaces(OutputFiles& files)
  {
    const StageClock watch;
    for (StagedFile& file : files.Surfaces)
    {
      const vtkSmartPointer<vtkPolyData> readBack =
        WriteSurface(this->InFile, file.GetTemporary(), file.GetTarget());
      this->ProveFile(ToMillimeters(readBack, this->Asked.Unit), file.GetTarget());
      const std::string loss = LossText(this->InFile, file.GetTarget());
      if (!loss.empty())
      {
        this->Notes.push_back(loss);
      }
    }
    if (files.Heatmap)
    {
      WriteSurface(
        this->HeatmapInFile(), files.Heatmap->GetTemporary(), files.Heatmap->GetTarget());
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
      page.Result = this->Result;
      page.Before = this->Filter->GetOutput(1);
      page.DistanceArrayName = this->Filter->GetInputDistanceArrayName();
      page.PictureFile =
        this->PictureProblem.empty() ? files.Picture->GetTemporary() : std::string();
      files.Page->WriteText(ComposePage(page));
    }
    if (files.Report)
    {
      files.Report->WriteText(ComposeJsonReport(this->Result, this->Subject));
    }
    files.KeepsPicture = files.KeepsPicture && this->PictureProblem.empty();
  }

  void Tell(const std::vector<std::string>& written)
  {
    if (!this->Asked.Quiet)
    {
      PrintSummary(this->Result, this->Subject, this->Notes, written);
    }
    if (!this->Asked.Picture.empty() && !this->PictureProblem.empty())
    {
      throw Failure(ExitCode::CouldNotWrite,
        "could not draw '" + this->Asked.Picture + "': " + this->PictureProblem +
          "; everything else is written");
    }
  }

  vtkSmartPointer<vtkPolyData> GetResult() { return this->Result; }

private:
  /// For what writing in another unit rounds.
  void LeaveRoom(Options& options)
  {
    if (this->Asked.Unit.IsMillimeter())
    {
      return;
    }
    this->WritesSingle = options.OutputPointsPrecision == PointsPrecision::Single ||
      (options.OutputPointsPrecision == PointsPrecision::Default && this->IsSingle);
    options.OutputPointsPrecision = PointsPrecision::Double;
    const bool isLimited = !options.ToleranceArrayName.empty() || !this->Asked.Regions.empty();
    if (options.PromisesError() || (isLimited && options.Mode != Mode::Thesis))
    {
      this->Room = LargestRounding(this->Input, this->Asked.Unit, this->WritesSingle);
    }
    this->Error = options.PromisesError() ? KnownError(options) : 0.0;
    if (this->Error > 0.0)
    {
      options.MaximumError = ErrorWithRoom(this->Error, this->Room, this->Asked.Unit, this->Path);
    }
  }

  vtkSmartPointer<vtkPolyData> InputWithRoom() const
  {
    const std::string array = this->Filter->GetToleranceArrayName();
    if (this->Room == 0.0 || array.empty())
    {
      return this->Input;
    }
    if (this->WritesSingle && !this->IsSingle && HasFrozenPoints(this->Input, array))
    {
      Refuse(this->Path,
        "single precision in " + this->Asked.Unit.Name +
          " would move points of tolerance 0; obj, ply, vtp and vtk hold double precision");
    }
    return TolerancesWithRoom(this->Input, array, this->Room);
  }

  /// The result in millimeters with what is proved of the files, and as the files will have it.
  void TakeResult()
  {
    const LengthUnit& unit = this->Asked.Unit;
    this->Result = this->Filter->GetOutput();
    this->InFile = FromMillimeters(this->Result, unit, this->WritesSingle, this->InputInFile);
    if (this->Room == 0.0)
    {
      return;
    }
    const RoundedResult rounded = RoundForFile(this->Result, this->InFile,
      { unit, this->Error, this->Filter->GetErrorBoundArrayName(), this->Filter->GetMergePoints(),
        this->Path });
    this->Move = rounded.Move;
    this->Result = rounded.Result;
    this->InFile = FromMillimeters(this->Result, unit, this->WritesSingle, this->InputInFile);
    this->Notes.push_back("coordinates in " + unit.Name + " are rounded by up to " +
      UpperBoundText(this->Move, 9) + " mm, which the largest error includes");
  }

  vtkSmartPointer<vtkPolyData> HeatmapInFile() const
  {
    if (this->Asked.Unit.IsMillimeter())
    {
      return this->Filter->GetOutput(1);
    }
    const vtkSmartPointer<vtkPolyData> heatmap =
      FromMillimeters(WithWidenedBounds(this->Filter->GetOutput(1),
                        this->Filter->GetInputErrorBoundArrayName(), this->Move),
        this->Asked.Unit, this->IsSingle, this->InputInFile);
    const std::string array = this->Filter->GetToleranceArrayName();
    if (!array.empty())
    {
      heatmap->GetPointData()->AddArray(this->Input->GetPointData()->GetArray(array.c_str()));
    }
    return heatmap;
  }

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
    const vtkSmartPointer<vtkPolyData> inFile = ToMillimeters(this->InFile, this->Asked.Unit);
    ProvedRun run = { this->Input, inFile,
      ReportFields(this->Result).Number("proof.tolerance").value_or(0.0),
      this->Filter->GetToleranceArrayName(), this->Filter->GetMergePoints(),
      this->Filter->GetNumberOfThreads() };
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
      Refuse(this->Path, WithUnitHint(messages.Errors.front()));
    }
    if (this->Filter->GetOutput()->GetNumberOfPolys() == 0)
    {
      Refuse(
        this->Path, messages.Warnings.empty() ? "it holds no triangle" : messages.Warnings.front());
    }
    std::transform(messages.Warnings.begin(), messages.Warnings.end(),
      std::back_inserter(this->Subject.Warnings), WithUnitHint);
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

  vtkSmartPointer<vtkPolyData> InputInFile; // null: a volume

  bool IsSingle = false;     // the input's file
  bool WritesSingle = false; // in another unit than millimeters
  double Room = 0.0;         // mm, for rounding; 0 in millimeters
  double Error = 0.0;        // mm, asked for in another unit than millimeters; 0: none
  double Move = 0.0;         // mm, by rounding
  vtkSmartPointer<vtkPolyData> Result;
  vtkSmartPointer<vtkPolyData> InFile; // the same in the unit of the files

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
  return run.GetResult();
}
}
