// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file NeighborFilter.h
 * @brief Keeps new faces away from parts of the surface that other runs edit at the same time.
 *
 * If this distance is more than how far another run may move its part, no new face of one
 * run meets a face of the other.
 */
#ifndef BoneDecimate_Core_Proof_EditFilters_NeighborFilter_h
#define BoneDecimate_Core_Proof_EditFilters_NeighborFilter_h

#include "EditFilter.h"
#include "Geometry/NearSurface.h"

#include <utility>

namespace bonedecimate
{
class NeighborFilter : public EditFilter
{
public:
  explicit NeighborFilter(Neighborhood neighbors)
    : Neighbors(std::move(neighbors))
  {
  }

  bool NeedsSurfaceChange() const override { return true; }
  Decision Check(const HalfEdgeMesh& mesh, const SurfaceChange& change,
    EditFilter::Pending& pending) const override;

private:
  Neighborhood Neighbors;
};
}

#endif
