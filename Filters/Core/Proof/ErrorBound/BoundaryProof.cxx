// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BoundaryProof.h"

#include "Geometry/TriangleGeometry.h"

namespace bonedecimate
{
double BoundaryProof::SquaredDistance(const Segment& segment, const Vector3& p)
{
  const double t = NearestFraction(p, segment[0], segment[1]);
  return (segment[0] + t * (segment[1] - segment[0]) - p).squaredNorm();
}

//------------------------------------------------------------------------------
std::size_t BoundaryProof::FindCommon(const Piece& piece) const
{
  const auto isNear = [&piece](const Segment& candidate, std::size_t end)
  { return SquaredDistance(candidate, piece.Ends[end]) <= piece.Limits[end] * piece.Limits[end]; };
  std::size_t i = 0;
  while (i < this->Candidates.size() &&
    !(isNear(this->Candidates[i], 0) && isNear(this->Candidates[i], 1)))
  {
    ++i;
  }
  return i;
}
}
