// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ShapeLoop.h
 * @brief What the loops over faces, edges and vertices that improve shapes have in common.
 */
#ifndef BoneDecimate_Core_Decimate_Stages_ShapeLoop_h
#define BoneDecimate_Core_Decimate_Stages_ShapeLoop_h

#include "Base/Monitor.h"

#include <cstddef>

namespace bonedecimate
{
/// The cosine of 45 degrees. Where angles are smaller, flips and moves make collapses possible.
constexpr double CosineOfRelaxed = 0.7071067811865476;

/// Calls work(i) for each index. False if the monitor requests a stop.
template <typename Work>
bool ForEachOf(std::size_t count, const Monitor& monitor, const Work& work)
{
  constexpr std::size_t indicesPerReport = 64;
  for (std::size_t i = 0; i < count; ++i)
  {
    work(i);
    if (i % indicesPerReport == 0 && !monitor(static_cast<double>(i) / static_cast<double>(count)))
    {
      return false;
    }
  }
  return monitor(1.0);
}
}

#endif
