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

  /// @param recordDistances Whether Merge looks every new vertex up; otherwise errors stay 0.
  Original(const CleanSurface& clean, bool recordDistances);

  /// Two vertices became one; the new one is looked up if that is wished, unless it stayed where
  /// `keep` was.
  void Merge(Index keep, Index gone, const Vector3& position, bool keepStays);

  /// The vertex was moved. Different vertices may be moved at the same time.
  void Move(Index vertex) { this->Known[vertex].Moved = true; }

  /// Looks the vertex up where it is now, if errors are recorded and it has moved.
  void LookUp(Index vertex, const Vector3& position);

  /// The vertex of the current mesh that the vertex has been merged into, over however many collapses.
  Index CurrentVertex(Index vertex);

  const Knowledge& Of(Index vertex) const { return this->Known[vertex]; }
  bool RecordsDistances() const { return this->Records; }
  double LargestError() const { return this->Largest; } ///< mm, the thesis's maxError.
  const BoundingTree& Tree() const { return this->Triangles; }

private:
  BoundingTree Triangles;
  std::vector<Knowledge> Known;
  std::vector<Index> MergedInto; // itself while it lives
  double Largest = 0.0;          // mm
  bool Records;
};
}

#endif
