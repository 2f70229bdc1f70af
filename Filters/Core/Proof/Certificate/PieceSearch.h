// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PieceSearch.h
 * @brief Branch and bound over the pieces of one simplex (Search.h).
 */
#ifndef BoneDecimate_Core_Proof_Certificate_PieceSearch_h
#define BoneDecimate_Core_Proof_Certificate_PieceSearch_h

#include "CutChoice.h"
#include "JointCover.h"
#include "Search.h"

#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <utility>

namespace bonedecimate::certificate
{
class PieceSearch
{
public:
  PieceSearch(const Simplices& source, const Target& target, const PointValues& values,
    const SearchGoal& goal, const MaxExcess& max);

  /// Ends searches early once this returns true. Called after every 1,024 cuts.
  void SetInterruption(std::function<bool()> isInterrupted)
  {
    this->IsInterrupted = std::move(isInterrupted);
  }

  /// mm, an upper bound of the excess of a simplex, without a cut.
  double UpperWithoutCuts(Index simplex) const
  {
    Piece whole = this->Whole(simplex);
    this->Bound(whole, std::numeric_limits<double>::infinity());
    return whole.Upper;
  }

  /// Closes pieces of a simplex with at most maxCuts cuts.
  /// @return mm, an upper bound of the excess of the open pieces; minus infinity if all are closed.
  double Explore(Index simplex, std::int64_t maxCuts);

  /// Searches one simplex independently of all others.
  /// @return mm, an upper bound of its excess, within the gap if maxCuts suffice.
  double UpperOf(Index simplex, std::int64_t maxCuts);

  const MaxExcess& Max() const { return this->MaxFound; }
  /// mm; pieces are closed if their upper bound does not exceed this.
  double ClosingBound() const;
  /// mm, the largest upper bound of the closed pieces.
  double MaxClosedUpper() const { return this->MaxClosed; }
  std::int64_t Cuts() const { return this->CutsMade; }

private:
  struct Parts
  {
    std::array<Piece, 3> Pieces;
    int Count = 0;
    double Upper = -std::numeric_limits<double>::infinity(); // mm, the largest of them
  };

  bool ShouldStop() const
  {
    constexpr std::int64_t period = 1024;
    return this->CutsMade % period == period - 1 && this->IsInterrupted && this->IsInterrupted();
  }
  Piece Whole(Index simplex) const;
  bool CloseAsSame(const Piece& whole);
  void Bound(Piece& piece, double parentUpper) const;
  double UpperOver(const Piece& piece, Index simplex, double bound) const;
  double UpperAt(const PieceCorner& corner, Index simplex) const;
  void UpdateMax(const PieceCorner& corner, Index simplex);
  PieceCorner NewCorner(const Piece& piece, const CutWeights& weights) const;
  Parts Divide(const Piece& piece, const CutWeights& weights, const PieceCorner& corner) const;
  void Cut(const Piece& piece, Index simplex);
  void BoundByCovers(Piece& piece, Index simplex);
  void BoundByOverlay(Piece& piece, Index simplex);
  double Limit() const;
  void BoundJointly(Piece& piece, Index simplex);
  bool AddWithNeighbors(Index simplex);
  bool AddNearest(Index nearest, double limit);
  Index UpdateMaxNear(const Vector3& position, Index hint, const Piece& piece, Index simplex);

  const Simplices& Source;
  const Target& TargetSet;
  const PointValues& Values;
  const SearchGoal& Goal;
  MaxExcess MaxFound;
  double MaxClosed = -std::numeric_limits<double>::infinity(); // mm
  std::int64_t CutsMade = 0;
  std::function<bool()> IsInterrupted; // may be empty
  std::vector<Piece> OpenPieces;
  JointCover CandidateCover;
  std::shared_ptr<OverlayCover> Overlay; // null: covers are not used
};
}

#endif
