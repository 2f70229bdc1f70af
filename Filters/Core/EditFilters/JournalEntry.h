// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file JournalEntry.h
 * @brief A collapse in the journal (EditJournal.h).
 */
#ifndef BoneDecimate_Core_EditFilters_JournalEntry_h
#define BoneDecimate_Core_EditFilters_JournalEntry_h

#include "Mesh/HalfEdgeMesh.h"

#include <array>
#include <vector>

namespace bonedecimate
{
/// A face as it was before the edit. The record is copied because its alignment would double the size.
struct JournalFace
{
  FaceId Id;
  Index Before; ///< The edit of the face before this one; None: the first.
  std::array<Index, 4> Origins, Twins;

  Triangle Corners() const { return { this->Origins[0], this->Origins[1], this->Origins[2] }; }
};

struct JournalEntry
{
  VertexId Keep, Gone;
  Vector3 OldPosition = Vector3::Zero(); ///< mm, of Keep.
  Vector3 NewPosition = Vector3::Zero();
  std::array<VertexId, 2> Apexes;
  std::array<HalfEdgeId, 4> Outgoing; ///< Before the edit, of Keep, Gone and the apexes.
  Index Before = None;                ///< The edit before this one that merged into Keep.
  Index FirstFace = 0;                ///< Removed faces first.
  std::uint16_t NumberOfFaces = 0;
  std::uint8_t NumberOfGoneFaces = 0;
  bool IsUndone = false;
};

/// What a worker has recorded since it was settled last; the faces of one entry after those of another.
struct JournalPart
{
  std::vector<JournalEntry> Entries;
  std::vector<JournalFace> Faces;
};
}

#endif
