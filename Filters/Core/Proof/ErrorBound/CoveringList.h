// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CoveringList.h
 * @brief The covering faces of each original while a draft is proved. Nearly all originals have
 * one, so most of them are a number.
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
  std::array<Index, Coverage::SlotsPerItem> Faces;
  int Count = 0;
  bool IsProved = true;

  bool IsOneFace() const { return this->Count == 1 && this->IsProved; }
};

class CoveringList
{
public:
  /// Each original is covered by the face of its own number.
  explicit CoveringList(Index originals);

  std::size_t Count() const { return this->OfOriginal.size(); }
  Covering Of(std::size_t original) const;
  /// Several workers may do so at the same time if it is one face.
  void Set(std::size_t original, const Covering& covering);
  /// @param coverings Number of faces.
  Coverage ToCoverage(Index coverings) const;

private:
  /// Position in Others for a number in OfOriginal that is less than None.
  static std::size_t PositionOf(Index number)
  {
    return static_cast<std::size_t>(None - 1 - number);
  }

  std::vector<Index> OfOriginal; // the face, or less than None: a position
  std::vector<Covering> Others;
};
}

#endif
