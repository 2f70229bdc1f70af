// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BorderProof.h"

#include "Geometry/TriangleGeometry.h"

namespace bonedecimate
{
double BorderProof::SquaredReach(const Segment& segment, const Vector3& p)
{
  const double t = NearestFraction(p, segment[0], segment[1]);
  return (segment[0] + t * (segment[1] - segment[0]) - p).squaredNorm();
}

//------------------------------------------------------------------------------
std::size_t BorderProof::SharedBy(const Segment& piece, double limit) const
{
  std::size_t i = 0;
  while (i < this->Candidates.size() &&
    (SquaredReach(this->Candidates[i], piece[0]) > limit * limit ||
      SquaredReach(this->Candidates[i], piece[1]) > limit * limit))
  {
    ++i;
  }
  return i;
}
}
