// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SplitRules.h"

#include <algorithm>

namespace bonedecimate
{
namespace
{
Rejection CheckBoundarySplit(const HalfEdgeMesh& mesh, HalfEdgeId edge)
{
  const VertexId a = mesh.Origin(edge);
  const VertexId b = mesh.Target(edge);
  const bool isAlone =
    mesh.Twin(HalfEdgeMesh::Next(edge)) != None && mesh.Twin(HalfEdgeMesh::Previous(edge)) != None;
  const bool isOnCurve = mesh.IsStationary(a) && mesh.IsStationary(b);
  const bool isConstrained = mesh.IsConstrained(a) || mesh.IsConstrained(b);
  return isAlone && !isOnCurve && !isConstrained ? Rejection::NotRejected : Rejection::Boundary;
}
}

Rejection CheckSplit(const HalfEdgeMesh& mesh, HalfEdgeId edge)
{
  const VertexConstraint kind =
    std::min(mesh.Constraint(mesh.Origin(edge)), mesh.Constraint(mesh.Target(edge)));
  if (IsConstrained(kind))
  {
    return kind == VertexConstraint::Constrained ? Rejection::Constrained : Rejection::NonManifold;
  }
  return mesh.Twin(edge) == None ? CheckBoundarySplit(mesh, edge) : Rejection::NotRejected;
}
}
