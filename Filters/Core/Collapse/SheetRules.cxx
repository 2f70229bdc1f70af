// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SheetRules.h"

#include <algorithm>

namespace bonedecimate
{
namespace
{
/// Calls isSo(copy) for the vertex and all its copies until it says yes.
template <typename IsSo>
bool IsAnyCopy(const HalfEdgeMesh& mesh, Index v, const IsSo& isSo)
{
  Index copy = v;
  do
  {
    if (isSo(copy))
    {
      return true;
    }
    copy = mesh.NextCopy(copy);
  } while (copy != v);
  return false;
}

bool HasCopies(const HalfEdgeMesh& mesh, Index v)
{
  return mesh.NextCopy(v) != v;
}

/// Of a vertex with copies: only their rings are read here. To others the rules apply that hold without sheets, too.
bool IsOutOfRange(const HalfEdgeMesh& mesh, Index v, VertexRange range)
{
  return HasCopies(mesh, v) &&
    IsAnyCopy(mesh, v, [&](Index copy) { return !range.Contains(copy); });
}

/// Whether an edge leads from any copy of a to any copy of b, or both are copies of one point.
bool AreJoined(const HalfEdgeMesh& mesh, Index a, Index b)
{
  const Index site = mesh.Site(b);
  return mesh.Site(a) == site ||
    IsAnyCopy(mesh, a,
      [&](Index copy)
      {
        bool joined = mesh.Kind(copy) == VertexKind::Locked; // nobody can tell
        for (Index h = joined ? None : mesh.Outgoing(copy), first = h; h != None && !joined;)
        {
          const Index back = HalfEdgeMesh::Previous(h);
          joined = mesh.Site(mesh.Target(h)) == site || mesh.Site(mesh.Origin(back)) == site;
          h = mesh.Twin(back) == first ? None : mesh.Twin(back);
        }
        return joined;
      });
}

/// Whether an end is pinned and the only face at it goes: another of its open lines would be left without the edge that it
/// has there, and with it what that edge proves.
bool LosesEar(const HalfEdgeMesh& mesh, const Neighbourhood& around)
{
  const auto isEar = [&](Index v)
  {
    int edges = 0;
    mesh.VisitEdges(v, [&edges](Index) { ++edges; });
    return mesh.IsPinned(v) && edges == 2;
  };
  return isEar(around.Start) || isEar(around.End);
}
}

/// The merged vertex gets the edges of both ends: none of those of one may be there already, between other copies or
/// from the other end to another copy.
Verdict JudgeSheets(const HalfEdgeMesh& mesh, const Neighbourhood& around, VertexRange range)
{
  const auto isOut = [&](Index v) { return IsOutOfRange(mesh, v, range); };
  if (isOut(around.Start) || isOut(around.End) ||
    std::any_of(around.Ring.begin(), around.Ring.end(), isOut))
  {
    return Verdict::Elsewhere;
  }
  if (LosesEar(mesh, around))
  {
    return Verdict::Border;
  }
  const auto endAt = [&](std::size_t i)
  { return i < around.Corners.size() ? mesh.Origin(around.Corners[i]) : around.BorderEnds[1]; };
  for (std::size_t i = 0; i < around.Ring.size(); ++i)
  {
    const Index v = around.Ring[i];
    const Index end = endAt(i);
    const Index other = end == around.Start ? around.End : around.Start;
    const bool isApex = v == around.Apexes[0] || v == around.Apexes[1];
    bool joins = HasCopies(mesh, other) && !isApex && AreJoined(mesh, other, v);
    for (std::size_t k = 0; k < i && HasCopies(mesh, v) && !joins; ++k)
    {
      const bool wereJoined = endAt(k) == end && HasCopies(mesh, end);
      joins = mesh.Site(around.Ring[k]) == mesh.Site(v) && !wereJoined;
    }
    if (joins)
    {
      return Verdict::LinkCondition;
    }
  }
  return Verdict::Allowed;
}

//------------------------------------------------------------------------------
Verdict JudgeNewEdge(const HalfEdgeMesh& mesh, Index a, Index b, VertexRange range)
{
  if (IsOutOfRange(mesh, a, range) || IsOutOfRange(mesh, b, range))
  {
    return Verdict::Elsewhere;
  }
  const bool areJoined =
    (HasCopies(mesh, a) && AreJoined(mesh, a, b)) || (HasCopies(mesh, b) && AreJoined(mesh, b, a));
  return areJoined ? Verdict::LinkCondition : Verdict::Allowed;
}
}
