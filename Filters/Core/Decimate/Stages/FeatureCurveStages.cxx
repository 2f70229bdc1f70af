// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "FeatureCurveStages.h"

#include <algorithm>
#include <cmath>

namespace bonedecimate
{
namespace
{
constexpr double FacesOfNextStage = 0.25;
constexpr double EdgesOfMaxDeviation = 0.5;
/// Once the run is stuck, a stage is run only after the curves have lost more than one edge in this
/// many.
constexpr Index EdgesPerRemoved = 128;
constexpr double MinRatioOfCurve = 1e-12;
}

FeatureCurveStages::FeatureCurveStages(
  Editor& editor, const StopTargets& stops, const Monitor& monitor)
  : MeshEditor(editor)
  , RunTargets(stops)
  , StageTargets(stops)
  , RunMonitor(monitor)
  , StageMonitor(monitor)
  , InitialFaces(editor.Mesh().NumberOfFaces())
  , Ratio(this->RatioOf(this->InitialFaces))
{
  if (this->InitialFaces > stops.Faces && editor.FeatureCurves() != nullptr)
  {
    this->FeatureCurves.emplace(editor);
  }
}

//------------------------------------------------------------------------------
bool FeatureCurveStages::Next()
{
  while (this->ShouldContinue && this->FeatureCurves)
  {
    this->Ratio *= FacesOfNextStage;
    this->Ratio =
      this->IsStuck ? this->Ratio : std::max(this->Ratio, this->RatioOf(this->RunTargets.Faces));
    const Index faces = this->FacesOfStageAt(this->Ratio);
    const FeatureCurveCollapse::Result curves = this->CollapseFeatureCurves(faces);
    this->RemovedVertices += curves.Removed;
    const bool isWorth =
      this->RemovedVertices > this->MeshEditor.FeatureCurves()->NumberOfEdges() / EdgesPerRemoved;
    const bool isDone = !curves.IsLimited || this->Ratio < MinRatioOfCurve;
    if (curves.IsAborted)
    {
      this->LastReason = StopReason::Aborted;
      return false;
    }
    this->CanCoarsen = !isDone || isWorth;
    const bool isDue = !this->IsStuck || isWorth || (isDone && this->RemovedVertices > 0);
    this->BeginStage(faces);
    if (isDue)
    {
      this->RemovedVertices = 0;
      return true;
    }
    this->NoteEnd(this->LastReason);
  }
  return this->ShouldContinue;
}

//------------------------------------------------------------------------------
void FeatureCurveStages::BeginStage(Index faces)
{
  const double from = this->FractionAt(this->MeshEditor.Mesh().NumberOfFaces());
  const double to = std::max(from, this->FractionAt(faces));
  this->StageTargets = { faces, faces == this->RunTargets.Faces ? this->RunTargets.Error : 0.0 };
  this->StageMonitor = [this, from, to](double done)
  {
    this->Reported = std::max(this->Reported, from + done * (to - from)); // never decreases
    return this->RunMonitor(this->Reported);
  };
}

//------------------------------------------------------------------------------
void FeatureCurveStages::NoteEnd(StopReason reason)
{
  const Index faces = this->MeshEditor.Mesh().NumberOfFaces();
  this->LastReason = reason;
  this->ShouldContinue = this->FeatureCurves && reason != StopReason::Aborted &&
    faces > this->RunTargets.Faces && (!this->IsStuck || this->CanCoarsen);
  this->IsStuck = this->IsStuck || faces > this->StageTargets.Faces;
}

//------------------------------------------------------------------------------
double FeatureCurveStages::RatioOf(Index faces) const
{
  return static_cast<double>(faces) / this->MeshEditor.Mesh().NumberOfFaceSlots();
}

//------------------------------------------------------------------------------
Index FeatureCurveStages::FacesOfStageAt(double ratio) const
{
  const double faces = ratio * this->MeshEditor.Mesh().NumberOfFaceSlots();
  return std::max(this->RunTargets.Faces, static_cast<Index>(std::floor(faces)));
}

//------------------------------------------------------------------------------
FeatureCurveCollapse::Result FeatureCurveStages::CollapseFeatureCurves(Index faces)
{
  const double factor = std::sqrt(this->Ratio);
  FeatureCurveCollapse::Targets targets;
  targets.Edges =
    static_cast<Index>(factor * this->MeshEditor.FeatureCurves()->NumberOfInitialEdges());
  targets.Faces = faces;
  targets.MaxDeviation = EdgesOfMaxDeviation * this->MeshEditor.Mesh().InitialEdgeLength() / factor;
  const double done = this->FractionAt(this->MeshEditor.Mesh().NumberOfFaces());
  return this->FeatureCurves->Run(targets,
    [this, done](double)
    {
      this->Reported = std::max(this->Reported, done);
      return this->RunMonitor(this->Reported);
    });
}

//------------------------------------------------------------------------------
double FeatureCurveStages::FractionAt(Index faces) const
{
  const double wanted = this->InitialFaces - this->RunTargets.Faces;
  return std::min(1.0, (this->InitialFaces - faces) / std::max(1.0, wanted));
}
}
