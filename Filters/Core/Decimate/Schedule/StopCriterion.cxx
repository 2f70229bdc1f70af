// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "StopCriterion.h"

#include <algorithm>
#include <cmath>

namespace bonedecimate
{
namespace
{
constexpr double ProgressStep = 0.005;
}

StopTargets StopTargetsOf(const Options& options, Index faces, bool isLimited)
{
  const bool reduce = options.EndsAtReduction(isLimited);
  const Index byReduction =
    reduce ? static_cast<Index>(std::floor(faces * (1.0 - options.TargetReduction) + 0.5)) : 0;
  const double error = options.ProvesError() ? 0.0 : options.MaximumError;
  Index number = std::max(options.TargetNumberOfTriangles, byReduction);
  if (error > 0.0 && number == 0 && !reduce)
  {
    number = faces; // an error alone: no number has to be reached
  }
  return { number, error };
}

//------------------------------------------------------------------------------
StopCriterion::StopCriterion(const Editor& editor, const StopTargets& stops)
  : MeshEditor(editor)
  , Targets(stops)
  , InitialFaces(editor.Mesh().NumberOfFaces())
{
}

//------------------------------------------------------------------------------
void StopCriterion::Restart(const StopTargets& stops)
{
  this->Targets = stops;
  this->InitialFaces = this->MeshEditor.Mesh().NumberOfFaces();
  this->Reported = 0.0;
}

//------------------------------------------------------------------------------
bool StopCriterion::ErrorIsReached() const
{
  return this->MeshEditor.Original().MaxError() >= this->Targets.Error;
}

//------------------------------------------------------------------------------
bool StopCriterion::IsReached() const
{
  return this->MeshEditor.Mesh().NumberOfFaces() <= this->Targets.Faces &&
    (this->Targets.Error == 0.0 || this->ErrorIsReached());
}

//------------------------------------------------------------------------------
StopReason StopCriterion::Reason() const
{
  if (this->MeshEditor.Totals().Collapses == 0)
  {
    return StopReason::AlreadySatisfied;
  }
  return this->Targets.Error > 0.0 ? StopReason::ErrorReached : StopReason::TargetReached;
}

//------------------------------------------------------------------------------
/// Measured in faces. With an error target, the final number of faces is not known, so the run may
/// end early.
double StopCriterion::FractionDone(Index unsettled) const
{
  const Index end = this->Targets.Error > 0.0 ? 0 : this->Targets.Faces;
  const double removed = this->InitialFaces - this->MeshEditor.Mesh().NumberOfFaces() + unsettled;
  return std::min(1.0, removed / std::max(1, this->InitialFaces - end));
}

//------------------------------------------------------------------------------
bool StopCriterion::Report(const Monitor& monitor)
{
  return this->FractionDone(0) < this->Reported + ProgressStep || this->ReportNow(monitor);
}

//------------------------------------------------------------------------------
bool StopCriterion::ReportNow(const Monitor& monitor, Index unsettled)
{
  this->Reported = std::max(this->Reported, this->FractionDone(unsettled));
  return monitor(this->Reported);
}
}
