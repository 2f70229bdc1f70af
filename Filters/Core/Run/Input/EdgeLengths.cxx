// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "EdgeLengths.h"

#include "Geometry/SmallestAngle.h"
#include "Mesh/Curvature.h"
#include "Tolerances.h"

#include <algorithm>
#include <cmath>

namespace bonedecimate
{
namespace
{
/// mm for each mm along an edge.
constexpr double Slope = 0.3;
/// Least length for a chordal error, as a fraction of EdgeLength.
constexpr double MinChordal = 0.1;
constexpr double RadiusOfCurvature = 0.25;

/// Shortens lengths where the surface is curved.
void ShortenByCurvature(const HalfEdgeMesh& mesh, const PointGraph& graph, const Options& options,
  std::vector<double>& lengths)
{
  const std::vector<double> curvatures =
    MaxCurvatures(mesh, graph, RadiusOfCurvature * options.EdgeLength, options.NumberOfThreads);
  for (std::size_t v = 0; v < lengths.size(); ++v)
  {
    const double chordal = ChordalLength(curvatures[v], options.ChordalError);
    lengths[v] = std::min(lengths[v], std::max(chordal, MinChordal * options.EdgeLength));
  }
}
}

InputStatus CheckEdgeLengths(
  const std::vector<double>* given, std::size_t numberOfPoints, CleaningStatistics& found)
{
  if (given == nullptr)
  {
    return InputStatus::Good;
  }
  for (std::size_t i = 0; i < given->size(); ++i)
  {
    const double length = (*given)[i];
    if (!(length > 0.0 && length <= MaxCoordinate) && found.BadEdgeLengths++ == 0)
    {
      found.FirstBadEdgeLength = static_cast<std::int64_t>(i);
    }
  }
  return given->size() == numberOfPoints && found.BadEdgeLengths == 0 ? InputStatus::Good
                                                                      : InputStatus::BadEdgeLengths;
}

//------------------------------------------------------------------------------
double ChordalLength(double curvature, double error)
{
  if (!(curvature > 0.0))
  {
    return Infinity;
  }
  const double radius = 1.0 / curvature;
  const double below = std::min(error, radius); // the largest triangle is that of a great circle
  return std::sqrt(6.0 * radius * below - 3.0 * below * below);
}

//------------------------------------------------------------------------------
std::shared_ptr<const SizingField> MakeSizingField(const CleanSurface& clean,
  const HalfEdgeMesh& mesh, const std::vector<double>* given, const Options& options)
{
  const bool isCurved = options.ChordalError > 0.0;
  if (options.EffectiveEdgeLength() == 0.0 || (given == nullptr && !isCurved))
  {
    return nullptr;
  }
  std::vector<double> lengths(clean.Surface.Points.size(), options.EdgeLength);
  if (given != nullptr)
  {
    const std::vector<double> ofPoints = TolerancesOf(clean, *given); // the least of merged points
    std::transform(lengths.begin(), lengths.end(), ofPoints.begin(), lengths.begin(),
      [](double most, double length) { return std::min(most, length); });
  }
  const PointGraph graph(clean.Surface, clean.ManifoldPatches.OriginalVertices);
  if (isCurved)
  {
    ShortenByCurvature(mesh, graph, options, lengths);
  }
  GradeLengths(clean.Surface, graph, Slope, lengths);
  return std::make_shared<SizingField>(clean.Surface, std::move(lengths), options.NumberOfThreads);
}

//------------------------------------------------------------------------------
ShapeLimits ShapeLimitsOf(const Options& options, std::shared_ptr<const SizingField> local)
{
  constexpr double margin = 1e-3; // degrees
  constexpr double sliver = 20.0; // degrees
  ShapeLimits limits;
  limits.EdgeLength = options.EffectiveEdgeLength();
  limits.Sizing = std::move(local);
  const double requested = options.EffectiveMinimumAngle();
  const double angle = requested == 0.0 && limits.LimitsEdges() ? sliver : requested;
  limits.MaxCosine = angle > 0.0 ? CosineOfDegrees(angle + margin) : 1.0;
  return limits;
}
}
