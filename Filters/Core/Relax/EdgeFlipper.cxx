// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "EdgeFlipper.h"

#include "Collapse/SmallEdits.h"
#include "Weights.h"

namespace bonedecimate
{
namespace
{
/// The other diagonal must lower the error by that much.
static const double FlipBelow = Knob("FB",0.98);
}

//------------------------------------------------------------------------------
Index EdgeFlipper::Improve(Index vertex)
{
  const HalfEdgeMesh& mesh = this->Work.Mesh();
  Index left = 0;
  for (const Index h : mesh.OutgoingOf(vertex))
  {
    left += h != None ? 1 : 0;
  }
  // Walked by hand: a flip takes its edge out of the ring and renames the one before.
  Index flips = 0;
  for (Index h = mesh.Outgoing(vertex); left > 0 && h != None; --left)
  {
    const Index next = mesh.Twin(HalfEdgeMesh::Previous(h));
    if (mesh.Twin(h) != None && vertex < mesh.Target(h) && this->TryFlip(h))
    {
      ++flips;
    }
    h = next;
  }
  return flips;
}

//------------------------------------------------------------------------------
double EdgeFlipper::SampleError(
  const TriangleFrame& first, const TriangleFrame& second, Index face) const
{
  double error = 0.0;
  this->Fit.VisitFace(face,
    [&](const Samples::Sample& sample)
    {
      const Vector3 p = sample.Position();
      error += sample.Weight *
        std::min(first.Nearest(p).SquaredDistance, second.Nearest(p).SquaredDistance);
    });
  return error;
}

//------------------------------------------------------------------------------
double EdgeFlipper::BackError(const std::array<Vector3, 3>& corners, Index face, Index& hint) const
{
  const PlaceOnMesh found =
    this->Back.FromFace((corners[0] + corners[1] + corners[2]) / 3.0, face);
  hint = found.Face;
  const double area = AreaVector(corners[0], corners[1], corners[2]).norm();
  return BackWeight * MiddleShare * area * found.Place.SquaredDistance;
}

//------------------------------------------------------------------------------
bool EdgeFlipper::TryFlip(Index edge)
{
  const HalfEdgeMesh& mesh = this->Work.Mesh();
  const std::array<Index, 4> around = CornersAround(mesh, edge);
  const std::array<Index, 2> faces = { HalfEdgeMesh::Face(edge),
    HalfEdgeMesh::Face(mesh.Twin(edge)) };
  const Vector3& a = mesh.Position(around[0]);
  const Vector3& b = mesh.Position(around[1]);
  const Vector3& c = mesh.Position(around[2]);
  const Vector3& d = mesh.Position(around[3]);
  std::array<Index, 2> hints{};
  const TriangleFrame oldFirst(a, b, c);
  const TriangleFrame oldSecond(b, a, d);
  const double before = this->SampleError(oldFirst, oldFirst, faces[0]) +
    this->SampleError(oldSecond, oldSecond, faces[1]) + this->BackError({ a, b, c }, faces[0], hints[0]) +
    this->BackError({ b, a, d }, faces[1], hints[1]);
  const TriangleFrame first(a, d, c);
  const TriangleFrame second(b, c, d);
  double after =
    this->SampleError(first, second, faces[0]) + this->SampleError(first, second, faces[1]);
  if (!(after < FlipBelow * before))
  {
    return false;
  }
  after += this->BackError({ a, d, c }, faces[0], hints[0]) +
    this->BackError({ b, c, d }, faces[1], hints[1]);
  Edit edit;
  edit.Kind = EditKind::Flip;
  edit.Edge = edge;
  if (!(after < FlipBelow * before) || this->Work.ApplySmall(edit, this->Space, this->Workers) != Verdict::Allowed)
  {
    return false;
  }
  for (std::size_t i = 0; i < 2; ++i)
  {
    this->Back.SetFace(faces[i], hints[i]);
  }
  for (Index s : { this->Fit.Take(faces[0]), this->Fit.Take(faces[1]) })
  {
    while (s != None)
    {
      const Vector3 p = this->Fit[s].Position();
      const Index next = this->Fit[s].Next;
      const bool nearer = first.Nearest(p).SquaredDistance <= second.Nearest(p).SquaredDistance;
      this->Fit.Put(s, faces[nearer ? 0 : 1]);
      s = next;
    }
  }
  return true;
}
}
