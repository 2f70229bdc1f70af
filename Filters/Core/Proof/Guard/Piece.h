// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Piece.h
 * @brief Faces with precomputed data for pair tests, and the two rules that do not depend on gaps:
 * whether a patch that replaces another one intersects more of the faces nearby, and whether it
 * jumps over something.
 *
 *     more:   pairs of the patch with what is near and within it that intersect (TrianglePair.h),
 *             after against before;
 *            those that pierce each other are counted by themselves, too, so that none becomes one
 *              that only touched;
 *            both where they will be written
 *     jump:   a corner of what is near lies in the volume that both patches enclose; patches in one
 *             plane enclose none
 */
#ifndef BoneDecimate_Core_Proof_Guard_Piece_h
#define BoneDecimate_Core_Proof_Guard_Piece_h

#include "GapRule.h"
#include "Mesh/HalfEdgeMesh.h"
#include "TrianglePair.h"
#include "WrittenPositions.h"

#include <optional>
#include <vector>

namespace bonedecimate
{
struct Piece : PlaneTriangle
{
  Piece() = default;
  /// Makes a piece without its gap.
  Piece(const HalfEdgeMesh& mesh, const Triangle& vertices, const TriangleCorners& corners);

  Triangle Vertices;                    // their original vertices
  Vector3 Low, High;                    // mm, its box
  Index Fragment = None;                // that it is a part of
  bonedecimate::Gap MinGap;             // of its corners
  double Reach = 0.0;                   // mm, how far from it gaps have to be looked after
  std::optional<PlaneTriangle> Written; // where it will be written; looked up by MeetMore

  Vector3 Normal() const
  {
    return (this->Corners[1] - this->Corners[0])
      .cross(this->Corners[2] - this->Corners[0])
      .normalized();
  }
};

/// mm^2, between the boxes.
double SquaredDistance(const Piece& a, const Piece& b);

/// How many corners both have.
int CountShared(const Piece& a, const Piece& b);

/// mm, the corners of the box around all of them; there is one at least.
Vector3 MinOf(const std::vector<Piece>& pieces);
Vector3 MaxOf(const std::vector<Piece>& pieces);

/// Whether they intersect where they will be written.
bool Meet(Piece& a, Piece& b, const WrittenPositions& written);

/// Whether more pairs intersect, or pierce each other, or more pairs of two fragments intersect,
/// than with the faces that go.
bool MeetMore(std::vector<Piece>& before, std::vector<Piece>& after, std::vector<Piece>& near,
  const WrittenPositions& written);

/// Whether something that is left lies between the faces that go and the new ones; in doubt it
/// does.
bool JumpOver(const std::vector<Piece>& before, const std::vector<Piece>& after,
  const std::vector<Piece>& left);
}

#endif
