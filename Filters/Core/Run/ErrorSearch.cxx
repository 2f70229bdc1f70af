// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ErrorSearch.h"

#include "Base/RunProgress.h"
#include "Base/StageClock.h"
#include "Mesh/Cleaning.h"
#include "Proof/Certificate/Certificate.h"
#include "Run/Output/ListLeftOut.h"
#include "Run/Output/ResultProof.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bonedecimate
{
namespace
{
/// Part of a run without a largest error in its progress; the rest is its certificate.
constexpr double ProgressOfPlainRun = 0.9;

/// Runs of the same input with different errors.
class Trials
{
public:
  Trials(
    const Surface& input, const ErrorSearchOptions& options, const Monitor& monitor, bool isCurve)
    : Input(input)
    , Requested(options)
    , IsCurve(isCurve)
    , Progress(monitor)
  {
    this->Requested.Run.ProveResult = true;
    this->Requested.Run.MeasureDistances = false;
    this->Requested.Run.MeasureInputDistances = false;
  }

  ErrorSearchResult& Output() { return this->Found; }

  /// @param error mm; 0: none.
  /// @returns Whether there is a result, which is then the last trial.
  bool Run(double error, std::int64_t mostTriangles, double from, double to)
  {
    const StageClock clock;
    Options options = this->Requested.Run;
    options.MaximumError = error;
    const bool isLimited = error > 0.0 || this->Requested.Inputs.Tolerances != nullptr;
    options.AllowLargeError = options.AllowLargeError && isLimited; // alone it would be warned of
    Result result = error > 0.0
      ? Decimate(this->Input, options, this->Progress.Stage(from, to), this->Requested.Inputs)
      : this->PlainRun(options, from, to);
    this->Status = result.Report.Status;
    const bool isRejected = this->Status != InputStatus::Good;
    const bool isWhole = !isRejected && result.Report.Proof.WasMade;
    if (isWhole)
    {
      this->Add(error, mostTriangles, clock.Seconds(), result.Report);
    }
    this->Found.WasAborted = !this->Progress.ShouldContinue();
    const bool endsCurve = isRejected && this->IsCurve;
    if (isWhole ? this->IsBetter() : endsCurve || this->Found.Best < 0)
    {
      this->Found.Found = std::move(result);
    }
    return isWhole;
  }

  const ErrorTrial& Last() const { return this->Found.Trials.back(); }

  /// Whether the last run was rejected because the input itself is farther from the reference than
  /// the largest error.
  bool IsFarFromReference() const { return this->Status == InputStatus::FarFromReference; }

private:
  /// Certified afterwards, against the reference if there is one.
  Result PlainRun(const Options& options, double from, double to)
  {
    const double runAt = from + ProgressOfPlainRun * (to - from);
    RunInputs inputs = this->Requested.Inputs;
    inputs.Reference = nullptr; // a run takes it with a largest error only
    Result result = Decimate(this->Input, options, this->Progress.Stage(from, runAt), inputs);
    if (result.Report.Status == InputStatus::Good && this->Progress.ShouldContinue())
    {
      this->ProvePlainRun(options, this->Progress.Stage(runAt, to), result);
    }
    return result;
  }

  void ProvePlainRun(const Options& options, const Monitor& monitor, Result& result) const
  {
    const Surface* reference = this->Requested.Inputs.Reference;
    KeptSurface kept;
    if (reference != nullptr)
    {
      const CleanSurface cleaned = Clean(*reference, options.MergePoints, options.NumberOfThreads);
      if (cleaned.Status != InputStatus::Good)
      {
        Result rejected;
        rejected.Report.Status = InputStatus::BadReference;
        result = std::move(rejected);
        return;
      }
      kept = KeptPart(*reference, cleaned);
    }
    const CleanSurface cleaned = Clean(this->Input, options.MergePoints, options.NumberOfThreads);
    ProveResult(this->Input, cleaned, options, monitor, result, this->Requested.Inputs.Tolerances,
      reference != nullptr ? &kept : nullptr);
    ListLeftOut(
      this->Input, cleaned, reference != nullptr ? &kept : nullptr, this->Requested.Inputs, result);
  }

  void Add(double error, std::int64_t mostTriangles, double seconds, const Report& report)
  {
    const ErrorProof& proof = report.Proof;
    const bool hasNoLimit = error == 0.0 && this->Requested.Inputs.Tolerances == nullptr;
    const bool isProved = hasNoLimit || proof.Status == ProofStatus::Proved;
    this->Found.Trials.push_back(
      { error, report.Output.Faces, proof.Upper(), isProved && report.Output.Faces <= mostTriangles,
        seconds, report.Voxels.WasChecked ? report.Voxels.Changes.Changed : -1 });
  }

  /// Whether the last trial is better than the best one, which it then replaces.
  bool IsBetter()
  {
    const auto last = static_cast<int>(this->Found.Trials.size()) - 1;
    const int best = this->Found.Best;
    const bool isBetter = this->Last().IsReached &&
      (best < 0 || this->Last().Proved < this->Found.Trials[static_cast<std::size_t>(best)].Proved);
    this->Found.Best = isBetter ? last : best;
    return isBetter || best < 0;
  }

  const Surface& Input;
  ErrorSearchOptions Requested;
  bool IsCurve; // errors are those of the caller: a rejected one ends the curve
  RunProgress Progress;
  InputStatus Status = InputStatus::Good; // of the last run
  ErrorSearchResult Found;
};
}

ErrorSearchResult FindSmallestError(
  const Surface& input, const ErrorSearchOptions& options, const Monitor& monitor)
{
  const std::int64_t mostTriangles = options.Run.TargetNumberOfTriangles;
  // its errors are found by the search, so a large one is no mistake of the caller
  ErrorSearchOptions withAnyError = options;
  withAnyError.Run.AllowLargeError = true;
  Trials trials(input, withAnyError, monitor, false);
  double done = 0.5; // each run takes half of the remaining progress
  if (!trials.Run(0.0, mostTriangles, 0.0, done) || !trials.Last().IsReached)
  {
    return std::move(trials.Output());
  }
  double low = 0.0;                   // mm
  double high = trials.Last().Proved; // mm
  double error = high;                // mm
  for (int runs = 1; runs < options.MaxRuns && low < high * (1.0 - options.RelativePrecision);
       ++runs)
  {
    const double next = 0.5 * (1.0 + done);
    const bool isWhole = trials.Run(error, mostTriangles, done, next);
    if (!isWhole && !trials.IsFarFromReference())
    {
      break;
    }
    done = next;
    const bool isReached = isWhole && trials.Last().IsReached;
    high = isReached ? std::min(high, trials.Last().Proved) : high;
    low = isReached ? low : std::max(low, error);
    error = low > 0.0 ? std::sqrt(low * high) : 0.5 * high;
  }
  trials.Output().MaxFailedError = low;
  return std::move(trials.Output());
}

ErrorSearchResult FindErrorCurve(const Surface& input, const std::vector<double>& errors,
  const ErrorSearchOptions& options, const Monitor& monitor)
{
  ErrorSearchOptions withoutTarget = options;
  withoutTarget.Run.TargetNumberOfTriangles = 0;
  Trials trials(input, withoutTarget, monitor, true);
  const double count = static_cast<double>(errors.size());
  for (std::size_t i = 0; i < errors.size(); ++i)
  {
    const auto before = static_cast<double>(i);
    if (!trials.Run(errors[i], std::numeric_limits<std::int64_t>::max(), before / count,
          (before + 1.0) / count))
    {
      break;
    }
  }
  return std::move(trials.Output());
}
}
