// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Original.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace bonedecimate
{
Original::Original(const CleanSurface& clean, bool recordDistances, const ReferenceMesh* reference)
  : Clean(clean)
  , ReferenceOfRun(reference)
  , MergedInto(clean.Surface.Points.size())
{
  std::iota(this->MergedInto.begin(), this->MergedInto.end(), 0);
  if (recordDistances)
  {
    this->Nearest = this->TrianglesAtPoints();
    this->Errors.assign(clean.Surface.Points.size(), 0.0);
  }
}

//------------------------------------------------------------------------------
const BoundingTree& Original::Tree(int threads, const std::function<void()>& afterStep) const
{
  std::call_once(
    this->TreeIsBuilt, [&] { this->InputTree.emplace(this->Clean.Surface, threads, afterStep); });
  return *this->InputTree;
}

//------------------------------------------------------------------------------
std::vector<Index> Original::TrianglesAtPoints() const
{
  std::vector<Index> triangles(this->Clean.Surface.Points.size(), None);
  for (std::size_t t = this->Clean.Surface.Triangles.size(); t-- > 0;)
  {
    for (const Index corner : this->Clean.Surface.Triangles[t])
    {
      triangles[static_cast<std::size_t>(corner)] = static_cast<Index>(t);
    }
  }
  return triangles;
}

//------------------------------------------------------------------------------
void Original::Merge(VertexId keep, VertexId gone, const Vector3& position)
{
  this->MergedInto[static_cast<std::size_t>(gone)] = keep;
  if (this->RecordsDistances())
  {
    double& error = this->Errors[static_cast<std::size_t>(keep)];
    error = std::max(error, this->Errors[static_cast<std::size_t>(gone)]);
    this->RecordDistance(keep, position);
  }
}

//------------------------------------------------------------------------------
void Original::BeginSplits()
{
  this->MergedBeforeSplits = this->CurrentVertices();
  std::iota(this->MergedInto.begin(), this->MergedInto.end(), 0);
}

//------------------------------------------------------------------------------
void Original::Make(VertexId made, VertexId start, VertexId end, const Vector3& position)
{
  if (this->RecordsDistances())
  {
    this->Errors[made] = std::max(this->Errors[start], this->Errors[end]);
    this->Nearest[made] = this->Nearest[start];
    this->RecordDistance(made, position);
  }
}

//------------------------------------------------------------------------------
void Original::KeepUnsmoothed(const HalfEdgeMesh& mesh, const std::vector<Vector3>& positions)
{
  this->UnsmoothedCopy = std::make_unique<HalfEdgeMesh>(mesh);
  for (std::size_t v = 0; this->RecordsDistances() && v < positions.size(); ++v)
  {
    this->RecordDistance(static_cast<Index>(v), positions[v]);
  }
}

//------------------------------------------------------------------------------
void Original::KeepInitial(const HalfEdgeMesh& mesh)
{
  this->InitialCopy = std::make_unique<HalfEdgeMesh>(mesh);
}

//------------------------------------------------------------------------------
void Original::RecordDistance(VertexId vertex, const Vector3& position)
{
  if (!this->HasMoved(vertex, position))
  {
    return;
  }
  Index& triangle = this->Nearest[static_cast<std::size_t>(vertex)];
  double& error = this->Errors[static_cast<std::size_t>(vertex)];
  const BoundingTree::Nearest nearest = this->Tree().FindNearest(position, triangle);
  const double distance = std::sqrt(nearest.Point.SquaredDistance);
  triangle = nearest.Triangle;
  error = std::max(error, distance);
  this->MaxRecorded = std::max(this->MaxRecorded, distance);
}

//------------------------------------------------------------------------------
std::vector<Index> Original::CurrentVertices() const
{
  std::vector<Index> current(this->MergedInto.begin(), this->MergedInto.end());
  for (std::size_t v = 0; v < current.size(); ++v)
  {
    Index last = static_cast<Index>(v);
    while (current[static_cast<std::size_t>(last)] != last)
    {
      Index& next = current[static_cast<std::size_t>(last)];
      next = current[static_cast<std::size_t>(next)]; // path halving
      last = next;
    }
    current[v] = last;
  }
  if (this->MergedBeforeSplits.empty())
  {
    return current;
  }
  std::vector<Index> all(this->MergedBeforeSplits.size());
  std::transform(this->MergedBeforeSplits.begin(), this->MergedBeforeSplits.end(), all.begin(),
    [&current](Index v) { return current[static_cast<std::size_t>(v)]; });
  return all;
}

//------------------------------------------------------------------------------
std::vector<Index> Original::CurrentOfInitial() const
{
  std::vector<Index> current = this->CurrentVertices();
  if (this->ReferenceOfRun == nullptr)
  {
    return current;
  }
  std::vector<Index> ofReference = this->ReferenceOfRun->NearVertex;
  for (Index& vertex : ofReference)
  {
    vertex = current[vertex];
  }
  return ofReference;
}
}
