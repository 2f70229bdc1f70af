// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VertexMover.h"

#include <array>

namespace bonedecimate
{
namespace
{
/// The fraction of the error that a step must be predicted to gain,
constexpr double MinGainOfMove = 1e-3;
/// and that of a step that has to be proved.
constexpr double MinGainOfProvedMove = 3e-3;
constexpr int AttemptsOfMove = 3;
}

//------------------------------------------------------------------------------
bool VertexMover::Improve(VertexId vertex)
{
  const HalfEdgeMesh& mesh = this->MeshEditor.Mesh();
  if (!MayMove(mesh, vertex))
  {
    return false;
  }
  this->Gather(vertex);
  Vector3 step = this->Equations.Solve();
  const double least = this->MeshEditor.LimitsEdits() ? MinGainOfProvedMove : MinGainOfMove;
  if (!(this->Equations.Gain(step) > least * this->Error))
  {
    return false;
  }
  for (int attempt = 0; attempt < AttemptsOfMove; ++attempt, step *= 0.5)
  {
    const Vector3 position = mesh.Position(vertex) + step;
    if (this->LowersError(vertex, position) &&
      this->MeshEditor.Try(MoveTo(vertex, position), this->Workspace).IsAccepted())
    {
      this->Hints.Set(vertex, this->Hint);
      return true;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
void VertexMover::Gather(VertexId vertex)
{
  const HalfEdgeMesh& mesh = this->MeshEditor.Mesh();
  const Vector3& position = mesh.Position(vertex);
  const PointOnMesh found = this->FindOriginal(vertex);
  const TriangleFrame original = FrameOf(this->Hints.Original(), found.Face);
  this->OriginalNormal = original.UnitNormal();
  this->SquaredDistance = found.Point.SquaredDistance;
  this->Ring.clear();
  this->Equations.Clear();
  this->Error = 0.0;
  double area = 0.0; // mm^2
  for (const HalfEdgeId h : mesh.OutgoingOf(vertex))
  {
    const FaceId face = HalfEdgeMesh::Face(h);
    const VertexId target = mesh.Target(h);
    const Vector3& second = mesh.Position(target);
    const Vector3& third = mesh.Position(mesh.Apex(h));
    const TriangleFrame frame(position, second, third);
    this->Error += this->AddSamples(frame, face);
    this->Ring.push_back({ face, target, second, third, frame.UnitNormal(),
      Dot(frame.UnitNormal(), this->OriginalNormal) });
    area += frame.SurfaceArea();
  }
  this->Error += this->AddChords(position, found.Face, &this->Equations);
  const double weight = BackWeight * CornerFraction * this->Penalties.InUnits(area);
  const Penalty penalty = this->Penalties.FitOfVertex(weight, this->SquaredDistance);
  this->Error += penalty.Value;
  this->Equations.AddVertex(position, original, found.Point, penalty.Weight);
}

//------------------------------------------------------------------------------
/// Finds the nearest point of the original. If it is far, the hints of the neighbors are tried,
/// too.
PointOnMesh VertexMover::FindOriginal(VertexId vertex)
{
  const HalfEdgeMesh& mesh = this->MeshEditor.Mesh();
  const Vector3& position = mesh.Position(vertex);
  PointOnMesh found = this->Hints.Find(position, vertex);
  if (this->Penalties.OfFarVertices().IsFar(found.Point.SquaredDistance))
  {
    this->Neighbors.clear();
    mesh.VisitEdges(
      vertex, [&](HalfEdgeId h) { this->Neighbors.push_back(mesh.OtherEnd(h, vertex)); });
    found = this->Hints.FindBetter(
      position, found, this->Penalties.OfFarVertices().SquaredLimit(), this->Neighbors);
    this->Hints.Set(vertex, found.Face);
  }
  return found;
}

//------------------------------------------------------------------------------
/// The error of the sharp edges at the vertex if it were at that position.
/// @param hint An original triangle near it.
double VertexMover::AddChords(const Vector3& position, Index hint, FitStep* equations) const
{
  const FarPenalty& far = this->Penalties.OfChords();
  const std::size_t count = this->Ring.size();
  double error = 0.0;
  for (std::size_t i = 0; i < count; ++i)
  {
    const RingFace& previous = this->Ring[(i + count - 1) % count];
    const RingFace& ring = this->Ring[i];
    if (!FoldSharply(previous.Normal, ring.Normal))
    {
      continue;
    }
    const std::array<Index, 3> others = { ring.Neighbor, this->Ring[(i + 1) % count].Neighbor,
      previous.Neighbor };
    for (const double fraction : ChordFractions)
    {
      const Vector3 p = fraction * position + (1.0 - fraction) * ring.Second;
      const PointOnMesh near = WalkFrom(this->Hints.Original(), p, hint);
      const PointOnMesh found = this->Hints.FindBetter(p, near, far.SquaredLimit(), others);
      const Penalty penalty = far.WithWeight(found.Point.SquaredDistance);
      error += penalty.Value;
      if (equations != nullptr && penalty.Value > 0.0)
      {
        const TriangleFrame frame = FrameOf(this->Hints.Original(), found.Face);
        equations->AddOnEdge(p, frame, found.Point, fraction, penalty.Weight);
      }
    }
  }
  return error;
}

//------------------------------------------------------------------------------
double VertexMover::AddSamples(const TriangleFrame& frame, FaceId face)
{
  double error = this->Penalties.OfShapes().Of(frame);
  this->Equations.AddShape(this->Penalties.OfShapes().At(frame));
  this->OriginalSamples.VisitFace(face,
    [&](const Samples::Sample& sample)
    {
      const Vector3 p = this->OriginalSamples.SamplePosition(sample);
      const TriangleFrame::Point nearest = frame.Nearest(p);
      const Penalty penalty = this->Penalties.FitOfSample(sample.Weight, nearest.SquaredDistance);
      error += penalty.Value;
      this->Equations.AddSample(p, frame, nearest, penalty.Weight);
    });
  return error;
}

//------------------------------------------------------------------------------
/// The error of the face after the move; infinite if it would turn away from the original.
double VertexMover::ErrorIfAllowed(const RingFace& ring, const TriangleFrame& frame) const
{
  const double facing = Dot(frame.UnitNormal(), this->OriginalNormal);
  return facing < MinFacing && facing < ring.Facing
    ? Infinity
    : ErrorWithinLimits(this->OriginalSamples, this->Penalties, ring.Face, frame);
}

//------------------------------------------------------------------------------
bool VertexMover::LowersError(VertexId vertex, const Vector3& position)
{
  const PointOnMesh found = this->Hints.Find(position, vertex);
  const double squared = found.Point.SquaredDistance;
  this->Hint = found.Face;
  double area = 0.0; // mm^2
  double error = 0.0;
  for (RingFace& ring : this->Ring)
  {
    const TriangleFrame frame(position, ring.Second, ring.Third);
    ring.Normal = frame.UnitNormal();
    area += frame.SurfaceArea();
    error += this->ErrorIfAllowed(ring, frame);
    if (!(error < this->Error))
    {
      return false;
    }
  }
  error +=
    this->Penalties.OfVertex(BackWeight * CornerFraction * this->Penalties.InUnits(area), squared);
  return error < this->Error &&
    error + this->AddChords(position, found.Face, nullptr) < this->Error;
}
}
