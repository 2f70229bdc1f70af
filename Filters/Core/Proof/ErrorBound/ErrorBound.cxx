// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ErrorBound.h"

#include "Prover.h"

#include <algorithm>

namespace bonedecimate
{
namespace
{
bool IsAsProved(const Coverage& coverage, const std::vector<CoveredItem>& items)
{
  return std::all_of(items.begin(), items.end(),
    [&](const CoveredItem& item) { return coverage.VersionOf(item.Id) == item.Version; });
}

/// @param gone Covering elements that are replaced by the new ones.
void Replace(Coverage& coverage, const std::vector<Index>& gone,
  const std::vector<CoveredItem>& items, const std::vector<Index>& newElements)
{
  for (const Index covering : gone)
  {
    coverage.Forget(covering);
  }
  for (const CoveredItem& item : items)
  {
    for (int slot = 0; slot < Coverage::SlotsPerItem; ++slot)
    {
      if ((item.Gone >> slot & 1) != 0)
      {
        coverage.Free(item.Id, slot);
      }
    }
    for (std::size_t i = 0; i < newElements.size(); ++i)
    {
      if ((item.Used >> i & 1) != 0)
      {
        coverage.Add(item.Id, newElements[i]);
      }
    }
  }
}
}

Vector3 ErrorBoundSettings::Rounded(const Vector3& position) const
{
  return this->Rounding.OfLocal(position, this->Origin);
}

//------------------------------------------------------------------------------
ErrorBound::ErrorBound(
  const HalfEdgeMesh& atFirst, const BoundingTree& tree, const ErrorBoundSettings& settings)
  : Source(atFirst)
  , Tree(tree)
  , Settings(settings)
  , Allowed(atFirst, settings)
  , Boundaries(atFirst)
  , NearestBoundary(this->Boundaries.EdgesAtVertices())
  , Nearest(static_cast<std::size_t>(atFirst.NumberOfVertexSlots()), None)
{
  for (FaceId face = 0; face < atFirst.NumberOfFaceSlots(); ++face)
  {
    for (const VertexId v : atFirst.Corners(face))
    {
      const Index known = this->Nearest[v];
      const bool allowsMore =
        known == None || this->Allowed.Over(face) >= this->Allowed.Over(known);
      this->Nearest[v] = allowsMore ? static_cast<Index>(face) : known;
    }
  }
}

ErrorBound::ErrorBound(
  const ReferenceMesh& reference, const HalfEdgeMesh& mesh, const ErrorBoundSettings& settings)
  : Source(reference.Mesh)
  , Tree(reference.Tree)
  , CutsOfSource(reference.Cuts)
  , Settings(settings)
  , Allowed(reference.Mesh, settings)
  , ByFaces(reference.Mesh.NumberOfFaceSlots(), mesh.NumberOfFaceSlots())
  , Boundaries(reference.Mesh, reference.Cuts)
  , ByBoundaries(this->Boundaries.Count(),
      static_cast<Index>(HalfEdgeMesh::HalfEdge(mesh.NumberOfFaceSlots(), 0)))
  , NearestBoundary(static_cast<std::size_t>(mesh.NumberOfVertexSlots()), None)
  , Nearest(reference.NearTriangle)
  , Witnesses(this->Nearest.size(), { None, None, None, None })
{
}

ErrorBound::~ErrorBound() = default;

//------------------------------------------------------------------------------
std::vector<float> ErrorBound::LimitsOfVertices() const
{
  std::vector<float> limits;
  for (VertexId v = 0; v < this->Source.NumberOfVertexSlots(); ++v)
  {
    limits.push_back(static_cast<float>(this->LimitAt(v)));
  }
  return limits;
}

//------------------------------------------------------------------------------
std::shared_ptr<Prover> ErrorBound::BorrowProver() const
{
  return this->Provers.Borrow([this] { return std::make_unique<Prover>(*this); });
}

//------------------------------------------------------------------------------
std::shared_ptr<EditFilter::Pending> ErrorBound::MakePending()
{
  this->BuildCoverage();
  return std::make_shared<EditProof>();
}

//------------------------------------------------------------------------------
/// The first worker builds it, as in IntersectionGuard.
void ErrorBound::BuildCoverage()
{
  const std::lock_guard<std::mutex> lock(this->Building);
  if (this->ByFaces.IsEmpty())
  {
    const Index faces = this->Source.NumberOfFaceSlots();
    this->ByFaces = Coverage(faces, faces);
    for (Index face = 0; face < faces; ++face)
    {
      this->ByFaces.Add(face, face);
    }
  }
  if (this->Witnesses.empty())
  {
    this->Witnesses.assign(this->Nearest.size(), { None, None, None, None });
    const Index edges = this->Boundaries.Count();
    this->ByBoundaries = Coverage(edges,
      edges == 0 ? 0
                 : static_cast<Index>(HalfEdgeMesh::HalfEdge(this->Source.NumberOfFaceSlots(), 0)));
    for (Index edge = 0; edge < edges; ++edge)
    {
      this->ByBoundaries.Add(edge, this->Boundaries.HalfEdge(edge));
    }
  }
}

//------------------------------------------------------------------------------
void ErrorBound::Adopt(VertexId made, VertexId like)
{
  this->BuildCoverage();
  this->Nearest[made] = this->Nearest[like];
  if (!this->NearestBoundary.empty()) // as it is if the original has no boundary
  {
    this->NearestBoundary[made] = this->NearestBoundary[like];
  }
  this->Witnesses[made] = this->Witnesses[like];
}

//------------------------------------------------------------------------------
Decision ErrorBound::Check(
  const HalfEdgeMesh& mesh, const SurfaceChange& change, EditFilter::Pending& pending) const
{
  return this->BorrowProver()->Prove(mesh, change, static_cast<EditProof&>(pending));
}

//------------------------------------------------------------------------------
bool ErrorBound::StillAccepts(
  const HalfEdgeMesh&, const SurfaceChange&, EditFilter::Pending& pending) const
{
  const EditProof& proof = static_cast<const EditProof&>(pending);
  return IsAsProved(this->ByFaces, proof.Items) &&
    IsAsProved(this->ByBoundaries, proof.BoundaryItems);
}

//------------------------------------------------------------------------------
void ErrorBound::Commit(
  const HalfEdgeMesh&, const SurfaceChange& change, EditFilter::Pending& pending, Tally&)
{
  EditProof& proof = static_cast<EditProof&>(pending);
  if (change.Moved != None)
  {
    this->Nearest[change.Moved] = proof.Nearest;
  }
  proof.NewElements.clear();
  for (const SurfaceChange::Face& face : change.NewFaces)
  {
    proof.NewElements.push_back(face.Id);
  }
  Replace(this->ByFaces, change.OldFaces, proof.Items, proof.NewElements);
  if (!change.NewBoundary.empty() && !change.BoundaryStays && change.Moved != None)
  {
    this->NearestBoundary[change.Moved] = proof.NearestBoundary;
  }
  proof.NewElements.clear();
  for (const SurfaceChange::BoundaryEdge& edge : change.NewBoundary)
  {
    proof.NewElements.push_back(edge.Id);
  }
  Replace(this->ByBoundaries, change.OldBoundary, proof.BoundaryItems, proof.NewElements);
}
}
