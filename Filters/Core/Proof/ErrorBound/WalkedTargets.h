// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file WalkedTargets.h
 * @brief Finds the nearest part of the original or of its boundaries, for PieceCover and FaceProof.
 *
 * If limits differ, the nearest part need not be the one with the largest margin. If it is too far,
 * the search continues with its neighbors while distance - limit falls.
 */
#ifndef BoneDecimate_Core_Proof_ErrorBound_WalkedTargets_h
#define BoneDecimate_Core_Proof_ErrorBound_WalkedTargets_h

#include "BoundaryCurves.h"
#include "ErrorLimits.h"
#include "Geometry/BoundingTree.h"
#include "PieceCover.h"
#include "Proof/Reference/SurfaceWalk.h"

namespace bonedecimate
{
/// Finds near edges of the original's boundaries by walking along them.
class WalkedBoundary
{
public:
  WalkedBoundary(const BoundaryCurves& curves, const ErrorLimits& limits)
    : Curves(curves)
    , Limits(limits)
  {
  }
  PieceCover<2>::Corner Find(const Vector3& p, Index hint) const;
  double Distance(const Vector3& p, Index edge) const { return this->Curves.Distance(p, edge); }
  double Limit(Index edge) const { return this->Limits.OfEdge(this->Curves.HalfEdge(edge)); }

private:
  const BoundaryCurves& Curves;
  const ErrorLimits& Limits;
};

/// Finds near triangles of the original by walking over it.
class WalkedSurface
{
public:
  WalkedSurface(const HalfEdgeMesh& mesh, const BoundingTree& tree, const ErrorLimits& limits)
    : Mesh(mesh)
    , Tree(tree)
    , Limits(limits)
  {
  }
  PieceCover<3>::Corner Find(const Vector3& p, Index hint) const;
  double Distance(const Vector3& p, FaceId face) const
  {
    return std::sqrt(FrameOf(this->Mesh, face).SquaredReach(p));
  }
  double Limit(FaceId face) const { return this->Limits.OfTriangle(face); }
  bool IsWithin(const PieceCover<3>::Corner& corner) const
  {
    return corner.Distance <= this->Limit(corner.Nearest);
  }

private:
  PieceCover<3>::Corner FindBetter(const PieceCover<3>::Corner& from) const;

  const HalfEdgeMesh& Mesh;
  const BoundingTree& Tree;
  const ErrorLimits& Limits;
};
}

#endif
