// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Original.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace bonedecimate
{
Original::Original(const CleanSurface& clean, bool recordDistances)
  : Triangles(clean.Surface)
  , Known(clean.Surface.Points.size())
  , MergedInto(clean.Surface.Points.size())
  , Records(recordDistances)
{
  std::iota(this->MergedInto.begin(), this->MergedInto.end(), 0);
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

void Original::Merge(Index keep, Index gone, const Vector3& position, bool keepStays)
{
  Knowledge& kept = this->Known[keep];
  const Knowledge& lost = this->Known[gone];
  this->MergedInto[gone] = keep;
  kept.PointCount += lost.PointCount;
  kept.RunningError = std::max(kept.RunningError, lost.RunningError);
  if (keepStays)
  {
    return; // its distance was recorded when it came there
  }
  kept.Moved = true;
  this->LookUp(keep, position);
}

void Original::LookUp(Index vertex, const Vector3& position)
{
  Knowledge& known = this->Known[vertex];
  if (!this->Records || !known.Moved)
  {
    return;
  }
  const BoundingTree::Nearest nearest =
    this->Triangles.FindNearest(position, known.NearestTriangle);
  const double distance = std::sqrt(nearest.Place.SquaredDistance);
  known.NearestTriangle = nearest.Triangle;
  known.RunningError = std::max(known.RunningError, distance);
  this->Largest = std::max(this->Largest, distance);
}

Index Original::CurrentVertex(Index vertex)
{
  Index last = vertex;
  while (this->MergedInto[last] != last)
  {
    last = this->MergedInto[last];
  }
  while (this->MergedInto[vertex] != last) // next time in one step
  {
    const Index next = this->MergedInto[vertex];
    this->MergedInto[vertex] = last;
    vertex = next;
  }
  return last;
}
}
