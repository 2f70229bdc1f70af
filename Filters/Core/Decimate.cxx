// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Decimate.h"

#include "Collapse/LineStages.h"
#include "Collapse/OwnPlaces.h"
#include "Collapse/Sweep.h"
#include "Collapse/ThesisLoop.h"
#include "Cost/AutomaticTolerance.h"
#include "Extract.h"
#include "Judgement.h"
#include "Mesh/Checksum.h"
#include "Mesh/Sheets.h"
#include "Mesh/SpatialOrder.h"
#include "Mesh/SurfaceAssembly.h"
#include "OptionTable.h"
#include "Prune.h"
#include "ReferenceInput.h"
#include "Relax/RelaxedLoop.h"
#include "ResultProof.h"
#include "RunProgress.h"
#include "StageClock.h"
#include "Tolerances.h"
#include "VoxelSize.h"

#include <algorithm>
#include <limits>
#include <optional>

namespace bonedecimate
{
namespace
{
/// Where on the way from 0 to 1 each stage ends. Stages that cannot be interrupted are short steps.
constexpr double CleanedAt = 0.01;
constexpr double BuiltAt = 0.02;
constexpr double ExtractionShare = 0.005;

class Run // stage after stage
{
public:
  Run(const Surface& input, const Options& options, const Monitor& monitor,
    const Companions& companions)
    : Input(input)
    , Wanted(options)
    , Progress(monitor)
    , RoundToSingle(options.OutputPointsPrecision == PointsPrecision::Single ||
        (options.OutputPointsPrecision == PointsPrecision::Default && companions.InputIsSingle))
    , WithOrigins(companions.WantsOrigins)
    , Given(companions.Tolerances)
    , Allowed(companions.Tolerances)
    , Reference(companions.Reference)
    , Log(companions.Log)
    , Named(companions.Labels)
  {
  }

  Result Go()
  {
    const StageClock clock;
    if (this->Prepare() && this->Collapse())
    {
      this->Answer.Report.Seconds.Decimate = clock.Seconds();
      const JudgedRun run = { this->Input, this->Cleaned, *this->Work, this->LocalResult,
        this->First ? &this->First->Reference.Surface : nullptr, this->IsProved() };
      Judge(run, this->Wanted, this->Progress, this->Answer);
      this->MeasureLabels();
      this->Prove();
      Report& report = this->Answer.Report;
      report.Stop = this->Progress.GoesOn() ? report.Stop : StopReason::Aborted;
    }
    this->Answer.Report.Seconds.Total = clock.Seconds();
    return std::move(this->Answer);
  }

private:
  bool Prepare()
  {
    const StageClock clock;
    this->Cleaned = Clean(this->Input, this->Wanted.MergePoints, this->Wanted.NumberOfThreads);
    Report& report = this->Answer.Report;
    report.Status = this->Cleaned.Status;
    report.Cleaning = this->Cleaned.Statistics;
    if (this->Wanted.ExamineInput)
    {
      report.Findings = Examine(this->Input, this->Wanted.NumberOfThreads);
    }
    this->Progress.Stage(0.0, CleanedAt)(1.0);
    if (report.Status == InputStatus::Good)
    {
      report.Pruned = Prune(this->Input, this->Wanted, this->Cleaned);
      report.Status = report.Pruned.TookAll ? InputStatus::EverythingPruned : InputStatus::Good;
    }
    if (report.Status == InputStatus::Good)
    {
      report.Status = CheckErrors(
        this->Input, this->Cleaned, this->Given, this->RoundToSingle, this->Wanted, report);
    }
    if (report.Status == InputStatus::Good && this->Given != nullptr)
    {
      this->Limited = LimitedTolerances(*this->Given, report.Size.Diagonal);
      this->Given = this->Allowed = &this->Limited;
    }
    if (report.Status == InputStatus::Good && this->Reference != nullptr)
    {
      this->Compare();
    }
    if (report.Status == InputStatus::Good)
    {
      report.InputChecksum = Checksum(this->Input, this->Wanted.NumberOfThreads);
      this->Build();
    }
    this->Progress.Stage(CleanedAt, BuiltAt)(1.0);
    report.Seconds.Prepare = clock.Seconds();
    return report.Status == InputStatus::Good;
  }

