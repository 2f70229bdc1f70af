// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Goal.h"

#include <algorithm>
#include <cmath>

namespace bonedecimate
{
namespace
{
constexpr double ProgressStep = 0.005;
}

Stops StopsOf(const Options& options, Index faces, bool isLimited)
{
  const bool anyOther =
    isLimited || options.TargetNumberOfTriangles > 0 || options.MaximumError > 0.0;
  const bool reduce =
    options.TargetReduction < 1.0 && (options.TargetReductionIsExplicit || !anyOther);
  const Index byReduction =
    reduce ? static_cast<Index>(std::floor(faces * (1.0 - options.TargetReduction) + 0.5)) : 0;
  const double error = options.Mode == Mode::Thesis ? options.MaximumError : 0.0;
  Index number = std::max(options.TargetNumberOfTriangles, byReduction);
  if (error > 0.0 && number == 0 && !reduce)
  {
    number = faces; // an error alone: no number has to be reached
  }
  return { number, error };
}

//------------------------------------------------------------------------------
Goal::Goal(const Editor& editor, const Stops& stops)
  : Work(editor)
  , Wanted(stops)
  , FacesAtFirst(editor.Mesh().NumberOfFaces())
{
}

//------------------------------------------------------------------------------
void Goal::Set(const Stops& stops)
{
  this->Wanted = stops;
  this->FacesAtFirst = this->Work.Mesh().NumberOfFaces();
  this->Told = 0.0;
}

//------------------------------------------------------------------------------
bool Goal::ErrorIsReached() const
{
  return this->Work.Reference().LargestError() >= this->Wanted.Error;
}

//------------------------------------------------------------------------------
bool Goal::IsReached() const
{
  return this->Work.Mesh().NumberOfFaces() <= this->Wanted.Faces &&
    (this->Wanted.Error == 0.0 || this->ErrorIsReached());
}

//------------------------------------------------------------------------------
StopReason Goal::Reason() const
{
  if (this->Work.NumberOfEdits() == 0)
  {
    return StopReason::AlreadySatisfied;
  }
  return this->Wanted.Error > 0.0 ? StopReason::ErrorReached : StopReason::TargetReached;
}

//------------------------------------------------------------------------------
/// By faces; towards an error nobody knows when it will be reached, so that the end may come early.
double Goal::FractionDone(Index unsettled) const
{
  const Index end = this->Wanted.Error > 0.0 ? 0 : this->Wanted.Faces;
  const double removed = this->FacesAtFirst - this->Work.Mesh().NumberOfFaces() + unsettled;
  return std::min(1.0, removed / std::max(1, this->FacesAtFirst - end));
}

//------------------------------------------------------------------------------
bool Goal::Tell(const Monitor& monitor)
{
  return this->FractionDone(0) < this->Told + ProgressStep || this->TellNow(monitor);
}

//------------------------------------------------------------------------------
bool Goal::TellNow(const Monitor& monitor, Index unsettled)
{
  this->Told = std::max(this->Told, this->FractionDone(unsettled));
  return monitor(this->Told);
}
}
