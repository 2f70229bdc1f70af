// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BoundaryProof.h
 * @brief Whether every point of a segment lies within its limit of one of several segments, proved.
 *
 * As in CommonFaceProof.h: the distance to a segment is a convex function. So if both ends are near a common segment, all
 * points between them are; otherwise both halves are proved.
 */
#ifndef BoneDecimate_Core_Proof_ErrorBound_BoundaryProof_h
#define BoneDecimate_Core_Proof_ErrorBound_BoundaryProof_h

#include "ErrorLimits.h"
#include "Geometry/Surface.h"

#include <array>
#include <vector>

namespace bonedecimate
{
class BoundaryProof
{
public:
  using Segment = std::array<Vector3, 2>; // mm
  struct Piece
  {
    Segment Ends;
    std::array<double, 2> ErrorLimits; // mm, at the ends, linear in between; see ErrorLimits.h
  };

  std::vector<Segment> Candidates;

  /// mm^2, of p to a point on the segment.
  static double SquaredReach(const Segment& segment, const Vector3& p);

  /// @param visit Called with the index of each candidate that proves a part.
  template <typename Visit>
  bool Prove(const Piece& whole, Visit visit)
  {
    this->Open.assign(1, whole);
    for (int pieces = 0; !this->Open.empty(); ++pieces)
    {
      const Piece piece = this->Open.back();
      this->Open.pop_back();
      const std::size_t shared = this->SharedBy(piece);
      if (shared < this->Candidates.size())
      {
        visit(shared);
        continue;
      }
      if (pieces >= MaxPieces)
      {
        return false;
      }
      const Vector3 middle = 0.5 * (piece.Ends[0] + piece.Ends[1]);
      const double limit = ErrorLimits::Between(piece.ErrorLimits[0], piece.ErrorLimits[1], 0.5);
      this->Open.push_back({ { piece.Ends[0], middle }, { piece.ErrorLimits[0], limit } });
      this->Open.push_back({ { middle, piece.Ends[1] }, { limit, piece.ErrorLimits[1] } });
    }
    return true;
  }

private:
  static constexpr int MaxPieces = 64;

  /// The first candidate within the limits of both ends; their number if there is none.
  std::size_t SharedBy(const Piece& piece) const;

  std::vector<Piece> Open;
};
}

#endif
