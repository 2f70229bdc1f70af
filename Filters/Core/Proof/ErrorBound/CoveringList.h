// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CoveringList.h
 * @brief The covering faces of each original while a draft is proved. Nearly all originals have
 * one, which is stored as a number.
 */
#ifndef BoneDecimate_Core_Proof_ErrorBound_CoveringList_h
#define BoneDecimate_Core_Proof_ErrorBound_CoveringList_h

#include "Coverage.h"

#include <array>
#include <vector>

namespace bonedecimate
{
struct Covering
{
  std::array<Index, Coverage::SlotsPerElement> Faces;
  int Count = 0;
  bool IsProved = true;

  bool IsOneFace() const { return this->Count == 1 && this->IsProved; }
};

class CoveringList
{
public:
  /// Initially, each original is covered by the face with its number.
  explicit CoveringList(Index originals);

  std::size_t Count() const { return this->FacesOrPositions.size(); }
  Covering Of(std::size_t original) const;
  /// Several workers may call this at the same time for coverings of one face.
  void Set(std::size_t original, const Covering& covering);
  /// @param coverings Number of faces.
  Coverage ToCoverage(Index coverings) const;

private:
  /// Position in CoveringsBySeveral of a number less than None.
  static std::size_t PositionOf(Index number)
  {
    return static_cast<std::size_t>(None - 1 - number);
  }

  std::vector<Index> FacesOrPositions; // of each original: a face, or less than None: PositionOf()
  std::vector<Covering> CoveringsBySeveral;
};
}

#endif
