// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Prover.h"

#include "WalkedTargets.h"

#include <algorithm>

namespace bonedecimate
{
namespace
{

/// Distance of the removed vertices from the new faces, in limits, above which a proof hardly ever
/// succeeds.
constexpr double MaxEndLimits = 1.5;

/// Leaves candidates for the remaining covering faces.
constexpr std::size_t MaxNewFaces = CommonFaceProof::MaxCandidates - Coverage::SlotsPerElement;

bool FaceIsInRange(const HalfEdgeMesh& mesh, FaceId face, VertexRange range)
{
  const Triangle corners = mesh.Corners(face);
  return range.Contains(corners[0]) && range.Contains(corners[1]) && range.Contains(corners[2]);
}
}

Prover::Prover(const ErrorBound& bound)
  : Bound(bound)
  , CoveredTriangles(bound.OriginalMesh.NumberOfFaceSlots())
  , CoveredEdges(static_cast<Index>(bound.Boundaries.Count()))
  , Points(bound.OriginalMesh.NumberOfVertexSlots())
  , NewFaceProof(bound.OriginalMesh)
{
}

//------------------------------------------------------------------------------
Decision Prover::Prove(const HalfEdgeMesh& mesh, const SurfaceChange& change, EditProof& proof)
{
  this->Change = &change;
  if (change.NewFaces.size() > MaxNewFaces || !this->MovedVertexIsNear())
  {
    return Rejection::ErrorBound;
  }
  this->Prepare();
  if (!this->EndsAreNear(mesh) || !this->WitnessesAreNear(mesh))
  {
    return Rejection::ErrorBound;
  }
  Gather(this->Bound.FaceCoverage, change.OldFaces, this->CoveredTriangles);
  Gather(this->Bound.BoundaryCoverage, change.OldBoundary, this->CoveredEdges);
  if (!this->AreInRange(mesh))
  {
    return Decision::Defer();
  }
  const bool isProved =
    this->BoundaryIsNear(mesh) && this->OriginalsAreNear(mesh) && this->NewFacesAreNear();
  if (!isProved)
  {
    return Rejection::ErrorBound;
  }
  Copy(this->Bound.FaceCoverage, this->CoveredTriangles, proof.CoveredTriangles);
  Copy(this->Bound.BoundaryCoverage, this->CoveredEdges, proof.CoveredEdges);
  proof.NearTriangle = this->MovedCorner.Nearest;
  proof.NearBoundaryEdge = this->BoundaryHint;
  return Decision::Accept();
}

//------------------------------------------------------------------------------
void Prover::Copy(const Coverage& coverage, const SparseSet<CoveredElement>& elements,
  std::vector<CoveredElement>& copies)
{
  copies.assign(elements.begin(), elements.end());
  for (CoveredElement& covered : copies)
  {
    covered.Version = coverage.VersionOf(covered.Id);
  }
}

//------------------------------------------------------------------------------
bool Prover::MovedVertexIsNear()
{
  const Index moved = this->Change->MovedVertex;
  if (moved == None)
  {
    return true;
  }
  const WalkedSurface original(
    this->Bound.OriginalMesh, this->Bound.OriginalTree, this->Bound.OriginalLimits);
  this->MovedCorner =
    original.Find(this->Change->Requested.Position, this->Bound.NearTriangles[moved]);
  return this->MovedCorner.Distance <= original.Limit(this->MovedCorner.Nearest);
}

//------------------------------------------------------------------------------
/// Collects the elements that are covered by what the edit replaces.
void Prover::Gather(
  const Coverage& coverage, const std::vector<Index>& old, SparseSet<CoveredElement>& elements)
{
  elements.Clear();
  for (const Index covering : old)
  {
    coverage.VisitCovered(covering,
      [&elements](Index covered, int slot)
      {
        const Index known = elements.Find(covered);
        elements[known == None ? elements.Insert({ covered, 0 }) : known].ReplacedSlots |= 1U
          << slot;
      });
  }
}

//------------------------------------------------------------------------------
/// Whether all its other covering elements are in range.
template <typename IsElementInRange>
bool Prover::IsInRange(
  const Coverage& coverage, const CoveredElement& covered, const IsElementInRange& isElementInRange)
{
  bool isInside = true;
  for (int slot = 0; slot < Coverage::SlotsPerElement && isInside; ++slot)
  {
    const Index covering = coverage.CoveringElement(covered.Id, slot);
    isInside =
      covering == None || (covered.ReplacedSlots >> slot & 1) != 0 || isElementInRange(covering);
  }
  return isInside;
}

//------------------------------------------------------------------------------
template <typename IsElementInRange>
bool Prover::AreInRange(const Coverage& coverage, const SparseSet<CoveredElement>& elements,
  const IsElementInRange& isElementInRange)
{
  return std::all_of(elements.begin(), elements.end(),
    [&](const CoveredElement& covered) { return IsInRange(coverage, covered, isElementInRange); });
}

//------------------------------------------------------------------------------
bool Prover::AreInRange(const HalfEdgeMesh& mesh) const
{
  const VertexRange range = this->Change->Range;
  if (range.HasAll(mesh.NumberOfVertexSlots()))
  {
    return true;
  }
  return AreInRange(this->Bound.FaceCoverage, this->CoveredTriangles,
           [&](FaceId face) { return FaceIsInRange(mesh, face, range); }) &&
    AreInRange(this->Bound.BoundaryCoverage, this->CoveredEdges,
      [&](HalfEdgeId h)
      { return range.Contains(mesh.Origin(h)) && range.Contains(mesh.Target(h)); });
}

//------------------------------------------------------------------------------
void Prover::Prepare()
{
  this->Points.Clear();
  this->SquaredDistances.clear();
  this->CommonFaces.Resize(0);
  for (const SurfaceChange::Face& face : this->Change->NewFaces)
  {
    this->CommonFaces.AddCandidate(face.Corners);
  }
}

//------------------------------------------------------------------------------
/// An early rejection. Removed vertices lie within the limit of the original, which must lie within
/// the limit of the new faces.
bool Prover::EndsAreNear(const HalfEdgeMesh& mesh)
{
  if (this->Change->MovedVertex == None)
  {
    return true;
  }
  const Triangle around = this->Bound.OriginalMesh.Corners(this->MovedCorner.Nearest);
  const double limit = std::max({ this->Bound.LimitAt(around[0]), this->Bound.LimitAt(around[1]),
    this->Bound.LimitAt(around[2]) });
  return std::all_of(this->Change->Ends.begin(), this->Change->Ends.end(),
    [&](VertexId end)
    { return this->CommonFaces.FacesNear(mesh.Position(end), MaxEndLimits * limit) != 0; });
}

//------------------------------------------------------------------------------
/// Originals that caused the last rejections here are likely to cause the next one. Those with a
/// covering face out of range are skipped: another worker may be changing that face.
bool Prover::WitnessesAreNear(const HalfEdgeMesh& mesh)
{
  const auto isInRange = [&](FaceId face)
  { return FaceIsInRange(mesh, face, this->Change->Range); };
  for (const VertexId end : this->Change->Ends)
  {
    const ErrorBound::Witness& known = this->Bound.Witnesses[end];
    for (const Index witness : known)
    {
      CoveredElement covered = { witness, 0 };
      if (witness != None && this->FindReplacedSlots(covered) &&
        IsInRange(this->Bound.FaceCoverage, covered, isInRange) &&
        !this->ProveTriangle(mesh, covered))
      {
        this->AddWitness(witness);
        return false;
      }
    }
  }
  return true;
}

//------------------------------------------------------------------------------
/// Finds the slots of which the edit replaces the face. False if there are none.
bool Prover::FindReplacedSlots(CoveredElement& covered) const
{
  const std::vector<Index>& old = this->Change->OldFaces;
  for (int slot = 0; slot < Coverage::SlotsPerElement; ++slot)
  {
    const Index covering = this->Bound.FaceCoverage.CoveringElement(covered.Id, slot);
    if (covering != None && std::find(old.begin(), old.end(), covering) != old.end())
    {
      covered.ReplacedSlots |= 1U << slot;
    }
  }
  return covered.ReplacedSlots != 0;
}

//------------------------------------------------------------------------------
/// Originals with a far corner first, because they cause most rejections; then those that must be
/// split.
bool Prover::OriginalsAreNear(const HalfEdgeMesh& mesh)
{
  this->UnprovedTriangles.clear();
  for (CoveredElement& covered : this->CoveredTriangles)
  {
    const std::array<Index, 3> points = this->PointsOf(covered.Id);
    covered.ProvedBy = this->NearestCommonFace(points);
    const bool isAnyFar = std::any_of(points.begin(), points.end(),
      [this](Index point) { return this->Points[point].NearCandidates == 0; });
    if (isAnyFar && !this->ProveInPieces(mesh, covered))
    {
      this->AddWitness(covered.Id);
      return false;
    }
    if (covered.ProvedBy == 0 && !isAnyFar)
    {
      this->UnprovedTriangles.push_back(covered.Id);
    }
  }
  for (const Index id : this->UnprovedTriangles)
  {
    if (!this->ProveInPieces(mesh, this->CoveredTriangles[this->CoveredTriangles.Find(id)]))
    {
      this->AddWitness(id);
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
/// Stores an original that could not be proved, in place of the oldest one.
void Prover::AddWitness(Index covered)
{
  for (const VertexId end : this->Change->Ends)
  {
    if (end != None)
    {
      ErrorBound::Witness& known = this->Bound.Witnesses[end];
      const auto position = std::find(known.begin(), known.end() - 1, covered);
      std::rotate(known.begin(), position, position + 1);
      known.front() = covered;
    }
  }
}

//------------------------------------------------------------------------------
bool Prover::ProveTriangle(const HalfEdgeMesh& mesh, CoveredElement& covered)
{
  covered.ProvedBy = this->NearestCommonFace(this->PointsOf(covered.Id));
  return covered.ProvedBy != 0 || this->ProveInPieces(mesh, covered);
}

//------------------------------------------------------------------------------
std::array<Index, 3> Prover::PointsOf(Index original)
{
  const Triangle corners = this->Bound.OriginalMesh.Corners(original);
  return { this->PointOf(corners[0]), this->PointOf(corners[1]), this->PointOf(corners[2]) };
}

//------------------------------------------------------------------------------
/// The position of an original vertex among the points, with its distances to all new faces.
Index Prover::PointOf(Index id)
{
  const Index known = this->Points.Find(id);
  if (known != None)
  {
    return known;
  }
  const Vector3& p = this->Bound.OriginalMesh.Position(id);
  const Faces near = this->CommonFaces.FacesNear(p, this->Bound.LimitAt(id));
  const Point point = { id, near, this->SquaredDistances.size() };
  for (std::size_t i = 0; i < this->Change->NewFaces.size(); ++i)
  {
    this->SquaredDistances.push_back(static_cast<float>(this->CommonFaces.SquaredDistance(i)));
  }
  return this->Points.Insert(point);
}

//------------------------------------------------------------------------------
/// The nearest of the new faces that are near all corners of an original; 0 if there is none.
Prover::Faces Prover::NearestCommonFace(const std::array<Index, 3>& points) const
{
  const Faces shared = this->Points[points[0]].NearCandidates &
    this->Points[points[1]].NearCandidates & this->Points[points[2]].NearCandidates;
  float least = std::numeric_limits<float>::infinity();
  Faces nearest = shared & (~shared + 1);
  for (std::size_t i = 0; i < this->Change->NewFaces.size(); ++i)
  {
    float sum = 0.0F;
    for (const Index point : points)
    {
      sum += this->SquaredDistances[this->Points[point].FirstDistance + i];
    }
    if ((shared >> i & 1) != 0 && sum < least)
    {
      least = sum;
      nearest = Faces(1) << i;
    }
  }
  return nearest;
}

//------------------------------------------------------------------------------
/// By the new faces together with the remaining faces that cover it now.
bool Prover::ProveInPieces(const HalfEdgeMesh& mesh, CoveredElement& covered)
{
  const Triangle corners = this->Bound.OriginalMesh.Corners(covered.Id);
  const std::size_t newFaces = this->Change->NewFaces.size();
  const std::size_t remaining = this->AddRemaining(mesh, covered);
  CommonFaceProof::Piece whole;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const Vector3& p = this->Bound.OriginalMesh.Position(corners[i]);
    const double limit = this->Bound.LimitAt(corners[i]);
    whole[i] = { p, limit, this->CommonFaces.FacesNear(p, limit) };
  }
  covered.ProvedBy = 0;
  const bool proved = this->CommonFaces.Prove(whole, covered.ProvedBy,
                        CommonFaceProof::MaxPieces) == CommonFaceResult::Proved;
  covered.ProvedBy &= (Faces(1) << newFaces) - 1;
  this->CommonFaces.Resize(newFaces);
  return proved && remaining + CountBits(covered.ProvedBy) <= Coverage::SlotsPerElement;
}

//------------------------------------------------------------------------------
/// Adds the remaining covering faces as candidates after the new faces. Returns their number.
std::size_t Prover::AddRemaining(const HalfEdgeMesh& mesh, const CoveredElement& covered)
{
  std::size_t remaining = 0;
  for (int slot = 0; slot < Coverage::SlotsPerElement; ++slot)
  {
    const Index covering = this->Bound.FaceCoverage.CoveringElement(covered.Id, slot);
    if (covering != None && (covered.ReplacedSlots >> slot & 1) == 0)
    {
      this->CommonFaces.AddCandidate(PositionsOf(mesh, covering));
      ++remaining;
    }
  }
  return remaining;
}

//------------------------------------------------------------------------------
/// Tests their centroids and the midpoints of their new edges first: hardly any face that cannot be
/// proved passes.
bool Prover::NewFacesAreNear()
{
  const WalkedSurface original(
    this->Bound.OriginalMesh, this->Bound.OriginalTree, this->Bound.OriginalLimits);
  this->Centroids.clear();
  for (const SurfaceChange::Face& face : this->Change->NewFaces)
  {
    const std::array<Vector3, 3>& p = face.Corners;
    const Index first = face.Vertices[0];
    const Index hint = first == this->Change->MovedVertex ? this->MovedCorner.Nearest
                                                          : this->Bound.NearTriangles[first];
    const PieceCover<3>::Corner centroid = original.Find((p[0] + p[1] + p[2]) / 3.0, hint);
    if (!original.IsWithin(centroid) ||
      !original.IsWithin(original.Find(0.5 * (p[0] + p[1]), centroid.Nearest)))
    {
      return false;
    }
    this->Centroids.push_back(centroid.Nearest);
  }
  for (std::size_t i = 0; i < this->Centroids.size(); ++i)
  {
    if (!this->NewFaceProof.Prove(original, this->Change->NewFaces[i].Corners, this->Centroids[i]))
    {
      return false;
    }
  }
  return true;
}
}
