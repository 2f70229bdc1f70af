// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "RegionRun.h"

#include "Base/RunProgress.h"
#include "Base/StageClock.h"
#include "Options/RunKinds.h"
#include "Proof/Guard/GuardReach.h"
#include "RegionCut.h"
#include "RegionMatch.h"
#include "RegionProof.h"
#include "RegionReport.h"
#include "Run/Input/PrepareInput.h"
#include "Run/Input/Tolerances.h"
#include "Run/Input/VoxelSize.h"
#include "Run/Output/ListLeftOut.h"
#include "Run/Output/ResultProof.h"

#include <algorithm>

namespace bonedecimate
{
namespace
{
/// Fractions of the progress.
constexpr double PreparedAt = 0.05;
constexpr double JoinedFrom = 0.95;

/// What a run has beside options and tolerances.
std::vector<Request> RequestsOf(const RunInputs& inputs)
{
  return { { "a reference", { Need::Reference }, inputs.Reference != nullptr },
    { "a label map", { Need::LabelMap }, inputs.LabelMap != nullptr },
    { "a log of edits", { Need::Log }, inputs.Log != nullptr },
    { "a part of a surface", { Need::PartOfSurface }, inputs.Part != nullptr },
    { "edge lengths of points", { Need::GradedLengths }, inputs.EdgeLengths != nullptr } };
}

/// Whether the largest error or a tolerance limits every point, and no request needs the whole
/// surface.
bool CanRunInRegions(const Options& options, const RunInputs& inputs)
{
  const std::vector<double>& tolerances = *inputs.Tolerances;
  const bool areAllLimited = options.BoundsError() ||
    std::none_of(tolerances.begin(), tolerances.end(), [](double t) { return t < 0.0; });
  const std::vector<RunKind> kinds = { FindRunKind("Regions") };
  return options.ProvesError() && areAllLimited &&
    FindUnsupported(kinds, RequestsOf(options)).empty() &&
    FindUnsupported(kinds, RequestsOf(inputs)).empty();
}

/// The cache of the caller during a run; an empty one if there is none, or if another run uses it.
class CacheUse
{
public:
  explicit CacheUse(RegionCache* shared)
    : Shared(shared != nullptr && shared->BeginRun() ? shared : nullptr)
  {
  }
  ~CacheUse()
  {
    if (this->Shared != nullptr)
    {
      this->Shared->EndRun();
    }
  }
  CacheUse(const CacheUse&) = delete;
  CacheUse& operator=(const CacheUse&) = delete;

  /// Keeps nothing of this run.
  void Drop()
  {
    if (this->Shared != nullptr)
    {
      this->Shared->Release();
    }
  }
  RegionCache* operator->() { return this->Shared != nullptr ? this->Shared : &this->Own; }

private:
  RegionCache* Shared;
  RegionCache Own;
};

class RegionRun
{
public:
  RegionRun(const Surface& input, const Options& options, const Monitor& monitor,
    const RunInputs& inputs, WholeRun run)
    : Input(input)
    , Effective(options)
    , Inputs(inputs)
    , Run(run)
    , Progress(monitor)
    , Cache(inputs.Regions)
  {
    this->Made.Report.Requested = options;
    this->Made.Report.Voxel = ApplyPreset(input, this->Effective);
    this->WantsProof = bonedecimate::WantsProof(this->Effective, true);
  }

  RegionStatus Decimate()
  {
    const RegionStatus status = this->Try();
    if (status != RegionStatus::Used)
    {
      this->Cache.Drop();
    }
    return status;
  }

  Result TakeResult() { return std::move(this->Made); }

private:
  RegionStatus Try()
  {
    if (!this->FindRegions())
    {
      return RegionStatus::OtherOptions;
    }
    if (!this->CutRegions())
    {
      return RegionStatus::TooLarge;
    }
    this->Made.Report.Seconds.Prepare = this->Clock.Seconds();
    return this->RunParts() && this->Join() ? RegionStatus::Used : RegionStatus::NotProved;
  }

