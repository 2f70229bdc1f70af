// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "RunOne.h"

#include "Arguments/FilterOptions.h"
#include "Arguments/InputArguments.h"
#include "Base/StageClock.h"
#include "BoneVolume.h"
#include "ExitCode.h"
#include "FilePath.h"
#include "Files/FileNames.h"
#include "Files/InputHints.h"
#include "Files/OutputFiles.h"
#include "Files/OutputRounding.h"
#include "Files/SurfaceFiles.h"
#include "Files/WrittenProof.h"
#include "FilterRun.h"
#include "Formats/FileChecks.h"
#include "Formats/FileFrame.h"
#include "Formats/SurfaceFormat.h"
#include "LeftOutOfReader.h"
#include "Picture.h"
#include "PlainText.h"
#include "Report/JsonReport.h"
#include "Report/PageSurfaces.h"
#include "Report/Summary.h"
#include "ReportFields.h"
#include "Segments/SegmentFiles.h"
#include "Segments/SegmentOutput.h"
#include "Segments/SegmentSurfaces.h"
#include "SlabSource.h"
#include "SlabbedRun.h"
#include "Terminal/Interruption.h"
#include "Terminal/VtkMessages.h"

#include "vtkNew.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <utility>

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
    , Rounding(arguments)
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
      SegmentSurfaces segments = ExtractSegments(this->Requested, this->Subject.Warnings);
      this->Input = segments.Surface;
      this->Subject.CoordinateSystem = "LPS";
      this->Filter->SetLabelMapData(segments.Map);
      this->Subject.Changed = segments.Changed;
      this->Remark = segments.Note;
      this->TakeModelGrid(segments);
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
      if (bone.Padding > 0)
      {
        AddLeftOutOfReader(PaddingLeftOut(bone.Padding), this->Input);
      }
      this->VoxelSize = bone.VoxelSize;
      this->Remark = bone.Remark;
      if (!bone.Note.empty())
      {
        this->Subject.Warnings.push_back(bone.Note);
      }
    }
    else
    {
      const MillimeterSurface loaded =
        ReadInput(this->Path, this->Requested.Unit, this->Subject.Warnings);
      RequireUnitOfFile(loaded, this->Path, this->Requested.Unit);
      this->Input = loaded.Surface;
      this->InputInFile = loaded.InFile;
      this->Remark = loaded.Note;
      this->Subject.CoordinateSystem = FrameOf(loaded.Surface);
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
    this->Rounding.SetInput(this->Input, this->InputInFile);
    this->Rounding.Reserve(options);
    ApplyOptions(options, this->Filter);
    NeedPointArray(this->Input, options.EdgeLengthArrayName, this->Path);
    this->Input = ApplyRegions(this->Requested.Regions, this->Requested.Options.ToleranceArrayName,
      this->Path, this->Input, this->Filter, this->Subject.Warnings);
    this->Filter->SetMeasureInputDistances(this->WantsDistances());
    this->Filter->SetInputData(
      this->Rounding.InputOfRun(this->Input, this->Filter->GetToleranceArrayName()));
    const VtkMessages messages =
      UpdateFilter(this->Filter, ProgressOf(this->Requested), "simplifying");
    this->AcceptProof(messages);
    this->RequireTriangles(messages);
    AcceptMessages(messages, this->Path, this->Subject.Warnings, this->Requested.Unit);
    this->CompareWithFile();
    this->TakeResult();
    if (!this->Volume)
    {
      const std::string hint = VertexCellsHint(this->Input);
      if (!hint.empty())
      {
        this->Subject.Warnings.push_back(hint);
      }
    }
  }

  void WriteSurfaces(OutputFiles& files)
  {
    const StageClock watch;
    ProgressDisplay display(ProgressOf(this->Requested));
    display.Begin("writing");
    for (StagedFile& file : files.Surfaces)
    {
      const LengthUnit unit = UnitOfFile(file.GetTarget(), this->Rounding.GetUnit());
      const vtkSmartPointer<vtkPolyData> written =
        unit.IsMillimeter() ? this->Result.Get() : this->Rounding.GetInFile();
      const vtkSmartPointer<vtkPolyData> readBack =
        WriteSurface(written, file.GetTemporary(), file.GetTarget(), this->Requested.CompressesGlb);
      this->ProveFile(
        ToMillimeters(written, unit), ToMillimeters(readBack, unit), file.GetTarget());
      if (!WritesSegments(this->Requested) && &file == &files.Surfaces.front())
      {
        this->Subject.OutputBytes =
          static_cast<std::int64_t>(std::filesystem::file_size(FilePath(file.GetTemporary())));
      }
    }
    if (this->Requested.Segments.IsRequested())
    {
      WriteSegments(this->Result, this->Requested, files, this->Subject);
    }
    for (const SurfaceFormat* format : FormatsOfSurfaces(this->Requested))
    {
      const bool isDivided = this->Subject.Segments.size() == 1 ||
        (WritesSegments(this->Requested) && this->Requested.Also.empty());
      const std::string loss = LossText(this->Rounding.GetInFile(), *format, isDivided);
      if (!loss.empty())
      {
        this->Subject.Notes.push_back(loss);
      }
    }
    if (files.Heatmap)
    {
      WriteSurface(this->Rounding.HeatmapOf(this->Filter, this->Input),
        files.Heatmap->GetTemporary(), files.Heatmap->GetTarget());
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
    this->PictureProblem = WhyNoPictures();
    if (!this->PictureProblem.empty())
    {
      return; // none was requested, and the page says that it has none
    }
    PictureSubject picture;
    const vtkSmartPointer<vtkPolyData> before = SurfaceBefore(this->Filter);
    picture.Before = before;
    picture.After = this->Filter->GetOutput();
    picture.DistanceArrayName = this->Filter->GetInputDistanceArrayName();
    picture.Title = PlainText(this->Subject.Input);
    picture.Frame = this->Subject.CoordinateSystem;
    TakeReport(picture);
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
      page.Command = "bonedecimate " + this->Subject.Input + " " + this->Subject.Output + " " +
        OptionsText(this->Subject.Given);
      page.Result = this->Result;
      page.Changes = ChangesTexts(this->Subject.Changed, !this->Subject.Segments.empty());
      page.Frame = this->Subject.CoordinateSystem;
      page.Specks = this->Subject.Specks;
      page.ModelGrid =
        this->Subject.ModelGrid ? ModelGridText(*this->Subject.ModelGrid) : std::string();
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
      PrintSummary(this->Result, this->Subject, written);
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
  void TakeModelGrid(SegmentSurfaces& segments)
  {
    if (segments.Model.AreFound())
    {
      const VoxelGrid& grid = segments.Model.Labels.Image.Grid;
      this->Subject.ModelGrid = ModelGridRecord{ segments.Model.Sentence,
        { grid.Spacing[0], grid.Spacing[1], grid.Spacing[2] }, grid.Dimensions,
        segments.Model.Chance, segments.Model.Different };
      segments.Surface = nullptr; // which the filter has
      this->Segments = std::move(segments);
    }
  }

  void CompareWithFile()
  {
    if (this->Subject.ModelGrid)
    {
      this->Subject.ModelGrid->OfFile = CompareWithMapOfFile(
        this->Filter->GetOutput(), this->Segments, this->Requested, this->Subject.Warnings);
      this->Segments = {};
    }
  }

  /// With what is proved of the files.
  void TakeResult()
  {
    vtkSmartPointer<vtkPolyData> result = this->Filter->GetOutput();
    if (this->Requested.Segments.IsRequested())
    {
      result = WithColorArray(result);
    }
    this->Subject.Specks = FindSpecks(SurfaceBefore(this->Filter));
    this->Rounding.Apply(result, this->Filter);
    this->Result = this->Rounding.GetResult();
    this->Subject.Notes = this->Rounding.GetNotes();
    if (!this->Remark.empty())
    {
      this->Subject.Notes.push_back(this->Remark);
    }
    const std::vector<std::string>& warnings = this->Rounding.GetWarnings();
    this->Subject.Warnings.insert(this->Subject.Warnings.end(), warnings.begin(), warnings.end());
  }

  bool WantsDistances() const
  {
    return !this->Requested.Heatmap.empty() || !this->Requested.Picture.empty() ||
      !this->Requested.Page.empty();
  }

  void AcceptProof(const VtkMessages& messages) const
  {
    const std::string status = this->Filter->GetReportText("proof.status");
    RequireProof(status, this->Path, messages.Errors.empty() ? status : messages.Errors.front());
  }

  /// @param written mm, as the file should have it.
  void ProveFile(vtkPolyData* written, vtkPolyData* readBack, const std::string& target)
  {
    if (this->Filter->GetReportText("proof.status").empty())
    {
      return;
    }
    ProvedRun run = { this->Input, written,
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
  OutputRounding Rounding;
  double VoxelSize = 0.0;   // mm, of a volume
  SegmentSurfaces Segments; // of the map of a network, until they are compared with the file
  vtkSmartPointer<vtkPolyData> Input;
  vtkSmartPointer<vtkPolyData> Reference; // null: none
  vtkNew<vtkBoneDecimate> Filter;
  vtkSmartPointer<vtkPolyData> InputInFile; // null: a volume

  vtkSmartPointer<vtkPolyData> Result;

  std::string Remark; // on the input
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
