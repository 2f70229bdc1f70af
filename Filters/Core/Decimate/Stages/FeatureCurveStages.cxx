// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "FeatureCurveStages.h"

#include <algorithm>
#include <cmath>

namespace bonedecimate
{
namespace
{
constexpr double FacesOfNext = 0.25;
constexpr double EdgesOfBound = 0.5;
/// Once the run is stuck, a stage is run only after the curves have lost more than one edge in this
/// many.
constexpr Index MinOfLines = 128;
constexpr double MinRatioOfCurve = 1e-12;
}

FeatureCurveStages::FeatureCurveStages(
  Editor& editor, const StopTargets& stops, const Monitor& monitor)
  : MeshEditor(editor)
  , All(stops)
  , OfStage(stops)
  , Tell(monitor)
  , TellOfStage(monitor)
  , FacesAtFirst(editor.Mesh().NumberOfFaces())
  , Ratio(this->RatioOf(this->FacesAtFirst))
{
  if (this->FacesAtFirst > stops.Faces && editor.FeatureCurves() != nullptr)
  {
    this->FeatureCurves.emplace(editor);
  }
}

//------------------------------------------------------------------------------
bool FeatureCurveStages::Next()
{
  while (this->GoesOn && this->FeatureCurves)
  {
    this->Ratio *= FacesOfNext;
    this->Ratio =
      this->IsStuck ? this->Ratio : std::max(this->Ratio, this->RatioOf(this->All.Faces));
    const Index faces = this->FacesOfStageAt(this->Ratio);
    const FeatureCurveCollapse::Result lines = this->CollapseFeatureCurves(faces);
    this->Gone += lines.Gone;
    const bool isWorth =
      this->Gone > this->MeshEditor.FeatureCurves()->NumberOfEdges() / MinOfLines;
    const bool areDone = !lines.IsBound || this->Ratio < MinRatioOfCurve;
    if (lines.IsAborted)
    {
      this->Ended = StopReason::Aborted;
      return false;
    }
    this->MayGoOn = !areDone || isWorth;
    const bool isDue = !this->IsStuck || isWorth || (areDone && this->Gone > 0);
    this->BeginStage(faces);
    if (isDue)
    {
      this->Gone = 0;
      return true;
    }
    this->Note(this->Ended);
  }
  return this->GoesOn;
}

//------------------------------------------------------------------------------
void FeatureCurveStages::BeginStage(Index faces)
{
  const double from = this->FractionAt(this->MeshEditor.Mesh().NumberOfFaces());
  const double to = std::max(from, this->FractionAt(faces));
  this->OfStage = { faces, faces == this->All.Faces ? this->All.Error : 0.0 };
  this->TellOfStage = [this, from, to](double done)
  {
    this->Told = std::max(this->Told, from + done * (to - from)); // never less than before
    return this->Tell(this->Told);
  };
}

//------------------------------------------------------------------------------
void FeatureCurveStages::Note(StopReason reason)
{
  const Index faces = this->MeshEditor.Mesh().NumberOfFaces();
  this->Ended = reason;
  this->GoesOn = this->FeatureCurves && reason != StopReason::Aborted && faces > this->All.Faces &&
    (!this->IsStuck || this->MayGoOn);
  this->IsStuck = this->IsStuck || faces > this->OfStage.Faces;
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
  return std::max(this->All.Faces, static_cast<Index>(std::floor(faces)));
}

//------------------------------------------------------------------------------
FeatureCurveCollapse::Result FeatureCurveStages::CollapseFeatureCurves(Index faces)
{
  const double factor = std::sqrt(this->Ratio);
  FeatureCurveCollapse::Targets targets;
  targets.Edges =
    static_cast<Index>(factor * this->MeshEditor.FeatureCurves()->NumberOfEdgesAtFirst());
  targets.Faces = faces;
  targets.Bound = EdgesOfBound * this->MeshEditor.Mesh().LengthAtFirst() / factor;
  const double done = this->FractionAt(this->MeshEditor.Mesh().NumberOfFaces());
  return this->FeatureCurves->Run(targets,
    [this, done](double)
    {
      this->Told = std::max(this->Told, done);
      return this->Tell(this->Told);
    });
}

//------------------------------------------------------------------------------
double FeatureCurveStages::FractionAt(Index faces) const
{
  const double wanted = this->FacesAtFirst - this->All.Faces;
  return std::min(1.0, (this->FacesAtFirst - faces) / std::max(1.0, wanted));
}
}
