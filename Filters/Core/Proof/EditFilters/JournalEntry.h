// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file JournalEntry.h
 * @brief A collapse in the journal (EditJournal.h). A draft has a collapse for every second
 * triangle of its input, with ten face versions each, so these records are most of its memory.
 */
#ifndef BoneDecimate_Core_Proof_EditFilters_JournalEntry_h
#define BoneDecimate_Core_Proof_EditFilters_JournalEntry_h

#include "Mesh/HalfEdgeMesh.h"

#include <array>
#include <cstdint>
#include <vector>

namespace bonedecimate
{
/// A face from the edit that made it to the edit that replaced it.
struct FaceVersion
{
  FaceId Face;
  Index MadeBy = None; ///< The edit that made it; None: no edit.
  /// Positions of its corners, for EditJournal::VertexAt and PointAt.
  std::array<Index, 3> Positions;
};

struct JournalEntry
{
  VertexId Keep, Gone;
  Vector3 NewPosition = Vector3::Zero();     ///< mm, of Keep.
  std::array<std::array<Index, 3>, 2> Twins; ///< Twins of the edges of the removed faces.
  /// Before the edit: of Keep, Gone and the apexes of the removed faces.
  std::array<HalfEdgeId, 4> Outgoing;
  Index PreviousMerge = None; ///< The edit before this one that merged into Keep.
  Index FirstFace = 0;        ///< First of its old face versions, removed faces first.
  std::uint16_t NumberOfFaces = 0;
  bool IsUndone = false;

  static constexpr Index NumberOfRemovedFaces = 2;
};

/// Unsettled records of a worker. The faces of the entries follow each other.
struct JournalPart
{
  struct Face
  {
    FaceId Id;
    Triangle Corners;
  };
  std::vector<JournalEntry> Entries;
  std::vector<Face> Faces;
};
}

#endif
