// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file EditJournal.h
 * @brief Records what each collapse replaces, so that it can be undone. It is the last edit filter
 * and accepts everything.
 *
 *     entry:      the vertices, the new position, what Editor::Undo cannot derive,
 *                 and the versions of its faces
 *     version:    a face from one of its edits to the next, with the positions of its corners then
 *     position:   of a vertex from one of its edits to the next: the id of the vertex before the
 *                 first edit, number of vertices + edit after an edit
 *     chains:     of each face and of each merged vertex, its edits from the last to the first
 *     undo e:     first every later edit of one of the faces of e, then
 *                 restore the faces (Editor::Undo)
 *
 * An edit depends only on the versions of its faces and on the positions of their corners, and
 * every edit that moves a corner replaces all faces there. So the remaining edits, in their order,
 * are a valid sequence of edits, and each replaces the same faces by the same faces as when it was
 * made.
 */
#ifndef BoneDecimate_Core_Proof_EditFilters_EditJournal_h
#define BoneDecimate_Core_Proof_EditFilters_EditJournal_h

#include "Base/ChunkedArray.h"
#include "EditFilter.h"

#include <vector>

namespace bonedecimate
{
class EditJournal : public EditFilter
{
public:
  /// @param mesh Before the first collapse that is recorded.
  explicit EditJournal(const HalfEdgeMesh& mesh);

  Decision Check(const HalfEdgeMesh& mesh, const SurfaceChange& change,
    EditFilter::Pending& pending) const override;
  void Commit(const HalfEdgeMesh& mesh, const SurfaceChange& change, EditFilter::Pending& pending,
    Tally& tally) override;
  void Settle(Tally* tallies, std::size_t count) override;
  std::shared_ptr<EditFilter::Pending> MakePending() override;
  bool NeedsSurfaceChange() const override { return true; }

  /// Edits that were recorded, undone ones included.
  Index Count() const { return static_cast<Index>(this->Entries.Size()); }
  Index NumberOfUndone() const { return this->UndoneCount; }
  const JournalEntry& Entry(Index edit) const { return this->Entries[edit]; }

  /// A face version. Those of an entry are consecutive from JournalEntry::FirstFace.
  const FaceVersion& Version(Index version) const { return this->Versions[version]; }
  /// The faces that an edit replaced, removed ones first.
  const FaceVersion& OldFace(Index edit, Index i) const
  {
    return this->Versions[this->Entries[edit].FirstFace + i];
  }
  /// The face that the edit made of an old one. @param i Not less than the number of removed faces.
  FaceVersion NewFace(Index edit, Index i) const;
  /// A face as it is now.
  FaceVersion LastVersion(FaceId face, const Triangle& corners) const;

  VertexId VertexAt(Index position) const
  {
    const Index vertices = static_cast<Index>(this->InitialPositions.size());
    return position < vertices ? VertexId(position) : this->Entries[position - vertices].Keep;
  }
  const Vector3& PointAt(Index position) const ///< mm
  {
    const Index vertices = static_cast<Index>(this->InitialPositions.size());
    return position < vertices ? this->InitialPositions[position]
                               : this->Entries[position - vertices].NewPosition;
  }
  Triangle VerticesOf(const FaceVersion& face) const
  {
    return { this->VertexAt(face.Positions[0]), this->VertexAt(face.Positions[1]),
      this->VertexAt(face.Positions[2]) };
  }
  std::array<Vector3, 3> CornersOf(const FaceVersion& face) const ///< mm
  {
    return { this->PointAt(face.Positions[0]), this->PointAt(face.Positions[1]),
      this->PointAt(face.Positions[2]) };
  }

  /// The last edit of a face that is not undone; None if there is none.
  Index LastEditOf(FaceId face) const { return this->LastEdits[face]; }
  /// Whether an edit that is not undone has replaced or removed the face.
  bool IsChanged(FaceId face) const { return this->LastEdits[face] != None; }

  /// mm, where the vertex was before the edit that merged into it.
  const Vector3& OldPosition(const JournalEntry& entry) const
  {
    return entry.PreviousMerge == None ? this->InitialPositions[entry.Keep]
                                       : this->Entries[entry.PreviousMerge].NewPosition;
  }
  /// Whether the mesh stored the first normal of a face before the first edit.
  bool HadInitialNormal(FaceId face) const { return this->HadInitialNormals[face]; }

  /// The edit and all later edits that depend on it, the last first: the order in which to undo
  /// them.
  std::vector<Index> DependentsOf(Index edit) const;
  /// Removes the edit from the chains. No remaining edit may depend on it.
  void Remove(Index edit);

private:
  struct Pending : public EditFilter::Pending
  {
    JournalEntry Entry;
    std::vector<JournalPart::Face> Faces;
  };
  void Link(JournalEntry entry, const JournalPart::Face* faces);
  Index PositionOf(VertexId vertex) const;
  Index MakerOf(Index edit, FaceId face) const;

  std::vector<Vector3> InitialPositions; // mm, of each vertex
  std::vector<bool> HadInitialNormals;   // of each face
  ChunkedArray<JournalEntry> Entries;
  ChunkedArray<FaceVersion> Versions; // all that were replaced
  std::vector<Index> LastEdits;       // of each face
  std::vector<Index> LastMerges;      // of each vertex, the last edit that merged into it
  Index UndoneCount = 0;
};
}

#endif
