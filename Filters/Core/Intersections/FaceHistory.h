// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FaceHistory.h
 * @brief All faces that there were between the edits of a journal, found by box and time.
 *
 *     version:    a face from the edit that made it to the edit that replaced it; edits that were undone never happened
 *     position:   of a vertex from the edit that moved it to the next one
 *
 * So the mesh need not be made again to know what was near an edit, and edits are looked at in parallel. Versions are sorted
 * by size and then by face, because faces lie along a curve that fills space, and versions of very different sizes would spoil each
 * other's boxes.
 */
#ifndef BoneDecimate_Core_Intersections_FaceHistory_h
#define BoneDecimate_Core_Intersections_FaceHistory_h

#include "EditFilters/EditJournal.h"
#include "SpaceTimeTree.h"

#include <array>
#include <optional>
#include <vector>

namespace bonedecimate
{
class FaceHistory
{
public:
  struct Version
  {
    FaceId Face;
    Triangle Vertices;
    std::array<Index, 3> Positions; ///< Of the corners, for CornersOf.
    Index Made;                     ///< The edit that made it; None: it was there before.
  };

  /// @param mesh After the edits of the journal that are not undone. The journal must outlive this object and get no more edits.
  FaceHistory(const HalfEdgeMesh& mesh, const EditJournal& journal);

  /// The faces that an edit replaced, removed ones first, and those that it made.
  const Version& OldFace(Index edit, Index i) const
  {
    return this->Versions[this->OldVersions[this->Journal.Entry(edit).FirstFace + i]];
  }
  /// @param i Not less than the number of removed faces.
  const Version& NewFace(Index edit, Index i) const
  {
    return this->Versions[this->NewVersions[this->Journal.Entry(edit).FirstFace + i]];
  }
  TriangleCorners CornersOf(const Version& version) const; ///< mm

  /// That the edit, on which no other one depends any more, never happened.
  void Undo(Index edit);

  /// Calls visit(version) for each face that meets the box, was there before the edit and is not replaced by it. Number of
  /// edits: after the last one.
  template <typename Visit>
  void VisitAt(const FloatBox& box, Index edit, const Visit& visit) const
  {
    this->Tree->VisitAt(box, edit, [&](std::size_t position) { visit(this->Versions[position]); });
  }

private:
  void AddFirst(const HalfEdgeMesh& mesh);
  void Replace(Index edit);
  void Add(FaceId face, const Triangle& vertices, Index made);
  void SortBySize();

  const EditJournal& Journal;
  std::vector<Vector3> FirstPositions; // mm, of each vertex
  std::vector<Version> Versions;
  std::vector<TimedBox> Boxes;                 // of the versions, while they are added
  std::vector<Index> Current;                  // version of each face, likewise
  std::vector<Index> CurrentPositions;         // of each vertex, likewise
  std::vector<Index> OldVersions, NewVersions; // of each face of the journal
  std::optional<SpaceTimeTree> Tree;           // of the versions
};
}

#endif
