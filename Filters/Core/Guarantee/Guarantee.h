// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Guarantee.h
 * @brief The promise: no point of the original farther than a limit from the result, and none of the result from the original.
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
#include "Mesh/HalfEdgeMesh.h"
#include "Reference/Original.h"
#include "Supports.h"

#include <memory>
#include <mutex>
#include <vector>

namespace bonedecimate
{
class Prover;

/// What is promised.
struct Promise
{
  double Error = 0.0;               ///< mm, the limit everywhere
  bool RoundsToSingle = false;      ///< Whether the result will be written in single precision,
  Vector3 Origin = Vector3::Zero(); ///< mm, relative to this place.
};

class Guarantee
{
public:
  /// @param atFirst The mesh before the first edit, which must stay, as must its triangles' tree.
  Guarantee(const HalfEdgeMesh& atFirst, const BoundingTree& tree, const Promise& promise);
  ~Guarantee();

  /// Where the point will be when it has been written.
  Vector3 Rounded(const Vector3& position) const;

  /// A prover for one worker, which goes back when it is let go.
  std::shared_ptr<Prover> Lend();

private:
  friend class Prover;

  const HalfEdgeMesh& Source;
  const BoundingTree& Tree;
  Promise Promised;
  double Limit; // mm, a little less than promised: for the rounding of the proof itself
  Supports ByFaces;
  BorderLines Borders;              // of the original: the items of ByBorders
  Supports ByBorders;               // held by half-edges
  std::vector<Index> NearestBorder; // of each vertex: an original border edge near it
  std::vector<Index> Nearest;       // of each vertex of the mesh: an original triangle near it
  std::vector<Index> Witnesses; // of each vertex: the original that could not be proved last time
  std::mutex Lending;
  std::vector<std::unique_ptr<Prover>> Idle;
};
}

#endif