  /// What the first original leaves of the largest error caps the tolerances.
  void Compare()
  {
    this->First = CompareWithReference(*this->Reference, this->Input, this->Cleaned, this->Wanted,
      this->Progress.Stage(CleanedAt, CleanedAt));
    this->Answer.Report.Status = this->First->Status;
    this->Answer.Report.Reference = this->First->Figures;
    std::vector<double>& left = this->First->Left;
    for (std::size_t i = 0; this->Given != nullptr && i < left.size(); ++i)
    {
      const double given = (*this->Given)[i];
      left[i] = given >= 0.0 ? std::min(left[i], given) : left[i];
    }
    this->Allowed = &left;
  }

  /// In steps that are short enough for somebody who waits; what nobody needs any more is left out.
  void Build()
  {
    const int threads = this->Wanted.NumberOfThreads;
    const Monitor tell = this->Progress.Stage(CleanedAt, BuiltAt);
    if (this->Progress.GoesOn())
    {
      SortAlongCurve(this->Cleaned, threads);
    }
    tell(0.25);
    HalfEdgeMesh mesh(this->Cleaned.Surface, threads);
    this->CountLocked(mesh);
    if (this->Named != nullptr)
    {
      mesh =
        HalfEdgeMesh(this->Cleaned.Surface, threads, {}, LabelsOf(this->Cleaned, *this->Named));
    }
    if (this->Progress.GoesOn() && SplitSheets(this->Cleaned, mesh))
    {
      SortAlongCurve(this->Cleaned, threads);
      mesh = HalfEdgeMesh(this->Cleaned.Surface, threads, this->Cleaned.Sheets);
    }
    tell(0.5);
    const bool isThesis = this->Wanted.Mode == Mode::Thesis;
    const Editor::Books books = { isThesis, isThesis, !isThesis && this->Progress.GoesOn() };
    this->Work.emplace(std::move(mesh), this->Cleaned, books, threads);
    if (this->Log != nullptr)
    {
      this->Work->Record();
    }
    if (books.Distances && this->Progress.GoesOn())
    {
      this->Work->Reference().Tree(threads, [&] { tell(0.5); });
    }
    if (this->Progress.GoesOn())
    {
      this->Limit(PartOf(tell, 0.5, 1.0));
    }
  }

  /// What has to be proved, and what stays as it is.
  void Limit(const Monitor& monitor)
  {
    const std::vector<double> tolerances = this->Allowed != nullptr
      ? TolerancesOf(this->Cleaned, *this->Allowed)
      : std::vector<double>();
    const auto any = [&](auto isSo)
    { return std::any_of(tolerances.begin(), tolerances.end(), isSo); };
    const bool promises = this->Wanted.PromisesError();
    if (promises || (this->Wanted.Mode != Mode::Thesis && any([](double t) { return t > 0.0; })))
    {
      Promise promise;
      promise.Error = promises ? this->Wanted.MaximumError : promise.Error;
      promise.RoundsToSingle = this->RoundToSingle;
      promise.Origin = this->Cleaned.Origin;
      promise.Tolerances = tolerances.empty() ? nullptr : &tolerances;
      this->Work->ProveEdits(promise, this->Wanted.NumberOfThreads);
      if (promises && this->Wanted.KeepClearance)
      {
        this->Work->KeepClearance(this->Wanted.MaximumError, this->Wanted.NumberOfThreads, monitor);
      }
    }
    if (!tolerances.empty())
    {
      this->Answer.Report.Cleaning.FrozenPoints = this->Work->Freeze(tolerances);
      this->IsLimited = !any([](double t) { return t < 0.0; });
    }
    if (this->Named != nullptr)
    {
      this->Work->FreeLines();
    }
  }

