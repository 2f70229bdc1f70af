// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BorderProof.h
 * @brief Whether every point of a segment lies within a limit of one of several segments, proved.
 *
 * As in ShareProof.h: the distance to a segment is a convex function, so that two ends which share a segment prove all
 * between them; where they share none, both halves are proved.
 */
#ifndef BoneDecimate_Core_Guarantee_BorderProof_h
#define BoneDecimate_Core_Guarantee_BorderProof_h

#include "Surface.h"

#include <array>
#include <vector>

namespace bonedecimate
{
class BorderProof
{
public:
  using Segment = std::array<Vector3, 2>; // mm

  std::vector<Segment> Candidates;

  /// mm^2, of p to a place that lies on the segment.
  static double SquaredReach(const Segment& segment, const Vector3& p);

  /// @param limit mm.  @param visit Called with the place of each candidate that proves a part.
  template <typename Visit>
  bool Prove(const Segment& whole, double limit, Visit visit)
  {
    this->Open.assign(1, whole);
    for (int pieces = 0; !this->Open.empty(); ++pieces)
    {
      const Segment piece = this->Open.back();
      this->Open.pop_back();
      const std::size_t shared = this->SharedBy(piece, limit);
      if (shared < this->Candidates.size())
      {
        visit(shared);
        continue;
      }
      if (pieces >= MostPieces)
      {
        return false;
      }
      const Vector3 middle = 0.5 * (piece[0] + piece[1]);
      this->Open.push_back({ piece[0], middle });
      this->Open.push_back({ middle, piece[1] });
    }
    return true;
  }

private:
  static constexpr int MostPieces = 64;

  /// The first candidate within the limit of both ends; their number if there is none.
  std::size_t SharedBy(const Segment& piece, double limit) const;

  std::vector<Segment> Open;
};
}

#endif
