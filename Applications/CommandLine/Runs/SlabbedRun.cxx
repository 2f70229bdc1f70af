// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SlabbedRun.h"

#include "Arguments/FilterOptions.h"
#include "Arguments/FlagNames.h"
#include "Arguments/MemoryArguments.h"
#include "Base/StageClock.h"
#include "ExitCode.h"
#include "FilePath.h"
#include "Files/FileNames.h"
#include "Files/OutputFiles.h"
#include "Files/SurfaceFiles.h"
#include "Files/WrittenProof.h"
#include "FilterRun.h"
#include "Formats/FileChecks.h"
#include "Formats/SurfaceFormat.h"
#include "Partition/Slabs/SlabRun.h"
#include "Report/JsonReport.h"
#include "Report/Summary.h"
#include "ReportFields.h"
#include "Segments/SegmentFiles.h"
#include "Segments/SegmentOutput.h"
#include "Segments/SegmentSurfaces.h"
#include "SlabSource.h"
#include "SurfaceArrays.h"
#include "SurfaceConversion.h"
#include "Terminal/Interruption.h"

#include "vtkNew.h"

#include <filesystem>
#include <memory>

namespace bonedecimate
{
namespace
{
/// One run; the steps are in the order of RunInSlabs().
class SlabbedRun
{
public:
  explicit SlabbedRun(const Arguments& arguments)
    : Requested(arguments)
    , Path(arguments.Inputs[0])
    , Subject(SubjectOf(arguments, arguments.Inputs[0], arguments.Output))
    , Display(ProgressOf(arguments))
  {
    if (arguments.Iso)
    {
      this->Subject.CoordinateSystem = "LPS";
    }
    this->Display.Begin("counting");
    this->Source = MakeSlabSource(arguments);
    this->RejectIf(this->Source->GetProblem());
    this->Plan = PlanSlabs(this->Source->GetExtent(), arguments.Memory);
    this->RejectIf(this->Plan.Problem);
    this->Subject.SecondsRead = this->Whole.Seconds();
  }

  bool FitsAsAWhole() const { return this->Plan.IsWhole; }

  void Decimate()
  {
    const std::size_t slabs = this->Source->Divide(this->Plan.Triangles, this->Plan.VoxelBytes);
    Options options = OptionsForFiles(this->Requested);
    options.VoxelSize = options.VoxelSize > 0.0 ? options.VoxelSize : this->Source->GetVoxelSize();
    SlabRun run(options, this->Source->GetAxis(), this->Source->GetInputs());
    for (std::size_t i = 0; i < slabs && run.Status() == SlabStatus::Good; ++i)
    {
      this->Display.Begin("slab " + std::to_string(i + 1) + " of " + std::to_string(slabs));
      this->Add(run);
      StopIfInterrupted();
    }
    this->Take(run, options);
  }

  void Write(OutputFiles& files)
  {
    const StageClock watch;
    this->Display.Begin("writing");
    for (StagedFile& file : files.Surfaces)
    {
      this->WriteOne(file);
    }
    if (this->Requested.Segments.IsRequested())
    {
      WriteSegments(this->Result, this->Requested, files, this->Subject);
    }
    for (const SurfaceFormat* format : FormatsOfSurfaces(this->Requested))
    {
      const std::string loss = LossText(this->Result, *format);
      if (!loss.empty())
      {
        this->Subject.Notes.push_back(loss);
      }
    }
    if (!WritesSegments(this->Requested))
    {
      this->Subject.OutputBytes = static_cast<std::int64_t>(
        std::filesystem::file_size(FilePath(files.Surfaces.front().GetTemporary())));
    }
    this->Subject.SecondsWrite = watch.Seconds();
    this->Subject.SecondsTotal = this->Whole.Seconds();
    if (files.Report)
    {
      files.Report->WriteText(ComposeJsonReport(this->Result, this->Subject));
    }
    this->Display.Clear();
  }

  void Tell(const std::vector<std::string>& written)
  {
    if (!this->Requested.Quiet)
    {
      PrintSummary(this->Result, this->Subject, written);
    }
  }

  vtkSmartPointer<vtkPolyData> GetResult() { return this->Result; }

private:
  void RejectIf(const std::string& problem) const
  {
    if (!problem.empty())
    {
      Reject(this->Path, WithFlags(problem));
    }
  }

  void Add(SlabRun& run)
  {
    const StageClock watch;
    SlabSource::ReadSlab read = this->Source->ReadNext();
    this->RejectIf(read.Problem);
    this->Subject.SecondsRead += watch.Seconds();
    run.Add(std::move(read.Slab),
      [this](double fraction)
      {
        this->Display.Show(fraction);
        return !IsInterrupted();
      });
  }

  void Take(SlabRun& run, const Options& options)
  {
    this->Display.Begin("joining");
    bonedecimate::Result result = run.Finish();
    this->RejectIf(run.Message());
    const bool isSingle = options.OutputPointsPrecision != PointsPrecision::Double;
    const vtkNew<vtkPolyData> nothing; // of which arrays would pass
    this->Result = vtkSmartPointer<vtkPolyData>::New();
    FillOutput(result, {}, options, isSingle, nothing, this->Result);
    this->Source->AddArrays(result, this->Result);
    this->Result = WithColorArray(this->Result);
    RequireProof(
      ReportFields(this->Result).Text("proof.status"), this->Path, ProofMessage(result.Report));
    this->Subject.Slabs = run.Figures();
    if (!this->Source->GetNote().empty())
    {
      this->Subject.Warnings.push_back(this->Source->GetNote());
    }
    if (!this->Source->GetRemark().empty())
    {
      this->Subject.Notes.push_back(this->Source->GetRemark());
    }
  }

  /// What was proved holds for the file if its triangles are the same bits.
  void WriteOne(StagedFile& file)
  {
    const vtkSmartPointer<vtkPolyData> readBack =
      WriteSurface(this->Result, file.GetTemporary(), file.GetTarget());
    RequireSameTriangles(this->Result, readBack, file.GetTarget());
    this->Subject.ProvedFiles[BaseName(file.GetTarget())] = "same_bits";
  }

  const Arguments& Requested;
  const std::string& Path;
  StageClock Whole;
  ReportSubject Subject;
  ProgressDisplay Display;
  std::unique_ptr<SlabSource> Source;
  SlabPlan Plan;
  vtkSmartPointer<vtkPolyData> Result;
};
}

vtkSmartPointer<vtkPolyData> RunInSlabs(const Arguments& arguments)
{
  SlabbedRun run(arguments);
  if (run.FitsAsAWhole())
  {
    return nullptr;
  }
  OutputFiles files(arguments);
  run.Decimate();
  run.Write(files);
  StopIfInterrupted();
  run.Tell(files.Commit());
  return run.GetResult();
}
}
