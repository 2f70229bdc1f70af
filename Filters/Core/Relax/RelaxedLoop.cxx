// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "RelaxedLoop.h"

#include "Collapse/LineStages.h"
#include "Collapse/Sweep.h"

#include <algorithm>

namespace bonedecimate
{
namespace
{
/// Below that share of the original triangles, few remain.
constexpr double FewTriangles = 0.2;
/// Stricter than Fast: what that costs, the relaxation wins back.
constexpr double PeakWeight = 0.5;
/// Of the time, when the sweep ends.
constexpr double SweptAt = 0.3;
}

RelaxedLoop::RelaxedLoop(Editor& editor, const Recipe& recipe, const Stops& stops, int threads)
  : Work(editor)
  , Asked(recipe)
  , Wanted(stops)
  , Threads(threads)
  , FacesAtFirst(editor.Mesh().NumberOfFaces())
{
}

//------------------------------------------------------------------------------
StopReason RelaxedLoop::Run(const Monitor& monitor)
{
  const auto goOn = [&monitor](double done) { return !monitor || monitor(done); };
  const Monitor all = goOn;
  if (this->FacesAtFirst <= this->Wanted.Faces)
  {
    return this->Collapse(this->Wanted.Faces, all);
  }
  const HalfEdgeMesh& original = this->Work.KeepFirst();
  const StopReason swept = this->Collapse(this->FacesOfSweep(), PartOf(all, 0.0, SweptAt));
  if (swept == StopReason::Aborted || !this->Relax(original, PartOf(all, SweptAt, 1.0)))
  {
    return StopReason::Aborted;
  }
  const Goal goal(this->Work, this->Wanted);
  return goal.IsReached()      ? goal.Reason()
    : this->Work.MetItsLimit() ? StopReason::ErrorReached
                               : StopReason::NothingLeft;
}

//------------------------------------------------------------------------------
StopReason RelaxedLoop::Collapse(Index faces, const Monitor& monitor)
{
  Stops stops = this->Wanted;
  stops.Faces = faces;
  Sweep sweep(this->Work, stops, this->Threads, PeakWeight, this->Asked.PlacesTried);
  return RunInStages(this->Work, stops, monitor,
    [&sweep](const Stops& stage, const Monitor& tell) { return sweep.RunTo(stage, tell); });
}

//------------------------------------------------------------------------------
Index RelaxedLoop::FacesOfSweep() const
{
  const double extra = std::min(this->Asked.ExtraOfWanted * this->Wanted.Faces,
    this->Asked.ExtraOfOriginal * this->FacesAtFirst);
  return std::min(this->FacesAtFirst, this->Wanted.Faces + static_cast<Index>(extra));
}

//------------------------------------------------------------------------------
bool RelaxedLoop::Relax(const HalfEdgeMesh& original, const Monitor& monitor)
{
  constexpr double begunAt = 0.2;
  constexpr double relaxedAt = 0.4; // of a round
  constexpr double collapsedAt = 0.7;
  Relaxation relaxation(this->Work, original, this->Threads);
  const bool fewRemain = this->Wanted.Faces < FewTriangles * this->FacesAtFirst;
  const int sweepsAfter = fewRemain ? this->Asked.SweepsIfFew : this->Asked.SweepsAfter;
  const int rounds = this->Work.IsGuaranteed() ? this->Asked.ProvedRounds : 1;
  const Monitor tell = PartOf(monitor, begunAt, collapsedAt);
  bool goesOn = relaxation.Begin(PartOf(monitor, 0.0, begunAt));
  for (int i = 0; i < rounds && goesOn; ++i)
  {
    const Monitor round = PartOf(tell, static_cast<double>(i) / rounds, (i + 1.0) / rounds);
    goesOn = relaxation.Sweep(this->Asked.SweepsBefore, PartOf(round, 0.0, relaxedAt)) &&
      this->CollapseLast(relaxation, PartOf(round, relaxedAt, 1.0));
  }
  return goesOn && relaxation.Sweep(sweepsAfter, PartOf(monitor, collapsedAt, 1.0));
}

//------------------------------------------------------------------------------
bool RelaxedLoop::CollapseLast(Relaxation& relaxation, const Monitor& monitor)
{
  constexpr double lastAt = 0.99;
  if (this->Work.Mesh().NumberOfFaces() <= this->Wanted.Faces)
  {
    return true;
  }
  if (!this->Work.IsGuaranteed() &&
    !relaxation.CollapseTo(
      this->Wanted.Faces, this->Asked.EdgesOfCollapse, PartOf(monitor, 0.0, lastAt)))
  {
    return false;
  }
  if (this->Work.Mesh().NumberOfFaces() <= this->Wanted.Faces)
  {
    return monitor(1.0);
  }
  const Monitor last = PartOf(monitor, lastAt, 1.0);
  const Monitor standing = [&last](double) { return last(0.0); };
  return this->Collapse(this->Wanted.Faces, standing) != StopReason::Aborted &&
    relaxation.Begin(last);
}
}
