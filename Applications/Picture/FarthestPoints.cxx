// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "FarthestPoints.h"

#include "NamedLabels.h"
#include "NumberText.h"
#include "SurfaceDistances.h"

#include "vtkBoundingBox.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkTriangle.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <tuple>

namespace bonedecimate
{
namespace
{
constexpr double LeastSeparation = 0.05; // of the diagonal

constexpr vtkIdType OfLargest = -1; // in place of a point

struct Candidate
{
  double Distance;
  int Side; // 0: original
  vtkIdType Point;

  /// Larger distances first; then an order that is always the same.
  bool operator<(const Candidate& other) const
  {
    return std::tie(other.Distance, this->Side, this->Point) <
      std::tie(this->Distance, other.Side, other.Point);
  }
};

void AddCandidates(
  vtkPolyData* triangles, const std::string& arrayName, int side, std::vector<Candidate>& all)
{
  vtkDataArray* const distances = triangles->GetPointData()->GetArray(arrayName.c_str());
  for (vtkIdType point = 0; distances && point < distances->GetNumberOfTuples(); ++point)
  {
    const double distance = distances->GetComponent(point, 0);
    if (std::isfinite(distance) && distance > 0.0)
    {
      all.push_back({ distance, side, point });
    }
  }
}

bool IsNear(const double* point, const std::vector<FarPoint>& found, double separation)
{
  return std::any_of(found.begin(), found.end(),
    [&](const FarPoint& one) {
      return vtkMath::Distance2BetweenPoints(point, one.Position.data()) < separation * separation;
    });
}

/// The sum of the normals of the triangles around a point, weighted by area.
std::array<double, 3> OutwardAt(vtkPolyData* triangles, vtkIdList* cells)
{
  std::array<double, 3> sum = { 0.0, 0.0, 0.0 };
  vtkNew<vtkIdList> corners;
  for (vtkIdType i = 0; i < cells->GetNumberOfIds(); ++i)
  {
    triangles->GetCellPoints(cells->GetId(i), corners);
    std::array<std::array<double, 3>, 3> p;
    for (vtkIdType k = 0; k < 3; ++k)
    {
      triangles->GetPoint(corners->GetId(k), p[static_cast<std::size_t>(k)].data());
    }
    std::array<double, 3> normal;
    vtkTriangle::ComputeNormalDirection(p[0].data(), p[1].data(), p[2].data(), normal.data());
    vtkMath::Add(sum.data(), normal.data(), sum.data());
  }
  vtkMath::Normalize(sum.data());
  return sum;
}

std::vector<std::string> LabelsAt(
  vtkPolyData* triangles, vtkIdList* cells, const std::vector<NamedLabel>& labels)
{
  vtkDataArray* const pairs = triangles->GetCellData()->GetArray(LabelsOfSidesName);
  std::vector<std::string> found;
  for (const NamedLabel& label : labels)
  {
    bool isThere = false;
    for (vtkIdType i = 0; pairs && i < cells->GetNumberOfIds(); ++i)
    {
      for (int side = 0; side < pairs->GetNumberOfComponents(); ++side)
      {
        isThere = isThere ||
          static_cast<std::int64_t>(pairs->GetComponent(cells->GetId(i), side)) == label.Value;
      }
    }
    if (isThere)
    {
      found.push_back(LabelText(label));
    }
  }
  return found;
}
}

std::vector<FarPoint> FindFarthestPoints(
  const MeasuredSurface& original, const MeasuredSurface& result, std::size_t count)
{
  const std::array<const MeasuredSurface*, 2> surfaces = { &original, &result };
  const std::vector<NamedLabel> labels = LabelsOf(result.Surface);
  std::array<vtkSmartPointer<vtkPolyData>, 2> triangles;
  std::vector<Candidate> candidates;
  vtkBoundingBox box;
  for (std::size_t side = 0; side < 2; ++side)
  {
    triangles[side] = MergedTriangles(surfaces[side]->Surface);
    triangles[side]->BuildLinks();
    box.AddBounds(triangles[side]->GetBounds());
    AddCandidates(
      triangles[side], surfaces[side]->DistanceArrayName, static_cast<int>(side), candidates);
    if (surfaces[side]->Largest.Distance > 0.0)
    {
      candidates.push_back({ surfaces[side]->Largest.Distance, static_cast<int>(side), OfLargest });
    }
  }
  std::sort(candidates.begin(), candidates.end());
  std::vector<FarPoint> points;
  vtkNew<vtkIdList> cells;
  for (auto at = candidates.begin(); at != candidates.end() && points.size() < count; ++at)
  {
    const auto side = static_cast<std::size_t>(at->Side);
    vtkPolyData* const surface = triangles[side];
    FarPoint one;
    one.Position = surfaces[side]->Largest.Position;
    if (at->Point != OfLargest)
    {
      surface->GetPoint(at->Point, one.Position.data());
    }
    if (IsNear(one.Position.data(), points, LeastSeparation * box.GetDiagonalLength()))
    {
      continue;
    }
    surface->GetPointCells(
      at->Point == OfLargest ? surface->FindPoint(one.Position.data()) : at->Point, cells);
    one.Distance = at->Distance;
    one.Outward = OutwardAt(surface, cells);
    one.IsOnOriginal = at->Side == 0;
    one.Labels = LabelsAt(surface, cells, labels);
    points.push_back(std::move(one));
  }
  return points;
}

std::string AnatomicalText(const std::array<double, 3>& position, const std::string& frame)
{
  const auto letters = AxisLetters(frame);
  std::string text;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const double along = position[axis];
    text += (axis == 0 ? "" : ", ") +
      (frame.empty() ? GroupedText(along, 1)
                     : letters[axis][along < 0.0 ? 0 : 1] + " " + GroupedText(std::abs(along), 1));
  }
  return text;
}

std::array<std::array<std::string, 2>, 3> AxisLetters(const std::string& frame)
{
  if (frame == "LPS")
  {
    return { { { "R", "L" }, { "A", "P" }, { "I", "S" } } };
  }
  if (frame == "RAS")
  {
    return { { { "L", "R" }, { "P", "A" }, { "I", "S" } } };
  }
  return { { { "", "x" }, { "", "y" }, { "", "z" } } };
}
}
