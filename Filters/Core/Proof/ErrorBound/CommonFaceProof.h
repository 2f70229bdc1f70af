// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CommonFaceProof.h
 * @brief Proves that every point of a triangle lies within its limit of some of a few candidate
 * faces.
 *
 * The distance to a face is a convex function. So if all three corners are near one face, every
 * point between them is. The same holds for distance - limit if the limit is linear on the
 * triangle.
 *
 *     near(corner) = the candidates within the corner's limit and within their own
 *     piece:  if the three corners have a candidate in common: proved
 *             else split an edge, preferably one whose ends have no candidate in common,
 *               where it leaves the prism over a face near its start, or else in the middle:
 *               no candidate near the new corner: too far
 *               else prove both halves, larger pieces first
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
  /// Pieces of an original triangle after which its proof is given up. With fewer, good edits are
  /// rejected.
  static constexpr std::size_t MaxPieces = 256;

  struct Corner
  {
    Vector3 Position; // mm
    double Limit;     // mm
    Faces NearCandidates;
  };
  using Piece = std::array<Corner, 3>;

  CommonFaceProof();

  /// Keeps only the first `count` candidates.
  void Resize(std::size_t count) { this->Count = count; }
  /// @param maxDistance mm, a limit of this candidate that holds in addition to those of the
  ///   corners.
  void AddCandidate(const std::array<Vector3, 3>& corners,
    double maxDistance = std::numeric_limits<double>::infinity());

  /// The candidates within the limit (mm) of p and within their own.
  Faces FacesNear(const Vector3& p, double limit);
  /// Squared distance of the last point passed to FacesNear from a candidate, mm^2.
  double SquaredDistance(std::size_t candidate) const { return this->SquaredDistances[candidate]; }

  /// @param used Receives the candidates that prove the pieces. Those already set are preferred.
  /// @param maxPieces Number of pieces after which the proof is given up.
  CommonFaceResult Prove(const Piece& whole, Faces& used, std::size_t maxPieces);
  /// After TooFar, the point that was near no candidate.
  const Vector3& FarPosition() const { return this->FarPoint; }

private:
  Corner Between(const Corner& from, const Corner& to, double t);
  double ExitFraction(const Corner& from, const Corner& to) const;
  bool Split(const Piece& piece);
  bool IsFar(const Corner& corner);
  std::array<double, 3> Weights(std::size_t candidate, const Vector3& p) const;

  const Kernels& Compute;
  std::array<TriangleBatch, MaxCandidates / TriangleBatch::Size> Candidates;
  std::size_t Count = 0;
  std::array<double, MaxCandidates> MaxDistances;     // mm
  std::array<double, MaxCandidates> SquaredDistances; // mm^2
  std::vector<Piece> OpenPieces;
  Vector3 FarPoint = Vector3::Zero();
};
}

#endif
