// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Original.h
 * @brief The surface as it came, and what each vertex of the current mesh knows of it.
 */
#ifndef BoneDecimate_Core_Reference_Original_h
#define BoneDecimate_Core_Reference_Original_h

#include "Geometry/BoundingTree.h"
#include "Memory/LargeArray.h"
#include "Mesh/Cleaning.h"

#include <mutex>
#include <optional>
#include <vector>

namespace bonedecimate
{
class Original
{
public:
  /**
   * @param clean Must live as long as this.
   * @param recordDistances Whether Merge looks every new vertex up; otherwise there are no errors to ask for.
   */
  Original(const CleanSurface& clean, bool recordDistances);
  Original(CleanSurface&&, bool) = delete;

  /// Two vertices became one; the new one is looked up if that is wished, and if it has moved.
  void Merge(Index keep, Index gone, const Vector3& position);

  /// Whether the vertex no longer lies where its input point lay, bit for bit.
  bool HasMoved(Index vertex, const Vector3& position) const
  {
    return position != this->Clean.Surface.Points[static_cast<std::size_t>(vertex)];
  }

  const CleanSurface& AtFirst() const { return this->Clean; }

  /// Of every vertex there was: the one it has been merged into, over however many collapses.
  std::vector<Index> CurrentVertices() const;

  bool RecordsDistances() const { return !this->Errors.empty(); }
  /// mm, the largest distance recorded along the collapses into the vertex; only where distances are recorded.
  double RunningError(Index vertex) const { return this->Errors[static_cast<std::size_t>(vertex)]; }
  double LargestError() const { return this->Largest; } ///< mm, the thesis's maxError.

  /// Of every point of the surface as it came: a triangle at it.
  std::vector<Index> TrianglesAtPoints() const;

  /// Built when it is asked for first, with so many threads; may be called by several threads.
  const BoundingTree& Tree(int threads = 1, const std::function<void()>& afterStep = {}) const;

private:
  void LookUp(Index vertex, const Vector3& position);

  const CleanSurface& Clean;
  mutable std::once_flag TreeIsBuilt;
  mutable std::optional<BoundingTree> Triangles;
  LargeArray<Index> MergedInto; // itself while it lives
  std::vector<Index> Nearest;   // of each vertex, where distances are recorded
  std::vector<double> Errors;   // the same, mm
  double Largest = 0.0;         // mm
};
}

#endif
