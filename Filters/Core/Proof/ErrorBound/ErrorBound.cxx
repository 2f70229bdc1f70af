// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ErrorBound.h"

#include "Prover.h"

#include <algorithm>

namespace bonedecimate
{
namespace
{
bool IsAsProved(const Coverage& coverage, const std::vector<CoveredElement>& elements)
{
  return std::all_of(elements.begin(), elements.end(),
    [&](const CoveredElement& covered)
    { return coverage.VersionOf(covered.Id) == covered.Version; });
}

/// @param gone Covering elements that the new ones replace.
void Replace(Coverage& coverage, const std::vector<Index>& gone,
  const std::vector<CoveredElement>& elements, const std::vector<Index>& newElements)
{
  for (const Index covering : gone)
  {
    coverage.Forget(covering);
  }
  for (const CoveredElement& covered : elements)
  {
    for (int slot = 0; slot < Coverage::SlotsPerElement; ++slot)
    {
      if ((covered.ReplacedSlots >> slot & 1) != 0)
      {
        coverage.Free(covered.Id, slot);
      }
    }
    for (std::size_t i = 0; i < newElements.size(); ++i)
    {
      if ((covered.ProvedBy >> i & 1) != 0)
      {
        coverage.Add(covered.Id, newElements[i]);
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
  const HalfEdgeMesh& original, const BoundingTree& tree, const ErrorBoundSettings& settings)
  : OriginalMesh(original)
  , OriginalTree(tree)
  , Settings(settings)
  , OriginalLimits(original, settings)
  , Boundaries(original)
  , NearBoundaryEdges(this->Boundaries.EdgesAtVertices())
  , NearTriangles(static_cast<std::size_t>(original.NumberOfVertexSlots()), None)
{
  for (FaceId face = 0; face < original.NumberOfFaceSlots(); ++face)
  {
    for (const VertexId v : original.Corners(face))
    {
      const Index known = this->NearTriangles[v];
      const bool allowsMore = known == None ||
        this->OriginalLimits.OfTriangle(face) >= this->OriginalLimits.OfTriangle(known);
      this->NearTriangles[v] = allowsMore ? static_cast<Index>(face) : known;
    }
  }
}

ErrorBound::ErrorBound(
  const ReferenceMesh& reference, const HalfEdgeMesh& mesh, const ErrorBoundSettings& settings)
  : OriginalMesh(reference.Mesh)
  , OriginalTree(reference.Tree)
  , OriginalCuts(reference.Cuts)
  , Settings(settings)
  , OriginalLimits(reference.Mesh, settings)
  , FaceCoverage(reference.Mesh.NumberOfFaceSlots(), mesh.NumberOfFaceSlots())
  , Boundaries(reference.Mesh, reference.Cuts)
  , BoundaryCoverage(this->Boundaries.Count(),
      static_cast<Index>(HalfEdgeMesh::HalfEdge(mesh.NumberOfFaceSlots(), 0)))
  , NearBoundaryEdges(static_cast<std::size_t>(mesh.NumberOfVertexSlots()), None)
  , NearTriangles(reference.NearTriangle)
  , Witnesses(this->NearTriangles.size(), { None, None, None, None })
{
}

ErrorBound::~ErrorBound() = default;

//------------------------------------------------------------------------------
std::vector<float> ErrorBound::LimitsOfVertices() const
{
  std::vector<float> limits;
  for (VertexId v = 0; v < this->OriginalMesh.NumberOfVertexSlots(); ++v)
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
/// The first worker builds the coverages.
void ErrorBound::BuildCoverage()
{
  const std::lock_guard<std::mutex> lock(this->BuildMutex);
  if (this->FaceCoverage.IsEmpty())
  {
    const Index faces = this->OriginalMesh.NumberOfFaceSlots();
    this->FaceCoverage = Coverage(faces, faces);
    for (Index face = 0; face < faces; ++face)
    {
      this->FaceCoverage.Add(face, face);
    }
  }
  if (this->Witnesses.empty())
  {
    this->Witnesses.assign(this->NearTriangles.size(), { None, None, None, None });
    const Index edges = this->Boundaries.Count();
    this->BoundaryCoverage = Coverage(edges,
      edges == 0
        ? 0
        : static_cast<Index>(HalfEdgeMesh::HalfEdge(this->OriginalMesh.NumberOfFaceSlots(), 0)));
    for (Index edge = 0; edge < edges; ++edge)
    {
      this->BoundaryCoverage.Add(edge, this->Boundaries.HalfEdge(edge));
    }
  }
}

//------------------------------------------------------------------------------
void ErrorBound::Adopt(VertexId made, VertexId like)
{
  this->BuildCoverage();
  this->NearTriangles[made] = this->NearTriangles[like];
  if (!this->NearBoundaryEdges.empty()) // empty: the original has no boundary
  {
    this->NearBoundaryEdges[made] = this->NearBoundaryEdges[like];
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
  return IsAsProved(this->FaceCoverage, proof.CoveredTriangles) &&
    IsAsProved(this->BoundaryCoverage, proof.CoveredEdges);
}

//------------------------------------------------------------------------------
void ErrorBound::Commit(
  const HalfEdgeMesh&, const SurfaceChange& change, EditFilter::Pending& pending, Tally&)
{
  EditProof& proof = static_cast<EditProof&>(pending);
  if (change.MovedVertex != None)
  {
    this->NearTriangles[change.MovedVertex] = proof.NearTriangle;
  }
  proof.NewElements.clear();
  for (const SurfaceChange::Face& face : change.NewFaces)
  {
    proof.NewElements.push_back(face.Id);
  }
  Replace(this->FaceCoverage, change.OldFaces, proof.CoveredTriangles, proof.NewElements);
  if (!change.NewBoundary.empty() && !change.BoundaryStays && change.MovedVertex != None)
  {
    this->NearBoundaryEdges[change.MovedVertex] = proof.NearBoundaryEdge;
  }
  proof.NewElements.clear();
  for (const SurfaceChange::BoundaryEdge& edge : change.NewBoundary)
  {
    proof.NewElements.push_back(edge.Id);
  }
  Replace(this->BoundaryCoverage, change.OldBoundary, proof.CoveredEdges, proof.NewElements);
}
}
