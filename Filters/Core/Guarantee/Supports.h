// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Supports.h
 * @brief Which faces of the current mesh prove an original triangle, and which originals a face proves.
 *
 * "Items" are what is proved, "holders" what proves it: triangles and faces, or border edges of both. An item has
 * room for eight holders, one cache line; the slots of one holder are a list that runs through the items. Who changes
 * an item must own all its holders; lists of other holders are then never touched.
 */
#ifndef BoneDecimate_Core_Guarantee_Supports_h
#define BoneDecimate_Core_Guarantee_Supports_h

#include "Surface.h"

#include <array>
#include <atomic>
#include <cstdint>
#include <limits>
#include <vector>

namespace bonedecimate
{
class Supports
{
public:
  static constexpr int MostHolders = 8;

  /// Nothing holds anything yet.
  Supports(Index items, Index holders)
    : Items(static_cast<std::size_t>(items))
    , Firsts(static_cast<std::size_t>(holders), NoSlot)
  {
  }

  /// Calls visit(item, slot) for all that the holder proves.
  template <typename Visit>
  void VisitItems(Index holder, Visit visit) const
  {
    for (SlotId s = this->Firsts[holder]; s != NoSlot; s = this->Slot(s).Next)
    {
      visit(static_cast<Index>(s / MostHolders), static_cast<int>(s % MostHolders));
    }
  }

  /// None where the slot is free.
  Index Holder(Index item, int slot) const
  {
    return this->Items[item][slot].Holder.load(std::memory_order_relaxed);
  }

  /// The holder proves nothing any more; its items still have to be told by Free.
  void Forget(Index holder) { this->Firsts[holder] = NoSlot; }
  void Free(Index item, int slot)
  {
    this->Items[item][slot].Holder.store(None, std::memory_order_relaxed);
  }

  /// There must be a free slot.
  void Add(Index item, Index holder)
  {
    int slot = 0;
    while (this->Holder(item, slot) != None)
    {
      ++slot;
    }
    this->Items[item][slot].Holder.store(holder, std::memory_order_relaxed);
    this->Items[item][slot].Next = this->Firsts[holder];
    this->Firsts[holder] = static_cast<SlotId>(item) * MostHolders + static_cast<SlotId>(slot);
  }

private:
  /// item * MostHolders + slot: of as many items as a mesh may have faces, a quarter of an Index' range.
  using SlotId = std::uint32_t;
  static constexpr SlotId NoSlot = std::numeric_limits<SlotId>::max();
  struct Entry
  {
    std::atomic<Index> Holder{ None }; ///< Others may look whether it is theirs.
    SlotId Next = NoSlot;              ///< Of the same holder.
  };
  const Entry& Slot(SlotId s) const { return this->Items[s / MostHolders][s % MostHolders]; }

  std::vector<std::array<Entry, MostHolders>> Items;
  std::vector<SlotId> Firsts; // of each holder
};
}

#endif
