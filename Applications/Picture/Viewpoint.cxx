// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Viewpoint.h"

#include "vtkCellArray.h"
#include "vtkIdList.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkStaticCellLocator.h"
#include "vtkTriangle.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace bonedecimate
{
namespace
{
using Vector = std::array<double, 3>;

constexpr double Aside = 25.0;  // degrees
constexpr double Above = 10.0;  // degrees
constexpr double Margin = 1.15; // leaves space for the words at the edges of a view
constexpr double FacingCosine =
  0.5; // what is seen more slantwise than 60 degrees is not used for a close-up
constexpr vtkIdType VisibilityTests = 20000;

/// Degrees from the front to the patient's left, and from level upwards.
Viewpoint ViewFrom(double degreesAside, double degreesAbove)
{
  const double aside = vtkMath::RadiansFromDegrees(degreesAside);
  const double above = vtkMath::RadiansFromDegrees(degreesAbove);
  Viewpoint view;
  view.ToViewer = { std::sin(aside) * std::cos(above), -std::cos(aside) * std::cos(above),
    std::sin(above) };
  const Vector head = { 0.0, 0.0, 1.0 };
  vtkMath::Cross(head.data(), view.ToViewer.data(), view.Right.data());
  vtkMath::Normalize(view.Right.data());
  vtkMath::Cross(view.ToViewer.data(), view.Right.data(), view.Up.data());
  return view;
}

/// Calls visit(normal with the length of twice the area, id of the first corner) for each triangle.
template <typename Visitor>
void ForEachTriangle(vtkPolyData* surface, Visitor visit)
{
  vtkCellArray* triangles = surface->GetPolys();
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < triangles->GetNumberOfCells(); ++cell)
  {
    triangles->GetCellAtId(cell, corners);
    Vector a, b, c, normal;
    surface->GetPoint(corners->GetId(0), a.data());
    surface->GetPoint(corners->GetId(1), b.data());
    surface->GetPoint(corners->GetId(2), c.data());
    vtkTriangle::ComputeNormalDirection(a.data(), b.data(), c.data(), normal.data());
    visit(normal, corners->GetId(0));
  }
}

/// Amount of distance that faces the viewer, mm3 up to a factor.
double FacingDistance(const Viewpoint& view, vtkPolyData* surface, vtkDataArray* distances)
{
  double sum = 0.0;
  ForEachTriangle(surface,
    [&](const Vector& normal, vtkIdType corner)
    {
      const double facing = vtkMath::Dot(normal.data(), view.ToViewer.data());
      sum += std::max(facing, 0.0) * (distances ? distances->GetComponent(corner, 0) : 1.0);
    });
  return sum;
}

/// Coordinates along Right, Up and ToViewer.
Vector InView(const Viewpoint& view, const Vector& point)
{
  return { vtkMath::Dot(point.data(), view.Right.data()),
    vtkMath::Dot(point.data(), view.Up.data()), vtkMath::Dot(point.data(), view.ToViewer.data()) };
}

Vector InSpace(const Viewpoint& view, const Vector& seen)
{
  Vector point;
  for (std::size_t i = 0; i < 3; ++i)
  {
    point[i] = seen[0] * view.Right[i] + seen[1] * view.Up[i] + seen[2] * view.ToViewer[i];
  }
  return point;
}

struct Box
{
  Vector Least;
  Vector Greatest;
};

Box BoxInView(const Viewpoint& view, vtkPolyData* surface)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Box box{ { infinity, infinity, infinity }, { -infinity, -infinity, -infinity } };
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    Vector point;
    surface->GetPoint(i, point.data());
    const Vector seen = InView(view, point);
    for (std::size_t k = 0; k < 3; ++k)
    {
      box.Least[k] = std::min(box.Least[k], seen[k]);
      box.Greatest[k] = std::max(box.Greatest[k], seen[k]);
    }
  }
  return box;
}

/// Whether nothing of the surface lies between a point and a viewer at that depth.
bool IsVisible(
  vtkStaticCellLocator* locator, const Viewpoint& view, const Vector& seen, double depth)
{
  // mm, off the triangles at the point itself
  const double offset = 1e-4 * (depth - seen[2]) + 1e-3;
  const Vector from = InSpace(view, { seen[0], seen[1], seen[2] + offset });
  const Vector to = InSpace(view, { seen[0], seen[1], depth });
  double parameter;
  Vector hit, local;
  int part;
  return !locator->IntersectWithLine(
    from.data(), to.data(), 1e-6, parameter, hit.data(), local.data(), part);
}

/// As of PointView. @param length mm, of the line that looks for it.
double FreeBefore(
  vtkStaticCellLocator* locator, const Viewpoint& view, const Vector& point, double length)
{
  Vector from, to, hit, local;
  for (std::size_t i = 0; i < 3; ++i)
  {
    from[i] = point[i] + (1e-4 * length + 1e-3) * view.ToViewer[i]; // off the triangles there
    to[i] = point[i] + length * view.ToViewer[i];
  }
  double parameter;
  int part;
  return locator->IntersectWithLine(
           from.data(), to.data(), 1e-6, parameter, hit.data(), local.data(), part)
    ? std::sqrt(vtkMath::Distance2BetweenPoints(point.data(), hit.data()))
    : std::numeric_limits<double>::infinity();
}

