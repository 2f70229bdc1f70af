// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "WalkedTargets.h"

namespace bonedecimate
{
PieceCover<2>::Corner WalkedBoundary::Find(const Vector3& p, Index hint) const
{
  Index best = this->Curves.WalkFrom(p, hint);
  double excess = this->Distance(p, best) - this->Limit(best); // mm
  for (Index from = None; !this->Limits.IsUniform() && excess > 0.0 && from != best;)
  {
    from = best;
    for (const Index next : this->Curves.NeighborsOf(from))
    {
      // mm
      const double other = next == None ? excess : this->Distance(p, next) - this->Limit(next);
      best = other < excess ? next : best;
      excess = std::min(excess, other);
    }
  }
  return { p, best, this->Distance(p, best) };
}

//------------------------------------------------------------------------------
PieceCover<3>::Corner WalkedSurface::Find(const Vector3& p, Index hint) const
{
  PointOnMesh found = WalkFrom(this->Mesh, p, hint);
  const double limit = this->Limit(found.Face);
  if (found.Point.SquaredDistance > limit * limit)
  {
    const Index nearest = !this->Limits.IsUniform()
      ? this->Tree.FindNearest(p, found.Face).Triangle
      : this->Tree.FindNearestWithin(p, limit * limit).Triangle;
    found.Face = nearest != None ? nearest : found.Face;
    found.Point = FrameOf(this->Mesh, found.Face).Nearest(p);
  }
  const double distance = (p - FrameOf(this->Mesh, found.Face).At(found.Point)).norm();
  return this->FindBetter({ p, found.Face, distance });
}

//------------------------------------------------------------------------------
/// The neighbor of least distance - limit, step by step, if a point is too far and limits differ.
PieceCover<3>::Corner WalkedSurface::FindBetter(const PieceCover<3>::Corner& from) const
{
  PieceCover<3>::Corner best = from;
  double excess = best.Distance - this->Limit(best.Nearest); // mm
  for (Index last = None; !this->Limits.IsUniform() && excess > 0.0 && last != best.Nearest;)
  {
    last = best.Nearest;
    for (const Index corner : this->Mesh.Corners(last))
    {
      if (this->Mesh.Constraint(corner) == VertexConstraint::NonManifold)
      {
        continue; // has no ring to walk
      }
      for (const HalfEdgeId h : this->Mesh.OutgoingOf(corner))
      {
        const FaceId face = HalfEdgeMesh::Face(h);
        const double distance = this->Distance(from.Position, face);
        if (distance - this->Limit(face) < excess)
        {
          best = { from.Position, face, distance };
          excess = distance - this->Limit(face);
        }
      }
    }
  }
  return best;
}
}