  void CountLocked(const HalfEdgeMesh& mesh)
  {
    CleaningStatistics& found = this->Answer.Report.Cleaning;
    for (Index v = mesh.NumberOfVertexSlots(); v-- > 0;)
    {
      if (mesh.Kind(v) == VertexKind::Locked)
      {
        ++found.LockedPoints;
        found.FirstLockedPoint = this->Cleaned.InputPoint[v];
      }
    }
  }

  /// Without a number of triangles nobody knows how many will stay.
  double NormalTolerance(const Stops& stops) const
  {
    const double faces = this->Work->Mesh().NumberOfFaces();
    return this->Wanted.AutomaticNormalTolerance && stops.Faces > 0
      ? AutomaticNormalTolerance(stops.Faces / faces)
      : this->Wanted.NormalTolerance;
  }

  StopReason RunLoop(const Monitor& monitor)
  {
    const Stops stops = StopsOf(this->Wanted, this->Work->Mesh().NumberOfFaces(), this->IsLimited);
    if (this->Wanted.Mode == Mode::Thesis)
    {
      const double tolerance = this->NormalTolerance(stops);
      this->Answer.Report.NormalTolerance = tolerance;
      ThesisLoop thesis(*this->Work, tolerance, stops);
      return RunInStages(*this->Work, stops, monitor,
        [&](const Stops& stage, const Monitor& tell) { return thesis.RunTo(stage, tell); });
    }
    if (this->Wanted.Mode == Mode::Fast)
    {
      Sweep sweep(*this->Work, stops, this->Wanted.NumberOfThreads);
      return RunInStages(*this->Work, stops, monitor,
        [&](const Stops& stage, const Monitor& tell) { return sweep.RunTo(stage, tell); });
    }
    const bool isAccurate = this->Wanted.Mode == Mode::Accurate;
    return RelaxedLoop(*this->Work, isAccurate ? AccurateRecipe : BalancedRecipe, stops,
      this->Wanted.NumberOfThreads)
      .Run(monitor);
  }

  /// False if its result cannot be written in single precision.
  bool Collapse()
  {
    const StageClock clock;
    Report& report = this->Answer.Report;
    const double extractedAt = MeasuredFrom(this->Wanted, this->IsProved());
    const double collapsedAt = extractedAt - ExtractionShare;
    report.Stop = this->Progress.GoesOn()
      ? this->RunLoop(this->Progress.Stage(BuiltAt, collapsedAt))
      : StopReason::Aborted;
    const bool placesMayMeet =
      this->RoundToSingle && this->Wanted.MergePoints && this->Work->IsGuaranteed();
    if (placesMayMeet && report.Stop != StopReason::Aborted)
    {
      report.Status = GiveOwnPlaces(*this->Work, this->Input, this->Cleaned, report.Cleaning);
    }
    if (report.Status != InputStatus::Good)
    {
      return false;
    }
    report.Collapses = this->Work->NumberOfEdits();
    report.Refusals = this->Work->Refusals();
    this->HandLogOver();
    this->Extract(this->Progress.Stage(collapsedAt, extractedAt));
    report.RunningError = this->LargestError();
    report.Seconds.Collapse = clock.Seconds();
    return true;
  }

