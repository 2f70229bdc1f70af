// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Prover.h"

#include "WalkedTargets.h"

#include <algorithm>

namespace bonedecimate
{
Prover::Prover(Guarantee& promise)
  : Shared(promise)
  , Items(promise.Source.NumberOfFaceSlots())
  , BorderItems(static_cast<Index>(promise.Borders.Count()))
  , Points(promise.Source.NumberOfVertexSlots())
  , Planes(promise.Source)
{
}

//------------------------------------------------------------------------------
ProofAnswer Prover::Prove(const HalfEdgeMesh& mesh, VertexRange range)
{
  if (this->Change.NewFaces.size() > ShareProof::MostCandidates || !this->PlaceIsNear())
  {
    return ProofAnswer::Refused;
  }
  this->Prepare();
  if (!this->WitnessesAreNear(mesh))
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
  const auto faceIsInRange = [&](Index face)
  {
    const Triangle corners = mesh.Corners(face);
    return range.Contains(corners[0]) && range.Contains(corners[1]) && range.Contains(corners[2]);
  };
  return IsOurs(this->Shared.ByFaces, this->Items, faceIsInRange) &&
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
/// What refused an edit here last time will most often do so again.
bool Prover::WitnessesAreNear(const HalfEdgeMesh& mesh)
{
  for (const Index end : this->Change.Ends)
  {
    const Index witness = end == None ? None : this->Shared.Witnesses[end];
    Item item = { witness, 0 };
    if (witness != None && this->Depends(item) && !this->ProveItem(mesh, item))
    {
      return false;
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
bool Prover::OriginalsAreNear(const HalfEdgeMesh& mesh)
{
  for (Item& item : this->Items)
  {
    if (!this->ProveItem(mesh, item))
    {
      for (const Index end : this->Change.Ends)
      {
        this->Shared.Witnesses[end] = item.Id;
      }
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool Prover::ProveItem(const HalfEdgeMesh& mesh, Item& item)
{
  const Triangle corners = this->Shared.Source.Corners(item.Id);
  const std::array<Index, 3> points = { this->PointOf(corners[0]), this->PointOf(corners[1]),
    this->PointOf(corners[2]) };
  const Faces shared =
    this->Points[points[0]].Near & this->Points[points[1]].Near & this->Points[points[2]].Near;
  if (shared == 0)
  {
    return this->ProveInPieces(mesh, item, corners);
  }
  item.Used = this->Nearest(shared, points);
  return true;
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
/// Of the faces that could prove an original, the nearest: its neighbours are those that may have to take over.
Prover::Faces Prover::Nearest(Faces shared, const std::array<Index, 3>& points) const
{
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
bool Prover::ProveInPieces(const HalfEdgeMesh& mesh, Item& item, const Triangle& corners)
{
  const std::size_t ours = this->Change.NewFaces.size();
  std::size_t others = 0;
  for (int slot = 0; slot < Supports::MostHolders; ++slot)
  {
    const Index holder = this->Shared.ByFaces.Holder(item.Id, slot);
    if (holder != None && (item.Gone >> slot & 1) == 0 &&
      ours + others < ShareProof::MostCandidates)
    {
      const Triangle v = mesh.Corners(holder);
      this->Share.AddCandidate({ mesh.Position(v[0]), mesh.Position(v[1]), mesh.Position(v[2]) });
      ++others;
    }
  }
  ShareProof::Piece whole;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const Vector3& p = this->Shared.Source.Position(corners[i]);
    const double limit = this->Shared.LimitAt(corners[i]);
    whole[i] = { p, limit, this->Share.FacesNear(p, limit) };
  }
  item.Used = 0;
  const bool proved = this->Share.Prove(whole, item.Used);
  item.Used &= ours < ShareProof::MostCandidates ? (Faces(1) << ours) - 1 : ~Faces(0);
  this->Share.Resize(ours);
  return proved && others + CountBits(item.Used) <= Supports::MostHolders;
}

//------------------------------------------------------------------------------
bool Prover::NewFacesAreNear()
{
  const WalkedSurface original(this->Shared.Source, this->Shared.Tree, this->Shared.Allowed);
  return std::all_of(this->Change.NewFaces.begin(), this->Change.NewFaces.end(),
    [&](const Patch::Face& face)
    {
      const Index seed = this->Shared.Nearest[face.Vertices[0]];
      if (this->Planes.Prove(face.Corners,
            face.Vertices[0] == this->Change.Moved ? this->Place.Nearest : seed,
            [&original](Index id) { return original.Limit(id); }))
      {
        return true;
      }
      PieceCover<3>::Piece whole;
      for (std::size_t i = 0; i < 3; ++i)
      {
        const Index v = face.Vertices[i];
        whole[i] = v == this->Change.Moved
          ? this->Place
          : original.Find(face.Corners[i], this->Shared.Nearest[v]);
      }
      return this->Pieces.Prove(original, whole);
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
  if (!this->Change.NewBorder.empty() && this->Change.Moved != None)
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