/// The unit normal of the nearest triangle.
Vector NormalAt(vtkStaticCellLocator* locator, vtkPolyData* surface, const Vector& point)
{
  Vector nearest, a, b, c, normal;
  vtkIdType cell;
  int part;
  double squared;
  locator->FindClosestPoint(point.data(), nearest.data(), cell, part, squared);
  vtkNew<vtkIdList> corners;
  surface->GetCellPoints(cell, corners);
  surface->GetPoint(corners->GetId(0), a.data());
  surface->GetPoint(corners->GetId(1), b.data());
  surface->GetPoint(corners->GetId(2), c.data());
  vtkTriangle::ComputeNormal(a.data(), b.data(), c.data(), normal.data());
  return normal;
}

/// Squares of half a close-up's width, and the distances squared that are seen in each of them.
using Weights = std::map<std::pair<int, int>, double>;

Weights WeighSquares(const Viewpoint& view, vtkPolyData* surface, vtkDataArray* distances,
  const Box& box, double square)
{
  Weights weights;
  vtkNew<vtkStaticCellLocator> locator;
  locator->SetDataSet(surface);
  locator->BuildLocator();
  vtkDataArray* normals = surface->GetPointData()->GetNormals();
  const double depth = box.Greatest[2] + 1.0;
  const vtkIdType stride = surface->GetNumberOfPoints() / VisibilityTests + 1;
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); i += stride)
  {
    Vector point, normal;
    surface->GetPoint(i, point.data());
    normals->GetTuple(i, normal.data());
    const Vector seen = InView(view, point);
    const bool isFacing = vtkMath::Dot(normal.data(), view.ToViewer.data()) > FacingCosine;
    if (isFacing && IsVisible(locator, view, seen, depth))
    {
      const double distance = distances ? distances->GetComponent(i, 0) : 1.0;
      const int column = static_cast<int>((seen[0] - box.Least[0]) / square);
      const int row = static_cast<int>((seen[1] - box.Least[1]) / square);
      weights[{ column, row }] += distance * distance;
    }
  }
  return weights;
}

/// The lower left of the two by two squares that weigh most together.
std::pair<int, int> HeaviestSquare(const Weights& weights)
{
  Weights sums;
  for (const auto& [position, weight] : weights)
  {
    for (const auto& [left, down] :
      { std::pair(0, 0), std::pair(1, 0), std::pair(0, 1), std::pair(1, 1) })
    {
      sums[{ position.first - left, position.second - down }] += weight;
    }
  }
  const auto heaviest = std::max_element(
    sums.begin(), sums.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  return heaviest == sums.end() ? std::pair(0, 0) : heaviest->first;
}
}

Viewpoint ChooseViewpoint(vtkPolyData* surface, vtkDataArray* distances)
{
  const Viewpoint left = ViewFrom(Aside, Above);
  const Viewpoint right = ViewFrom(-Aside, Above);
  return FacingDistance(right, surface, distances) > FacingDistance(left, surface, distances)
    ? right
    : left;
}

Frame FrameWhole(const Viewpoint& view, vtkPolyData* surface, double aspect)
{
  const Box box = BoxInView(view, surface);
  Vector middle;
  for (std::size_t k = 0; k < 3; ++k)
  {
    middle[k] = 0.5 * (box.Least[k] + box.Greatest[k]);
  }
  const double width = box.Greatest[0] - box.Least[0];
  const double height = box.Greatest[1] - box.Least[1];
  return { InSpace(view, middle), Margin * 0.5 * std::max(height, width / aspect) };
}

Frame FrameCloseUp(
  const Viewpoint& view, vtkPolyData* surface, vtkDataArray* distances, double width)
{
  const Box box = BoxInView(view, surface);
  const double square = 0.5 * width;
  const auto [column, row] = HeaviestSquare(WeighSquares(view, surface, distances, box, square));
  const Vector middle = { box.Least[0] + (column + 1) * square, box.Least[1] + (row + 1) * square,
    0.5 * (box.Least[2] + box.Greatest[2]) };
  return { InSpace(view, middle), square };
}

PointView ChooseViewOfPoint(
  const Viewpoint& preferred, vtkPolyData* surface, const std::array<double, 3>& point)
{
  vtkNew<vtkStaticCellLocator> locator;
  locator->SetDataSet(surface);
  locator->BuildLocator();
  const double length = surface->GetLength();
  const Vector normal = NormalAt(locator, surface, point);
  const auto facing = [&normal](const Viewpoint& view)
  { return std::abs(vtkMath::Dot(normal.data(), view.ToViewer.data())); };
  PointView best = { preferred, FreeBefore(locator, preferred, point, length) };
  if (facing(preferred) > FacingCosine && best.Free > length)
  {
    return best;
  }
  double most = facing(preferred) * std::min(best.Free, length);
  for (const double above : { Above, 50.0, -40.0 })
  {
    for (double aside = 0.0; aside < 360.0; aside += 45.0)
    {
      const Viewpoint view = ViewFrom(aside, above);
      const double free = FreeBefore(locator, view, point, length);
      const double value = facing(view) * std::min(free, length);
      if (value > most)
      {
        most = value;
        best = { view, free };
      }
    }
  }
  return best;
}

double TypicalEdge(vtkPolyData* surface)
{
  double twiceArea = 0.0;
  ForEachTriangle(
    surface, [&](const Vector& normal, vtkIdType) { twiceArea += vtkMath::Norm(normal.data()); });
  const double count = static_cast<double>(std::max<vtkIdType>(surface->GetNumberOfPolys(), 1));
  return std::sqrt(2.0 * twiceArea / (std::sqrt(3.0) * count));
}
}
