// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BulkProof.h
 * @brief Proves a mesh that was made by unproved edits of a journal, all at once, by the provers of
 * ErrorBound.
 *
 *     face:      as it was before the first edit of the journal, or proved by FaceProof
 *     original:  its covering faces before the first edit are all as they were, or
 *                faces near its corners cover it                                    (OriginalProof)
 *     again:     after edits were undone, only faces that are not those proved, and originals that
 *                such a face covers
 *
 * A face is the one that was proved if its last edit in the journal is the same.
 */
#ifndef BoneDecimate_Core_Proof_ErrorBound_BulkProof_h
#define BoneDecimate_Core_Proof_ErrorBound_BulkProof_h

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
  /// @param limits Limits of the original, for what has changed; not above those of the bound. They
  /// must outlive this object.
  BulkProof(ErrorBound& bound, const ErrorLimits& limits, const HalfEdgeMesh& mesh,
    const EditJournal& journal, int threads);

  /// Proves what has changed since the last call. For each face and original that is not proved,
  /// the last edit to undo.
  /// @param current For each original vertex, the vertex of the mesh into which it was merged.
  std::vector<Index> FindFailures(const std::vector<Index>& current);

  /// Proves these originals by the faces as they are, where none has covered any, and makes the
  /// proofs the coverage of the bound.
  /// @return Originals that are not proved.
  std::vector<Index> CoverFirst(
    const std::vector<char>& originals, const std::vector<Index>& current);

  /// Makes the proofs the coverage of the bound. There must be no failures. The journal may be
  /// gone.
  void WriteCoverage();

private:
  /// An original that is not proved.
  struct Failure
  {
    Index Original;
    std::optional<Vector3> Far; // a point of it that is near no face, if one was found
  };

  void FindChanged();
  void ProveFaces();
  std::vector<char> OriginalsToProve() const;
  void ProveOriginals(const std::vector<char>& originals);
  Covering CoveringAtFirst(Index original) const;
  bool IsAsAtFirst(const Covering& covering) const;
  Covering Prove(Index original, CommonFaceProof& proof, std::optional<Vector3>& far) const;
  Index EditToUndo(const Failure& failure, const std::vector<Index>& current) const;
  Index LastEditAt(Index original, const std::vector<Index>& current) const;

  ErrorBound& Shared;
  const ErrorLimits& Allowed;
  const HalfEdgeMesh& Mesh;
  const EditJournal& Journal;
  int Threads;
  OriginalProof Originals;
  CoveringList Found;
  std::vector<Index> ProvedVersion; // of each face, its last edit when it was proved
  std::vector<char> IsChanged;      // of each face, since then
  std::vector<char> IsFaceProved;
  std::vector<Failure> Failures;
};
}

#endif
