// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ShapeCollapse.h"

#include "Decimate/Placement/Freedom.h"
#include "FaceShape.h"

#include <algorithm>

namespace bonedecimate
{
bool ShapeCollapse::Try(HalfEdgeId edge)
{
  const HalfEdgeMesh& mesh = this->MeshEditor.Mesh();
  if (mesh.IsConstrained(mesh.Origin(edge)) || mesh.IsConstrained(mesh.Target(edge)) ||
    !this->MeshEditor.Gather(edge, this->Workspace).IsAccepted())
  {
    return false;
  }
  const EdgeNeighborhood& around = this->Workspace.Neighborhood;
  this->MaxNewCosine = std::max(this->CosineBefore(around) - MinGainOfCosine, this->MaxCosine);
  this->Ring.Gather(mesh, around);
  this->Proposed.Edge = edge;
  this->Candidates.clear();
  this->AddCandidates(around);
  std::stable_sort(this->Candidates.begin(), this->Candidates.end(),
    [](const Candidate& a, const Candidate& b) { return a.Cosine < b.Cosine; });
  for (const Candidate& candidate : this->Candidates)
  {
    if (this->MeshEditor.Try(candidate.Proposed, this->Workspace).IsAccepted())
    {
      this->MeshEditor.Settle(&this->Workspace.Counts);
      return true;
    }
  }
  this->MeshEditor.Settle(&this->Workspace.Counts);
  return false;
}

//------------------------------------------------------------------------------
double ShapeCollapse::CosineBefore(const EdgeNeighborhood& around) const
{
  double cosine = 0.0;
  const auto take = [&](FaceId face)
  { cosine = std::max(cosine, CosineOfFace(this->MeshEditor.Mesh(), face)); };
  for (Index i = 0; i < around.NumberOfRemovedFaces; ++i)
  {
    take(around.RemovedFaces[static_cast<std::size_t>(i)]);
  }
  for (const Index corner : around.Corners)
  {
    take(HalfEdgeMesh::Face(corner));
  }
  return cosine;
}

//------------------------------------------------------------------------------
void ShapeCollapse::AddCandidates(const EdgeNeighborhood& around)
{
  const HalfEdgeMesh& mesh = this->MeshEditor.Mesh();
  const Vector3 start = mesh.Position(around.Start);
  const Vector3 end = mesh.Position(around.End);
  const Freedom freedom =
    FreedomOf(mesh.Constraint(around.Start), mesh.Constraint(around.End), around.IsBoundaryEdge());
  if (freedom == Freedom::Nowhere)
  {
    return;
  }
  if (freedom != Freedom::Second)
  {
    this->Add(start, around.Start, true);
  }
  if (freedom != Freedom::First)
  {
    this->Add(end, around.End, true);
  }
  if (freedom == Freedom::Space || freedom == Freedom::Edge)
  {
    this->Add(0.5 * (start + end), around.Start, false);
  }
  if (freedom == Freedom::Space)
  {
    this->AddSearched(start, end);
  }
}

//------------------------------------------------------------------------------
void ShapeCollapse::AddSearched(const Vector3& start, const Vector3& end)
{
  Vector3 from = start;
  double least = this->Ring.CosineAt(start);
  for (const Vector3& position : { end, Vector3(0.5 * (start + end)) })
  {
    const double cosine = this->Ring.CosineAt(position, least);
    from = cosine < least ? position : from;
    least = std::min(least, cosine);
  }
  double cosine = least;
  const Vector3 found = this->Ring.Search(from, this->Enough, cosine);
  if (cosine < least)
  {
    const BoundingTree& tree = this->MeshEditor.Original().BoundedTree();
    const auto onOriginal = [&tree](const Vector3& p)
    { return tree.FindNearest(p).Point.Position; };
    const VertexId keep = this->Workspace.Neighborhood.Start;
    const Vector3 nearest = onOriginal(found);
    const Vector3 offset = 0.5 * (start - onOriginal(start) + end - onOriginal(end));
    this->Add(nearest + offset, keep, false);
    this->Add(nearest, keep, false);
    this->Add(found, keep, false);
  }
}

//------------------------------------------------------------------------------
void ShapeCollapse::Add(const Vector3& position, VertexId keep, bool stays)
{
  const double cosine = this->Ring.CosineAt(position, this->MaxNewCosine);
  if (cosine <= this->MaxNewCosine)
  {
    this->Proposed.Keep = keep;
    this->Proposed.Position = position;
    this->Proposed.KeepStays = stays;
    this->Candidates.push_back({ cosine, this->Proposed });
  }
}
}
