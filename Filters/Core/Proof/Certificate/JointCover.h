// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file JointCover.h
 * @brief An upper bound of the distance from a triangle T to a few other triangles, the candidates, that together are near all
 *        of T.
 *
 *     piece of T:  a candidate is within the limit of all three corners:    closed; its largest distance bounds the piece
 *                  else halve the longest edge whose ends have no candidate in common, or the longest edge:
 *                      no candidate is within the limit of the new corner:  the caller adds one, or raises the limit
 *
 * Proof. The pieces cover T. The distance to one triangle is a convex function, so on a piece it is largest at a corner. The
 * distance to all candidates is not larger. Any candidates are valid: a poor choice closes fewer pieces.
 *
 * Rounding. Each distance is that to a position of the candidate: its weights are limited to the triangle, however they were
 * found (Foot.h). Of the corners each is the middle of two others, at most MostCorners times in a row.
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
  static constexpr std::size_t MostCandidates = 64;
  static constexpr std::size_t MostCorners = 100; ///< Largest number of corners of all pieces.

  enum class Outcome : int
  {
    Covered = 0,
    Far,     ///< No candidate is within the limit of FarPosition().
    Exceeded ///< There are too many corners.
  };

  JointCover();

  /// Starts with T and no candidates.
  void Begin(const Corners& triangle);
  /// Adds a candidate unless it is one already.
  /// @param id Number by which the caller knows it.  @return False if there are too many.
  bool Add(const Corners& candidate, Index id);
  bool Has(Index id) const;

  /// Continues with the pieces that are not closed.  @param limit mm, not smaller than before.
  /// @param mostCorners At most MostCorners.
  Outcome Run(double limit, std::size_t mostCorners);
  /// mm, the largest bound of a closed piece: a bound of T if it is covered.
  double Upper() const;
  /// mm, in T.
  const Vector3& FarPosition() const { return this->FarCorner.Position; }
  /// The candidate that is nearest to it.
  Index NearestToFar() const;

private:
  using Set = std::uint64_t; // a bit for each candidate
  template <typename T>
  using PerCandidate = std::array<T, MostCandidates>;

  struct Corner
  {
    Vector3 Position = Vector3::Zero(); // mm
    Set Near = 0;                       // within the limit
    PerCandidate<double> Squared;       // mm^2, distances
  };
  using Piece = std::array<std::size_t, 3>; // corners

  std::size_t Groups() const;
  void Measure(Corner& corner, std::size_t first) const;
  void FindNear(Corner& corner) const;
  bool Halve(const Piece& piece);
  void Close(const Piece& piece, Set common);
  std::size_t EdgeToHalve(const Piece& piece) const;

  std::size_t Count = 0;    // of candidates
  std::size_t Measured = 0; // to how many of them, a whole number of groups, distances are known
  // A corner of each candidate and the sides from it, mm; products of the sides, mm^2; inverses, or 0.
  std::array<PerCandidate<double>, 3> A, AB, AC;
  PerCandidate<double> Bb, Bc, Cc, PerBb, PerCc, PerOpposite, PerDeterminant;
  PerCandidate<Index> Ids;
  double SquaredLimit = 0.0; // mm^2
  double SquaredUpper = 0.0; // mm^2
  std::vector<Corner> Known;
  Corner FarCorner;
  std::vector<Piece> Open;
};
}

#endif
