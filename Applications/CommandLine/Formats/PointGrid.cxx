// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PointGrid.h"

#include "vtkNew.h"
#include "vtkPoints.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace bonedecimate
{
namespace
{
constexpr int BitsOfSingle = 24;
constexpr int BitsOfDouble = 53;
constexpr double LargestNumber16 = 65535.0;

/// The least power of two that is not smaller.
double PowerOfTwoAbove(double value)
{
  int exponent = 0;
  const double fraction = std::frexp(value, &exponent);
  return std::ldexp(1.0, fraction == 0.5 ? exponent - 1 : exponent);
}

/// The exponent of the last bit of a number that is not 0.
int LastBit(double value)
{
  int exponent = 0;
  const auto whole =
    static_cast<std::int64_t>(std::ldexp(std::frexp(value, &exponent), BitsOfDouble));
  int zeros = 0;
  while ((whole >> zeros) % 2 == 0)
  {
    ++zeros;
  }
  return exponent - BitsOfDouble + zeros;
}

double WidestSide(const std::array<double, 6>& bounds)
{
  return std::max({ bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4] });
}
}

double GridStepOf(vtkPolyData* surface, double margin, int bits)
{
  std::array<double, 6> bounds = {};
  surface->GetBounds(bounds.data());
  double farthest = 0.0;
  for (const double bound : bounds)
  {
    farthest = std::max(farthest, std::abs(bound) + margin);
  }
  const double side = WidestSide(bounds) + 2.0 * margin;
  const double ofBits = side / (std::ldexp(1.0, bits) - 2.0); // both ends may be rounded outward
  const double ofSingle = std::ldexp(farthest, -BitsOfSingle);
  return PowerOfTwoAbove(std::max({ ofBits, ofSingle, std::numeric_limits<double>::min() }));
}

double LargestGridRounding(double step)
{
  return 0.5 * std::sqrt(3.0) * step;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> RoundedToGrid(vtkPolyData* surface, double step)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(surface->GetNumberOfPoints());
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    std::array<double, 3> position = {};
    surface->GetPoint(i, position.data());
    std::transform(position.begin(), position.end(), position.begin(),
      [step](double coordinate) { return std::round(coordinate / step) * step; });
    points->SetPoint(i, position.data());
  }
  auto rounded = vtkSmartPointer<vtkPolyData>::New();
  rounded->ShallowCopy(surface);
  rounded->SetPoints(points);
  return rounded;
}

//------------------------------------------------------------------------------
std::optional<PointGrid> FindGrid(vtkPolyData* surface)
{
  int last = std::numeric_limits<int>::max();
  std::array<double, 6> bounds = {};
  surface->GetPoints()->GetBounds(bounds.data());
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    std::array<double, 3> position = {};
    surface->GetPoint(i, position.data());
    for (const double coordinate : position)
    {
      if (!std::isfinite(coordinate))
      {
        return {};
      }
      last = coordinate == 0.0 ? last : std::min(last, LastBit(coordinate));
    }
  }
  PointGrid grid;
  grid.Step = last == std::numeric_limits<int>::max() ? 1.0 : std::ldexp(1.0, last);
  grid.Origin = { bounds[0], bounds[2], bounds[4] };
  const bool fits = WidestSide(bounds) <= LargestNumber16 * grid.Step;
  return fits ? std::optional<PointGrid>(grid) : std::nullopt;
}
}
