// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "RunOne.h"

#include "BoneVolume.h"
#include "BoundText.h"
#include "ExitCode.h"
#include "FileNames.h"
#include "FileRounding.h"
#include "FilterOptions.h"
#include "FilterRun.h"
#include "Formats/FileChecks.h"
#include "Formats/SurfaceFormat.h"
#include "InputArguments.h"
#include "Interruption.h"
#include "JsonReport.h"
#include "OutputFiles.h"
#include "PageSurfaces.h"
#include "Picture.h"
#include "ReportFields.h"
#include "SegmentFiles.h"
#include "SegmentOutput.h"
#include "SegmentSurfaces.h"
#include "SlabbedRun.h"
#include "StageClock.h"
#include "Summary.h"
#include "SurfaceFiles.h"
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
/// One run; the steps are in the order of RunOne().
class BoneRun
{
public:
  explicit BoneRun(const Arguments& arguments)
    : Requested(arguments)
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
    ProgressDisplay display(ProgressOf(this->Requested));
    display.Begin("reading");
    if (this->Requested.Segments.IsRequested())
    {
      const SegmentSurfaces segments = ExtractSegments(this->Requested, this->Subject.Warnings);
      this->Input = segments.Surface;
      this->Filter->SetLabelMapData(segments.Map);
      this->Subject.Changed = segments.Changed;
    }
    else if (this->Volume)
    {
      const BoneSurface bone = ExtractBoneSurface(this->Path, *this->Requested.Iso,
        this->Requested.TakesLabels ? LabelPolicy::AsIntensities : LabelPolicy::Reject,
        this->Requested.LabelMap.GetSpacing(),
        CavityFilling(this->Requested, this->Subject.Changed));
      this->Subject.CoordinateSystem = "LPS";
      if (!bone.Surface)
      {
        Reject(this->Path, bone.Problem);
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
      const MillimeterSurface loaded =
        ReadInput(this->Path, this->Requested.Unit, this->Subject.Warnings);
      this->Input = loaded.Surface;
      this->InputInFile = loaded.InFile;
      this->IsSingle = loaded.IsSingle();
    }
    if (!this->Requested.Reference.empty())
    {
      this->Reference = ReadInMillimeters(this->Requested.Reference, this->Requested.Unit).Surface;
      this->Filter->SetReferenceData(this->Reference);
    }
    ApplyLabelMap(this->Requested.LabelMap, this->Filter, this->Subject.Warnings);
    this->Subject.SecondsRead = watch.Seconds();
  }

  void Decimate()
  {
    Options options = OptionsForFiles(this->Requested);
    if (options.ErrorPreset != ErrorPreset::NoPreset && options.VoxelSize == 0.0)
    {
      options.VoxelSize = this->VoxelSize;
    }
    this->ReserveRounding(options);
    ApplyOptions(options, this->Filter);
    this->Input = ApplyRegions(this->Requested.Regions, this->Requested.Options.ToleranceArrayName,
      this->Path, this->Input, this->Filter, this->Subject.Warnings);
    this->Filter->SetMeasureInputDistances(this->WantsDistances());
    this->Filter->SetInputData(this->InputBeforeRounding());
    const VtkMessages messages =
      UpdateFilter(this->Filter, ProgressOf(this->Requested), "simplifying");
    this->AcceptProof(messages);
    this->RequireTriangles(messages);
    AcceptMessages(messages, this->Path, this->Subject.Warnings);
    this->TakeResult();
  }

