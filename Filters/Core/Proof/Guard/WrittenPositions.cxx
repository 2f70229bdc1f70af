// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "WrittenPositions.h"

#include "Mesh/SurfaceAssembly.h"

#include <algorithm>
#include <limits>

namespace bonedecimate
{
WrittenPositions::WrittenPositions(
  const Surface& input, const CleanSurface& clean, double error, const PointRounding& rounding)
  : Input(&input)
  , Clean(&clean)
  , Rounds(rounding)
{
  double farthest = clean.Origin.cwiseAbs().maxCoeff();
  for (const Vector3& p : clean.Surface.Points)
  {
    farthest = std::max(farthest, p.maxCoeff()); // none is negative
  }
  // Local and written coordinates, and those between, are not larger than twice that.
  const double ofSingle = rounding.ToSingle ? std::numeric_limits<float>::epsilon() : 0.0;
  this->MaxRounding =
    (4.0 * std::numeric_limits<double>::epsilon() + ofSingle) * (farthest + error) +
    0.5 * rounding.GridStep;
}

//------------------------------------------------------------------------------
Vector3 WrittenPositions::Of(VertexId vertex, const Vector3& local) const
{
  if (this->Input == nullptr)
  {
    return local;
  }
  return OutputPosition(*this->Input, *this->Clean, vertex, local, this->Rounds);
}
}
