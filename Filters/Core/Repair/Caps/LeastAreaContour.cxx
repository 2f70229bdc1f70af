// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "LeastAreaContour.h"

#include <utility>

namespace bonedecimate
{
namespace
{
/// mm^2, the area and a small term for the perimeter; infinite if the three points lie nearly on a
/// line.
double CostOf(const Vector3& a, const Vector3& b, const Vector3& c)
{
  constexpr double flat = 1e-6;      // of the squared perimeter
  constexpr double roundness = 1e-4; // of the squared perimeter
  const double perimeter = (b - a).norm() + (c - b).norm() + (a - c).norm();
  const double area = 0.5 * (b - a).cross(c - a).norm();
  return area > flat * perimeter * perimeter ? area + roundness * perimeter * perimeter : Infinity;
}

class LeastAreaFilling
{
public:
  LeastAreaFilling(
    const std::vector<Vector3>& contour, const std::function<bool(Index, Index)>& isAllowed)
    : Contour(contour)
    , IsAllowed(isAllowed)
    , Count(contour.size())
    , BestParts(Count * Count)
  {
  }

  std::vector<Triangle> Fill()
  {
    for (std::size_t span = 2; span < this->Count; ++span)
    {
      for (std::size_t first = 0; first + span < this->Count; ++first)
      {
        this->Improve(first, first + span);
      }
    }
    std::vector<Triangle> triangles;
    if (this->At(0, this->Count - 1).Area < Infinity)
    {
      this->Collect(triangles);
    }
    return triangles;
  }

private:
  /// The best triangulation of a part of the contour, closed by the edge between its ends.
  struct Part
  {
    double Area = 0.0; // mm^2, the cost
    std::size_t Apex = 0;
  };

  Part& At(std::size_t first, std::size_t last)
  {
    return this->BestParts[first * this->Count + last];
  }

  void Improve(std::size_t first, std::size_t last)
  {
    const bool isSide = first == 0 && last == this->Count - 1;
    Part best = { Infinity, first };
    const bool canHave =
      isSide || this->IsAllowed(static_cast<Index>(first), static_cast<Index>(last));
    for (std::size_t apex = first + 1; canHave && apex < last; ++apex)
    {
      const double area = this->At(first, apex).Area + this->At(apex, last).Area +
        CostOf(this->Contour[first], this->Contour[apex], this->Contour[last]);
      if (area < best.Area)
      {
        best = { area, apex };
      }
    }
    this->At(first, last) = best;
  }

  void Collect(std::vector<Triangle>& triangles)
  {
    std::vector<std::pair<std::size_t, std::size_t>> parts = { { 0, this->Count - 1 } };
    while (!parts.empty())
    {
      const auto [first, last] = parts.back();
      parts.pop_back();
      if (last - first >= 2)
      {
        const std::size_t apex = this->At(first, last).Apex;
        triangles.push_back(
          { static_cast<Index>(first), static_cast<Index>(apex), static_cast<Index>(last) });
        parts.emplace_back(first, apex);
        parts.emplace_back(apex, last);
      }
    }
  }

  const std::vector<Vector3>& Contour;
  const std::function<bool(Index, Index)>& IsAllowed;
  std::size_t Count;
  std::vector<Part> BestParts;
};
}

std::vector<Triangle> FillByLeastArea(
  const std::vector<Vector3>& contour, const std::function<bool(Index, Index)>& isAllowed)
{
  if (contour.size() < 3 || contour.size() > MaxPointsOfLeastArea)
  {
    return {};
  }
  return LeastAreaFilling(contour, isAllowed).Fill();
}
}