  /// False if the whole has to run, because it rejects the input or rounds it, or feature curves
  /// meet edges that are not manifold.
  bool FindRegions()
  {
    const Options& options = this->Effective;
    const Labels* labels = this->Inputs.Labels;
    this->Prepared =
      &this->Cache->Whole(this->Input, labels, options.MergePoints, options.NumberOfThreads);
    const CleanSurface& clean = this->Prepared->Cleaned;
    Report& report = this->Made.Report;
    report.Cleaning = clean.Statistics;
    report.HasTolerances = true;
    const PointRounding rounding = RoundingOf(options, this->Inputs.InputIsSingle);
    const bool isManifold = clean.Statistics.NonManifoldPoints == 0;
    if (clean.Status != InputStatus::Good || rounding.HasGrid() ||
      (rounding.ToSingle && !this->Prepared->IsSingle) || (labels != nullptr && !isManifold) ||
      CheckErrors(this->Input, clean, this->Inputs.Tolerances, rounding, this->Effective,
        report.Cleaning, report.Size) != InputStatus::Good)
    {
      return false;
    }
    const std::vector<double> tolerances =
      TolerancesOf(clean, LimitedTolerances(*this->Inputs.Tolerances, report.Size.Diagonal));
    if (tolerances.empty()) // no triangle has a point with one
    {
      return false;
    }
    this->Regions = bonedecimate::FindRegions(
      clean.Surface, tolerances, ErrorsOfReach * report.Size.ErrorBound, options.NumberOfThreads);
    report.Cleaning.ConstrainedPoints = std::count(tolerances.begin(), tolerances.end(), 0.0);
    return true;
  }

  /// The run of a part. Its size says nothing about the whole.
  Options OptionsOfPart() const
  {
    Options options = this->Effective;
    options.AllowLargeError = true;
    return options;
  }

  /// Fills in the parts whose results are kept, and cuts the others. False if they are more than
  /// half of the surface.
  bool CutRegions()
  {
    const CleanSurface& clean = this->Prepared->Cleaned;
    RegionFigures& figures = this->Made.Report.Regions;
    std::size_t triangles = 0;
    for (const Region& region : this->Regions)
    {
      std::shared_ptr<const RegionPart> kept =
        this->Cache->Find(region, this->OptionsOfPart(), this->Inputs.InputIsSingle);
      figures.Kept += kept ? 1 : 0;
      this->Parts.push_back(std::move(kept));
      this->Cut.emplace_back();
      if (!this->Parts.back())
      {
        this->Cut.back() = CutRegion(this->Input, clean, region, this->Effective.NumberOfThreads);
        this->AddLabels(this->Cut.back());
      }
      const RegionPart& part = this->Parts.back() ? *this->Parts.back() : this->Cut.back();
      triangles += part.Triangles.size();
      if (2 * triangles > clean.Surface.Triangles.size())
      {
        return false;
      }
    }
    figures.Count = static_cast<std::int64_t>(this->Parts.size());
    figures.Triangles = static_cast<std::int64_t>(triangles);
    return true;
  }

  void AddLabels(RegionPart& part) const
  {
    const Labels* labels = this->Inputs.Labels;
    part.Labels.Names = labels != nullptr ? labels->Names : std::vector<std::string>();
    for (std::size_t t = 0; t < part.Triangles.size() && labels != nullptr; ++t)
    {
      const Index triangle = this->Prepared->Cleaned.InputTriangle[part.Triangles[t]];
      part.Labels.OfTriangle.push_back(labels->OfTriangle[static_cast<std::size_t>(triangle)]);
    }
  }

  /// False if the result of a part cannot be used. After an abort the other regions stay as they
  /// are.
  bool RunParts()
  {
    this->Progress.Stage(0.0, PreparedAt)(1.0);
    RegionParts made;
    for (std::size_t i = 0; i < this->Parts.size(); ++i)
    {
      const double width = (JoinedFrom - PreparedAt) / static_cast<double>(this->Parts.size());
      const double from = PreparedAt + width * static_cast<double>(i);
      if (!this->Parts[i] && this->Progress.ShouldContinue() &&
        !this->RunPart(this->Cut[i], this->Progress.Stage(from, from + width)))
      {
        return false;
      }
      if (this->Parts[i] == nullptr && this->Progress.ShouldContinue())
      {
        this->Parts[i] = std::make_shared<const RegionPart>(std::move(this->Cut[i]));
        this->Cache->Keep(this->Parts[i], this->OptionsOfPart(), this->Inputs.InputIsSingle);
      }
      if (this->Parts[i] != nullptr)
      {
        made.push_back(this->Parts[i]);
      }
    }
    this->Parts = std::move(made);
    return true;
  }

