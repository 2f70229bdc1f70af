// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file VertexMover.h
 * @brief One Gauss-Newton step of a vertex towards the original surface, kept only if the sampled two-sided error falls.
 *
 *     E(x) = sum over the samples of the ring's faces          weight d(sample, its face)^2
 *          + BackWeight * sum over the vertex and the middles  area   d(place, original)^2          mm^4
 *     with b the share of x in the nearest place and n its direction of distance:
 *     H = sum weight b^2 n n^T + damping,   g = sum weight b (n . r) n,   x += H^-1 g
 *
 * H. Hoppe et al., Mesh Optimization, 1993: samples fitted with the nearest places held; A. Fitzgibbon, Robust Registration
 * of 2D and 3D Point Sets, 2003: distances to planes instead of places make the steps long.
 */
#ifndef BoneDecimate_Core_Relax_VertexMover_h
#define BoneDecimate_Core_Relax_VertexMover_h

#include "Collapse/Editor.h"
#include "Reference/BackHints.h"
#include "Reference/Samples.h"

#include <Eigen/Dense>

#include <vector>

namespace bonedecimate
{
class VertexMover
{
public:
  VertexMover(Editor& editor, const Samples& samples, BackHints& hints, int workers)
    : Work(editor)
    , Workers(workers)
    , Fit(samples)
    , Back(hints)
  {
  }

  /// True if the vertex moved.
  bool Improve(Index vertex);

private:
  struct RingFace
  {
    Index Face;
    Vector3 Second, Third;
    double Area;            // mm^2, before the step
    double Facing;          // cosine between face and original, before the step
    Vector3 OriginalNormal; // at the middle, before the step
    Index Hint;             // after the step
  };
  void Gather(Index vertex);
  void AddSamples(const TriangleFrame& frame, Index face);
  PlaceOnMesh AddBack(const Vector3& p, const PlaceOnMesh& found, double share, double weight);
  void Add(const Vector3& residual, const Vector3& direction, double share, double weight);
  Vector3 Step() const;
  bool Lowers(Index vertex, const Vector3& position);
  double ErrorOfFace(RingFace& ring, const TriangleFrame& frame, const Vector3& position) const;

  Editor& Work;
  Workspace Space;
  int Workers;
  const Samples& Fit;
  BackHints& Back;
  std::vector<RingFace> Ring;
  Eigen::Matrix3d Normal = Eigen::Matrix3d::Zero(); // mm^2
  Vector3 Pull = Vector3::Zero();                   // mm^3
  double Error = 0.0;                               // mm^4
  double RingArea = 0.0;                            // mm^2
  Index VertexHint = None;
};
}

#endif
