// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "EdgeFlipper.h"

#include "Decimate/Edit/FlipAndMoveRules.h"

namespace bonedecimate
{
namespace
{
/// The fraction to which the other diagonal must lower the error.
constexpr double FlipBelow = 0.98;
constexpr float Unknown = -1.0F;
}

//------------------------------------------------------------------------------
Index EdgeFlipper::Improve(VertexId vertex)
{
  const HalfEdgeMesh& mesh = this->MeshEditor.Mesh();
  Index left = mesh.OutgoingOf(vertex).Count();
  // A loop over OutgoingOf() would fail: a flip takes its edge out of the ring and renames the
  // previous one.
  Index flips = 0;
  for (HalfEdgeId h = mesh.Outgoing(vertex); left > 0 && h != None; --left)
  {
    const HalfEdgeId next = mesh.Twin(HalfEdgeMesh::Previous(h));
    if (mesh.Twin(h) != None && vertex < mesh.Target(h) && this->TryFlip(h))
    {
      ++flips;
    }
    h = next;
  }
  return flips;
}

//------------------------------------------------------------------------------
double EdgeFlipper::ErrorBefore(const HalfEdgeMesh& mesh, FaceId face)
{
  float& known = this->FaceErrors[static_cast<std::size_t>(face)];
  if (known < 0.0F)
  {
    known = static_cast<float>(
      ErrorOfFace(this->OriginalSamples, this->Penalties, face, FrameOf(mesh, face)));
  }
  return known;
}

//------------------------------------------------------------------------------
/// The error after the flip. Not below `enough` if this is reached on the way or a sample is beyond
/// its limit.
double EdgeFlipper::ErrorAfter(const Pair& after, double enough) const
{
  double error =
    this->Penalties.OfShapes().Of(after.Frames[0]) + this->Penalties.OfShapes().Of(after.Frames[1]);
  for (const FaceId face : after.Faces)
  {
    for (Index s = this->OriginalSamples.First(face); s != None && error < enough;
         s = this->OriginalSamples[s].Next)
    {
      const Vector3 p = this->OriginalSamples.SamplePosition(this->OriginalSamples[s]);
      const double squared = std::min(
        after.Frames[0].Nearest(p).SquaredDistance, after.Frames[1].Nearest(p).SquaredDistance);
      const double limit = this->OriginalSamples[s].Limit;
      error += squared <= limit * limit
        ? this->Penalties.OfSample(this->OriginalSamples[s].Weight, squared)
        : Infinity;
    }
  }
  return error;
}

//------------------------------------------------------------------------------
/// The error of the edge between the faces, from one corner to another.
double EdgeFlipper::ErrorOfChord(
  const Pair& pair, const std::array<Index, 4>& corners, std::size_t from, std::size_t to) const
{
  if (!FoldSharply(pair.Frames[0].UnitNormal(), pair.Frames[1].UnitNormal()))
  {
    return 0.0;
  }
  const HalfEdgeMesh& mesh = this->MeshEditor.Mesh();
  const FarPenalty& far = this->Penalties.OfChords();
  double error = 0.0;
  for (const double fraction : ChordFractions)
  {
    const Vector3 p =
      fraction * mesh.Position(corners[from]) + (1.0 - fraction) * mesh.Position(corners[to]);
    const PointOnMesh near = this->Hints.Find(p, corners[from]);
    error +=
      far.Of(this->Hints.FindBetter(p, near, far.SquaredLimit(), corners).Point.SquaredDistance);
  }
  return error;
}

//------------------------------------------------------------------------------
bool EdgeFlipper::TurnsAway(
  const std::array<Index, 4>& corners, const Pair& before, const Pair& after) const
{
  Vector3 original = Vector3::Zero();
  for (const Index corner : corners)
  {
    original += FrameOf(this->Hints.Original(), this->Hints.Of(corner)).UnitNormal();
  }
  const auto facing = [&original](const Pair& pair)
  {
    return std::min(
      Dot(pair.Frames[0].UnitNormal(), original), Dot(pair.Frames[1].UnitNormal(), original));
  };
  const double now = facing(after);
  return now < MinFacing * original.norm() && now < facing(before);
}

//------------------------------------------------------------------------------
bool EdgeFlipper::TryFlip(HalfEdgeId edge)
{
  const HalfEdgeMesh& mesh = this->MeshEditor.Mesh();
  const std::array<Index, 2> faces = { HalfEdgeMesh::Face(edge),
    HalfEdgeMesh::Face(mesh.Twin(edge)) };
  const std::array<Index, 4> corners = CornersAround(mesh, edge);
  const auto [a, b, c, d] = PositionsOf(mesh, corners);
  const Pair now = { faces, { TriangleFrame(a, b, c), TriangleFrame(b, a, d) } };
  const double enough = FlipBelow *
    (this->ErrorBefore(mesh, faces[0]) + this->ErrorBefore(mesh, faces[1]) +
      this->ErrorOfChord(now, corners, 0, 1));
  if (!(enough > 0.0))
  {
    return false;
  }
  const Pair after = { faces, { TriangleFrame(a, d, c), TriangleFrame(b, c, d) } };
  const double error = this->ErrorAfter(after, enough);
  if (!(error < enough) || this->TurnsAway(corners, now, after) ||
    !(error + this->ErrorOfChord(after, corners, 2, 3) < enough))
  {
    return false;
  }
  if (!this->MeshEditor.Try(FlipOf(edge), this->Workspace).IsAccepted())
  {
    return false;
  }
  this->HandOver(after);
  return true;
}

//------------------------------------------------------------------------------
/// Gives each sample of both faces to the nearer one.
void EdgeFlipper::HandOver(const Pair& after)
{
  for (Index s :
    { this->OriginalSamples.Take(after.Faces[0]), this->OriginalSamples.Take(after.Faces[1]) })
  {
    while (s != None)
    {
      const Vector3 p = this->OriginalSamples.SamplePosition(this->OriginalSamples[s]);
      const Index next = this->OriginalSamples[s].Next;
      const bool first =
        after.Frames[0].Nearest(p).SquaredDistance <= after.Frames[1].Nearest(p).SquaredDistance;
      this->OriginalSamples.Put(s, after.Faces[first ? 0 : 1]);
      s = next;
    }
  }
  for (const FaceId face : after.Faces)
  {
    this->FaceErrors[static_cast<std::size_t>(face)] = Unknown;
  }
}
}