  bool RunPart(RegionPart& part, const Monitor& monitor)
  {
    constexpr double provedFrom = 0.8;
    Options options = this->OptionsOfPart();
    options.ProveResult = false;
    RunInputs inputs = { this->Inputs.InputIsSingle, true, &part.Tolerances };
    inputs.Labels = this->Inputs.Labels != nullptr ? &part.Labels : nullptr;
    part.Result = this->Run(part.Surface, options, PartOf(monitor, 0.0, provedFrom), inputs);
    const Report& report = part.Result.Report;
    if (this->Progress.ShouldContinue() &&
      (report.Status != InputStatus::Good || report.Cleaning.DroppedTriangles > 0 ||
        !MatchUnchanged(part)))
    {
      return false;
    }
    if (this->WantsProof && this->Progress.ShouldContinue())
    {
      ProvePart(this->Effective, this->Prepared->Statistics.BoundaryEdges > 0,
        PartOf(monitor, provedFrom, 1.0), part);
    }
    return true;
  }

  bool Join()
  {
    const WholeSurface& whole = *this->Prepared;
    const int threads = this->Effective.NumberOfThreads;
    const bool isAborted = !this->Progress.ShouldContinue();
    const std::map<Index, ExtentChange> changes = ChangesOfComponents(whole, this->Parts);
    JoinedRegions joined = JoinRegions(this->Input, whole, this->Parts, threads);
    if (!ArePartsValid(whole, this->Parts, changes, this->WantsProof) ||
      !CheckJoined(this->Input, whole, this->Parts, joined, threads))
    {
      return false;
    }
    FillJoined(whole, this->Parts, joined,
      { this->Effective.MeasureDistances, this->Inputs.WantsOrigins,
        this->WantsProof && !isAborted },
      this->Made);
    CombineReports(whole, this->Parts, changes, this->WantsProof && !isAborted, this->Made);
    ListLeftOut(this->Input, whole.Cleaned, nullptr, this->Inputs, this->Made);
    Report& report = this->Made.Report;
    if (this->Inputs.Labels != nullptr)
    {
      report.Labels = AreasOfLabels(whole, this->Parts, *this->Inputs.Labels);
    }
    report.Regions.Status = RegionStatus::Used;
    if (isAborted)
    {
      MarkAborted(this->WantsProof, report);
    }
    report.Seconds.Decimate = report.Seconds.Prepare + report.Seconds.Collapse;
    this->Progress.Stage(JoinedFrom, 1.0)(1.0);
    report.Seconds.Total = this->Clock.Seconds();
    return true;
  }

  const StageClock Clock;
  const Surface& Input;
  Options Effective; // without a preset, the largest error no more than the diagonal
  const RunInputs& Inputs;
  WholeRun Run;
  RunProgress Progress;
  CacheUse Cache;
  bool WantsProof = false;
  const WholeSurface* Prepared = nullptr;
  std::vector<Region> Regions;
  std::vector<RegionPart> Cut; // of each region, moved to the parts when it has run
  RegionParts Parts;           // of each region; null: it has to run
  bonedecimate::Result Made;
};

/// The result is set if the regions alone were run.
RegionStatus TryRegions(const Surface& input, const Options& options, const Monitor& monitor,
  const RunInputs& inputs, WholeRun run, Result& result)
{
  const std::ptrdiff_t unchanged = inputs.Tolerances == nullptr
    ? 0
    : std::count(inputs.Tolerances->begin(), inputs.Tolerances->end(), 0.0);
  if (unchanged == 0 || inputs.Tolerances->size() != input.Points.size())
  {
    return RegionStatus::NotRequested;
  }
  if (!CanRunInRegions(options, inputs))
  {
    return RegionStatus::OtherOptions;
  }
  if (2 * static_cast<std::size_t>(unchanged) < input.Points.size())
  {
    return RegionStatus::TooLarge;
  }
  RegionRun regions(input, options, monitor, inputs, run);
  const RegionStatus status = regions.Decimate();
  if (status == RegionStatus::Used)
  {
    result = regions.TakeResult();
  }
  return status;
}
}

Result DecimateRegions(const Surface& input, const Options& options, const Monitor& monitor,
  const RunInputs& inputs, WholeRun run)
{
  double reported = 0.0;
  bool shouldContinue = true;
  const Monitor forward = [&](double fraction) // the whole may run after regions
  {
    reported = std::max(reported, fraction);
    shouldContinue = shouldContinue && (!monitor || monitor(reported));
    return shouldContinue;
  };
  Result result;
  const RegionStatus status = TryRegions(input, options, forward, inputs, run, result);
  if (status != RegionStatus::Used)
  {
    result = run(input, options, forward, inputs);
    result.Report.Regions.Status = status;
  }
  return result;
}
}
