// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ZoneFilter.h
 * @brief Keeps all edits between two parallel planes.
 *
 * What lies between two planes is convex: new faces with all corners there stay there. Zones that
 * do not overlap can be edited independently, and no face of one can intersect a face of another.
 */
#ifndef BoneDecimate_Core_Proof_EditFilters_ZoneFilter_h
#define BoneDecimate_Core_Proof_EditFilters_ZoneFilter_h

#include "EditFilter.h"
#include "Geometry/Zone.h"

namespace bonedecimate
{
class ZoneFilter : public EditFilter
{
public:
  /// @param zone Relative to the origin of the mesh.
  explicit ZoneFilter(const Zone& zone)
    : Inside(zone)
  {
  }

  bool NeedsSurfaceChange() const override { return true; }
  /// Corners of new faces are inside, or vertices that do not move.
  Decision Screen(const HalfEdgeMesh& mesh, const SurfaceChange& change,
    EditFilter::Pending& pending) const override;

private:
  Zone Inside;
};
}

#endif
