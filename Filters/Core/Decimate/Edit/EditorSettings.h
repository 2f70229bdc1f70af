// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file EditorSettings.h
 * @brief What an editor keeps, guarantees and leaves alone: all of it is set when the editor is
 * constructed.
 */
#ifndef BoneDecimate_Core_Decimate_Edit_EditorSettings_h
#define BoneDecimate_Core_Decimate_Edit_EditorSettings_h

#include "Geometry/NearSurface.h"
#include "Geometry/Zone.h"
#include "Labels/VoxelGuard/VoxelGuard.h"
#include "Mesh/ShapeLimits.h"
#include "Options/Options.h"
#include "Proof/EditFilters/EditFilter.h"
#include "Proof/ErrorBound/ErrorBound.h"
#include "Proof/Reference/ReferenceMesh.h"

#include <memory>
#include <optional>
#include <vector>

namespace bonedecimate
{
struct EditorSettings
{
  /// Whether the distance of every new vertex to the original is recorded: the error of mode
  /// Thesis.
  bool RecordsDistances = true;
  bool KeepsAreas = true;     ///< Area and normal of each face.
  bool KeepsQuadrics = false; ///< RingQuadrics.h: the Quadric of each vertex record.
  /// A copy of the mesh before the first edit; an error bound keeps one too.
  bool KeepsInitialMesh = false;
  bool RecordsEdits = false; ///< Editor::TakeLog. Not together with CollapsesFeatureCurves.
  /// Curves between manifold patches may be collapsed along themselves.
  bool CollapsesFeatureCurves = false;
  /// Whether edits are rejected that let triangles intersect or narrow a gap; only with a Bound of
  /// finite Error.
  bool GuardsIntersections = false;
  /// The surface that was cleaned, for GuardsIntersections: unmoved vertices keep every bit of it
  /// when they are written. Null: vertices are written where the mesh has them.
  const Surface* Input = nullptr;
  /// Whether GuardsIntersections measures gaps first, so that no edit narrows one.
  bool GuardsGaps = true;
  /// The error bound that every edit keeps; none: edits are not limited. Its Tolerances are those
  /// below.
  std::optional<ErrorBoundSettings> Bound = {};
  /// Whether edits are rejected that let a voxel center change sides; none: no voxel is guarded.
  std::optional<VoxelGuardSettings> Voxels = {};
  /// mm, of each vertex of the mesh; negative: none of its own. A vertex of tolerance 0, or of one
  /// too small to be proved, is constrained, and so are the corners of its faces. Empty: no vertex
  /// has a tolerance.
  std::vector<double> Tolerances = {};
  /// For each vertex of the mesh, whether it and the corners of its faces are constrained, whatever
  /// its tolerance. Empty: none is.
  std::vector<char> IsConstrained = {};
  /// mm from the local origin, of each vertex of the mesh: where edits start from. The error bound
  /// and the distances recorded refer to the mesh as it was made; everything else sees these
  /// positions. Empty: vertices are where the mesh has them.
  std::vector<Vector3> SmoothedPositions = {};
  /// The original that the error bound refers to, if the mesh is itself a result. It must outlive
  /// the editor. Only with a Bound, without Tolerances and SmoothedPositions. Null: the mesh.
  const ReferenceMesh* Reference = nullptr;
  /// Where edits are allowed, mm from the local origin; none: everywhere.
  std::optional<Zone> EditZone = {};
  /// Neighbors from which new faces keep a distance.
  NeighborSurfaces Neighbors = {};
  /// Limits of the shapes that edits leave, unless a triangle that they replace is worse.
  ShapeLimits Shape = {};
  /// Options of the run, read only by Editor::AddFilters: a new filter finds its option here.
  Options Requested = {};
  /// Filters that run after the editor's own.
  std::vector<std::shared_ptr<EditFilter>> MoreFilters = {};
  int Threads = 1; ///< Number of threads for the construction.
};
}

#endif
