// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "FanFit.h"

#include "FanSearch.h"

#include <array>

namespace bonedecimate
{
FanFit::Result FanFit::Evaluate(const EdgeNeighborhood& around, const Vector3& position)
{
  this->Gather(around);
  FitStep equations;
  const Result first = this->EvaluateAt(around, position, &equations);
  const Result second = this->EvaluateAt(around, position + equations.Solve(), nullptr);
  return second.Error < first.Error ? second : first;
}

//------------------------------------------------------------------------------
void FanFit::Gather(const EdgeNeighborhood& around)
{
  this->SampleMembers.clear();
  for (std::size_t i = 0; i < around.Corners.size(); ++i)
  {
    this->GatherFace(HalfEdgeMesh::Face(around.Corners[i]), i);
  }
  for (std::size_t k = 0; k < 2; ++k)
  {
    this->GatherFace(around.RemovedFaces[k], around.SlotAtApex(k));
  }
}

//------------------------------------------------------------------------------
void FanFit::GatherFace(FaceId face, std::size_t slot)
{
  for (Index s = this->OriginalSamples.First(face); s != None; s = this->OriginalSamples[s].Next)
  {
    this->SampleMembers.push_back({ s, slot });
  }
}

//------------------------------------------------------------------------------
void FanFit::Build(const EdgeNeighborhood& around, const Vector3& x)
{
  this->Frames.clear();
  for (std::size_t i = 0; i < around.Corners.size(); ++i)
  {
    this->Frames.emplace_back(
      x, this->Mesh.Position(around.Ring[i]), this->Mesh.Position(around.RingAfter(i)));
  }
}

//------------------------------------------------------------------------------
/// @param step Receives the normal equations; may be null.
FanFit::Result FanFit::EvaluateAt(const EdgeNeighborhood& around, const Vector3& x, FitStep* step)
{
  this->Build(around, x);
  Result result;
  result.Position = x;
  for (Member& member : this->SampleMembers)
  {
    const Samples::Sample& sample = this->OriginalSamples[member.Sample];
    const Vector3 p = this->OriginalSamples.SamplePosition(sample);
    const TriangleFrame::Point position = FindInFan(this->Frames, p, member.Slot);
    const Penalty penalty = this->Penalties.FitOfSample(sample.Weight, position.SquaredDistance);
    result.Error += penalty.Value;
    if (step != nullptr)
    {
      step->AddSample(p, this->Frames[member.Slot], position, penalty.Weight);
    }
  }
  this->AddVertex(around, result, step);
  result.Error += this->ErrorOfChords(around, result);
  return result;
}

//------------------------------------------------------------------------------
/// Adds the terms of the vertex and of the shapes of its faces. The nearest point is searched from
/// the hints of both ends.
void FanFit::AddVertex(const EdgeNeighborhood& around, Result& result, FitStep* step) const
{
  const PointOnMesh atStart = this->Hints.Find(result.Position, around.Start);
  const PointOnMesh atEnd = this->Hints.Find(result.Position, around.End);
  const PointOnMesh& found =
    atEnd.Point.SquaredDistance < atStart.Point.SquaredDistance ? atEnd : atStart;
  double area = 0.0; // mm^2
  for (const TriangleFrame& frame : this->Frames)
  {
    area += frame.SurfaceArea();
    result.Error += this->Penalties.OfShapes().Of(frame);
    if (step != nullptr)
    {
      step->AddShape(this->Penalties.OfShapes().At(frame));
    }
  }
  const double weight = BackWeightOfCollapse * CornerFraction * this->Penalties.InUnits(area);
  result.Hint = found.Face;
  const Penalty penalty = this->Penalties.FitOfVertex(weight, found.Point.SquaredDistance);
  result.VertexError = penalty.Value;
  result.Error += result.VertexError;
  if (step != nullptr)
  {
    step->AddVertex(
      result.Position, FrameOf(this->Hints.Original(), found.Face), found.Point, penalty.Weight);
  }
}

//------------------------------------------------------------------------------
double FanFit::ErrorOfChords(const EdgeNeighborhood& around, const Result& result) const
{
  const FarPenalty& far = this->Penalties.OfChords();
  const std::size_t count = this->Frames.size();
  double error = 0.0;
  for (std::size_t i = 0; i < count; ++i)
  {
    const std::size_t previous = (i + count - 1) % count;
    if (FoldSharply(this->Frames[previous].UnitNormal(), this->Frames[i].UnitNormal()))
    {
      const std::array<Index, 5> others = { around.Ring[i], around.RingAfter(i),
        around.Ring[previous], around.Start, around.End };
      for (const double fraction : ChordFractions)
      {
        const Vector3 p =
          fraction * result.Position + (1.0 - fraction) * this->Mesh.Position(around.Ring[i]);
        const PointOnMesh near = WalkFrom(this->Hints.Original(), p, result.Hint);
        error +=
          far.Of(this->Hints.FindBetter(p, near, far.SquaredLimit(), others).Point.SquaredDistance);
      }
    }
  }
  return error;
}
}
