// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "StartProof.h"

#include "BulkProof.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <tuple>
#include <utility>

namespace bonedecimate
{
namespace
{
/// Distance of a search position from the end of an edge, as a ratio of its length.
constexpr double FromEnd = 0.25;

/// The direction of length 1 away from an edge, in the plane of its triangle.
Vector3 Inward(const HalfEdgeMesh& mesh, HalfEdgeId h)
{
  const Triangle c = mesh.Corners(HalfEdgeMesh::Face(h));
  const std::size_t first = mesh.Origin(h) == c[0] ? 0 : mesh.Origin(h) == c[1] ? 1 : 2;
  const Vector3 along =
    (mesh.Position(mesh.Target(h)) - mesh.Position(mesh.Origin(h))).normalized();
  const Vector3 inside = mesh.Position(c[(first + 2) % 3]) - mesh.Position(mesh.Origin(h));
  return (inside - Dot(inside, along) * along).normalized();
}

/// Boundary edges in a search tree, each as a triangle with two equal corners. If edges of several
/// patches are at the same position, the one with its triangle in the same direction is preferred.
class EdgeSearch
{
public:
  EdgeSearch(const HalfEdgeMesh& mesh, const CutEdges& cuts)
    : Edges(mesh, cuts)
  {
    Surface surface;
    for (Index edge = 0; edge < this->Edges.Count(); ++edge)
    {
      BoundaryProof::Segment ends = this->Edges.Ends(edge);
      // The same order for edges at the same positions, so that distances are the same bits.
      if (std::lexicographical_compare(
            ends[1].begin(), ends[1].end(), ends[0].begin(), ends[0].end()))
      {
        std::swap(ends[0], ends[1]);
      }
      this->Segments.push_back(ends);
      this->Insides.push_back(Inward(mesh, this->Edges.HalfEdge(edge)));
      const Index first = static_cast<Index>(surface.Points.size());
      surface.Points.insert(surface.Points.end(), ends.begin(), ends.end());
      surface.Triangles.push_back({ first, first + 1, first + 1 });
    }
    this->Tree = std::make_unique<BoundingTree>(surface);
  }

  const BoundaryCurves& Curves() const { return this->Edges; }
  const Vector3& InwardOf(Index edge) const { return this->Insides[edge]; }

  /// None if there are no edges.
  Index FindNearest(const Vector3& p, const Vector3& inward) const
  {
    double least = std::numeric_limits<double>::infinity(); // squared
    Key best = { least, 0.0, None };
    this->Tree->VisitNear(p, least,
      [&](Index edge)
      {
        const double squared = BoundaryProof::SquaredDistance(this->Segments[edge], p);
        best = std::min(best, Key{ squared, -Dot(this->Insides[edge], inward), edge });
        least = std::get<0>(best);
      });
    return std::get<2>(best);
  }

  /// Edges that may be within the distance of a part of the segment, nearest to both ends first.
  std::vector<Index> FindAround(
    const BoundaryProof::Segment& ends, const Vector3& inward, double distance) const
  {
    const double reach = 0.5 * (ends[1] - ends[0]).norm() + distance;
    std::vector<Key> found;
    this->Tree->VisitNear(0.5 * (ends[0] + ends[1]), reach * reach,
      [&](Index edge)
      {
        found.emplace_back(BoundaryProof::SquaredDistance(this->Segments[edge], ends[0]) +
            BoundaryProof::SquaredDistance(this->Segments[edge], ends[1]),
          -Dot(this->Insides[edge], inward), edge);
      });
    std::sort(found.begin(), found.end());
    std::vector<Index> edges;
    edges.reserve(found.size());
    for (const Key& key : found)
    {
      edges.push_back(std::get<2>(key));
    }
    return edges;
  }

private:
  using Key = std::tuple<double, double, Index>; // mm^2, cosine with changed sign, edge

  BoundaryCurves Edges;
  std::vector<BoundaryProof::Segment> Segments;
  std::vector<Vector3> Insides;
  std::unique_ptr<BoundingTree> Tree;
};
}

//------------------------------------------------------------------------------
std::vector<Index> BulkProof::ProveInitialCoverage(
  const std::vector<char>& originals, const std::vector<Index>& current)
{
  this->ProofOfOriginals.FindNear(originals, current, this->Threads);
  this->ProveOriginals(originals, {});
  this->WriteCoverage();
  std::vector<Index> left(this->Failures.size());
  std::transform(this->Failures.begin(), this->Failures.end(), left.begin(),
    [](const Failure& failure) { return failure.Triangle; });
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
  const EdgeSearch originals(this->OriginalMesh, this->OriginalCuts);
  const EdgeSearch edges(mesh, this->Settings.Cuts);
  for (Index edge = 0; edge < edges.Curves().Count(); ++edge)
  {
    const HalfEdgeId h = edges.Curves().HalfEdge(edge);
    const Vector3 along = mesh.Position(mesh.Target(h)) - mesh.Position(mesh.Origin(h));
    // Do not search from the ends themselves, where curves meet.
    this->NearBoundaryEdges[mesh.Origin(h)] =
      originals.FindNearest(mesh.Position(mesh.Origin(h)) + FromEnd * along, edges.InwardOf(edge));
    this->NearBoundaryEdges[mesh.Target(h)] =
      originals.FindNearest(mesh.Position(mesh.Target(h)) - FromEnd * along, edges.InwardOf(edge));
  }
  BoundaryProof proof;
  for (Index item = 0; item < this->Boundaries.Count(); ++item)
  {
    const HalfEdgeId h = this->Boundaries.HalfEdge(item);
    const BoundaryProof::Piece whole = { this->Boundaries.Ends(item),
      { this->LimitAt(this->OriginalMesh.Origin(h)),
        this->LimitAt(this->OriginalMesh.Target(h)) } };
    if (zone != nullptr && !zone->MayReach(whole.Ends, whole.Limits[0]))
    {
      continue;
    }
    const std::vector<Index> around = edges.FindAround(
      whole.Ends, Inward(this->OriginalMesh, h), std::max(whole.Limits[0], whole.Limits[1]));
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
    if (!isProved || used.size() > Coverage::SlotsPerElement)
    {
      left.push_back(HalfEdgeMesh::Face(h));
      continue;
    }
    for (const Index covering : used)
    {
      this->BoundaryCoverage.Add(item, covering);
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
    const std::array<Vector3, 3> corners = PositionsOf(reference.Mesh, static_cast<Index>(i));
    originals[i] = zone->MayReach(corners, bound.LimitAt(c[0])) ? 1 : 0;
  }
  const EditJournal none(mesh);
  std::vector<Index> left = BulkProof(bound, bound.Limits(), mesh, none, threads)
                              .ProveInitialCoverage(originals, reference.NearVertex);
  const std::vector<Index> boundaries = bound.CoverBoundaries(mesh, zone);
  left.insert(left.end(), boundaries.begin(), boundaries.end());
  return left;
}
}
