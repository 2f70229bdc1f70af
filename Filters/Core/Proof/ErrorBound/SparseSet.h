// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SparseSet.h
 * @brief A small set of ids out of many, each with its data, cleared in constant time.
 *
 * P. Briggs, L. Torczon, An efficient representation for sparse sets, 1993.
 */
#ifndef BoneDecimate_Core_Proof_ErrorBound_SparseSet_h
#define BoneDecimate_Core_Proof_ErrorBound_SparseSet_h

#include "Geometry/Surface.h"

#include <vector>

namespace bonedecimate
{
/// @tparam Entry Has a member Id.
template <typename Entry>
class SparseSet
{
public:
  explicit SparseSet(Index ids)
    : Positions(static_cast<std::size_t>(ids), 0)
  {
  }
  void Clear() { this->Entries.clear(); }

  /// The position of the entry with this id; None if there is none.
  Index Find(Index id) const
  {
    const Index position = this->Positions[id];
    return position < static_cast<Index>(this->Entries.size()) && this->Entries[position].Id == id
      ? position
      : None;
  }
  /// @param entry Must not be there yet.
  Index Insert(const Entry& entry)
  {
    const Index position = static_cast<Index>(this->Entries.size());
    this->Positions[entry.Id] = position;
    this->Entries.push_back(entry);
    return position;
  }

  Entry& operator[](Index position) { return this->Entries[position]; }
  const Entry& operator[](Index position) const { return this->Entries[position]; }
  auto begin() const { return this->Entries.begin(); }
  auto end() const { return this->Entries.end(); }
  auto begin() { return this->Entries.begin(); }
  auto end() { return this->Entries.end(); }
  Index Size() const { return static_cast<Index>(this->Entries.size()); }

private:
  std::vector<Index> Positions;
  std::vector<Entry> Entries;
};
}

#endif
