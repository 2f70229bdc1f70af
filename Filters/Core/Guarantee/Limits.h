// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Limits.h
 * @brief How far the result may be from each place of the original, with the slack for rounding taken off.
 *
 * At a vertex it is its tolerance, capped by the error promised everywhere. On an original triangle it is linear, so
 * that distance - limit stays a convex function; towards the original, a triangle counts with the least of its
 * corners. No limit is infinity: then everything inside a triangle or edge at that corner is allowed. The certificate
 * reads tolerance maps in the same way.
 */
#ifndef BoneDecimate_Core_Guarantee_Limits_h
#define BoneDecimate_Core_Guarantee_Limits_h

#include "Mesh/HalfEdgeMesh.h"

#include <algorithm>
#include <vector>

namespace bonedecimate
{
struct Promise;

class Limits
{
public:
  /// @param original Must stay as it is.
  Limits(const HalfEdgeMesh& original, const Promise& promise);

  /// Whether they are not the same everywhere.
  bool Differ() const { return !this->Values.empty(); }

  /// mm, at a vertex.
  double At(Index vertex) const
  {
    return this->Values.empty() ? this->Everywhere : this->Values[vertex];
  }

  /// mm, of what a triangle or an edge explains: the least of its corners.
  double Over(Index triangle) const
  {
    const Triangle c = this->Original.Corners(triangle);
    return this->Values.empty()
      ? this->Everywhere
      : std::min({ this->Values[c[0]], this->Values[c[1]], this->Values[c[2]] });
  }
  double OverEdge(Index halfEdge) const
  {
    return std::min(
      this->At(this->Original.Origin(halfEdge)), this->At(this->Original.Target(halfEdge)));
  }

  /// mm, between two places of a triangle whose limits are known, t from 0 to 1 and neither.
  static double Between(double from, double to, double t);

private:
  const HalfEdgeMesh& Original;
  double Everywhere = 0.0;    // mm
  std::vector<double> Values; // mm, of each vertex; empty: the same for all
};
}

#endif
