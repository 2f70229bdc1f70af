// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VertexMover.h"

#include <limits>

namespace bonedecimate
{
namespace
{
/// A step that would lower the error by less than this share is not tried.
constexpr double LeastGain = 3e-3;
constexpr int Attempts = 2;
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
  const PlaceOnMesh found = this->Back.Find(position, vertex);
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
    const Vector3& second = mesh.Position(mesh.Target(h));
    const Vector3& third = mesh.Position(mesh.Origin(HalfEdgeMesh::Previous(h)));
    const TriangleFrame frame(position, second, third);
    this->Error += this->AddSamples(frame, face);
    this->Ring.push_back({ face, second, third, frame.UnitNormal().dot(this->OriginalNormal) });
    area += frame.SurfaceArea();
  }
  const double weight = BackWeight * CornerShare * this->Penalty.InUnits(area);
  const ThreeHalves::Answer penalty = this->Penalty.WithWeight(this->SquaredDistance);
  this->Error += weight * penalty.Value;
  this->Equations.AddVertex(position, original, found.Place, weight * penalty.Weight);
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
      const ThreeHalves::Answer penalty = this->Penalty.WithWeight(place.SquaredDistance);
      error += sample.Weight * penalty.Value;
      this->Equations.AddSample(p, frame, place, sample.Weight * penalty.Weight);
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
    : ErrorOfFace(this->Fit, this->Penalty, ring.Face, frame);
}

//------------------------------------------------------------------------------
bool VertexMover::Lowers(Index vertex, const Vector3& position)
{
  const PlaceOnMesh found = this->Back.Find(position, vertex);
  const double squared = found.Place.SquaredDistance;
  if (this->Farthest > 0.0 &&
    squared > std::max(this->Farthest * this->Farthest, this->SquaredDistance))
  {
    return false;
  }
  this->Hint = found.Face;
  double area = 0.0; // mm^2
  double error = 0.0;
  for (const RingFace& ring : this->Ring)
  {
    const TriangleFrame frame(position, ring.Second, ring.Third);
    area += frame.SurfaceArea();
    error += this->ErrorIfAllowed(ring, frame);
    if (!(error < this->Error))
    {
      return false;
    }
  }
  return error +
    BackWeight * CornerShare * this->Penalty.InUnits(area) * this->Penalty.Of(squared) <
    this->Error;
}
}
