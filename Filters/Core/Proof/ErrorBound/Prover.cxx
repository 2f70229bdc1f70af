// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Prover.h"

#include "WalkedTargets.h"

#include <algorithm>

namespace bonedecimate
{
namespace
{
/// Largest number of pieces of an original before its proof is given up. With fewer, good edits are
/// rejected.
constexpr std::size_t MaxPiecesOfItem = 256;

/// How many limits the ends of an edge may lie from the new faces.
constexpr double FarthestOfEnds = 1.5;

/// Leaves candidates for other faces that may have to help cover an item.
constexpr std::size_t MaxNewFaces = CommonFaceProof::MaxCandidates - Coverage::SlotsPerItem;

bool FaceIsInRange(const HalfEdgeMesh& mesh, FaceId face, VertexRange range)
{
  const Triangle corners = mesh.Corners(face);
  return range.Contains(corners[0]) && range.Contains(corners[1]) && range.Contains(corners[2]);
}
}

Prover::Prover(const ErrorBound& bound)
  : Shared(bound)
  , Items(bound.Source.NumberOfFaceSlots())
  , BoundaryItems(static_cast<Index>(bound.Boundaries.Count()))
  , Points(bound.Source.NumberOfVertexSlots())
  , Back(bound.Source)
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
  Gather(this->Shared.ByFaces, change.OldFaces, this->Items);
  Gather(this->Shared.ByBoundaries, change.OldBoundary, this->BoundaryItems);
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
  Copy(this->Shared.ByFaces, this->Items, proof.Items);
  Copy(this->Shared.ByBoundaries, this->BoundaryItems, proof.BoundaryItems);
  proof.Nearest = this->MovedCorner.Nearest;
  proof.NearestBoundary = this->BoundaryHint;
  return Decision::Accept();
}

//------------------------------------------------------------------------------
void Prover::Copy(const Coverage& coverage, const SparseSet<Item>& items, std::vector<Item>& copies)
{
  copies.assign(items.begin(), items.end());
  for (Item& item : copies)
  {
    item.Version = coverage.VersionOf(item.Id);
  }
}

//------------------------------------------------------------------------------
bool Prover::MovedVertexIsNear()
{
  const Index moved = this->Change->Moved;
  if (moved == None)
  {
    return true;
  }
  const WalkedSurface original(this->Shared.Source, this->Shared.Tree, this->Shared.Allowed);
  this->MovedCorner = original.Find(this->Change->Requested.Position, this->Shared.Nearest[moved]);
  return this->MovedCorner.Distance <= original.Limit(this->MovedCorner.Nearest);
}

//------------------------------------------------------------------------------
/// The items of covering elements that the edit changes.
void Prover::Gather(const Coverage& coverage, const std::vector<Index>& old, SparseSet<Item>& items)
{
  items.Clear();
  for (const Index covering : old)
  {
    coverage.VisitItems(covering,
      [&items](Index item, int slot)
      {
        const Index known = items.Find(item);
        items[known == None ? items.Insert({ item, 0 }) : known].Gone |= 1U << slot;
      });
  }
}

//------------------------------------------------------------------------------
/// Whether all other covering elements of the item are in range.
template <typename IsElementInRange>
bool Prover::IsInRange(
  const Coverage& coverage, const Item& item, const IsElementInRange& isElementInRange)
{
  bool isInside = true;
  for (int slot = 0; slot < Coverage::SlotsPerItem && isInside; ++slot)
  {
    const Index covering = coverage.CoveringElement(item.Id, slot);
    isInside = covering == None || (item.Gone >> slot & 1) != 0 || isElementInRange(covering);
  }
  return isInside;
}

//------------------------------------------------------------------------------
template <typename IsElementInRange>
bool Prover::AreInRange(
  const Coverage& coverage, const SparseSet<Item>& items, const IsElementInRange& isElementInRange)
{
  return std::all_of(items.begin(), items.end(),
    [&](const Item& item) { return IsInRange(coverage, item, isElementInRange); });
}

