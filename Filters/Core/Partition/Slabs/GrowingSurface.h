// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file GrowingSurface.h
 * @brief The result of a run in slabs so far: what is finished, and what later runs may change.
 *
 *     Take       moves what reaches into a zone out of it, as a surface of its own
 *     PutBack    the changed strip and what was added to it; its points that stayed
 *                are found by their coordinates
 *     Finish     what is below a position is no longer searched
 */
#ifndef BoneDecimate_Core_Partition_Slabs_GrowingSurface_h
#define BoneDecimate_Core_Partition_Slabs_GrowingSurface_h

#include "SurfacePiece.h"

#include <vector>

namespace bonedecimate
{
class GrowingSurface
{
public:
  struct Strip
  {
    SurfacePiece Piece;
    std::vector<Index> Points; ///< The point of the whole for each point.
  };
  Strip Take(const Zone& zone);
  void PutBack(const Strip& taken, const SurfacePiece& changed);
  void Finish(const Zone& above);

  /// All of it; nothing is left here.
  SurfacePiece Release();

private:
  void Add(const SurfacePiece& piece, const std::vector<Index>& points);

  std::vector<Vector3> Points;
  SurfacePiece Finished, Open; // triangles alone
};
}

#endif
