// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ShapeFilter.h
 * @brief No edit makes a triangle with an angle below the least one, unless a triangle that it replaces was worse.
 *
 * So triangles of the input that are worse do not stop collapses, and no edit makes the worst triangle around it worse.
 */
#ifndef BoneDecimate_Core_EditFilters_ShapeFilter_h
#define BoneDecimate_Core_EditFilters_ShapeFilter_h

#include "EditFilter.h"

namespace bonedecimate
{
class ShapeFilter : public EditFilter
{
public:
  /// @param largestCosine That of the least angle.
  explicit ShapeFilter(double largestCosine)
    : LargestCosine(largestCosine)
  {
  }

  bool NeedsSurfaceChange() const override { return true; }
  Decision Screen(
    const HalfEdgeMesh& mesh, const ProposedEdit& edit, Pending& pending) const override;

private:
  double LargestCosine;
};
}

#endif
