// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Guarantee.h
 * @brief The promise: no point of the original farther than a limit from the result, and none of the result from the original.
 *        The limit may differ from vertex to vertex: Limits.h.
 *
 *     Prove(edit):   the new vertex lies within the limit of the original
 *                    every original that a changed face proved is proved again by the new faces   (ShareProof)
 *                    every new face is proved by the original                                     (PieceCover)
 *                    the same for borders, curve to curve
 *     Commit(edit):  who proves whom
 *
 * All proofs are against the original itself, so that no error adds up. What finds candidates may err: then it refuses.
 */
#ifndef BoneDecimate_Core_Guarantee_Guarantee_h
#define BoneDecimate_Core_Guarantee_Guarantee_h

#include "BorderLines.h"
#include "Limits.h"
#include "Mesh/HalfEdgeMesh.h"
#include "Reference/Original.h"
#include "Supports.h"

#include <array>
#include <limits>
#include <memory>
#include <mutex>
#include <vector>

namespace bonedecimate
{
class Prover;

/// What is promised.
struct Promise
{
  /// mm, the limit everywhere
  double Error = std::numeric_limits<double>::infinity();
  bool RoundsToSingle = false;      ///< Whether the result will be written in single precision,
  Vector3 Origin = Vector3::Zero(); ///< mm, relative to this place.
  /// mm, of each vertex of the mesh at first; negative or not a number: none of its own. Null: Error everywhere. Read
  /// only when the guarantee is made.
  const std::vector<double>* Tolerances = nullptr;

  /// Where the point will be when it has been written.
  Vector3 Rounded(const Vector3& position) const;
};

class Guarantee
{
public:
  /// @param atFirst The mesh before the first edit, which must stay, as must its triangles' tree.
  Guarantee(const HalfEdgeMesh& atFirst, const BoundingTree& tree, const Promise& promise);
  ~Guarantee();

  /// Where the point will be when it has been written.
  Vector3 Rounded(const Vector3& position) const { return this->Promised.Rounded(position); }

  /// mm, how far the result may be from an original vertex: slack taken off, never above that of Promise::Error, infinite
  /// where nothing limits, 0 where nothing may change.
  double LimitAt(Index vertex) const { return this->Allowed.At(vertex); }

  /// A prover for one worker, which goes back when it is let go.
  std::shared_ptr<Prover> Lend();

private:
  friend class Prover;

  const HalfEdgeMesh& Source;
  const BoundingTree& Tree;
  Promise Promised;
  Limits Allowed; // a little less than promised: for the rounding of the proof itself
  Supports ByFaces;
  BorderLines Borders;              // of the original: the items of ByBorders
  Supports ByBorders;               // held by half-edges
  std::vector<Index> NearestBorder; // of each vertex: an original border edge near it
  std::vector<Index> Nearest;       // of each vertex of the mesh: an original triangle near it
  /// Originals that could not be proved, the last one first.
  using Witness = std::array<Index, 4>;
  std::vector<Witness> Witnesses; // of each vertex
  std::mutex Lending;
  std::vector<std::unique_ptr<Prover>> Idle;
};
}

#endif
