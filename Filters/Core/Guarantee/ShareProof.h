// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ShareProof.h
 * @brief Whether every point of a triangle lies within a limit of some of a few candidate faces, proved.
 *
 * The distance to a face is a convex function: if all three corners are near enough to one face, so is every point
 * between them, and this holds for distance - limit, too, where the limit is linear on the triangle.
 *
 *     near(corner) = the candidates within the corner's limit
 *     piece:  a corner without any:          refused
 *             all three share a candidate:   proved
 *             else split the edge whose ends share none where it leaves the prism over a face near its start,
 *             or the longest edge in the middle, and prove both halves
 */
#ifndef BoneDecimate_Core_Guarantee_ShareProof_h
#define BoneDecimate_Core_Guarantee_ShareProof_h

#include "Kernels/Kernels.h"

#include <array>
#include <cstdint>
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

class ShareProof
{
public:
  using Faces = std::uint64_t; ///< A bit for each candidate.
  static constexpr std::size_t MostCandidates = 64;

  struct Corner
  {
    Vector3 Place; // mm
    double Limit;  // mm
    Faces Near;
  };
  using Piece = std::array<Corner, 3>;

  ShareProof();

  /// Only the first `count` candidates stay.
  void Resize(std::size_t count) { this->Count = count; }
  std::size_t NumberOfCandidates() const { return this->Count; }
  void AddCandidate(const std::array<Vector3, 3>& corners);

  /// Those that lie within the limit (mm) of p.
  Faces FacesNear(const Vector3& p, double limit);
  /// mm^2, of the point asked about last to a candidate.
  double SquaredDistance(std::size_t candidate) const { return this->Squared[candidate]; }

  /// @param used The candidates that prove it, added to those given, which are preferred.
  bool Prove(const Piece& whole, Faces& used);

private:
  Corner Between(const Corner& from, const Corner& to, double t);
  double ExitFraction(const Corner& from, const Corner& to) const;
  std::array<Piece, 2> Split(const Piece& piece);
  std::array<double, 3> Weights(std::size_t candidate, const Vector3& p) const;

  const Kernels& Compute;
  std::array<TriangleBatch, MostCandidates / TriangleBatch::Size> Candidates;
  std::size_t Count = 0;
  std::array<double, MostCandidates> Squared; // mm^2
  std::vector<Piece> Open;
};
}

#endif
