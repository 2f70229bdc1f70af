// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "StartProof.h"

#include "BulkProof.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

namespace bonedecimate
{
namespace
{
/// Boundary edges with a search tree. An edge is a triangle of which two corners are equal.
class EdgeSearch
{
public:
  EdgeSearch(const HalfEdgeMesh& mesh, const Zone* zone)
    : Edges(mesh, zone)
  {
    Surface surface;
    for (Index edge = 0; edge < this->Edges.Count(); ++edge)
    {
      const BoundaryProof::Segment ends = this->Edges.Ends(edge);
      const Index first = static_cast<Index>(surface.Points.size());
      surface.Points.insert(surface.Points.end(), ends.begin(), ends.end());
      surface.Triangles.push_back({ first, first + 1, first + 1 });
    }
    this->Tree = std::make_unique<BoundingTree>(surface);
  }

  const BoundaryCurves& Curves() const { return this->Edges; }

  /// None if there is no edge.
  Index FindNearest(const Vector3& p) const
  {
    double least = std::numeric_limits<double>::infinity(); // squared
    Index nearest = None;
    this->Tree->VisitNear(p, least,
      [&](Index edge)
      {
        const double squared = BoundaryProof::SquaredReach(this->Edges.Ends(edge), p);
        nearest = squared < least || (squared == least && edge < nearest) ? edge : nearest;
        least = std::min(least, squared);
      });
    return nearest;
  }

  /// Ascending.
  std::vector<Index> FindAround(const Vector3& p, double reach) const
  {
    std::vector<Index> edges;
    this->Tree->VisitNear(p, reach * reach, [&](Index edge) { edges.push_back(edge); });
    std::sort(edges.begin(), edges.end());
    return edges;
  }

private:
  BoundaryCurves Edges;
  std::unique_ptr<BoundingTree> Tree;
};
}

//------------------------------------------------------------------------------
std::vector<Index> BulkProof::CoverFirst(
  const std::vector<char>& originals, const std::vector<Index>& current)
{
  this->FindNear(originals, current);
  this->ProveOriginals(originals);
  this->WriteCoverage();
  std::vector<Index> left;
  for (std::size_t i = 0; i < this->Found.Count(); ++i)
  {
    if (!this->Found.Of(i).IsProved)
    {
      left.push_back(static_cast<Index>(i));
    }
  }
  return left;
}

//------------------------------------------------------------------------------
std::vector<Index> ErrorBound::CoverBoundaries(const HalfEdgeMesh& mesh, const Zone* zone)
{
  std::vector<Index> left;
  if (this->Boundaries.Count() == 0)
  {
    return left;
  }
  const EdgeSearch originals(this->Source, this->BoundaryZone());
  const EdgeSearch edges(mesh, this->BoundaryZone());
  for (Index edge = 0; edge < edges.Curves().Count(); ++edge)
  {
    const HalfEdgeId h = edges.Curves().HalfEdge(edge);
    for (const VertexId end : { mesh.Origin(h), mesh.Target(h) })
    {
      this->NearestBoundary[end] = originals.FindNearest(mesh.Position(end));
    }
  }
  BoundaryProof proof;
  for (Index item = 0; item < this->Boundaries.Count(); ++item)
  {
    const HalfEdgeId h = this->Boundaries.HalfEdge(item);
    const BoundaryProof::Piece whole = { this->Boundaries.Ends(item),
      { this->LimitAt(this->Source.Origin(h)), this->LimitAt(this->Source.Target(h)) } };
    if (zone != nullptr && !zone->MayReach(whole.Ends, whole.ErrorLimits[0]))
    {
      continue;
    }
    const double reach = 0.5 * (whole.Ends[1] - whole.Ends[0]).norm() +
      std::max(whole.ErrorLimits[0], whole.ErrorLimits[1]);
    const std::vector<Index> around =
      edges.FindAround(0.5 * (whole.Ends[0] + whole.Ends[1]), reach);
    proof.Candidates.clear();
    for (const Index edge : around)
    {
      proof.Candidates.push_back(edges.Curves().Ends(edge));
    }
    std::vector<Index> used;
    const bool isProved = proof.Prove(
      whole, [&](std::size_t i) { used.push_back(edges.Curves().HalfEdge(around[i])); });
    std::sort(used.begin(), used.end());
    used.erase(std::unique(used.begin(), used.end()), used.end());
    if (!isProved || used.size() > Coverage::SlotsPerItem)
    {
      left.push_back(HalfEdgeMesh::Face(h));
      continue;
    }
    for (const Index covering : used)
    {
      this->ByBoundaries.Add(item, covering);
    }
  }
  return left;
}

//------------------------------------------------------------------------------
std::vector<Index> ProveStart(ErrorBound& bound, const ReferenceMesh& reference,
  const HalfEdgeMesh& mesh, const Zone* zone, int threads)
{
  std::vector<char> originals(static_cast<std::size_t>(reference.Mesh.NumberOfFaceSlots()), 1);
  for (std::size_t i = 0; i < originals.size() && zone != nullptr; ++i)
  {
    const Triangle c = reference.Mesh.Corners(static_cast<Index>(i));
    const std::array<Vector3, 3> corners = { reference.Mesh.Position(c[0]),
      reference.Mesh.Position(c[1]), reference.Mesh.Position(c[2]) };
    originals[i] = zone->MayReach(corners, bound.LimitAt(c[0])) ? 1 : 0;
  }
  const EditJournal none(mesh);
  std::vector<Index> left =
    BulkProof(bound, mesh, none, threads).CoverFirst(originals, reference.NearVertex);
  const std::vector<Index> boundaries = bound.CoverBoundaries(mesh, zone);
  left.insert(left.end(), boundaries.begin(), boundaries.end());
  return left;
}
}
