// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PieceCover.h
 * @brief Proves piece by piece that every point of a triangle or segment lies within the limits of
 * a large target.
 *
 *     piece:  every corner is nearer to the target than the limit there, by the reach
 *             of the piece or more:                                                       proved
 *             the part nearest to one corner is within its limit of the others, too:      proved
 *             a corner is farther from its nearest part than the limit:                   rejected
 *             else split the longest edge in the middle, and prove both halves
 *     reach:  every point of a triangle is within longest edge / sqrt(3) of a corner,
 *             every point of a segment within half of its length
 *
 * The search for the nearest part may fail; that can only cause a rejection.
 */
#ifndef BoneDecimate_Core_Proof_ErrorBound_PieceCover_h
#define BoneDecimate_Core_Proof_ErrorBound_PieceCover_h

#include "Geometry/Surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace bonedecimate
{
/// @tparam Corners 3 for triangles, 2 for segments.
template <std::size_t Corners>
class PieceCover
{
public:
  struct Corner
  {
    Vector3 Position; // mm
    Index Nearest;    // part of the target
    double Distance;  // mm, to this part
  };
  using Piece = std::array<Corner, Corners>;

  /// @param target Has Find(p, hint) that returns a Corner; Distance(p, id), mm; Limit(id), mm.
  template <typename Target>
  bool Prove(const Target& target, const Piece& whole)
  {
    this->OpenPieces.assign(1, whole);
    for (int pieces = 0; !this->OpenPieces.empty(); ++pieces)
    {
      const Piece piece = this->OpenPieces.back();
      this->OpenPieces.pop_back();
      if (pieces == MaxPieces || !IsWithin(target, piece, 0.0))
      {
        return false;
      }
      const std::size_t edge = LongestEdge(piece);
      const std::size_t next = (edge + 1) % Corners;
      const double length = (piece[next].Position - piece[edge].Position).norm();
      if (IsWithin(target, piece, length * Reach) || HasCommonFace(target, piece))
      {
        continue;
      }
      const Corner middle =
        target.Find(0.5 * (piece[edge].Position + piece[next].Position), piece[edge].Nearest);
      this->OpenPieces.push_back(piece);
      this->OpenPieces.back()[next] = middle;
      this->OpenPieces.push_back(piece);
      this->OpenPieces.back()[edge] = middle;
    }
    return true;
  }

private:
  static constexpr int MaxPieces = 4096;
  static constexpr double Reach = Corners == 3 ? 0.57735026919 : 0.5; // 1 / sqrt(3), rounded up

  static std::size_t LongestEdge(const Piece& piece)
  {
    std::size_t longest = 0;
    double length = -1.0; // mm^2
    for (std::size_t i = 0; i < Corners; ++i)
    {
      const double squared = (piece[(i + 1) % Corners].Position - piece[i].Position).squaredNorm();
      if (squared > length)
      {
        longest = i;
        length = squared;
      }
    }
    return longest;
  }

  template <typename Target>
  static bool IsWithin(const Target& target, const Piece& piece, double radius)
  {
    return std::all_of(piece.begin(), piece.end(),
      [&](const Corner& corner)
      { return corner.Distance + radius <= target.Limit(corner.Nearest); });
  }

  template <typename Target>
  static bool HasCommonFace(const Target& target, const Piece& piece)
  {
    return std::any_of(piece.begin(), piece.end(),
      [&](const Corner& owner)
      {
        const Index id = owner.Nearest;
        const double limit = target.Limit(id);
        return std::all_of(piece.begin(), piece.end(),
          [&](const Corner& corner)
          { return corner.Nearest == id || target.Distance(corner.Position, id) <= limit; });
      });
  }

  std::vector<Piece> OpenPieces;
};
}

#endif
