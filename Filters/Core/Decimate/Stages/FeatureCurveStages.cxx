// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "FeatureCurveStages.h"

#include "FeatureCurveCollapse.h"

#include <algorithm>
#include <cmath>

namespace bonedecimate
{
namespace
{
constexpr double FacesOfStage = 0.25;
constexpr double EdgesOfBound = 0.5;
/// Once the loop is stuck, it runs again only after the curves have lost more than one edge in this many.
constexpr Index MinOfLines = 128;
constexpr double MinRatioOfCurve = 1e-12;

class Stages
{
public:
  Stages(Editor& editor, const StopTargets& stops, const Monitor& monitor, const StagedLoop& loop)
    : MeshEditor(editor)
    , Targets(stops)
    , Tell(
        [this, &monitor](double done)
        {
          this->Told = std::max(this->Told, done);
          return monitor(this->Told);
        })
    , Loop(loop)
    , FeatureCurves(editor)
    , FacesAtFirst(editor.Mesh().NumberOfFaces())
    , Ratio(this->RatioOf(this->FacesAtFirst))
  {
  }

  StopReason Run()
  {
    StopReason reason = StopReason::NothingLeft;
    bool isStuck = false;
    bool goesOn = true;
    while (goesOn)
    {
      this->Ratio *= FacesOfStage;
      this->Ratio =
        isStuck ? this->Ratio : std::max(this->Ratio, this->RatioOf(this->Targets.Faces));
      const Index faces = this->FacesOfStageAt(this->Ratio);
      const FeatureCurveCollapse::Result lines = this->CollapseFeatureCurves(faces);
      this->Gone += lines.Gone;
      const bool isWorth =
        this->Gone > this->MeshEditor.FeatureCurves()->NumberOfEdges() / MinOfLines;
      const bool areDone = !lines.IsBound || this->Ratio < MinRatioOfCurve;
      if (lines.IsAborted)
      {
        return StopReason::Aborted;
      }
      if (!isStuck || isWorth || (areDone && this->Gone > 0))
      {
        this->Gone = 0;
        reason = this->RunLoop(faces);
      }
      const bool isThere = this->MeshEditor.Mesh().NumberOfFaces() <= this->Targets.Faces;
      goesOn = reason != StopReason::Aborted && !isThere && !(isStuck && areDone && !isWorth);
      isStuck = isStuck || this->MeshEditor.Mesh().NumberOfFaces() > faces;
    }
    return reason;
  }

private:
  double RatioOf(Index faces) const
  {
    return static_cast<double>(faces) / this->MeshEditor.Mesh().NumberOfFaceSlots();
  }

  Index FacesOfStageAt(double ratio) const
  {
    const double faces = ratio * this->MeshEditor.Mesh().NumberOfFaceSlots();
    return std::max(this->Targets.Faces, static_cast<Index>(std::floor(faces)));
  }

  FeatureCurveCollapse::Result CollapseFeatureCurves(Index faces)
  {
    const double factor = std::sqrt(this->Ratio);
    FeatureCurveCollapse::Targets targets;
    targets.Edges =
      static_cast<Index>(factor * this->MeshEditor.FeatureCurves()->NumberOfEdgesAtFirst());
    targets.Faces = faces;
    targets.Bound = EdgesOfBound * this->MeshEditor.Mesh().LengthAtFirst() / factor;
    const double done = this->FractionAt(this->MeshEditor.Mesh().NumberOfFaces());
    return this->FeatureCurves.Run(targets, [this, done](double) { return this->Tell(done); });
  }

  StopReason RunLoop(Index faces)
  {
    const double from = this->FractionAt(this->MeshEditor.Mesh().NumberOfFaces());
    const bool isLast = faces == this->Targets.Faces;
    const StopTargets stops = { faces, isLast ? this->Targets.Error : 0.0 };
    return this->Loop(stops, PartOf(this->Tell, from, std::max(from, this->FractionAt(faces))));
  }

  double FractionAt(Index faces) const
  {
    const double wanted = this->FacesAtFirst - this->Targets.Faces;
    return std::min(1.0, (this->FacesAtFirst - faces) / std::max(1.0, wanted));
  }

  Editor& MeshEditor;
  StopTargets Targets;
  Monitor Tell; // never less than before
  const StagedLoop& Loop;
  FeatureCurveCollapse FeatureCurves;
  Index FacesAtFirst;
  double Ratio;   // of the faces that there were before the first edit
  Index Gone = 0; // since the loop ran last
  double Told = 0.0;
};
}

StopReason RunInStages(
  Editor& editor, const StopTargets& stops, const Monitor& monitor, const StagedLoop& loop)
{
  const bool hasWork = editor.Mesh().NumberOfFaces() > stops.Faces;
  return hasWork && editor.FeatureCurves() != nullptr ? Stages(editor, stops, monitor, loop).Run()
                                                      : loop(stops, monitor);
}
}
