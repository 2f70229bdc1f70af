// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "EditWorkspace.h"

namespace bonedecimate
{
Fan& FanStorage::Reserve(int faces)
{
  constexpr std::size_t numberOfArrays = 9;
  constexpr std::size_t spare = 8; // kernels read and write whole lanes
  this->Arrays.Faces = faces;
  if (this->Masks.size() < static_cast<std::size_t>(faces) + spare)
  {
    const std::size_t size = 2 * (static_cast<std::size_t>(faces) + spare);
    this->Numbers.assign(numberOfArrays * size, 0.0);
    this->Masks.assign(size, 0);
    this->Arrays.AtEnd = this->Masks.data();
    for (std::size_t k = 0; k < 3; ++k)
    {
      this->Arrays.Ring[k] = this->Numbers.data() + k * size;
      this->Arrays.OldArea[k] = this->Numbers.data() + (3 + k) * size;
      this->Arrays.NewArea[k] = this->Numbers.data() + (6 + k) * size;
    }
  }
  return this->Arrays;
}
}
