// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file WalkedTargets.h
 * @brief The original and its borders as PieceCover asks them for what is near.
 */
#ifndef BoneDecimate_Core_Guarantee_WalkedTargets_h
#define BoneDecimate_Core_Guarantee_WalkedTargets_h

#include "BorderLines.h"
#include "Geometry/BoundingTree.h"
#include "PieceCover.h"
#include "Reference/SurfaceWalk.h"

namespace bonedecimate
{
/// The original's borders, asked for what is near by walking along them.
class WalkedBorder
{
public:
  WalkedBorder(const BorderLines& lines, double limit)
    : Lines(lines)
    , Most(limit)
  {
  }
  PieceCover<2>::Corner Find(const Vector3& p, Index hint) const
  {
    const Index nearest = this->Lines.WalkFrom(p, hint);
    return { p, nearest, this->Lines.Distance(p, nearest) };
  }
  double Distance(const Vector3& p, Index edge) const { return this->Lines.Distance(p, edge); }
  double Limit(Index) const { return this->Most; }

private:
  const BorderLines& Lines;
  double Most; // mm
};

/// The original, asked for what is near by walking over it.
class WalkedSurface
{
public:
  WalkedSurface(const HalfEdgeMesh& mesh, const BoundingTree& tree, double limit)
    : Mesh(mesh)
    , Tree(tree)
    , Most(limit)
  {
  }
  PieceCover<3>::Corner Find(const Vector3& p, Index hint) const
  {
    PlaceOnMesh found = WalkFrom(this->Mesh, p, hint);
    if (found.Place.SquaredDistance > this->Most * this->Most)
    {
      found.Face = this->Tree.FindNearest(p, found.Face).Triangle;
      found.Place = FrameOf(this->Mesh, found.Face).Nearest(p);
    }
    return { p, found.Face, (p - FrameOf(this->Mesh, found.Face).At(found.Place)).norm() };
  }
  double Distance(const Vector3& p, Index face) const
  {
    return std::sqrt(FrameOf(this->Mesh, face).SquaredReach(p));
  }
  double Limit(Index) const { return this->Most; }

private:
  const HalfEdgeMesh& Mesh;
  const BoundingTree& Tree;
  double Most; // mm
};
}

#endif
