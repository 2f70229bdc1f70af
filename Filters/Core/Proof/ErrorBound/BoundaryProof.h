// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BoundaryProof.h
 * @brief Proves that every point of a segment lies within its limit of one of several candidate
 * segments.
 *
 * The distance to a segment is a convex function. So if both ends are near one candidate, all
 * points between them are; otherwise both halves are proved. CommonFaceProof.h does the same for
 * triangles.
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
    std::array<double, 2> Limits; // mm, at the ends; linear in between
  };

  std::vector<Segment> Candidates;

  /// mm^2, from p to the segment.
  static double SquaredDistance(const Segment& segment, const Vector3& p);

  /// @param visit Called with the index of each candidate that proves a part.
  template <typename Visit>
  bool Prove(const Piece& whole, Visit visit)
  {
    this->OpenPieces.assign(1, whole);
    for (int pieces = 0; !this->OpenPieces.empty(); ++pieces)
    {
      const Piece piece = this->OpenPieces.back();
      this->OpenPieces.pop_back();
      const std::size_t shared = this->FindCommon(piece);
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
      const double limit = ErrorLimits::Interpolate(piece.Limits[0], piece.Limits[1], 0.5);
      this->OpenPieces.push_back({ { piece.Ends[0], middle }, { piece.Limits[0], limit } });
      this->OpenPieces.push_back({ { middle, piece.Ends[1] }, { limit, piece.Limits[1] } });
    }
    return true;
  }

private:
  static constexpr int MaxPieces = 64;

  /// The first candidate within the limits of both ends; the number of candidates if there is none.
  std::size_t FindCommon(const Piece& piece) const;

  std::vector<Piece> OpenPieces;
};
}

#endif
