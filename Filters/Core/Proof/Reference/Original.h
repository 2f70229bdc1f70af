// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Original.h
 * @brief The original of a run: the surface, the meshes that the result is compared with, and their
 * relation to the vertices of the current mesh.
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
   * @param clean Must outlive this object.
   * @param recordDistances Whether Merge measures the distance of each new vertex; otherwise there
   *   are no errors.
   * @param reference The original, if the surface is itself a result. Null: the surface.
   */
  Original(
    const CleanSurface& clean, bool recordDistances, const ReferenceMesh* reference = nullptr);
  Original(CleanSurface&&, bool) = delete;

  /// Records that two vertices became one. If distances are recorded, measures that of the new
  /// position unless it has not moved.
  void Merge(VertexId keep, VertexId gone, const Vector3& position);

  /// Takes back the last merge of the vertex. Not if distances are recorded.
  void Unmerge(VertexId gone) { this->MergedInto[static_cast<std::size_t>(gone)] = gone; }

  /// To be called before the first split. From then on ids of removed vertices may be reused, each
  /// for one vertex.
  void BeginSplits();
  /// Records the vertex that the split of an edge with these ends made. Measures its distance if
  /// distances are recorded.
  void Make(VertexId made, VertexId start, VertexId end, const Vector3& position);

  /// Copies the mesh before it is smoothed, and measures the distances of these positions if
  /// distances are recorded.
  void KeepUnsmoothed(const HalfEdgeMesh& mesh, const std::vector<Vector3>& positions);
  /// Copies the mesh before its first edit, smoothed or not. Not with a reference.
  void KeepInitial(const HalfEdgeMesh& mesh);

  /// Null: the surface is the original.
  const ReferenceMesh* Reference() const { return this->ReferenceOfRun; }
  bool IsSmoothed() const { return this->UnsmoothedCopy != nullptr; }
  /// The mesh that the result should resemble: the reference, or the mesh before the first edit,
  /// smoothed if the run smooths. Only if there is one of them.
  const HalfEdgeMesh& InitialMesh() const
  {
    return this->ReferenceOfRun != nullptr ? this->ReferenceOfRun->Mesh : *this->InitialCopy;
  }
  /// The mesh that the error bound refers to: the reference, or the mesh before the first edit, not
  /// smoothed. Only if there is one of them.
  const HalfEdgeMesh& BoundedMesh() const
  {
    return this->UnsmoothedCopy ? *this->UnsmoothedCopy : this->InitialMesh();
  }
  /// Bounding tree of BoundedMesh().
  const BoundingTree& BoundedTree(int threads = 1) const
  {
    return this->ReferenceOfRun != nullptr ? this->ReferenceOfRun->Tree : this->Tree(threads);
  }
  /// For each vertex of InitialMesh(), the vertex into which it was merged, or one near it.
  std::vector<Index> CurrentOfInitial() const;
  /// For each vertex of the mesh, a triangle of InitialMesh() near it. Null: both have the same
  /// vertices.
  const std::vector<Index>* NearInitial() const
  {
    return this->ReferenceOfRun != nullptr ? &this->ReferenceOfRun->NearTriangle : nullptr;
  }

  /// Whether the position differs from that of the input point in any bit.
  bool HasMoved(VertexId vertex, const Vector3& position) const
  {
    return position != this->Clean.Surface.Points[static_cast<std::size_t>(vertex)];
  }

  const CleanSurface& CleanInput() const { return this->Clean; }

  /// For each original vertex, the current vertex into which it was merged, directly or not.
  std::vector<Index> CurrentVertices() const;

  bool RecordsDistances() const { return !this->Errors.empty(); }
  /// mm, the largest distance recorded for the vertices that were merged into it; only if distances
  /// are recorded.
  double RunningError(VertexId vertex) const
  {
    return this->Errors[static_cast<std::size_t>(vertex)];
  }
  double MaxError() const { return this->MaxRecorded; } ///< mm; maxError of the thesis.

  /// For each point of the input, one of its triangles.
  std::vector<Index> TrianglesAtPoints() const;

  /// The bounding tree of the input, built on the first call with this number of threads.
  /// Thread-safe.
  const BoundingTree& Tree(int threads = 1, const std::function<void()>& afterStep = {}) const;

private:
  void RecordDistance(VertexId vertex, const Vector3& position);

  const CleanSurface& Clean;
  const ReferenceMesh* ReferenceOfRun;
  std::unique_ptr<const HalfEdgeMesh> InitialCopy;
  std::unique_ptr<const HalfEdgeMesh> UnsmoothedCopy; // null: not smoothed
  mutable std::once_flag TreeIsBuilt;
  mutable std::optional<BoundingTree> InputTree;
  // For each vertex the one into which it was merged before the first split. Empty: no split yet.
  std::vector<Index> MergedBeforeSplits;
  LargeArray<Index> MergedInto; // since the first split; the vertex itself while it exists
  std::vector<Index> Nearest;   // for each vertex, if distances are recorded
  std::vector<double> Errors;   // mm, for each vertex, if distances are recorded
  double MaxRecorded = 0.0;     // mm
};
}

#endif
