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
  this->MostRounding =
    4.0 * std::numeric_limits<double>::epsilon() * (farthest + error) + 0.5 * rounding.GridStep;
}

//------------------------------------------------------------------------------
Vector3 WrittenPositions::Of(VertexId vertex, const Vector3& local) const
{
  if (this->Input == nullptr)
  {
    return local;
  }
  const auto v = static_cast<std::size_t>(vertex);
  const bool hasMoved = local != this->Clean->Surface.Points[v];
  const bool isRounded = hasMoved || this->Rounds.HasGrid();
  return OutputPosition(
    *this->Input, *this->Clean, vertex, local, isRounded ? this->Rounds : PointRounding());
}
}
