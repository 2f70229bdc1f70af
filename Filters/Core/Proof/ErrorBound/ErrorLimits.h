// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ErrorLimits.h
 * @brief Largest distance of the result at each point of the original, less the slack for rounding.
 *
 * At a vertex, the limit is the smaller of its tolerance and the overall error bound. On an
 * original triangle it is linear, so that distance - limit is a convex function. For distances to
 * the original, a triangle has the least limit of its corners. An infinite limit allows everything
 * inside a triangle or edge at that corner. The certificate reads tolerance maps in the same way.
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

  /// At each vertex not more than that part of the distance, less the slack; mm.
  void Reduce(const std::vector<double>& distances, double part);

  /// mm, the largest of all.
  double Most() const { return this->Everywhere; }
  /// Whether they are not the same everywhere.
  bool Differ() const { return !this->Values.empty(); }

  /// mm, at a vertex.
  double At(VertexId vertex) const
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
  double OverEdge(HalfEdgeId halfEdge) const
  {
    return std::min(
      this->At(this->Original.Origin(halfEdge)), this->At(this->Original.Target(halfEdge)));
  }

  /// mm, between two points of a triangle with known limits; 0 < t < 1.
  static double Between(double from, double to, double t);

private:
  const HalfEdgeMesh& Original;
  double Slack = 0.0;         // mm
  double Everywhere = 0.0;    // mm
  std::vector<double> Values; // mm, of each vertex; empty: the same for all
};
}

#endif
