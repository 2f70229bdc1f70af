// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ErrorLimits.h
 * @brief Largest distance that the result may have at each point of the original, less the slack
 * for rounding.
 *
 * At a vertex, the limit is the smaller of its tolerance and the overall error bound. It is linear
 * on an original triangle, so distance - limit is a convex function. For distances to the original,
 * the limit of a triangle is the least of its corners. A corner with an infinite limit makes the
 * limit infinite inside of its triangles and edges. The certificate reads tolerance maps in the
 * same way.
 */
#ifndef BoneDecimate_Core_Proof_ErrorBound_ErrorLimits_h
#define BoneDecimate_Core_Proof_ErrorBound_ErrorLimits_h

#include "Mesh/HalfEdgeMesh.h"

#include <algorithm>
#include <vector>

namespace bonedecimate
{
struct ErrorBoundSettings;

class ErrorLimits
{
public:
  /// @param original Must not change.
  ErrorLimits(const HalfEdgeMesh& original, const ErrorBoundSettings& settings);

  /// Lowers the limit of each vertex to this part of its distance (mm), less the slack. Infinite
  /// distances lower nothing.
  void Reduce(const std::vector<double>& distances, double part);

  /// mm, the largest of all.
  double Max() const { return this->MaxLimit; }
  /// Whether the limit is the same everywhere.
  bool IsUniform() const { return this->VertexLimits.empty(); }

  /// mm, at a vertex.
  double At(VertexId vertex) const
  {
    return this->VertexLimits.empty() ? this->MaxLimit : this->VertexLimits[vertex];
  }

  /// mm, of points near a triangle or an edge of the original: the least of its corners.
  double OfTriangle(Index triangle) const
  {
    const Triangle c = this->OriginalMesh.Corners(triangle);
    return this->VertexLimits.empty()
      ? this->MaxLimit
      : std::min({ this->VertexLimits[c[0]], this->VertexLimits[c[1]], this->VertexLimits[c[2]] });
  }
  double OfEdge(HalfEdgeId halfEdge) const
  {
    return std::min(
      this->At(this->OriginalMesh.Origin(halfEdge)), this->At(this->OriginalMesh.Target(halfEdge)));
  }

  /// mm, between two points with known limits on a triangle; 0 < t < 1.
  static double Interpolate(double from, double to, double t);

private:
  const HalfEdgeMesh& OriginalMesh;
  double RoundingMargin = 0.0;      // mm
  double MaxLimit = 0.0;            // mm
  std::vector<double> VertexLimits; // mm, of each vertex; empty: the same for all
};
}

#endif
