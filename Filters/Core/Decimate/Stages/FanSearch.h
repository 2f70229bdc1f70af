// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FanSearch.h
 * @brief Finds the face of a closed fan nearest to a point, by walking from a face on while the
 * distance decreases.
 */
#ifndef BoneDecimate_Core_Decimate_Stages_FanSearch_h
#define BoneDecimate_Core_Decimate_Stages_FanSearch_h

#include "Geometry/TriangleFrame.h"

#include <vector>

namespace bonedecimate
{
/// @param frames The faces in order around the vertex, which is corner A of each.  @param slot The
/// face to start at; becomes the nearest one.
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

/// The same, but searches all faces if the walk ends at the vertex, where all faces are equally
/// near, or at an outer edge: a fan need not be convex, so the distance may rise before it falls.
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
