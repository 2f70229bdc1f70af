// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Original.h
 * @brief The surface as it came, and what each vertex of the current mesh knows of it.
 */
#ifndef BoneDecimate_Core_Reference_Original_h
#define BoneDecimate_Core_Reference_Original_h

#include "Geometry/BoundingTree.h"
#include "Mesh/Cleaning.h"

#include <mutex>
#include <optional>
#include <vector>

namespace bonedecimate
{
class Original
{
public:
  struct Knowledge
  {
    Index NearestTriangle = None; ///< Of the cleaned input.
    Index PointCount = 0;         ///< Input points this vertex stands for.
    double RunningError = 0.0; ///< mm, the largest distance recorded along the collapses into it.
    bool Moved = false;        ///< Whether it still lies where its input point lay, bit for bit.
  };

  /**
   * @param clean Its surface must live as long as Tree() may be called for the first time.
   * @param recordDistances Whether Merge looks every new vertex up; otherwise errors stay 0. Builds the tree.
   */
  Original(const CleanSurface& clean, bool recordDistances);

  /// Two vertices became one; the new one is looked up if that is wished, unless it stayed where
  /// `keep` was.
  void Merge(Index keep, Index gone, const Vector3& position, bool keepStays);

  const Knowledge& Of(Index vertex) const { return this->Known[vertex]; }
  bool RecordsDistances() const { return this->Records; }
  double LargestError() const { return this->Largest; } ///< mm, the thesis's maxError.

  /// Built when it is asked for first, with so many threads; may be called by several threads.
  const BoundingTree& Tree(int threads = 1) const;

private:
  const Surface& Source;
  mutable std::once_flag TreeIsBuilt;
  mutable std::optional<BoundingTree> Triangles;
  std::vector<Knowledge> Known;
  double Largest = 0.0; // mm
  bool Records;
};
}

#endif
