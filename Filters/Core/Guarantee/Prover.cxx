// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Prover.h"

#include "WalkedTargets.h"

#include <algorithm>

namespace bonedecimate
{
namespace
{
/// Of an original, before it is given up: with too few, good edits are refused.
constexpr std::size_t MostPieces = 256;

/// Limits that the ends of an edge may be away from the new faces.
constexpr double FarthestOfEnds = 1.5;

/// Others may have to help.
constexpr std::size_t MostNewFaces = ShareProof::MostCandidates - Supports::MostHolders;

bool FaceIsInRange(const HalfEdgeMesh& mesh, Index face, VertexRange range)
{
  const Triangle corners = mesh.Corners(face);
  return range.Contains(corners[0]) && range.Contains(corners[1]) && range.Contains(corners[2]);
}
}

Prover::Prover(Guarantee& promise)
  : Shared(promise)
  , Items(promise.Source.NumberOfFaceSlots())
  , BorderItems(static_cast<Index>(promise.Borders.Count()))
  , Points(promise.Source.NumberOfVertexSlots())
  , Back(promise.Source)
{
}

//------------------------------------------------------------------------------
ProofAnswer Prover::Prove(const HalfEdgeMesh& mesh, VertexRange range)
{
  if (this->Change.NewFaces.size() > MostNewFaces || !this->PlaceIsNear())
  {
    return ProofAnswer::Refused;
  }
  this->Prepare();
  if (!this->EndsAreNear(mesh) || !this->WitnessesAreNear(mesh))
  {
    return ProofAnswer::Refused;
  }
  Gather(this->Shared.ByFaces, this->Change.OldFaces, this->Items);
  Gather(this->Shared.ByBorders, this->Change.OldBorder, this->BorderItems);
  if (!this->IsOurs(mesh, range))
  {
    return ProofAnswer::Elsewhere;
  }
  const bool proved =
    this->BorderIsNear(mesh) && this->OriginalsAreNear(mesh) && this->NewFacesAreNear();
  return proved ? ProofAnswer::Proved : ProofAnswer::Refused;
}

//------------------------------------------------------------------------------
bool Prover::PlaceIsNear()
{
  const Index moved = this->Change.Moved;
  if (moved == None)
  {
    return true;
  }
  const WalkedSurface original(this->Shared.Source, this->Shared.Tree, this->Shared.Allowed);
  this->Place = original.Find(this->Change.Position, this->Shared.Nearest[moved]);
  return this->Place.Distance <= original.Limit(this->Place.Nearest);
}

//------------------------------------------------------------------------------
/// What was proved by holders that are about to change.
void Prover::Gather(const Supports& supports, const std::vector<Index>& old, SparseSet<Item>& items)
{
  items.Clear();
  for (const Index holder : old)
  {
    supports.VisitItems(holder,
      [&items](Index item, int slot)
      {
        const Index known = items.Find(item);
        items[known == None ? items.Insert({ item, 0 }) : known].Gone |= 1U << slot;
      });
  }
}

//------------------------------------------------------------------------------
/// Whether nothing out of range proves any of the items, too.
template <typename IsInRange>
bool Prover::IsOurs(
  const Supports& supports, const SparseSet<Item>& items, const IsInRange& isInRange)
{
  return std::all_of(items.begin(), items.end(),
    [&](const Item& item)
    {
      bool ours = true;
      for (int slot = 0; slot < Supports::MostHolders && ours; ++slot)
      {
        const Index holder = supports.Holder(item.Id, slot);
        ours = holder == None || (item.Gone >> slot & 1) != 0 || isInRange(holder);
      }
      return ours;
    });
}

//------------------------------------------------------------------------------
bool Prover::IsOurs(const HalfEdgeMesh& mesh, VertexRange range) const
{
  return IsOurs(this->Shared.ByFaces, this->Items,
           [&](Index face) { return FaceIsInRange(mesh, face, range); }) &&
    IsOurs(this->Shared.ByBorders, this->BorderItems,
      [&](Index h) { return range.Contains(mesh.Origin(h)) && range.Contains(mesh.Target(h)); });
}

//------------------------------------------------------------------------------
void Prover::Prepare()
{
  this->Points.Clear();
  this->SquaredDistances.clear();
  this->Share.Resize(0);
  for (const Patch::Face& face : this->Change.NewFaces)
  {
    this->Share.AddCandidate(face.Corners);
  }
}

//------------------------------------------------------------------------------
/// Vertices that go lie within the limit of the original, which shall lie within the limit of the new faces: where they
/// are farther from those than a good part of both together, a proof is not to be had, but for few.
bool Prover::EndsAreNear(const HalfEdgeMesh& mesh)
{
  if (this->Change.Moved == None)
  {
    return true;
  }
  const Triangle around = this->Shared.Source.Corners(this->Place.Nearest);
  const double limit = std::max({ this->Shared.LimitAt(around[0]), this->Shared.LimitAt(around[1]),
    this->Shared.LimitAt(around[2]) });
  return std::all_of(this->Change.Ends.begin(), this->Change.Ends.end(),
    [&](Index end)
    { return this->Share.FacesNear(mesh.Position(end), FarthestOfEnds * limit) != 0; });
}

//------------------------------------------------------------------------------
/// What refused an edit here last time will most often do so again.
bool Prover::WitnessesAreNear(const HalfEdgeMesh& mesh)
{
  for (const Index end : this->Change.Ends)
  {
    const Guarantee::Witness& known = this->Shared.Witnesses[end];
    for (const Index witness : known)
    {
      Item item = { witness, 0 };
      if (witness != None && this->Depends(item) && !this->ProveItem(mesh, item))
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
  const std::vector<Index>& old = this->Change.OldFaces;
  for (int slot = 0; slot < Supports::MostHolders; ++slot)
  {
    const Index holder = this->Shared.ByFaces.Holder(item.Id, slot);
    if (holder != None && std::find(old.begin(), old.end(), holder) != old.end())
    {
      item.Gone |= 1U << slot;
    }
  }
  return item.Gone != 0;
}

//------------------------------------------------------------------------------
/// Corners first, which refuse most of what is refused; then what has to be cut.
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
/// As what could not be proved, in place of what refused longest ago.
void Prover::Remember(Index item)
{
  for (const Index end : this->Change.Ends)
  {
    if (end != None)
    {
      Guarantee::Witness& known = this->Shared.Witnesses[end];
      const auto place = std::find(known.begin(), known.end() - 1, item);
      std::rotate(known.begin(), place, place + 1);
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
/// The place of an original vertex among the points, judged against all new faces.
Index Prover::PointOf(Index id)
{
  const Index known = this->Points.Find(id);
  if (known != None)
  {
    return known;
  }
  const Vector3& p = this->Shared.Source.Position(id);
  const Faces near = this->Share.FacesNear(p, this->Shared.LimitAt(id));
  const Point point = { id, near, this->SquaredDistances.size() };
  for (std::size_t i = 0; i < this->Change.NewFaces.size(); ++i)
  {
    this->SquaredDistances.push_back(static_cast<float>(this->Share.SquaredDistance(i)));
  }
  return this->Points.Insert(point);
}

//------------------------------------------------------------------------------
/// Of the faces near all corners of an original the nearest, if there is any: its neighbours are those that may have to
/// take over.
Prover::Faces Prover::Nearest(const std::array<Index, 3>& points) const
{
  const Faces shared =
    this->Points[points[0]].Near & this->Points[points[1]].Near & this->Points[points[2]].Near;
  float least = std::numeric_limits<float>::infinity();
  Faces nearest = shared & (~shared + 1);
  for (std::size_t i = 0; i < this->Change.NewFaces.size(); ++i)
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
/// With the help of the faces that stay and prove a part of it today.
bool Prover::ProveInPieces(const HalfEdgeMesh& mesh, Item& item)
{
  const Triangle corners = this->Shared.Source.Corners(item.Id);
  const std::size_t ours = this->Change.NewFaces.size();
  const std::size_t held = this->AddHelp(mesh, item);
  ShareProof::Piece whole;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const Vector3& p = this->Shared.Source.Position(corners[i]);
    const double limit = this->Shared.LimitAt(corners[i]);
    whole[i] = { p, limit, this->Share.FacesNear(p, limit) };
  }
  item.Used = 0;
  const bool proved = this->Share.Prove(whole, item.Used, MostPieces) == ShareAnswer::Proved;
  item.Used &= (Faces(1) << ours) - 1;
  this->Share.Resize(ours);
  return proved && held + CountBits(item.Used) <= Supports::MostHolders;
}

//------------------------------------------------------------------------------
/// Candidates behind the new faces: what else proves the item and stays. How many they are.
std::size_t Prover::AddHelp(const HalfEdgeMesh& mesh, const Item& item)
{
  std::size_t held = 0;
  for (int slot = 0; slot < Supports::MostHolders; ++slot)
  {
    const Index holder = this->Shared.ByFaces.Holder(item.Id, slot);
    if (holder != None && (item.Gone >> slot & 1) == 0)
    {
      const Triangle v = mesh.Corners(holder);
      this->Share.AddCandidate({ mesh.Position(v[0]), mesh.Position(v[1]), mesh.Position(v[2]) });
      ++held;
    }
  }
  return held;
}

//------------------------------------------------------------------------------
bool Prover::NewFacesAreNear()
{
  const WalkedSurface original(this->Shared.Source, this->Shared.Tree, this->Shared.Allowed);
  return std::all_of(this->Change.NewFaces.begin(), this->Change.NewFaces.end(),
    [&](const Patch::Face& face)
    {
      const Index first = face.Vertices[0];
      return this->Back.Prove(original, face.Corners,
        first == this->Change.Moved ? this->Place.Nearest : this->Shared.Nearest[first]);
    });
}

//------------------------------------------------------------------------------
void Prover::Commit()
{
  if (this->Change.Moved != None)
  {
    this->Shared.Nearest[this->Change.Moved] = this->Place.Nearest;
  }
  this->Holders.clear();
  for (const Patch::Face& face : this->Change.NewFaces)
  {
    this->Holders.push_back(face.Id);
  }
  Commit(this->Shared.ByFaces, this->Change.OldFaces, this->Items, this->Holders);
  if (!this->Change.NewBorder.empty() && !this->Change.BorderStays && this->Change.Moved != None)
  {
    this->Shared.NearestBorder[this->Change.Moved] = this->BorderPlace;
  }
  this->Holders.clear();
  for (const Patch::BorderEdge& edge : this->Change.NewBorder)
  {
    this->Holders.push_back(edge.Id);
  }
  Commit(this->Shared.ByBorders, this->Change.OldBorder, this->BorderItems, this->Holders);
}

//------------------------------------------------------------------------------
void Prover::Commit(Supports& supports, const std::vector<Index>& gone, SparseSet<Item>& items,
  const std::vector<Index>& holders)
{
  for (const Index holder : gone)
  {
    supports.Forget(holder);
  }
  for (const Item& item : items)
  {
    for (int slot = 0; slot < Supports::MostHolders; ++slot)
    {
      if ((item.Gone >> slot & 1) != 0)
      {
        supports.Free(item.Id, slot);
      }
    }
    for (std::size_t i = 0; i < holders.size(); ++i)
    {
      if ((item.Used >> i & 1) != 0)
      {
        supports.Add(item.Id, holders[i]);
      }
    }
  }
}
}
