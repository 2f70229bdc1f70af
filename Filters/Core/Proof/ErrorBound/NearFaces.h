// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file NearFaces.h
 * @brief Some faces within the limit of an original vertex, the nearest first.
 */
#ifndef BoneDecimate_Core_Proof_ErrorBound_NearFaces_h
#define BoneDecimate_Core_Proof_ErrorBound_NearFaces_h

#include "Geometry/Surface.h"

#include <algorithm>
#include <array>

namespace bonedecimate
{
struct NearFaces
{
  static constexpr int MaxCount = 12;
  std::array<Index, MaxCount> Faces;
  std::array<float, MaxCount> SquaredDistances; // mm^2
  int Count = 0;

  void Insert(Index face, float squaredDistance)
  {
    if (this->Count == MaxCount && squaredDistance >= this->SquaredDistances[MaxCount - 1])
    {
      return;
    }
    std::size_t at =
      static_cast<std::size_t>(this->Count < MaxCount ? this->Count++ : MaxCount - 1);
    for (; at > 0 && this->SquaredDistances[at - 1] > squaredDistance; --at)
    {
      this->SquaredDistances[at] = this->SquaredDistances[at - 1];
      this->Faces[at] = this->Faces[at - 1];
    }
    this->SquaredDistances[at] = squaredDistance;
    this->Faces[at] = face;
  }

  /// The position of the face; None if it is not there.
  int Find(Index face) const
  {
    const auto end = this->Faces.begin() + this->Count;
    const auto found = std::find(this->Faces.begin(), end, face);
    return found == end ? None : static_cast<int>(found - this->Faces.begin());
  }
};
}

#endif
