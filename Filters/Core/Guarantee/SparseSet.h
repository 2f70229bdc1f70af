// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SparseSet.h
 * @brief A few ids of very many, each with what belongs to it, emptied in no time.
 *
 * P. Briggs, L. Torczon, An efficient representation for sparse sets, 1993.
 */
#ifndef BoneDecimate_Core_Guarantee_SparseSet_h
#define BoneDecimate_Core_Guarantee_SparseSet_h

#include "Surface.h"

#include <vector>

namespace bonedecimate
{
/// @tparam Entry Has a member Id.
template <typename Entry>
class SparseSet
{
public:
  explicit SparseSet(Index ids)
    : Places(static_cast<std::size_t>(ids), 0)
  {
  }
  void Clear() { this->Entries.clear(); }

  /// The place of the id among the entries; None if it is not there.
  Index Find(Index id) const
  {
    const Index place = this->Places[id];
    return place < static_cast<Index>(this->Entries.size()) && this->Entries[place].Id == id ? place
                                                                                             : None;
  }
  /// @param entry Must not be there yet.
  Index Insert(const Entry& entry)
  {
    const Index place = static_cast<Index>(this->Entries.size());
    this->Places[entry.Id] = place;
    this->Entries.push_back(entry);
    return place;
  }

  Entry& operator[](Index place) { return this->Entries[place]; }
  const Entry& operator[](Index place) const { return this->Entries[place]; }
  auto begin() const { return this->Entries.begin(); }
  auto end() const { return this->Entries.end(); }
  auto begin() { return this->Entries.begin(); }
  auto end() { return this->Entries.end(); }
  Index Size() const { return static_cast<Index>(this->Entries.size()); }

private:
  std::vector<Index> Places;
  std::vector<Entry> Entries;
};
}

#endif
