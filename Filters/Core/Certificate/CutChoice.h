// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CutChoice.h
 * @brief A piece of a simplex, and where to cut it so that its parts can be closed.
 */
#ifndef BoneDecimate_Core_Certificate_CutChoice_h
#define BoneDecimate_Core_Certificate_CutChoice_h

#include "Target.h"

#include <array>
#include <optional>

namespace bonedecimate::certificate
{
struct PieceCorner
{
  Vector3 Place = Vector3::Zero(); // mm
  double Tolerance = 0.0;          // mm
  double Value = 0.0;              // mm, to the target
  Index Nearest = None;            // of the target, the simplex with that value
  bool IsGiven = false; // a corner of the simplex, with the coordinates as they are stored
};

/// Of one, two or three corners.
struct Piece
{
  std::array<PieceCorner, 3> Corners;
  double Upper = 0.0; // mm, of the excess, widened by the slack
  int Count = 0;
  int Depth = 0;
};

/// Of the corners of a piece, sum 1; a piece becomes as many as there are positive ones.
using CutWeights = std::array<double, 3>;

class CutChoice
{
public:
  /// @param goal mm; a piece is closed if its excess, widened by the slack, is proved to be at most this.
  CutChoice(const Target& target, double goal, double slack)
    : To(target)
    , Goal(goal)
    , Slack(slack)
  {
  }

  /**
   * In the middle of the longest edge while pieces can be closed by their size. Else at a vertex that lies under the
   * piece and belongs to several candidates; or on the longest edge whose ends share no candidate, where both are
   * equally far. Then the parts lie over one candidate each, and bounds become exact: after finitely many cuts where
   * both surfaces are flat.
   */
  CutWeights Choose(const Piece& piece) const;

private:
  struct Edge
  {
    int From = 0;
    int To = 0;
    double SquaredLength = -1.0; // mm^2
    double FromToOther = 0.0;    // mm, value of the one end over the candidate of the other
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

  const Target& To;
  double Goal;  // mm
  double Slack; // mm
};
}

#endif
