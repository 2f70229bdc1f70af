// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CommonFaceProof.h
 * @brief Whether every point of a triangle lies within a limit of some of a few candidate faces,
 * proved.
 *
 * The distance to a face is a convex function: if all three corners are near enough to one face, so
 * is every point between them, and this holds for distance - limit, too, where the limit is linear
 * on the triangle.
 *
 *     near(corner) = the candidates within the corner's limit and their own
 *     piece:  all three corners have a common candidate:   proved
 *             else split an edge whose ends have none where it leaves the prism over a face near
 *             its start, or the longest edge in the middle:
 *                 nothing near the new corner:       too far
 *                 else prove both halves, larger pieces first
 */
#ifndef BoneDecimate_Core_Proof_ErrorBound_CommonFaceProof_h
#define BoneDecimate_Core_Proof_ErrorBound_CommonFaceProof_h

#include "Decimate/Kernels/Kernels.h"

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

namespace bonedecimate
{
inline std::size_t CountBits(std::uint64_t bits)
{
  std::size_t count = 0;
  for (; bits != 0; bits &= bits - 1)
  {
    ++count;
  }
  return count;
}

enum class CommonFaceResult
{
  Proved,
  TooFar, ///< A point was found that is near no candidate.
  Unknown ///< The pieces became too many.
};

class CommonFaceProof
{
public:
  using Faces = std::uint64_t; ///< A bit for each candidate.
  static constexpr std::size_t MaxCandidates = 64;

  struct Corner
  {
    Vector3 Position; // mm
    double Limit;     // mm
    Faces Near;
  };
  using Piece = std::array<Corner, 3>;

  CommonFaceProof();

  /// Keeps only the first `count` candidates.
  void Resize(std::size_t count) { this->Count = count; }
  /// @param most mm, within which it proves anything, however large a corner's limit is.
  void AddCandidate(
    const std::array<Vector3, 3>& corners, double most = std::numeric_limits<double>::infinity());

  /// Candidates that lie within the limit (mm) of p, and within their own limit.
  Faces FacesNear(const Vector3& p, double limit);
  /// Squared distance of the last point passed to FacesNear from a candidate, mm^2.
  double SquaredDistance(std::size_t candidate) const { return this->Squared[candidate]; }

  /// @param used Receives the candidates that prove it, added to those already set, which are
  ///   preferred.
  /// @param mostPieces Most pieces before the proof is given up: with too few, good edits are
  ///   rejected.
  CommonFaceResult Prove(const Piece& whole, Faces& used, std::size_t mostPieces);
  /// After TooFar, the point that was near no candidate.
  const Vector3& FarPosition() const { return this->Far; }

private:
  Corner Between(const Corner& from, const Corner& to, double t);
  double ExitFraction(const Corner& from, const Corner& to) const;
  bool Split(const Piece& piece);
  bool IsFar(const Corner& corner);
  std::array<double, 3> Weights(std::size_t candidate, const Vector3& p) const;

  const Kernels& Compute;
  std::array<TriangleBatch, MaxCandidates / TriangleBatch::Size> Candidates;
  std::size_t Count = 0;
  std::array<double, MaxCandidates> Most;    // mm
  std::array<double, MaxCandidates> Squared; // mm^2
  std::vector<Piece> Open;
  Vector3 Far = Vector3::Zero();
};
}

#endif