  void HandLogOver()
  {
    if (this->Log == nullptr)
    {
      return;
    }
    EditLog& log = *this->Log;
    log = this->Work->TakeLog();
    log.InputChecksum = this->Answer.Report.InputChecksum;
    log.Vertices = this->Work->Mesh().NumberOfVertexSlots();
    log.Faces = this->Work->Mesh().NumberOfFaceSlots();
    log.IsSingle = this->RoundToSingle;
    log.MergesPoints = this->Wanted.MergePoints;
    const auto place = [this](Index vertex, Vector3& position) {
      position = OutputPosition(this->Input, this->Cleaned, vertex, position, this->RoundToSingle);
    };
    for (LoggedCollapse& collapse : log.Collapses)
    {
      place(collapse.Kept, collapse.Position);
    }
    for (LoggedPatch& patch : log.Patches)
    {
      for (LoggedPatch::Vertex& vertex : patch.Vertices)
      {
        place(vertex.Id, vertex.Position);
      }
    }
  }

  /// Who aborted does not wait for distances.
  void Extract(const Monitor& monitor)
  {
    const int threads = this->Wanted.NumberOfThreads;
    const Original& original = this->Work->Reference();
    const bool distances = this->Wanted.MeasureDistances || original.RecordsDistances();
    const ExtractOptions wanted = { this->RoundToSingle, this->Progress.GoesOn() && distances,
      this->Progress.GoesOn() && this->WithOrigins, threads, this->Named };
    if (wanted.Distances || wanted.Origins)
    {
      original.Tree(threads, [&] { monitor(0.0); });
    }
    this->LocalResult.Points =
      bonedecimate::Extract(this->Input, this->Cleaned, *this->Work, wanted, monitor, this->Answer);
    this->LocalResult.Triangles = this->Answer.Surface.Triangles;
    monitor(1.0);
  }

  void MeasureLabels()
  {
    if (this->Named != nullptr)
    {
      this->Answer.Report.Labels = LabelAreas(this->Cleaned, this->Work->Mesh(), *this->Named);
    }
  }

  /// mm; not a number if nobody looked any point up.
  double LargestError() const
  {
    const std::vector<double>& errors = this->Answer.RunningError;
    if (this->Work->Reference().RecordsDistances())
    {
      return this->Work->Reference().LargestError();
    }
    return errors.empty() ? std::numeric_limits<double>::quiet_NaN()
                          : *std::max_element(errors.begin(), errors.end());
  }

  bool IsProved() const { return WantsProof(this->Wanted, this->Given != nullptr); }

  /// Nothing of the run is needed any more but its result.
  void Prove()
  {
    if (this->IsProved() && this->Progress.GoesOn())
    {
      this->Work.reset();
      this->LocalResult = {};
      this->Cleaned.Surface = {};
      ProveResult(this->Input, this->Cleaned, this->Wanted,
        this->Progress.Stage(MeasuredTo(true), 1.0), this->Answer, this->Given,
        this->First ? &this->First->Reference : nullptr);
    }
  }

  const Surface& Input;
  Options Wanted; // with the largest error that is used
  RunProgress Progress;
  bool RoundToSingle;
  bool WithOrigins;
  const std::vector<double>* Given;   // mm, tolerances of the input points
  const std::vector<double>* Allowed; // mm, the same, capped by what the reference leaves
  std::vector<double> Limited;        // mm, the same, none above the diagonal
  const Surface* Reference;
  std::optional<ReferenceInput> First; // the reference read, if there is one
  EditLog* Log;                        // null: nobody wants it
  const Labels* Named;                 // null: there are none
  bool IsLimited = false;              // whether every point has a tolerance
  CleanSurface Cleaned;
  std::optional<Editor> Work;
  Surface LocalResult; // mm relative to Cleaned.Origin
  Result Answer;
};
}

Result Decimate(const Surface& input, const Options& options, const Monitor& monitor,
  const Companions& companions)
{
  Result result;
  result.Report.Status = InputStatus::InvalidOption;
  if (CheckOptions(options).empty())
  {
    Options wanted = options;
    const VoxelFigures voxel =
      ApplyPreset(companions.Reference != nullptr ? *companions.Reference : input, wanted);
    result = Run(input, wanted, monitor, companions).Go();
    result.Report.Voxel = voxel;
  }
  result.Report.Asked = options;
  return result;
}
}
