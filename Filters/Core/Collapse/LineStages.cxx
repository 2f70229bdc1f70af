// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "LineStages.h"

#include "LineCollapse.h"

#include <algorithm>
#include <cmath>

namespace bonedecimate
{
namespace
{
constexpr double FacesOfStage = 0.25;
constexpr double EdgesOfBound = 0.5;
/// Stuck lines that lose a smaller share of their edges than one by so many are not worth another run of the loop.
constexpr Index LeastOfLines = 128;
constexpr double LeastShare = 1e-12;

class Stages
{
public:
  Stages(Editor& editor, const Stops& stops, const Monitor& monitor, const StagedLoop& loop)
    : Work(editor)
    , Wanted(stops)
    , Tell(
        [this, &monitor](double done)
        {
          this->Told = std::max(this->Told, done);
          return monitor(this->Told);
        })
    , Loop(loop)
    , Lines(editor)
    , FacesAtFirst(editor.Mesh().NumberOfFaces())
    , Share(this->ShareOf(this->FacesAtFirst))
  {
  }

  StopReason Run()
  {
    StopReason reason = StopReason::NothingLeft;
    bool isStuck = false;
    bool goesOn = true;
    while (goesOn)
    {
      this->Share *= FacesOfStage;
      this->Share =
        isStuck ? this->Share : std::max(this->Share, this->ShareOf(this->Wanted.Faces));
      const Index faces = this->FacesOfStageAt(this->Share);
      const LineCollapse::Answer lines = this->CollapseLines(faces);
      this->Gone += lines.Gone;
      const bool isWorth = this->Gone > this->Work.Lines()->NumberOfEdges() / LeastOfLines;
      const bool areDone = !lines.IsBound || this->Share < LeastShare;
      if (lines.IsAborted)
      {
        return StopReason::Aborted;
      }
      if (!isStuck || isWorth || (areDone && this->Gone > 0))
      {
        this->Gone = 0;
        reason = this->RunLoop(faces);
      }
      const bool isThere = this->Work.Mesh().NumberOfFaces() <= this->Wanted.Faces;
      goesOn = reason != StopReason::Aborted && !isThere && !(isStuck && areDone && !isWorth);
      isStuck = isStuck || this->Work.Mesh().NumberOfFaces() > faces;
    }
    return reason;
  }

private:
  double ShareOf(Index faces) const
  {
    return static_cast<double>(faces) / this->Work.Mesh().NumberOfFaceSlots();
  }

  Index FacesOfStageAt(double share) const
  {
    const double faces = share * this->Work.Mesh().NumberOfFaceSlots();
    return std::max(this->Wanted.Faces, static_cast<Index>(std::floor(faces)));
  }

  LineCollapse::Answer CollapseLines(Index faces)
  {
    const double factor = std::sqrt(this->Share);
    LineCollapse::Wish wish;
    wish.Edges = static_cast<Index>(factor * this->Work.Lines()->NumberOfEdgesAtFirst());
    wish.Faces = faces;
    wish.Bound = EdgesOfBound * this->Work.Mesh().LengthAtFirst() / factor;
    const double done = this->FractionAt(this->Work.Mesh().NumberOfFaces());
    return this->Lines.Run(wish, [this, done](double) { return this->Tell(done); });
  }

  StopReason RunLoop(Index faces)
  {
    const double from = this->FractionAt(this->Work.Mesh().NumberOfFaces());
    const bool isLast = faces == this->Wanted.Faces;
    const Stops stops = { faces, isLast ? this->Wanted.Error : 0.0 };
    return this->Loop(stops, PartOf(this->Tell, from, std::max(from, this->FractionAt(faces))));
  }

  double FractionAt(Index faces) const
  {
    const double wanted = this->FacesAtFirst - this->Wanted.Faces;
    return std::min(1.0, (this->FacesAtFirst - faces) / std::max(1.0, wanted));
  }

  Editor& Work;
  Stops Wanted;
  Monitor Tell; // never less than before
  const StagedLoop& Loop;
  LineCollapse Lines;
  Index FacesAtFirst;
  double Share;   // of the faces that there were before the first edit
  Index Gone = 0; // since the loop ran last
  double Told = 0.0;
};
}

StopReason RunInStages(
  Editor& editor, const Stops& stops, const Monitor& monitor, const StagedLoop& loop)
{
  const bool hasWork = editor.Mesh().NumberOfFaces() > stops.Faces;
  return hasWork && editor.Lines() != nullptr ? Stages(editor, stops, monitor, loop).Run()
                                              : loop(stops, monitor);
}
}
