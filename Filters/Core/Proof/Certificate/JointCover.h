// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file JointCover.h
 * @brief An upper bound of the distance from a triangle T, or from parts of it, to a few other
 * triangles, the candidates, that together are near all of it.
 *
 *     piece of T:  a candidate is within the limit of all three corners:
 *                      closed; its largest distance at a corner bounds the piece
 *                  else halve the longest edge whose ends have no candidate in common,
 *                    or the longest edge:
 *                      no candidate is within the limit of the new corner:
 *                          far; the caller adds a candidate or raises the limit
 *
 * Proof. The pieces cover T. The distance to one triangle is a convex function, so on a piece it is
 * largest at a corner. The distance to all candidates is not larger. Any candidates are valid: a
 * poor choice closes fewer pieces.
 *
 * Rounding. A candidate is measured in a frame of its own, with two axes in its plane. The axes are
 * orthogonal up to a few u, for needles, too, so distances to the plane and to the sides are wrong
 * by less than 100 u of the extent. A foot on the inner side of all sides by more than the slack is
 * in the triangle. Each new corner is the midpoint of two others, at most MaxCorners times in a row
 * (Foot.h).
 */
#ifndef BoneDecimate_Core_Proof_Certificate_JointCover_h
#define BoneDecimate_Core_Proof_Certificate_JointCover_h

#include "Foot.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace bonedecimate::certificate
{
class JointCover
{
public:
  static constexpr std::size_t MaxCandidates = 64;
  static constexpr std::size_t MaxCorners = 100; ///< Largest number of corners of all pieces.

  enum class Outcome : int
  {
    Covered = 0,
    Far,     ///< No candidate is within the limit of FarPosition().
    Exceeded ///< There are too many corners.
  };

  JointCover();

  /// Starts without candidates and with nothing to cover.
  /// @param slack mm, more than the rounding error of a coordinate in the frame of a candidate.
  void Begin(double slack);
  /// Adds a convex polygon that has to be covered.
  /// @param count Number of its corners; all polygons together have at most MaxCorners.
  void Cover(const Vector3* corners, std::size_t count);
  /// Takes into account a part with this known bound, mm.
  void Raise(double upper);
  /// Adds a candidate unless it is one already.
  /// @param id The caller's number of the candidate.
  /// @return False if there are too many.
  bool Add(const Corners& candidate, Index id);
  bool Has(Index id) const;

  /// Continues with the open pieces.
  /// @param limit mm, not smaller than before.
  /// @param maxCorners At most MaxCorners.
  Outcome Run(double limit, std::size_t maxCorners);
  /// mm, the largest bound of a closed piece; after Covered, a bound of everything.
  double Upper() const;
  /// mm
  const Vector3& FarPosition() const { return this->FarCorner.Position; }
  /// The candidate nearest to FarPosition().
  Index NearestToFar() const;

private:
  using CandidateSet = std::uint64_t; // a bit for each candidate
  template <typename T>
  using PerCandidate = std::array<T, MaxCandidates>;

  struct Corner
  {
    Vector3 Position;             // mm
    CandidateSet NearCandidates;  // candidates within the limit
    PerCandidate<double> Squared; // mm^2, distances to the candidates
  };
  using Piece = std::array<std::size_t, 3>; // corners

  std::size_t RoundedCount() const;
  void Measure(Corner& corner, std::size_t first) const;
  void FindNear(Corner& corner) const;
  bool Halve(const Piece& piece);
  void Close(const Piece& piece, CandidateSet common);
  std::size_t EdgeToHalve(const Piece& piece) const;

  std::size_t NumberOfCandidates = 0;
  std::size_t MeasuredCandidates = 0; // whole groups to which the corners have distances
  std::size_t InitialCorners = 0;     // corners of the polygons
  // For each candidate its first corner A (mm), and the axes of its frame; W is the normal.
  std::array<PerCandidate<double>, 3> A, U, V, W;
  // For each side of a candidate its direction, and in mm the position of its middle along this
  // direction, half of its length and its position across.
  std::array<PerCandidate<double>, 3> AlongU, AlongV;
  std::array<PerCandidate<double>, 3> MiddleAlong, HalfLength, OffsetAcross;
  PerCandidate<Index> Ids;
  double Margin = 0.0;       // mm
  double SquaredLimit = 0.0; // mm^2
  double SquaredUpper = 0.0; // mm^2
  std::vector<Corner> PieceCorners;
  Corner FarCorner;
  std::vector<Piece> OpenPieces;
};
}

#endif
