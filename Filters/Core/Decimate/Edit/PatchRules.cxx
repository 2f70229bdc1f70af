// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PatchRules.h"

#include <algorithm>

namespace bonedecimate
{
namespace
{
/// Whether isSo holds for the vertex or one of its duplicates.
template <typename IsSo>
bool IsAnyDuplicate(const HalfEdgeMesh& mesh, VertexId v, const IsSo& isSo)
{
  Index duplicate = v;
  do
  {
    if (isSo(duplicate))
    {
      return true;
    }
    duplicate = mesh.NextDuplicate(duplicate);
  } while (duplicate != v);
  return false;
}

bool HasDuplicates(const HalfEdgeMesh& mesh, VertexId v)
{
  return mesh.NextDuplicate(v) != v;
}

/// Whether the vertex has duplicates, one of them out of range. The rules read the rings of such
/// vertices.
bool IsOutOfRange(const HalfEdgeMesh& mesh, VertexId v, VertexRange range)
{
  return HasDuplicates(mesh, v) &&
    IsAnyDuplicate(mesh, v, [&](Index duplicate) { return !range.Contains(duplicate); });
}

/// Whether an edge connects duplicates of a and b, or both are duplicates of one original vertex.
bool AreJoined(const HalfEdgeMesh& mesh, Index a, Index b)
{
  const VertexId original = mesh.OriginalVertex(b);
  return mesh.OriginalVertex(a) == original ||
    IsAnyDuplicate(mesh, a,
      [&](Index duplicate)
      {
        // its ring cannot be traversed
        bool joined = mesh.Constraint(duplicate) == VertexConstraint::NonManifold;
        for (HalfEdgeId h = joined ? HalfEdgeId() : mesh.Outgoing(duplicate), first = h;
             h != None && !joined;)
        {
          const HalfEdgeId back = HalfEdgeMesh::Previous(h);
          joined = mesh.OriginalVertex(mesh.Target(h)) == original ||
            mesh.OriginalVertex(mesh.Origin(back)) == original;
          h = mesh.Twin(back) == first ? HalfEdgeId() : mesh.Twin(back);
        }
        return joined;
      });
}

/// Whether the vertex has a single face.
bool IsEar(const HalfEdgeMesh& mesh, VertexId v)
{
  int edges = 0;
  mesh.VisitEdges(v, [&edges](Index) { ++edges; });
  return edges == 2;
}

/// Whether the collapse removes the only face at a stationary end. Another open curve at this end
/// would lose its edge, and what this edge proves.
bool LosesEar(const HalfEdgeMesh& mesh, const EdgeNeighborhood& around)
{
  const auto isEar = [&](VertexId v) { return mesh.IsStationary(v) && IsEar(mesh, v); };
  return isEar(around.Start) || isEar(around.End);
}

/// Whether the merged vertex would connect two patches. It gets the edges of both ends. None of
/// them may exist already between other duplicates, or from the other end to another duplicate.
/// @param exempt An original vertex to which such an edge is removed; None: there is none.
bool JoinsPatches(const HalfEdgeMesh& mesh, const EdgeNeighborhood& around, Index exempt)
{
  const auto endAt = [&](std::size_t i)
  { return i < around.Corners.size() ? mesh.Origin(around.Corners[i]) : around.BoundaryEnds[1]; };
  for (std::size_t i = 0; i < around.Ring.size(); ++i)
  {
    const VertexId v = around.Ring[i];
    const Index end = endAt(i);
    const Index other = end == around.Start ? around.End : around.Start;
    const bool isKnown =
      v == around.Apexes[0] || v == around.Apexes[1] || mesh.OriginalVertex(v) == exempt;
    bool joins = HasDuplicates(mesh, other) && !isKnown && AreJoined(mesh, other, v);
    for (std::size_t k = 0; k < i && HasDuplicates(mesh, v) && !joins; ++k)
    {
      const bool wereJoined = endAt(k) == end && HasDuplicates(mesh, end);
      joins = mesh.OriginalVertex(around.Ring[k]) == mesh.OriginalVertex(v) && !wereJoined;
    }
    if (joins)
    {
      return true;
    }
  }
  return false;
}
}

//------------------------------------------------------------------------------
Decision CheckPatches(const HalfEdgeMesh& mesh, const EdgeNeighborhood& around, VertexRange range)
{
  // Most edges are far from other patches; only stationary and constrained vertices have
  // duplicates.
  const auto isAlone = [&](VertexId v) { return mesh.Constraint(v) <= VertexConstraint::Boundary; };
  if (isAlone(around.Start) && isAlone(around.End) &&
    std::all_of(around.Ring.begin(), around.Ring.end(), isAlone))
  {
    return Decision::Accept();
  }
  const auto isOut = [&](VertexId v) { return IsOutOfRange(mesh, v, range); };
  if (isOut(around.Start) || isOut(around.End) ||
    std::any_of(around.Ring.begin(), around.Ring.end(), isOut))
  {
    return Decision::Defer();
  }
  return LosesEar(mesh, around)        ? Rejection::Boundary
    : JoinsPatches(mesh, around, None) ? Rejection::LinkCondition
                                       : Rejection::NotRejected;
}

//------------------------------------------------------------------------------
/// A single face at the removed vertex has two edges of the curve and is removed with it. Its third
/// edge joins the curve.
Rejection CheckPatchBoundary(
  const HalfEdgeMesh& mesh, const std::vector<const EdgeNeighborhood*>& patches, VertexId gone)
{
  VertexId third; // the original vertex at the end of this third edge
  for (const EdgeNeighborhood* around : patches)
  {
    const bool startGoes = mesh.OriginalVertex(around->Start) == gone;
    if (IsEar(mesh, startGoes ? around->End : around->Start))
    {
      return Rejection::Boundary;
    }
    third = IsEar(mesh, startGoes ? around->Start : around->End)
      ? mesh.OriginalVertex(around->Apexes[0])
      : third;
  }
  const bool joins = std::any_of(patches.begin(), patches.end(),
    [&](const EdgeNeighborhood* around) { return JoinsPatches(mesh, *around, third); });
  return joins ? Rejection::LinkCondition : Rejection::NotRejected;
}

//------------------------------------------------------------------------------
Decision CheckNewEdge(const HalfEdgeMesh& mesh, VertexId a, VertexId b, VertexRange range)
{
  if (IsOutOfRange(mesh, a, range) || IsOutOfRange(mesh, b, range))
  {
    return Decision::Defer();
  }
  const bool areJoined = (HasDuplicates(mesh, a) && AreJoined(mesh, a, b)) ||
    (HasDuplicates(mesh, b) && AreJoined(mesh, b, a));
  return areJoined ? Rejection::LinkCondition : Rejection::NotRejected;
}
}
