// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file JointCover.h
 * @brief An upper bound of the distance from a triangle T, or from parts of it, to a few other
 * triangles, the candidates, that together are near all of it.
 *
 *     piece of T:  a candidate is within the limit of all three corners:    closed; its largest
 *       distance bounds the piece
 *                  else halve the longest edge whose ends have no candidate in common, or the
 *                    longest edge:
 *                      no candidate is within the limit of the new corner:  the caller adds one, or
 *                        raises the limit
 *
 * Proof. The pieces cover T. The distance to one triangle is a convex function, so on a piece it is
 * largest at a corner. The distance to all candidates is not larger. Any candidates are valid: a
 * poor choice closes fewer pieces.
 *
 * Rounding. A candidate is measured in coordinates of its own, of which two lie in its plane. Their
 * axes are orthogonal but for a few u, for needles, too, so distances to the plane and to the sides
 * are wrong by less than 100 u of the extent. A foot on the inner side of all sides by more than
 * the slack is in the triangle. Of the corners each is the middle of two others, at most MaxCorners
 * times in a row (Foot.h).
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
  /// Adds a convex polygon to what is to be covered.
  /// @param count Number of its corners; all polygons together have at most MaxCorners.
  void Cover(const Vector3* corners, std::size_t count);
  /// Adds a part that is known to have this bound, mm.
  void Raise(double upper);
  /// Adds a candidate unless it is one already.
  /// @param id Number by which the caller knows it.  @return False if there are too many.
  bool Add(const Corners& candidate, Index id);
  bool Has(Index id) const;

  /// Continues with the pieces that are not closed.  @param limit mm, not smaller than before.
  /// @param mostCorners At most MaxCorners.
  Outcome Run(double limit, std::size_t mostCorners);
  /// mm, the largest bound of a closed piece: a bound of everything if it is covered.
  double Upper() const;
  /// mm
  const Vector3& FarPosition() const { return this->FarCorner.Position; }
  /// The candidate that is nearest to it.
  Index NearestToFar() const;

private:
  using Set = std::uint64_t; // a bit for each candidate
  template <typename T>
  using PerCandidate = std::array<T, MaxCandidates>;

  struct Corner
  {
    Vector3 Position;             // mm
    Set Near;                     // within the limit
    PerCandidate<double> Squared; // mm^2, distances
  };
  using Piece = std::array<std::size_t, 3>; // corners

  std::size_t Groups() const;
  void Measure(Corner& corner, std::size_t first) const;
  void FindNear(Corner& corner) const;
  bool Halve(const Piece& piece);
  void Close(const Piece& piece, Set common);
  std::size_t EdgeToHalve(const Piece& piece) const;

  std::size_t Count = 0;    // of candidates
  std::size_t Given = 0;    // corners
  std::size_t Measured = 0; // to how many of them, a whole number of groups, distances are known
  // For each candidate the first corner, mm, the axes of its frame, of which the third is the
  // normal, and its sides in it.
  std::array<PerCandidate<double>, 3> A, U, V, W;
  std::array<PerCandidate<double>, 3> AlongU, AlongV; // directions of the sides
  std::array<PerCandidate<double>, 3> Middle, Half,
    At; // mm: along the side, half of its length, across it
  PerCandidate<Index> Ids;
  double Margin = 0.0;       // mm
  double SquaredLimit = 0.0; // mm^2
  double SquaredUpper = 0.0; // mm^2
  std::vector<Corner> Known;
  Corner FarCorner;
  std::vector<Piece> Open;
};
}

#endif
