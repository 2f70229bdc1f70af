// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ShapeLimits.h"

#include "SizingField.h"

#include <algorithm>

namespace bonedecimate
{
double ShapeLimits::LengthOf(const Vector3& a, const Vector3& b) const
{
  return this->Local
    ? std::min({ this->EdgeLength, this->Local->At(a).Length, this->Local->At(b).Length })
    : this->EdgeLength;
}

//------------------------------------------------------------------------------
double ShapeLimits::MinOfLongest() const
{
  return this->Local ? Longest * this->Local->Least() : this->LongestEdge();
}
}
