// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file EditJournal.h
 * @brief Records what each collapse replaces, so that it can be undone: the last of the edit filters, accepts everything.
 *
 *     entry:    the vertices, their positions and half-edges before the edit, and the records of its faces
 *     chains:   of each face and of each merged vertex, its edits from the last to the first
 *     undo e:   first every later edit of one of the faces of e, then restore the records (Editor::Undo)
 *
 * An edit depends on the records of its faces and on the positions of their corners alone, and every edit that moves a corner
 * replaces all faces there. So the edits that are left are a valid sequence of edits, in their order, and each replaces the same faces
 * by the same faces as when it was made.
 */
#ifndef BoneDecimate_Core_EditFilters_EditJournal_h
#define BoneDecimate_Core_EditFilters_EditJournal_h

#include "EditFilter.h"

#include <vector>

namespace bonedecimate
{
class EditJournal : public EditFilter
{
public:
  /// @param mesh Whose collapses are recorded; it must outlive this object.
  explicit EditJournal(const HalfEdgeMesh& mesh);

  Decision Check(const HalfEdgeMesh& mesh, const ProposedEdit& edit,
    EditFilter::Pending& pending) const override;
  void Commit(const HalfEdgeMesh& mesh, const ProposedEdit& edit, EditFilter::Pending& pending,
    Tally& tally) override;
  void Settle(Tally* tallies, std::size_t count) override;
  std::shared_ptr<EditFilter::Pending> MakePending() override;
  bool NeedsSurfaceChange() const override { return true; }

  /// Edits that were recorded, undone ones included.
  Index Count() const { return static_cast<Index>(this->Entries.size()); }
  Index NumberOfUndone() const { return this->Undone; }

  /// Of all entries together; JournalEntry::FirstFace counts them.
  Index NumberOfFaceRecords() const { return static_cast<Index>(this->Faces.size()); }

  const JournalEntry& Entry(Index edit) const { return this->Entries[edit]; }
  const JournalFace& FaceOf(Index edit, Index i) const
  {
    return this->Faces[this->Entries[edit].FirstFace + i];
  }

  /// The last edit of a face that is not undone; None if there is none.
  Index LastOfFace(FaceId face) const { return this->OfFace[face]; }
  /// Whether an edit that is not undone has replaced or removed the face.
  bool IsChanged(FaceId face) const { return this->OfFace[face] != None; }

  /// mm, before the edit; Count(): at the end.
  Vector3 PositionBefore(VertexId vertex, Index edit) const;

  /// The edit and all later edits that depend on it, the last first: the order in which to undo them.
  std::vector<Index> DependentsOf(Index edit) const;
  /// Takes the edit out of the chains; nothing that is left may depend on it.
  void Remove(Index edit);

private:
  struct Pending : public EditFilter::Pending
  {
    JournalEntry Entry;
    std::vector<JournalFace> Faces;
  };
  void Link(JournalEntry entry, const JournalFace* faces);

  const HalfEdgeMesh& Mesh;
  std::vector<JournalEntry> Entries;
  std::vector<JournalFace> Faces;
  std::vector<Index> OfFace;   // the last edit of each face
  std::vector<Index> OfVertex; // the last edit that merged into each vertex
  Index Undone = 0;
};
}

#endif
