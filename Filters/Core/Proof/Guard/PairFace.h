// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PairFace.h
 * @brief A face with precomputed data for pair tests, and two rules for a patch of faces that
 * replaces another one: whether it intersects more of the faces nearby, and whether it jumps over
 * something.
 *
 *     more:   pairs of the patch with near faces and within it that intersect (TrianglePair.h),
 *             after compared with before; pairs that pierce each other are also counted by
 *             themselves, so that a pair that only touched may not become a piercing one
 *             all at the positions where they will be written
 *     jump:   a corner of a near face lies in the volume that both patches enclose;
 *             patches in one plane enclose none
 */
#ifndef BoneDecimate_Core_Proof_Guard_PairFace_h
#define BoneDecimate_Core_Proof_Guard_PairFace_h

#include "GapRule.h"
#include "Mesh/HalfEdgeMesh.h"
#include "TrianglePair.h"
#include "WrittenPositions.h"

#include <optional>
#include <vector>

namespace bonedecimate
{
struct PairFace : PlaneTriangle
{
  PairFace() = default;
  /// Makes a face without gap, reach and fragment.
  PairFace(const HalfEdgeMesh& mesh, const Triangle& vertices, const TriangleCorners& corners);

  Triangle Vertices;                    // original vertices of the corners
  Vector3 Low, High;                    // mm, its box
  Index Fragment = None;                // of which it is a part
  bonedecimate::Gap MinGap;             // of its corners
  double Reach = 0.0;                   // mm, within which its gaps have to be checked
  std::optional<PlaneTriangle> Written; // where it will be written; set by Meet

  Vector3 Normal() const
  {
    return (this->Corners[1] - this->Corners[0])
      .cross(this->Corners[2] - this->Corners[0])
      .normalized();
  }
};

/// mm^2, between the boxes of two faces.
double SquaredDistance(const PairFace& a, const PairFace& b);

/// mm, lower and upper corner of the box around the faces, at least one.
Vector3 MinOf(const std::vector<PairFace>& faces);
Vector3 MaxOf(const std::vector<PairFace>& faces);

/// Whether two faces intersect where they will be written.
bool Meet(PairFace& a, PairFace& b, const WrittenPositions& written);

/// Whether more pairs intersect, pierce each other, or intersect and belong to two fragments, than
/// before.
bool MeetMore(std::vector<PairFace>& before, std::vector<PairFace>& after,
  std::vector<PairFace>& near, const WrittenPositions& written);

/// Whether a remaining face lies between the old and the new faces; true in doubt.
bool JumpOver(const std::vector<PairFace>& before, const std::vector<PairFace>& after,
  const std::vector<PairFace>& left);
}

#endif
