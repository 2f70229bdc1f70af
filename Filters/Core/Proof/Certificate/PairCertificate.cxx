// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PairCertificate.h"

#include "Base/Parallel.h"
#include "DirectedSearch.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace bonedecimate::certificate
{
namespace
{
/// mm, the least limit of the corners of each simplex.
std::vector<double> MinLimits(const Simplices& simplices, const std::vector<double>& limit)
{
  std::vector<double> least;
  least.reserve(simplices.Size());
  for (const Triangle& corners : simplices.Corners)
  {
    double most = Infinity;
    for (const Index corner : corners)
    {
      most = corner == None ? most : std::min(most, limit[corner]);
    }
    least.push_back(most);
  }
  return least;
}

DirectedCertificate CertifyAlone(const BoundarySet& source, const PairTask& task)
{
  DirectedCertificate bounds;
  const bool isEmpty = source.Segments.Size() == 0;
  bounds.Distance.Lower = bounds.Distance.Upper = isEmpty ? 0.0 : Infinity;
  bounds.Distance.Triangle = isEmpty ? None : source.Segments.TriangleId(0);
  bounds.Distance.Position = isEmpty ? Vector3::Zero() : source.Segments.Points[0];
  if (!task.Options.ToleranceMap.empty() || task.Options.Tolerance)
  {
    const bool isFree = isEmpty ||
      (!source.Limit.empty() &&
        std::none_of(source.Limit.begin(), source.Limit.end(),
          [](double limit) { return std::isfinite(limit); }));
    bounds.Excess = bounds.Distance;
    bounds.Excess.Upper = bounds.Excess.Lower = isFree ? -Infinity : Infinity;
    bounds.Proof = isFree ? ProofStatus::Proved : ProofStatus::Violated;
  }
  return bounds;
}
}

//------------------------------------------------------------------------------
double MaxFinite(const std::vector<double>& limits)
{
  double max = 0.0;
  for (const double limit : limits)
  {
    max = std::isfinite(limit) ? std::max(max, limit) : max;
  }
  return max;
}

//------------------------------------------------------------------------------
PairSearch::PairSearch(const Simplices& reference, const Simplices& result,
  const std::vector<double>& limit, const PairTask& task, BoundsListener listener)
  : Reference(reference)
  , Limit(limit)
  , Listener(std::move(listener))
  , NumberOfThreads(task.Options.NumberOfThreads)
{
  const std::function<void()> tell =
    this->Listener ? std::function<void()>([this] { this->Tell(); }) : nullptr;
  this->Forward = std::make_unique<DirectedSearch>(
    reference, result, task, task.Options.ReferenceTriangleGap, tell);
  if (!task.Options.OneSided)
  {
    this->Backward = std::make_unique<DirectedSearch>(
      result, reference, task, task.Options.ResultTriangleGap, tell);
  }
}

PairSearch::~PairSearch() = default;

//------------------------------------------------------------------------------
/// Tells bounds that are tighter than those told before.
void PairSearch::Tell()
{
  double lower = this->Forward->Bounds().Lower;
  double upper = this->Forward->Bounds().Upper;
  if (this->Backward)
  {
    lower = std::max(lower, this->Backward->Bounds().Lower);
    upper = std::max(upper, this->Backward->Bounds().Upper);
  }
  if (lower > this->ToldLower || upper < this->ToldUpper)
  {
    this->ToldLower = lower;
    this->ToldUpper = upper;
    this->Listener(lower, upper);
  }
}

//------------------------------------------------------------------------------
void PairSearch::FindBounds(Stages& progress, double weight)
{
  if (this->Listener)
  {
    this->Tell();
  }
  std::vector<DirectedSearch*> searches = { this->Forward.get() };
  if (this->Backward)
  {
    searches.push_back(this->Backward.get());
  }
  const double part = weight / (this->Limit.empty() ? 2.0 : 4.0);
  const auto forEach = [&](auto step)
  {
    for (DirectedSearch* search : searches)
    {
      if (progress.ShouldContinue())
      {
        step(*search);
      }
    }
  };
  progress.Next(0.0)(0.0);
  this->FindValues(progress, 0.5 * part);
  forEach([&](DirectedSearch& search) { search.FindDistance(progress, 0.5 * part); });
  if (!this->Limit.empty())
  {
    this->FindExcess(progress, part);
  }
}

//------------------------------------------------------------------------------
/// Trees and values of corners. One thread builds the upper levels of a tree, so the second tree is
/// built beside the values to the first.
void PairSearch::FindValues(Stages& progress, double weight)
{
  if (!progress.ShouldContinue())
  {
    return;
  }
  const Monitor afterStep = progress.Next(0.0);
  this->Forward->BuildTarget([&] { afterStep(1.0); });
  this->Forward->TakeParts();
  const auto findForward = [&]
  {
    if (progress.ShouldContinue())
    {
      this->Forward->FindValues(progress, weight);
    }
  };
  if (!this->Backward)
  {
    findForward();
    return;
  }
  const bool isLarge = this->Reference.Size() > BlockSize;
  RunBoth(
    isLarge ? this->NumberOfThreads : 1, [&] { this->Backward->BuildTarget({}); }, findForward);
  this->Backward->TakeParts();
  if (progress.ShouldContinue())
  {
    this->Backward->FindValues(progress, weight);
  }
}

//------------------------------------------------------------------------------
void PairSearch::FindExcess(Stages& progress, double weight)
{
  const auto isFinite = [](double limit) { return std::isfinite(limit); };
  const auto hasLimit = [&](const Triangle& corners)
  {
    return std::any_of(corners.begin(), corners.end(),
      [&](Index corner) { return corner != None && isFinite(this->Limit[corner]); });
  };
  const std::vector<Triangle>& corners = this->Reference.Corners;
  if (std::none_of(corners.begin(), corners.end(), hasLimit))
  {
    this->Forward->MarkUnlimited();
  }
  else if (progress.ShouldContinue())
  {
    this->Forward->FindExcessOverPoints(this->Limit, progress, weight);
  }
  if (!this->Backward)
  {
    return;
  }
  std::vector<double> least = MinLimits(this->Reference, this->Limit);
  if (!std::all_of(least.begin(), least.end(), isFinite))
  {
    this->Backward->MarkUnlimited();
  }
  else if (progress.ShouldContinue())
  {
    this->Backward->FindExcessOverSimplices(std::move(least), progress, weight);
  }
}

//------------------------------------------------------------------------------
void PairSearch::AddStatistics(Stages& progress, double weight)
{
  for (DirectedSearch* search : { this->Forward.get(), this->Backward.get() })
  {
    if (search != nullptr && progress.ShouldContinue())
    {
      search->AddStatistics(progress, 0.5 * weight);
    }
  }
}

//------------------------------------------------------------------------------
PairCertificate PairSearch::Found(bool wasStopped)
{
  return { this->Forward->Found(wasStopped),
    this->Backward ? this->Backward->Found(wasStopped) : DirectedCertificate() };
}

//------------------------------------------------------------------------------
PairCertificate WithoutPartner(
  const BoundarySet& reference, const BoundarySet& result, const PairTask& task)
{
  return { CertifyAlone(reference, task), CertifyAlone(result, task) };
}
}
