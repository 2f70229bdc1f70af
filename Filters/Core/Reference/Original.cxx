// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Original.h"

#include <algorithm>
#include <cmath>

namespace bonedecimate
{
Original::Original(const CleanSurface& clean, bool recordDistances)
  : Source(clean.Surface)
  , Known(clean.Surface.Points.size())
  , Records(recordDistances)
{
  if (this->Records)
  {
    this->Tree();
  }
  for (std::size_t v = 0; v < this->Known.size(); ++v)
  {
    this->Known[v].PointCount = clean.InputPointCount[v];
  }
  for (std::size_t t = clean.Surface.Triangles.size(); t-- > 0;)
  {
    for (const Index corner : clean.Surface.Triangles[t])
    {
      this->Known[corner].NearestTriangle = static_cast<Index>(t);
    }
  }
}

const BoundingTree& Original::Tree(int threads) const
{
  std::call_once(this->TreeIsBuilt, [&] { this->Triangles.emplace(this->Source, threads); });
  return *this->Triangles;
}

//------------------------------------------------------------------------------
void Original::Merge(Index keep, Index gone, const Vector3& position, bool keepStays)
{
  Knowledge& kept = this->Known[keep];
  const Knowledge& lost = this->Known[gone];
  kept.PointCount += lost.PointCount;
  kept.RunningError = std::max(kept.RunningError, lost.RunningError);
  if (keepStays)
  {
    return; // its distance was recorded when it came there
  }
  kept.Moved = true;
  if (!this->Records)
  {
    return;
  }
  const BoundingTree::Nearest nearest = this->Tree().FindNearest(position, kept.NearestTriangle);
  const double distance = std::sqrt(nearest.Place.SquaredDistance);
  kept.NearestTriangle = nearest.Triangle;
  kept.RunningError = std::max(kept.RunningError, distance);
  this->Largest = std::max(this->Largest, distance);
}
}
