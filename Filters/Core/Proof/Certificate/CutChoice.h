// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CutChoice.h
 * @brief Chooses where to cut a piece of a simplex so that its parts can be closed.
 */
#ifndef BoneDecimate_Core_Proof_Certificate_CutChoice_h
#define BoneDecimate_Core_Proof_Certificate_CutChoice_h

#include "Target.h"

#include <array>
#include <optional>

namespace bonedecimate::certificate
{
struct PieceCorner
{
  Vector3 Position = Vector3::Zero(); // mm
  double Tolerance = 0.0;             // mm
  double Value = 0.0;                 // mm, Target::ValueTo(Nearest)
  Index Nearest = None;               // a simplex of the target
  bool IsStored = false; // a corner of the source simplex: its coordinates are not rounded
};

/// A part of a simplex with one, two or three corners.
struct Piece
{
  std::array<PieceCorner, 3> Corners;
  double Upper = 0.0; // mm, bound of the excess, widened by the slack
  int Count = 0;
  int Depth = 0;
};

/// Barycentric weights of the new corner, sum 1; the piece is cut into one part for each positive
/// weight.
using CutWeights = std::array<double, 3>;

class CutChoice
{
public:
  /// @param goal mm; a piece is closed if its excess, widened by the slack, is proved not to exceed
  ///   it.
  CutChoice(const Target& target, double goal, double slack)
    : TargetSet(target)
    , ClosingBound(goal)
    , Slack(slack)
  {
  }

  /**
   * Cuts the longest edge in the middle if a few cuts make pieces so small that they can be closed
   * by their size. Otherwise cuts
   *
   *     at a vertex that lies under the piece and belongs to several candidates, or
   *     on the longest edge whose ends have no common candidate, where both candidates are
   *       equally far
   *
   * Each part then lies over one candidate. Where both surfaces are flat, the bounds become exact
   * after finitely many cuts.
   */
  CutWeights Choose(const Piece& piece) const;

private:
  struct Edge
  {
    int From = 0;
    int To = 0;
    double SquaredLength = -1.0; // mm^2
    double FromToOther = 0.0;    // mm, value of the end From to the candidate of the end To
    double ToToOther = 0.0;
  };

  static int NumberOfEdges(const Piece& piece) { return piece.Count == 3 ? 3 : 1; }
  static Edge EdgeOf(const Piece& piece, int from);
  static Edge LongestEdge(const Piece& piece);
  static CutWeights OnEdge(const Edge& edge, double fraction);
  bool ClosesBySize(const Piece& piece, double longest) const;
  std::optional<CutWeights> CommonVertex(const Piece& piece) const;
  Edge LongestUnsharedEdge(const Piece& piece) const;
  bool IsUnshared(const Piece& piece, Edge& edge) const;
  double EqualFraction(const Piece& piece, const Edge& edge) const;

  const Target& TargetSet;
  double ClosingBound; // mm
  double Slack;        // mm
};
}

#endif
