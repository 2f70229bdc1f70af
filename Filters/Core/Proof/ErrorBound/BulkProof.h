// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BulkProof.h
 * @brief Proves at once a mesh that was made by the unproved edits of a journal.
 *
 *     first call:   faces that an edit has replaced                           (FaceProof)
 *                   originals of which a covering face was replaced: faces
 *                   near their corners cover them                             (OriginalProof)
 *     later calls:  faces that have changed since, and originals that such
 *                   a face covered or that were not proved
 *
 * A face has changed if its last edit in the journal is another one. "An original" is a triangle of
 * the original mesh.
 */
#ifndef BoneDecimate_Core_Proof_ErrorBound_BulkProof_h
#define BoneDecimate_Core_Proof_ErrorBound_BulkProof_h

#include "Base/Monitor.h"
#include "CoveringList.h"
#include "ErrorBound.h"
#include "OriginalProof.h"
#include "Proof/EditFilters/EditJournal.h"

#include <optional>
#include <vector>

namespace bonedecimate
{
class BulkProof
{
public:
  /// @param bound Its coverage is that of the mesh before the first edit of the journal.
  /// @param limits Limits of the original for what has changed, at most those of the bound; must
  ///   outlive this object.
  BulkProof(ErrorBound& bound, const ErrorLimits& limits, const HalfEdgeMesh& mesh,
    const EditJournal& journal, int threads);

  /// Proves what has changed since the last call.
  /// @param current For each original vertex, the vertex of the mesh into which it was merged.
  /// @return Edits to undo: one for each face and each original that is not proved. Nothing after
  ///   an abort by the monitor; then this object must not be used again.
  std::optional<std::vector<Index>> FindFailures(
    const std::vector<Index>& current, const Monitor& monitor);

  /// Proves these originals by the faces as they are and writes the coverage. For a mesh that has
  /// no coverage yet.
  /// @return Originals that are not proved.
  std::vector<Index> ProveInitialCoverage(
    const std::vector<char>& originals, const std::vector<Index>& current);

  /// Makes the proofs the coverage of the bound. There must be no failures. Does not read the
  /// journal.
  void WriteCoverage();

private:
  /// An original that is not proved.
  struct Failure
  {
    Index Triangle;
    std::optional<Vector3> FarPosition; // a point of it that is near no face, if one was found
  };

  void FindChanged();
  bool ProveFaces(const Monitor& monitor);
  std::vector<char> OriginalsToProve() const;
  bool ProveOriginals(const std::vector<char>& originals, const Monitor& monitor);
  Covering InitialCovering(Index original) const;
  bool IsUnchanged(const Covering& covering) const;
  Covering Prove(Index original, CommonFaceProof& proof, std::optional<Vector3>& far) const;
  Index EditToUndo(const Failure& failure, const std::vector<Index>& current) const;
  Index LastEditAt(Index original, const std::vector<Index>& current) const;

  ErrorBound& Bound;
  const ErrorLimits& Limits;
  const HalfEdgeMesh& Mesh;
  const EditJournal& Journal;
  int Threads;
  OriginalProof ProofOfOriginals;
  CoveringList Coverings;
  std::vector<Index> ProvedVersion; // of each face, its last edit when it was proved
  std::vector<char> IsChanged;      // of each face, since then
  std::vector<char> IsFaceProved;
  std::vector<Failure> Failures;
};
}

#endif
