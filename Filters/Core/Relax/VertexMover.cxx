// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VertexMover.h"

#include <array>
#include <limits>

namespace bonedecimate
{
namespace
{
/// A step that would lower the error by less than this share is not tried.
constexpr double LeastGain = 3e-3;
constexpr int Attempts = 3;
}

//------------------------------------------------------------------------------
bool VertexMover::Improve(Index vertex)
{
  const HalfEdgeMesh& mesh = this->Work.Mesh();
  if (mesh.Kind(vertex) != VertexKind::Inside)
  {
    return false;
  }
  this->Gather(vertex);
  Vector3 step = this->Equations.Solve();
  if (!(this->Equations.Gain(step) > LeastGain * this->Error))
  {
    return false;
  }
  for (int attempt = 0; attempt < Attempts; ++attempt, step *= 0.5)
  {
    Edit edit;
    edit.Kind = EditKind::Move;
    edit.Keep = vertex;
    edit.Position = mesh.Position(vertex) + step;
    if (this->Lowers(vertex, edit.Position) &&
      this->Work.ApplySmall(edit, this->Space, this->Workers) == Verdict::Allowed)
    {
      this->Back.Set(vertex, this->Hint);
      return true;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
void VertexMover::Gather(Index vertex)
{
  const HalfEdgeMesh& mesh = this->Work.Mesh();
  const Vector3& position = mesh.Position(vertex);
  const PlaceOnMesh found = this->FindOriginal(vertex);
  const TriangleFrame original = FrameOf(this->Back.Original(), found.Face);
  this->OriginalNormal = original.UnitNormal();
  this->SquaredDistance = found.Place.SquaredDistance;
  this->Ring.clear();
  this->Equations.Clear();
  this->Error = 0.0;
  double area = 0.0; // mm^2
  for (const Index h : mesh.OutgoingOf(vertex))
  {
    const Index face = HalfEdgeMesh::Face(h);
    const Index target = mesh.Target(h);
    const Vector3& second = mesh.Position(target);
    const Vector3& third = mesh.Position(mesh.Origin(HalfEdgeMesh::Previous(h)));
    const TriangleFrame frame(position, second, third);
    this->Error += this->AddSamples(frame, face);
    this->Ring.push_back({ face, target, second, third, frame.UnitNormal(),
      frame.UnitNormal().dot(this->OriginalNormal) });
    area += frame.SurfaceArea();
  }
  this->Error += this->AddChords(position, found.Face, &this->Equations);
  const double weight = BackWeight * CornerShare * this->Weigh.InUnits(area);
  const Penalty penalty = this->Weigh.FitOfVertex(weight, this->SquaredDistance);
  this->Error += penalty.Value;
  this->Equations.AddVertex(position, original, found.Place, penalty.Weight);
}

//------------------------------------------------------------------------------
/// If that is far, the neighbours may know better.
PlaceOnMesh VertexMover::FindOriginal(Index vertex)
{
  const HalfEdgeMesh& mesh = this->Work.Mesh();
  const Vector3& position = mesh.Position(vertex);
  PlaceOnMesh found = this->Back.Find(position, vertex);
  if (this->Weigh.OfFarVertices().IsFar(found.Place.SquaredDistance))
  {
    this->Neighbours.clear();
    mesh.VisitEdges(vertex, [&](Index h) { this->Neighbours.push_back(mesh.Across(h, vertex)); });
    found = this->Back.FindBetter(
      position, found, this->Weigh.OfFarVertices().SquaredLimit(), this->Neighbours);
    this->Back.Set(vertex, found.Face);
  }
  return found;
}

//------------------------------------------------------------------------------
/// Of the sharp edges from the vertex, if it were there.  @param hint The original triangle near it.
double VertexMover::AddChords(const Vector3& position, Index hint, FitStep* equations) const
{
  const FarPenalty& far = this->Weigh.OfChords();
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
    const std::array<Index, 3> others = { ring.Neighbour, this->Ring[(i + 1) % count].Neighbour,
      previous.Neighbour };
    for (const double share : PlacesOfChord)
    {
      const Vector3 p = share * position + (1.0 - share) * ring.Second;
      const PlaceOnMesh near = WalkFrom(this->Back.Original(), p, hint);
      const PlaceOnMesh found = this->Back.FindBetter(p, near, far.SquaredLimit(), others);
      const Penalty penalty = far.WithWeight(found.Place.SquaredDistance);
      error += penalty.Value;
      if (equations != nullptr && penalty.Value > 0.0)
      {
        const TriangleFrame frame = FrameOf(this->Back.Original(), found.Face);
        equations->AddOnEdge(p, frame, found.Place, share, penalty.Weight);
      }
    }
  }
  return error;
}

//------------------------------------------------------------------------------
double VertexMover::AddSamples(const TriangleFrame& frame, Index face)
{
  double error = 0.0;
  this->Fit.VisitFace(face,
    [&](const Samples::Sample& sample)
    {
      const Vector3 p = this->Fit.SamplePosition(sample);
      const TriangleFrame::Place place = frame.Nearest(p);
      const Penalty penalty = this->Weigh.FitOfSample(sample.Weight, place.SquaredDistance);
      error += penalty.Value;
      this->Equations.AddSample(p, frame, place, penalty.Weight);
    });
  return error;
}

//------------------------------------------------------------------------------
/// The error of the face as it would be; infinite if it would turn away from the original.
double VertexMover::ErrorIfAllowed(const RingFace& ring, const TriangleFrame& frame) const
{
  const double facing = frame.UnitNormal().dot(this->OriginalNormal);
  return facing < LeastFacing && facing < ring.Facing
    ? std::numeric_limits<double>::infinity()
    : ErrorOfFace(this->Fit, this->Weigh, ring.Face, frame);
}

//------------------------------------------------------------------------------
bool VertexMover::Lowers(Index vertex, const Vector3& position)
{
  const PlaceOnMesh found = this->Back.Find(position, vertex);
  const double squared = found.Place.SquaredDistance;
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
  error += this->Weigh.OfVertex(BackWeight * CornerShare * this->Weigh.InUnits(area), squared);
  return error < this->Error &&
    error + this->AddChords(position, found.Face, nullptr) < this->Error;
}
}
