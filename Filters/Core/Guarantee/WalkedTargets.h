// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file WalkedTargets.h
 * @brief The original and its borders as PieceCover asks them for what is near.
 *
 * Where limits differ, what is nearest may not be what allows most: if it is too far, its neighbours are asked, and theirs,
 * while the distance less the limit falls.
 */
#ifndef BoneDecimate_Core_Guarantee_WalkedTargets_h
#define BoneDecimate_Core_Guarantee_WalkedTargets_h

#include "BorderLines.h"
#include "Geometry/BoundingTree.h"
#include "Limits.h"
#include "PieceCover.h"
#include "Reference/SurfaceWalk.h"

namespace bonedecimate
{
/// The original's borders, asked for what is near by walking along them.
class WalkedBorder
{
public:
  WalkedBorder(const BorderLines& lines, const Limits& limits)
    : Lines(lines)
    , Allowed(limits)
  {
  }
  PieceCover<2>::Corner Find(const Vector3& p, Index hint) const;
  double Distance(const Vector3& p, Index edge) const { return this->Lines.Distance(p, edge); }
  double Limit(Index edge) const { return this->Allowed.OverEdge(this->Lines.HalfEdge(edge)); }

private:
  const BorderLines& Lines;
  const Limits& Allowed;
};

/// The original, asked for what is near by walking over it.
class WalkedSurface
{
public:
  WalkedSurface(const HalfEdgeMesh& mesh, const BoundingTree& tree, const Limits& limits)
    : Mesh(mesh)
    , Tree(tree)
    , Allowed(limits)
  {
  }
  PieceCover<3>::Corner Find(const Vector3& p, Index hint) const;
  double Distance(const Vector3& p, Index face) const
  {
    return std::sqrt(FrameOf(this->Mesh, face).SquaredReach(p));
  }
  double Limit(Index face) const { return this->Allowed.Over(face); }
  bool IsWithin(const PieceCover<3>::Corner& place) const
  {
    return place.Distance <= this->Limit(place.Nearest);
  }

private:
  PieceCover<3>::Corner FindBetter(const PieceCover<3>::Corner& from) const;

  const HalfEdgeMesh& Mesh;
  const BoundingTree& Tree;
  const Limits& Allowed;
};
}

#endif
