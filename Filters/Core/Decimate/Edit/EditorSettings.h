// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file EditorSettings.h
 * @brief What an editor maintains, guarantees and leaves unchanged. All of it is set when the
 * editor is constructed.
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
  /// Records the distance of every new vertex to the original, for the error of mode Thesis.
  bool RecordsDistances = true;
  bool KeepsAreas = true;     ///< Maintains area and normal of each face.
  bool KeepsQuadrics = false; ///< Maintains the quadric of each vertex (RingQuadrics.h).
  /// Keeps a copy of the mesh before the first edit. An error bound keeps one, too.
  bool KeepsInitialMesh = false;
  bool RecordsEdits = false; ///< For Editor::TakeLog; not with CollapsesFeatureCurves.
  /// Allows the collapse of curves between manifold patches along themselves.
  bool CollapsesFeatureCurves = false;
  /// Rejects edits that let triangles intersect or narrow a gap; only with a Bound of finite Error.
  bool GuardsIntersections = false;
  /// The surface before cleaning, for GuardsIntersections: vertices that never move are written
  /// with all of its bits. Null: vertices are written where the mesh has them.
  const Surface* Input = nullptr;
  /// Measures gaps first, so that no edit narrows one; only with GuardsIntersections.
  bool GuardsGaps = true;
  /// The error bound of every edit; none: there is no bound. Its Tolerances are set from those
  /// below.
  std::optional<ErrorBoundSettings> Bound = {};
  /// Rejects edits that let a voxel center change sides; none: no voxel is guarded.
  std::optional<VoxelGuardSettings> Voxels = {};
  /// Tolerance of each vertex of the mesh, mm; negative: it has none. A vertex is constrained, with
  /// the corners of its faces, if its tolerance is 0 or too small to be proved. Empty: no vertex
  /// has a tolerance.
  std::vector<double> Tolerances = {};
  /// For each vertex of the mesh, whether it and the corners of its faces are constrained, whatever
  /// its tolerance. Empty: none is.
  std::vector<char> IsConstrained = {};
  /// Position of each vertex of the mesh from which edits start, mm from the local origin. Error
  /// bound and recorded distances refer to the mesh as it was made; everything else uses these
  /// positions. Empty: those of the mesh.
  std::vector<Vector3> SmoothedPositions = {};
  /// The original that the error bound refers to if the mesh is itself a result; must outlive the
  /// editor. Only with a Bound, without Tolerances and SmoothedPositions. Null: the mesh.
  const ReferenceMesh* Reference = nullptr;
  /// The zone where edits are allowed, mm from the local origin; none: everywhere.
  std::optional<Zone> EditZone = {};
  /// Other surfaces, from which new faces keep a distance.
  NeighborSurfaces Neighbors = {};
  /// Limits of new triangles, unless a triangle that they replace is worse.
  ShapeLimits Shape = {};
  /// Options of the run. Only Editor::AddFilters reads them: a new filter finds its option here.
  Options Requested = {};
  /// Filters that run after those of the editor.
  std::vector<std::shared_ptr<EditFilter>> MoreFilters = {};
  int Threads = 1; ///< Number of threads for the construction.
};
}

#endif
