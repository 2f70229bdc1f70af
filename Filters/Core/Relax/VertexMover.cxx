// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VertexMover.h"

#include "Weights.h"

#include <cmath>

namespace bonedecimate
{
namespace
{
static const double Damping = Knob("DA",0.02); // of the weight of the samples
/// A step that would lower the error by less than this share is not tried.
static const double LeastGain = Knob("LG",1e-3);
/// Faces may turn away from the original by no more than 78 degrees, or not farther than they were.
constexpr double LeastFacing = 0.2;
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
  static const double OV=Knob("OV",1); Vector3 step = OV*this->Step();
  if (!(step.dot(this->Pull) > LeastGain * this->Error))
  {
    return false;
  }
  for (int attempt = 0; attempt < int(Knob("AT",2)); ++attempt, step *= 0.5)
  {
    Edit edit;
    edit.Kind = EditKind::Move;
    edit.Keep = vertex;
    edit.Position = mesh.Position(vertex) + step;
    if (this->Lowers(vertex, edit.Position) && this->Work.ApplySmall(edit, this->Space, this->Workers) == Verdict::Allowed)
    {
      this->Back.SetVertex(vertex, this->VertexHint);
      for (const RingFace& ring : this->Ring)
      {
        this->Back.SetFace(ring.Face, ring.Hint);
      }
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
  this->Ring.clear();
  this->Normal.setZero();
  this->Pull.setZero();
  this->Error = 0.0;
  this->RingArea = 0.0;
  for (const Index h : mesh.OutgoingOf(vertex))
  {
    const Index face = HalfEdgeMesh::Face(h);
    const Vector3& second = mesh.Position(mesh.Target(h));
    const Vector3& third = mesh.Position(mesh.Origin(HalfEdgeMesh::Previous(h)));
    const TriangleFrame frame(position, second, third);
    this->AddSamples(frame, face);
    const Vector3 middle = (position + second + third) / 3.0;
    const PlaceOnMesh found = this->Back.FromFace(middle, face);
    const TriangleFrame original = FrameOf(this->Back.Original(), found.Face);
    this->AddBack(middle, found, 1.0 / 3.0, MiddleShare * frame.SurfaceArea());
    this->Ring.push_back({ face, second, third, frame.SurfaceArea(),
      frame.UnitNormal().dot(original.UnitNormal()), original.UnitNormal(), found.Face });
    this->RingArea += frame.SurfaceArea();
  }
  this->VertexHint =
    this->AddBack(position, this->Back.FromVertex(position, vertex), 1.0, CornerShare * this->RingArea)
      .Face;
}

//------------------------------------------------------------------------------
void VertexMover::AddSamples(const TriangleFrame& frame, Index face)
{
  this->Fit.VisitFace(face,
    [&](const Samples::Sample& sample)
    {
      const Vector3 p = sample.Position();
      const TriangleFrame::Place place = frame.Nearest(p);
      const double weight = sample.Weight;
      this->Error += weight * place.SquaredDistance;
      this->Add(p - frame.At(place), place.Clamped == 0 ? frame.UnitNormal() : Vector3(Vector3::Zero()),
        1.0 - place.B - place.C, weight);
    });
}

//------------------------------------------------------------------------------
/// @param direction Of the distance; zero: that of the residual.
void VertexMover::Add(
  const Vector3& residual, const Vector3& direction, double share, double weight)
{
  Vector3 n = direction;
  double length = n.dot(residual);
  if (n.isZero(0.0))
  {
    length = residual.norm();
    if (!(length > 0.0))
    {
      return;
    }
    n = residual / length;
  }
  const Vector3 scaled = weight * share * n;
  this->Normal += share * scaled * n.transpose();
  this->Pull += length * scaled;
}

//------------------------------------------------------------------------------
PlaceOnMesh VertexMover::AddBack(
  const Vector3& p, const PlaceOnMesh& found, double share, double weight)
{
  const TriangleFrame original = FrameOf(this->Back.Original(), found.Face);
  const double scaled = BackWeight * weight;
  this->Error += scaled * found.Place.SquaredDistance;
  this->Add(original.At(found.Place) - p,
    found.Place.Clamped == 0 ? original.UnitNormal() : Vector3(Vector3::Zero()), share, scaled);
  return found;
}

//------------------------------------------------------------------------------
Vector3 VertexMover::Step() const
{
  const double damping = Damping * this->Normal.trace();
  if (!(damping > 0.0))
  {
    return Vector3::Zero();
  }
  const Eigen::Matrix3d damped = this->Normal + damping * Eigen::Matrix3d::Identity();
  return damped.inverse() * this->Pull;
}

//------------------------------------------------------------------------------
/// The error of the face if the vertex were there; infinite if the face would turn away from the original.
double VertexMover::ErrorOfFace(
  RingFace& ring, const TriangleFrame& frame, const Vector3& position) const
{
  const double facing = frame.UnitNormal().dot(ring.OriginalNormal);
  if (facing < LeastFacing && facing < ring.Facing)
  {
    return std::numeric_limits<double>::infinity();
  }
  double error = 0.0;
  this->Fit.VisitFace(ring.Face,
    [&](const Samples::Sample& sample)
    { error += sample.Weight * frame.Nearest(sample.Position()).SquaredDistance; });
  const Vector3 middle = (position + ring.Second + ring.Third) / 3.0;
  const PlaceOnMesh found = WalkFrom(this->Back.Original(), middle, ring.Hint);
  ring.Hint = found.Face;
  return error + BackWeight * MiddleShare * frame.SurfaceArea() * found.Place.SquaredDistance;
}

//------------------------------------------------------------------------------
bool VertexMover::Lowers(Index vertex, const Vector3& position)
{
  const PlaceOnMesh found = this->Back.FromVertex(position, vertex);
  double area = 0.0;
  double error = 0.0;
  for (RingFace& ring : this->Ring)
  {
    const TriangleFrame frame(position, ring.Second, ring.Third);
    area += frame.SurfaceArea();
    error += this->ErrorOfFace(ring, frame, position);
    if (!(error < this->Error))
    {
      return false;
    }
  }
  error += BackWeight * CornerShare * area * found.Place.SquaredDistance;
  this->VertexHint = found.Face;
  return error < this->Error;
}
}
