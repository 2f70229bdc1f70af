// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FanSearch.h
 * @brief The face of a closed fan that is nearest to a point, searched from a face on while the
 * distance falls.
 */
#ifndef BoneDecimate_Core_Decimate_Stages_FanSearch_h
#define BoneDecimate_Core_Decimate_Stages_FanSearch_h

#include "Geometry/TriangleFrame.h"

#include <vector>

namespace bonedecimate
{
/// @param frames The faces in order around the vertex, which is corner A of each.
/// @param slot Where to start; returns the face.
inline TriangleFrame::Point FindInFan(
  const std::vector<TriangleFrame>& frames, const Vector3& p, std::size_t& slot)
{
  constexpr int towardsPrevious = 4; // the weight of C is zero
  constexpr int towardsNext = 2;     // that of B is
  const std::size_t count = frames.size();
  TriangleFrame::Point best = frames[slot].Nearest(p);
  for (const int side : { towardsPrevious, towardsNext })
  {
    const std::size_t step = side == towardsPrevious ? count - 1 : 1;
    for (std::size_t tries = 1; (best.Clamped & side) != 0 && tries < count; ++tries)
    {
      const std::size_t next = (slot + step) % count;
      const TriangleFrame::Point position = frames[next].Nearest(p);
      if (!(position.SquaredDistance < best.SquaredDistance))
      {
        break;
      }
      best = position;
      slot = next;
    }
  }
  return best;
}

/// The same, and among all faces where that ends at the vertex, at which all faces are equally
/// near, or at the outer edge of a face: a fan need not be convex, so the distance may rise from
/// face to face before it falls.
inline TriangleFrame::Point FindInWholeFan(
  const std::vector<TriangleFrame>& frames, const Vector3& p, std::size_t& slot)
{
  constexpr int onOuterEdge = 1; // the weight of A is zero
  constexpr int atVertex = 6;    // those of B and C are
  TriangleFrame::Point best = FindInFan(frames, p, slot);
  if ((best.Clamped & onOuterEdge) == 0 && (best.Clamped & atVertex) != atVertex)
  {
    return best;
  }
  for (std::size_t i = 0; i < frames.size(); ++i)
  {
    const TriangleFrame::Point point = frames[i].Nearest(p);
    if (point.SquaredDistance < best.SquaredDistance)
    {
      best = point;
      slot = i;
    }
  }
  return best;
}
}

#endif
