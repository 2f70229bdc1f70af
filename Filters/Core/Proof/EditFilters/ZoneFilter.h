// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ZoneFilter.h
 * @brief Keeps edits between two parallel planes, and new faces away from neighbors that other runs
 * edit at the same time.
 *
 * The zone between two planes is convex: new faces with all corners in it stay in it. So zones that
 * do not overlap can be edited independently, and no face of one intersects a face of another. If
 * the distance from neighbors exceeds what another run may move them, no new face of one run meets
 * a face of the other.
 */
#ifndef BoneDecimate_Core_Proof_EditFilters_ZoneFilter_h
#define BoneDecimate_Core_Proof_EditFilters_ZoneFilter_h

#include "EditFilter.h"
#include "Geometry/NearSurface.h"
#include "Geometry/Zone.h"

#include <optional>
#include <utility>

namespace bonedecimate
{
class ZoneFilter : public EditFilter
{
public:
  /// @param zone Relative to the origin of the mesh. Nothing: everywhere.
  ZoneFilter(const std::optional<Zone>& zone, NeighborSurfaces neighbors)
    : AllowedZone(zone)
    , Neighbors(std::move(neighbors))
  {
  }

  bool NeedsSurfaceChange() const override { return true; }
  /// Corners of new faces that are not constrained vertices must be in the zone.
  Decision Screen(const HalfEdgeMesh& mesh, const SurfaceChange& change,
    EditFilter::Pending& pending) const override;
  /// New faces must keep the distance from the neighbors.
  Decision Check(const HalfEdgeMesh& mesh, const SurfaceChange& change,
    EditFilter::Pending& pending) const override;

private:
  std::optional<Zone> AllowedZone;
  NeighborSurfaces Neighbors;
};
}

#endif
