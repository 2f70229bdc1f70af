// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SettingsOfEditor.h"

#include "Options/Modes.h"
#include "Run/Input/EdgeLengths.h"
#include "Run/Input/LabelMapInput.h"
#include "Run/Input/PartInput.h"

#include <algorithm>

namespace bonedecimate
{
namespace
{
/// Settings of the error bound; none if there is nothing to prove.
std::optional<ErrorBoundSettings> BoundSettings(const RunTask& task, const PreparedInput& prepared)
{
  const Options& options = task.Effective;
  const std::vector<double>& tolerances = prepared.VertexTolerances;
  const bool hasPositive = std::any_of(
    tolerances.begin(), tolerances.end(), [](double tolerance) { return tolerance > 0.0; });
  if (!options.BoundsError() && !(options.ProvesError() && hasPositive))
  {
    return {};
  }
  ErrorBoundSettings settings;
  settings.Error = options.BoundsError() ? options.MaximumError : settings.Error;
  settings.Rounding = task.Rounding;
  settings.Origin = prepared.Cleaned.Origin;
  if (ContinuesEarlierRun(task.Inputs))
  {
    settings.Cuts = CutEdgesOf(task.Inputs.Part->CutEdges, prepared.Cleaned);
  }
  return settings;
}

/// Settings of the voxel guard; none if voxels may change.
std::optional<VoxelGuardSettings> VoxelSettings(const RunTask& task, const PreparedInput& prepared)
{
  if (!task.GuardsVoxels)
  {
    return {};
  }
  VoxelGuardSettings settings;
  settings.Grid = task.Inputs.LabelMap->Grid;
  settings.OfFace = BoundaryLabelsOf(prepared.Cleaned, *task.Inputs.LabelMap);
  settings.Rounding = task.Rounding;
  settings.Origin = prepared.Cleaned.Origin;
  return settings;
}
}

EditorSettings SettingsOfEditor(const RunTask& task, const PreparedInput& prepared, bool isAborted)
{
  const ModeInfo& mode = FindMode(task.Effective.Mode);
  EditorSettings settings;
  settings.RecordsDistances = mode.RecordsDistances;
  settings.KeepsAreas = mode.NeedsFaceAreas();
  settings.RecordsEdits = task.Inputs.Log != nullptr;
  settings.Threads = task.Effective.NumberOfThreads;
  if (!isAborted)
  {
    settings.Requested = task.Effective;
    settings.Shape = ShapeLimitsOf(task.Effective, prepared.Sizes);
    settings.KeepsQuadrics = mode.NeedsQuadrics();
    settings.KeepsInitialMesh = mode.KeepsInitialMesh;
    settings.CollapsesFeatureCurves = CollapsesFeatureCurves(task.Inputs);
    settings.Voxels = VoxelSettings(task, prepared);
    settings.Tolerances = prepared.VertexTolerances;
    settings.Bound = BoundSettings(task, prepared);
    settings.Reference = prepared.Original.get();
    if (const SurfacePart* part = task.Inputs.Part)
    {
      settings.EditZone = LocalZone(part->EditZone, prepared.Cleaned);
      settings.Neighbors = NeighborsOf(*part, prepared.Cleaned, settings.Threads);
      settings.IsConstrained = SharedVertices(*part, prepared.Cleaned, settings.Neighbors);
    }
    settings.GuardsIntersections = task.Effective.BoundsError() && task.Effective.IntersectionGuard;
    settings.Input = &task.Input;
    // Otherwise points that rounding would merge are separated, by no more than rounding.
    settings.GuardsGaps = !task.Effective.KeepsAllTriangles();
  }
  return settings;
}
}