  void WriteSurfaces(OutputFiles& files)
  {
    const StageClock watch;
    ProgressDisplay display(ProgressOf(this->Requested));
    display.Begin("writing");
    for (StagedFile& file : files.Surfaces)
    {
      const vtkSmartPointer<vtkPolyData> readBack =
        WriteSurface(this->InFile, file.GetTemporary(), file.GetTarget());
      this->ProveFile(ToMillimeters(readBack, this->Requested.Unit), file.GetTarget());
      if (!WritesSegments(this->Requested) && &file == &files.Surfaces.front())
      {
        this->Subject.OutputBytes =
          static_cast<std::int64_t>(std::filesystem::file_size(file.GetTemporary()));
      }
    }
    if (this->Requested.Segments.IsRequested())
    {
      WriteSegments(this->Result, this->Requested, files, this->Subject);
    }
    for (const SurfaceFormat* format : FormatsOfSurfaces(this->Requested))
    {
      const std::string loss = LossText(this->InFile, *format);
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
      PageSubject page = PageOfRun(this->Filter);
      page.Name = this->Subject.Input;
      page.Result = this->Result;
      page.Changes = ChangesTexts(this->Subject.Changed, !this->Subject.Segments.empty());
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
    if (!this->Requested.Quiet)
    {
      PrintSummary(this->Result, this->Subject, this->Notes, written);
    }
    if (this->Requested.PictureIsRequired && !this->Requested.Picture.empty() &&
      !this->PictureProblem.empty())
    {
      throw Failure(ExitCode::CouldNotWrite,
        "could not draw '" + this->Requested.Picture + "': " + this->PictureProblem +
          "; everything else is written");
    }
  }

  vtkSmartPointer<vtkPolyData> GetResult() { return this->Result; }

private:
  /// Reduces the largest error by what writing in another unit rounds.
  void ReserveRounding(Options& options)
  {
    if (this->Requested.Unit.IsMillimeter())
    {
      return;
    }
    this->WritesSingle = options.OutputPointsPrecision == PointsPrecision::Single ||
      (options.OutputPointsPrecision == PointsPrecision::Default && this->IsSingle);
    options.OutputPointsPrecision = PointsPrecision::Double;
    const bool isLimited = !options.ToleranceArrayName.empty() || !this->Requested.Regions.empty();
    if (options.BoundsError() || (isLimited && options.ProvesError()))
    {
      this->Rounding = LargestRounding(this->Input, this->Requested.Unit, this->WritesSingle);
    }
    this->Error = options.BoundsError() ? KnownError(options) : 0.0;
    if (this->Error > 0.0)
    {
      options.MaximumError =
        ErrorBeforeRounding(this->Error, this->Rounding, this->Requested.Unit, this->Path);
    }
  }

  vtkSmartPointer<vtkPolyData> InputBeforeRounding() const
  {
    const std::string array = this->Filter->GetToleranceArrayName();
    if (this->Rounding == 0.0 || array.empty())
    {
      return this->Input;
    }
    if (this->WritesSingle && !this->IsSingle && HasZeroTolerance(this->Input, array))
    {
      Reject(this->Path,
        "single precision in " + this->Requested.Unit.Name + " would move points of tolerance 0; " +
          ExtensionsThat(&SurfaceFormat::HoldsDoubles) + " hold double precision");
    }
    return TolerancesBeforeRounding(this->Input, array, this->Rounding);
  }

  /// The result in millimeters with what is proved of the files, and as the files will have it.
  void TakeResult()
  {
    const LengthUnit& unit = this->Requested.Unit;
    this->Result = this->Filter->GetOutput();
    if (this->Requested.Segments.IsRequested())
    {
      this->Result = WithColorArray(this->Result);
    }
    this->InFile = FromMillimeters(this->Result, unit, this->WritesSingle, this->InputInFile);
    if (this->Rounding == 0.0)
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
    if (this->Requested.Unit.IsMillimeter())
    {
      return this->Filter->GetOutput(1);
    }
    const vtkSmartPointer<vtkPolyData> heatmap =
      FromMillimeters(WithWidenedBounds(this->Filter->GetOutput(1),
                        this->Filter->GetInputErrorBoundArrayName(), this->Move),
        this->Requested.Unit, this->IsSingle, this->InputInFile);
    const std::string array = this->Filter->GetToleranceArrayName();
    if (!array.empty())
    {
      heatmap->GetPointData()->AddArray(this->Input->GetPointData()->GetArray(array.c_str()));
    }
    return heatmap;
  }

  bool WantsDistances() const
  {
    return !this->Requested.Heatmap.empty() || !this->Requested.Picture.empty() ||
      !this->Requested.Page.empty();
  }

  void AcceptProof(const VtkMessages& messages) const
  {
    const std::string status = this->Filter->GetReportText("proof.status");
    if (status == "violated" || status == "undecided")
    {
      throw Failure(status == "violated" ? ExitCode::Violated : ExitCode::Undecided,
        "'" + BaseName(this->Path) + "': " +
          (messages.Errors.empty() ? status : messages.Errors.front()) + "; nothing was written");
    }
  }

  void ProveFile(vtkPolyData* readBack, const std::string& target)
  {
    if (this->Filter->GetReportText("proof.status").empty())
    {
      return;
    }
    const vtkSmartPointer<vtkPolyData> inFile = ToMillimeters(this->InFile, this->Requested.Unit);
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

  void RequireTriangles(const VtkMessages& messages) const
  {
    if (messages.Errors.empty() && this->Filter->GetOutput()->GetNumberOfPolys() == 0)
    {
      Reject(
        this->Path, messages.Warnings.empty() ? "it holds no triangle" : messages.Warnings.front());
    }
  }

  const Arguments& Requested;
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
  double Rounding = 0.0;     // mm, for rounding; 0 in millimeters
  double Error = 0.0;        // mm, requested in another unit than millimeters; 0: none
  double Move = 0.0;         // mm, by rounding
  vtkSmartPointer<vtkPolyData> Result;
  vtkSmartPointer<vtkPolyData> InFile; // the same in the unit of the files

  std::vector<std::string> Notes;
  std::string PictureProblem;
};
}

vtkSmartPointer<vtkPolyData> RunOne(const Arguments& arguments)
{
  if (arguments.Memory > 0)
  {
    if (const vtkSmartPointer<vtkPolyData> result = RunInSlabs(arguments))
    {
      return result;
    }
  }
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
