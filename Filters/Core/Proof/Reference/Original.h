// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Original.h
 * @brief The original of a run: the surface, the meshes that the result is compared with, and the
 * relation of both to the vertices of the current mesh.
 */
#ifndef BoneDecimate_Core_Proof_Reference_Original_h
#define BoneDecimate_Core_Proof_Reference_Original_h

#include "Base/LargeArray.h"
#include "Geometry/BoundingTree.h"
#include "Mesh/Cleaning.h"
#include "Mesh/HalfEdgeMesh.h"
#include "ReferenceMesh.h"

#include <memory>
#include <mutex>
#include <optional>
#include <vector>

namespace bonedecimate
{
class Original
{
public:
  /**
   * @param clean Must outlive this.
   * @param recordDistances Whether Merge measures the distance of each new vertex;
   * otherwise there are no errors.
   * @param reference The original, if the surface is itself a result. Null: the surface.
   */
  Original(
    const CleanSurface& clean, bool recordDistances, const ReferenceMesh* reference = nullptr);
  Original(CleanSurface&&, bool) = delete;

  /// Records that two vertices became one. Measures its distance if distances are recorded and it
  /// has moved.
  void Merge(VertexId keep, VertexId gone, const Vector3& position);

  /// Takes back the last merge into the other vertex; not where distances are recorded.
  void Unmerge(VertexId gone) { this->MergedInto[static_cast<std::size_t>(gone)] = gone; }

  /// To be called before the first split: from then on ids of removed vertices may be reused, each
  /// for one vertex.
  void BeginSplits();
  /// Records that the split of an edge with those ends made a vertex. Measures its distance if
  /// distances are recorded.
  void Make(VertexId made, VertexId start, VertexId end, const Vector3& position);

  /// Keeps the mesh before it is smoothed, and measures the distances to these positions if
  /// distances are recorded.
  void KeepUnsmoothed(const HalfEdgeMesh& mesh, const std::vector<Vector3>& positions);
  /// Keeps the mesh before its first edit, smoothed or not; not where there is a reference.
  void KeepInitial(const HalfEdgeMesh& mesh);

  /// Null: the surface is the original.
  const ReferenceMesh* Reference() const { return this->Continued; }
  bool IsSmoothed() const { return this->Unsmoothed != nullptr; }
  /// What the result is to be like: the mesh before the first edit, smoothed, or the reference;
  /// only where it is kept.
  const HalfEdgeMesh& InitialMesh() const
  {
    return this->Continued != nullptr ? this->Continued->Mesh : *this->Initial;
  }
  /// The mesh that the error bound refers to: the one before the first edit, not smoothed, or the
  /// reference; only where it is kept.
  const HalfEdgeMesh& BoundedMesh() const
  {
    return this->Unsmoothed ? *this->Unsmoothed : this->InitialMesh();
  }
  /// Bounding tree of BoundedMesh().
  const BoundingTree& BoundedTree(int threads = 1) const
  {
    return this->Continued != nullptr ? this->Continued->Tree : this->Tree(threads);
  }
  /// For each vertex of InitialMesh(), the vertex into which it was merged, or one near it.
  std::vector<Index> CurrentOfInitial() const;
  /// For each vertex of the mesh, a triangle of InitialMesh() near it; null if both have the same
  /// vertices.
  const std::vector<Index>* NearInitial() const
  {
    return this->Continued != nullptr ? &this->Continued->NearTriangle : nullptr;
  }

  /// Whether the position differs from that of the input point in any bit.
  bool HasMoved(VertexId vertex, const Vector3& position) const
  {
    return position != this->Clean.Surface.Points[static_cast<std::size_t>(vertex)];
  }

  const CleanSurface& AtFirst() const { return this->Clean; }

  /// For each original vertex, the current vertex into which it was merged, directly or not.
  std::vector<Index> CurrentVertices() const;

  bool RecordsDistances() const { return !this->Errors.empty(); }
  /// mm, the largest distance recorded along the collapses into the vertex;
  /// only where distances are recorded.
  double RunningError(VertexId vertex) const
  {
    return this->Errors[static_cast<std::size_t>(vertex)];
  }
  double MaxError() const { return this->Largest; } ///< mm; maxError of the thesis.

  /// For each point of the original surface, a triangle at it.
  std::vector<Index> TrianglesAtPoints() const;

  /// Builds the tree on the first call, with that many threads. Thread-safe.
  const BoundingTree& Tree(int threads = 1, const std::function<void()>& afterStep = {}) const;

private:
  void LookUp(VertexId vertex, const Vector3& position);

  const CleanSurface& Clean;
  const ReferenceMesh* Continued;
  std::unique_ptr<const HalfEdgeMesh> Initial;
  std::unique_ptr<const HalfEdgeMesh> Unsmoothed; // null: it is not smoothed
  mutable std::once_flag TreeIsBuilt;
  mutable std::optional<BoundingTree> Triangles;
  // for each vertex the one into which it was merged before the first split; empty: none yet
  std::vector<Index> AtSplits;
  LargeArray<Index> MergedInto; // since then; the vertex itself while it exists
  std::vector<Index> Nearest;   // for each vertex, if distances are recorded
  std::vector<double> Errors;   // mm, for each vertex, if distances are recorded
  double Largest = 0.0;         // mm
};
}

#endif
