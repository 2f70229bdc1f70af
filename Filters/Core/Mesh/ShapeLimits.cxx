// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ShapeLimits.h"

#include "SizingField.h"

#include <algorithm>

namespace bonedecimate
{
double ShapeLimits::RequestedLength(const Vector3& a, const Vector3& b) const
{
  return this->Sizing
    ? std::min({ this->EdgeLength, this->Sizing->At(a).Length, this->Sizing->At(b).Length })
    : this->EdgeLength;
}

//------------------------------------------------------------------------------
double ShapeLimits::MinSplitLength() const
{
  return this->Sizing ? SplitRatio * this->Sizing->MinLength() : this->SplitLength();
}
}
