// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "FanFit.h"

#include <algorithm>
#include <array>

namespace bonedecimate
{
FanFit::Answer FanFit::Evaluate(const Neighbourhood& around, const Vector3& place)
{
  this->Gather(around);
  FitStep equations;
  const Answer first = this->AnswerAt(around, place, &equations);
  const Answer second = this->AnswerAt(around, place + equations.Solve(), nullptr);
  return second.Error < first.Error ? second : first;
}

//------------------------------------------------------------------------------
void FanFit::Gather(const Neighbourhood& around)
{
  this->Gathered.clear();
  for (std::size_t i = 0; i < around.Corners.size(); ++i)
  {
    this->GatherFace(HalfEdgeMesh::Face(around.Corners[i]), i);
  }
  for (std::size_t k = 0; k < 2; ++k)
  {
    const auto apex = std::find(around.Ring.begin(), around.Ring.end(), around.Apexes[k]);
    this->GatherFace(around.GoneFaces[k],
      static_cast<std::size_t>(apex - around.Ring.begin()) % around.Corners.size());
  }
}

//------------------------------------------------------------------------------
void FanFit::GatherFace(Index face, std::size_t slot)
{
  for (Index s = this->Fit.First(face); s != None; s = this->Fit[s].Next)
  {
    this->Gathered.push_back({ s, slot });
  }
}

//------------------------------------------------------------------------------
void FanFit::Build(const Neighbourhood& around, const Vector3& x)
{
  this->Frames.clear();
  for (std::size_t i = 0; i < around.Corners.size(); ++i)
  {
    const Index next = around.Ring[(i + 1) % around.Ring.size()];
    this->Frames.emplace_back(x, this->Mesh.Position(around.Ring[i]), this->Mesh.Position(next));
  }
}

//------------------------------------------------------------------------------
TriangleFrame::Place FanFit::FindInFan(const Vector3& p, std::size_t& slot) const
{
  constexpr int towardsPrevious = 4; // the weight of C is zero
  constexpr int towardsNext = 2;     // that of B is
  const std::size_t count = this->Frames.size();
  TriangleFrame::Place best = this->Frames[slot].Nearest(p);
  for (const int side : { towardsPrevious, towardsNext })
  {
    const std::size_t step = side == towardsPrevious ? count - 1 : 1;
    for (std::size_t tries = 1; (best.Clamped & side) != 0 && tries < count; ++tries)
    {
      const std::size_t next = (slot + step) % count;
      const TriangleFrame::Place place = this->Frames[next].Nearest(p);
      if (!(place.SquaredDistance < best.SquaredDistance))
      {
        break;
      }
      best = place;
      slot = next;
    }
  }
  return best;
}

//------------------------------------------------------------------------------
/// @param step Gets the normal equations if it is there.
FanFit::Answer FanFit::AnswerAt(const Neighbourhood& around, const Vector3& x, FitStep* step)
{
  this->Build(around, x);
  Answer answer;
  answer.Position = x;
  for (Member& member : this->Gathered)
  {
    const Samples::Sample& sample = this->Fit[member.Sample];
    const Vector3 p = this->Fit.SamplePosition(sample);
    const TriangleFrame::Place place = this->FindInFan(p, member.Slot);
    const Penalty penalty = this->Weigh.FitOfSample(sample.Weight, place.SquaredDistance);
    answer.Error += penalty.Value;
    if (step != nullptr)
    {
      step->AddSample(p, this->Frames[member.Slot], place, penalty.Weight);
    }
  }
  this->AddVertex(around, answer, step);
  answer.Error += this->ErrorOfChords(around, answer);
  return answer;
}

//------------------------------------------------------------------------------
/// Looked for near both ends.
void FanFit::AddVertex(const Neighbourhood& around, Answer& answer, FitStep* step) const
{
  const PlaceOnMesh atStart = this->Back.Find(answer.Position, around.Start);
  const PlaceOnMesh atEnd = this->Back.Find(answer.Position, around.End);
  const PlaceOnMesh& found =
    atEnd.Place.SquaredDistance < atStart.Place.SquaredDistance ? atEnd : atStart;
  double area = 0.0; // mm^2
  for (const TriangleFrame& frame : this->Frames)
  {
    area += frame.SurfaceArea();
  }
  const double weight = BackWeightOfCollapse * CornerShare * this->Weigh.InUnits(area);
  answer.Hint = found.Face;
  const Penalty penalty = this->Weigh.FitOfVertex(weight, found.Place.SquaredDistance);
  answer.VertexError = penalty.Value;
  answer.Error += answer.VertexError;
  if (step != nullptr)
  {
    step->AddVertex(
      answer.Position, FrameOf(this->Back.Original(), found.Face), found.Place, penalty.Weight);
  }
}

//------------------------------------------------------------------------------
double FanFit::ErrorOfChords(const Neighbourhood& around, const Answer& answer) const
{
  const FarPenalty& far = this->Weigh.OfChords();
  const std::size_t count = this->Frames.size();
  double error = 0.0;
  for (std::size_t i = 0; i < count; ++i)
  {
    const std::size_t previous = (i + count - 1) % count;
    if (FoldSharply(this->Frames[previous].UnitNormal(), this->Frames[i].UnitNormal()))
    {
      const std::array<Index, 5> others = { around.Ring[i], around.Ring[(i + 1) % count],
        around.Ring[previous], around.Start, around.End };
      for (const double share : PlacesOfChord)
      {
        const Vector3 p =
          share * answer.Position + (1.0 - share) * this->Mesh.Position(around.Ring[i]);
        const PlaceOnMesh near = WalkFrom(this->Back.Original(), p, answer.Hint);
        error +=
          far.Of(this->Back.FindBetter(p, near, far.SquaredLimit(), others).Place.SquaredDistance);
      }
    }
  }
  return error;
}
}
