// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ShapeFilter.h
 * @brief No edit makes a triangle with an angle below the least one or a side above the longest,
 * unless a triangle that it replaces was as bad.
 *
 * So triangles of the input beyond the limits do not stop collapses, and no edit makes the worst
 * triangle worse. Splits are exempt: a split shortens a side and may make smaller angles, which
 * flips and moves enlarge afterwards.
 */
#ifndef BoneDecimate_Core_Proof_EditFilters_ShapeFilter_h
#define BoneDecimate_Core_Proof_EditFilters_ShapeFilter_h

#include "EditFilter.h"
#include "Mesh/LocalLengths.h"
#include "Mesh/ShapeLimits.h"

#include <array>

namespace bonedecimate
{
class ShapeFilter : public EditFilter
{
public:
  /// @param mesh Before the first edit.
  ShapeFilter(const ShapeLimits& limits, const HalfEdgeMesh& mesh, int threads)
    : Limits(limits)
    , Lengths(limits.Sizing, mesh, threads)
  {
  }

  bool NeedsSurfaceChange() const override { return true; }
  Decision Screen(
    const HalfEdgeMesh& mesh, const SurfaceChange& change, Pending& pending) const override;
  void Commit(
    const HalfEdgeMesh& mesh, const SurfaceChange& change, Pending& pending, Tally& tally) override;

private:
  using Corners = std::array<Vector3, 3>;
  bool KeepsAngles(const HalfEdgeMesh& mesh, const SurfaceChange& change) const;
  bool KeepsLengths(const HalfEdgeMesh& mesh, const SurfaceChange& change) const;
  double SquareOfLongestRatio(const Triangle& vertices, const Corners& at) const;

  ShapeLimits Limits;
  LocalLengths Lengths;
};
}

#endif