//------------------------------------------------------------------------------
bool Prover::AreInRange(const HalfEdgeMesh& mesh) const
{
  const VertexRange range = this->Change->Range;
  if (range.HasAll(mesh.NumberOfVertexSlots()))
  {
    return true;
  }
  return AreInRange(this->Shared.ByFaces, this->Items,
           [&](FaceId face) { return FaceIsInRange(mesh, face, range); }) &&
    AreInRange(this->Shared.ByBoundaries, this->BoundaryItems,
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
/// An early rejection: removed vertices lie within the limit of the original, which must lie within
/// the limit of the new faces. If they are farther from the new faces than most of the sum of both
/// limits, a proof hardly ever succeeds.
bool Prover::EndsAreNear(const HalfEdgeMesh& mesh)
{
  if (this->Change->Moved == None)
  {
    return true;
  }
  const Triangle around = this->Shared.Source.Corners(this->MovedCorner.Nearest);
  const double limit = std::max({ this->Shared.LimitAt(around[0]), this->Shared.LimitAt(around[1]),
    this->Shared.LimitAt(around[2]) });
  return std::all_of(this->Change->Ends.begin(), this->Change->Ends.end(),
    [&](VertexId end)
    { return this->CommonFaces.FacesNear(mesh.Position(end), FarthestOfEnds * limit) != 0; });
}

//------------------------------------------------------------------------------
/// The items that caused the last rejections here are likely to cause the next one. Those with a
/// covering face out of range are skipped: another worker may be changing that face.
bool Prover::WitnessesAreNear(const HalfEdgeMesh& mesh)
{
  const auto isInRange = [&](FaceId face)
  { return FaceIsInRange(mesh, face, this->Change->Range); };
  for (const VertexId end : this->Change->Ends)
  {
    const ErrorBound::Witness& known = this->Shared.Witnesses[end];
    for (const Index witness : known)
    {
      Item item = { witness, 0 };
      if (witness != None && this->Depends(item) &&
        IsInRange(this->Shared.ByFaces, item, isInRange) && !this->ProveItem(mesh, item))
      {
        this->Remember(witness);
        return false;
      }
    }
  }
  return true;
}

//------------------------------------------------------------------------------
/// Whether faces that change prove the item; which of them, if so.
bool Prover::Depends(Item& item) const
{
  const std::vector<Index>& old = this->Change->OldFaces;
  for (int slot = 0; slot < Coverage::SlotsPerItem; ++slot)
  {
    const Index covering = this->Shared.ByFaces.CoveringElement(item.Id, slot);
    if (covering != None && std::find(old.begin(), old.end(), covering) != old.end())
    {
      item.Gone |= 1U << slot;
    }
  }
  return item.Gone != 0;
}

//------------------------------------------------------------------------------
/// Corners first, because they cause most rejections; then items that must be split.
bool Prover::OriginalsAreNear(const HalfEdgeMesh& mesh)
{
  this->Uncut.clear();
  for (Item& item : this->Items)
  {
    const std::array<Index, 3> points = this->PointsOf(item.Id);
    item.Used = this->Nearest(points);
    const bool isAnyFar = std::any_of(
      points.begin(), points.end(), [this](Index point) { return this->Points[point].Near == 0; });
    if (isAnyFar && !this->ProveInPieces(mesh, item))
    {
      this->Remember(item.Id);
      return false;
    }
    if (item.Used == 0 && !isAnyFar)
    {
      this->Uncut.push_back(item.Id);
    }
  }
  for (const Index id : this->Uncut)
  {
    if (!this->ProveInPieces(mesh, this->Items[this->Items.Find(id)]))
    {
      this->Remember(id);
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
/// Stores an item that could not be proved instead of the oldest one.
void Prover::Remember(Index item)
{
  for (const VertexId end : this->Change->Ends)
  {
    if (end != None)
    {
      ErrorBound::Witness& known = this->Shared.Witnesses[end];
      const auto position = std::find(known.begin(), known.end() - 1, item);
      std::rotate(known.begin(), position, position + 1);
      known.front() = item;
    }
  }
}

//------------------------------------------------------------------------------
bool Prover::ProveItem(const HalfEdgeMesh& mesh, Item& item)
{
  item.Used = this->Nearest(this->PointsOf(item.Id));
  return item.Used != 0 || this->ProveInPieces(mesh, item);
}

//------------------------------------------------------------------------------
std::array<Index, 3> Prover::PointsOf(Index original)
{
  const Triangle corners = this->Shared.Source.Corners(original);
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
  const Vector3& p = this->Shared.Source.Position(id);
  const Faces near = this->CommonFaces.FacesNear(p, this->Shared.LimitAt(id));
  const Point point = { id, near, this->SquaredDistances.size() };
  for (std::size_t i = 0; i < this->Change->NewFaces.size(); ++i)
  {
    this->SquaredDistances.push_back(static_cast<float>(this->CommonFaces.SquaredDistance(i)));
  }
  return this->Points.Insert(point);
}

//------------------------------------------------------------------------------
/// The nearest of the faces near all corners of an original, if there is one. Its neighbors may
/// have to take over.
Prover::Faces Prover::Nearest(const std::array<Index, 3>& points) const
{
  const Faces shared =
    this->Points[points[0]].Near & this->Points[points[1]].Near & this->Points[points[2]].Near;
  float least = std::numeric_limits<float>::infinity();
  Faces nearest = shared & (~shared + 1);
  for (std::size_t i = 0; i < this->Change->NewFaces.size(); ++i)
  {
    float sum = 0.0F;
    for (const Index point : points)
    {
      sum += this->SquaredDistances[this->Points[point].Distances + i];
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
/// Together with the remaining faces that prove a part of it now.
bool Prover::ProveInPieces(const HalfEdgeMesh& mesh, Item& item)
{
  const Triangle corners = this->Shared.Source.Corners(item.Id);
  const std::size_t newFaces = this->Change->NewFaces.size();
  const std::size_t remaining = this->AddRemaining(mesh, item);
  CommonFaceProof::Piece whole;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const Vector3& p = this->Shared.Source.Position(corners[i]);
    const double limit = this->Shared.LimitAt(corners[i]);
    whole[i] = { p, limit, this->CommonFaces.FacesNear(p, limit) };
  }
  item.Used = 0;
  const bool proved =
    this->CommonFaces.Prove(whole, item.Used, MaxPiecesOfItem) == CommonFaceResult::Proved;
  item.Used &= (Faces(1) << newFaces) - 1;
  this->CommonFaces.Resize(newFaces);
  return proved && remaining + CountBits(item.Used) <= Coverage::SlotsPerItem;
}

//------------------------------------------------------------------------------
/// Adds the remaining faces that prove the item as candidates after the new faces; returns their
/// number.
std::size_t Prover::AddRemaining(const HalfEdgeMesh& mesh, const Item& item)
{
  std::size_t remaining = 0;
  for (int slot = 0; slot < Coverage::SlotsPerItem; ++slot)
  {
    const Index covering = this->Shared.ByFaces.CoveringElement(item.Id, slot);
    if (covering != None && (item.Gone >> slot & 1) == 0)
    {
      const Triangle v = mesh.Corners(covering);
      this->CommonFaces.AddCandidate(
        { mesh.Position(v[0]), mesh.Position(v[1]), mesh.Position(v[2]) });
      ++remaining;
    }
  }
  return remaining;
}

//------------------------------------------------------------------------------
/// First their centroids and the middles of their new edges: hardly any face that cannot be proved
/// passes.
bool Prover::NewFacesAreNear()
{
  const WalkedSurface original(this->Shared.Source, this->Shared.Tree, this->Shared.Allowed);
  this->Centroids.clear();
  for (const SurfaceChange::Face& face : this->Change->NewFaces)
  {
    const std::array<Vector3, 3>& p = face.Corners;
    const Index first = face.Vertices[0];
    const Index hint =
      first == this->Change->Moved ? this->MovedCorner.Nearest : this->Shared.Nearest[first];
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
    if (!this->Back.Prove(original, this->Change->NewFaces[i].Corners, this->Centroids[i]))
    {
      return false;
    }
  }
  return true;
}
}
