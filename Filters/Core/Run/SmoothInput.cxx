// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SmoothInput.h"

#include "Mesh/ManifoldPatches.h"
#include "Proof/ErrorBound/ErrorLimits.h"
#include "Smoothing/Smoothing.h"

#include <algorithm>
#include <limits>

namespace bonedecimate
{
namespace
{
/// mm, of each vertex: how far the result may be.
std::vector<double> LimitsOf(
  const RunTask& task, const HalfEdgeMesh& mesh, const EditorSettings& settings)
{
  std::vector<double> limits(
    static_cast<std::size_t>(mesh.NumberOfVertexSlots()), std::numeric_limits<double>::infinity());
  if (settings.Bound)
  {
    ErrorBoundSettings bound = *settings.Bound;
    bound.Tolerances = settings.Tolerances.empty() ? nullptr : &settings.Tolerances;
    const ErrorLimits allowed(mesh, bound);
    for (std::size_t v = 0; v < limits.size(); ++v)
    {
      limits[v] = task.Smoothing.UsableOf(allowed.At(static_cast<Index>(v)));
    }
  }
  else
  {
    for (std::size_t v = 0; v < settings.Tolerances.size(); ++v)
    {
      limits[v] = settings.Tolerances[v] == 0.0 ? 0.0 : limits[v];
    }
  }
  // Duplicates move as one.
  for (Index v = 0; v < mesh.NumberOfVertexSlots(); ++v)
  {
    double& least = limits[mesh.OriginalVertex(v)];
    least = std::min(least, limits[v]);
  }
  return limits;
}

/// What is known of the segmentation, of the points and triangles of the cleaned surface. Labels of
/// triangles are kept if there are any.
LabelMapSource SourceOf(const RunTask& task, const CleanSurface& clean)
{
  LabelMapSource source;
  if (const LabelMapSource* known = task.Smoothing.Source())
  {
    source.Grid = known->Grid;
    source.Grid.Origin -= clean.Origin;
    for (const Index point : clean.InputPoint)
    {
      source.OfPoint.push_back(known->OfPoint[point]);
    }
    for (std::size_t t = 0; t < clean.InputTriangle.size() && !known->OfTriangle.empty(); ++t)
    {
      source.OfTriangle.push_back(known->OfTriangle[clean.InputTriangle[t]]);
    }
  }
  if (task.Inputs.Labels != nullptr)
  {
    const std::vector<Index> labels = LabelsOf(clean, *task.Inputs.Labels);
    source.OfTriangle.assign(labels.size(), {});
    for (std::size_t t = 0; t < labels.size(); ++t)
    {
      source.OfTriangle[t] = { labels[t], labels[t] };
    }
  }
  return source;
}

/// mm from the local origin, of each vertex of the mesh.
std::vector<Vector3> PositionsOfPart(const SurfacePart& part, const PreparedInput& prepared)
{
  const CleanSurface& clean = prepared.Cleaned;
  std::vector<Vector3> positions;
  for (Index v = 0; v < prepared.Mesh->NumberOfVertexSlots(); ++v)
  {
    const Index point = clean.InputPoint[prepared.Mesh->OriginalVertex(v)];
    positions.emplace_back(part.SmoothedPoints[point] - clean.Origin);
  }
  return positions;
}

SmoothingSettings SettingsOf(const RunTask& task, const CleanSurface& clean)
{
  SmoothingSettings settings;
  settings.Radius = task.Smoothing.Radius;
  settings.InVoxels = task.Smoothing.InVoxels;
  settings.FeatureAngle = task.Effective.FeatureAngle;
  settings.Rounding = task.Rounding;
  settings.Origin = clean.Origin;
  settings.Threads = task.Effective.NumberOfThreads;
  return settings;
}
}

std::vector<Vector3> SmoothInput(const RunTask& task, const PreparedInput& prepared,
  const EditorSettings& settings, const Monitor& monitor, SmoothingFigures& figures)
{
  figures.From = task.Smoothing.From;
  if (const SurfacePart* part = task.Inputs.Part; part && !part->SmoothedPoints.empty())
  {
    return PositionsOfPart(*part, prepared);
  }
  if (!(task.Smoothing.Radius > 0.0))
  {
    return {};
  }
  const CleanSurface& clean = prepared.Cleaned;
  const HalfEdgeMesh& mesh = *prepared.Mesh;
  const std::vector<double> limits = LimitsOf(task, mesh, settings);
  const LabelMapSource source = SourceOf(task, clean);
  SmoothedSurface smoothed = WithJoined(clean,
    [&](const Surface& joined) {
      return Smooth({ joined, &limits, &source }, SettingsOf(task, clean), monitor);
    });
  if (smoothed.IsAborted)
  {
    return {};
  }
  figures = smoothed.Figures;
  figures.From = task.Smoothing.From;
  for (Index v = 0; v < mesh.NumberOfVertexSlots(); ++v)
  {
    smoothed.Points[v] = smoothed.Points[mesh.OriginalVertex(v)];
  }
  return std::move(smoothed.Points);
}
}
