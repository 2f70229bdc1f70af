// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Coverage.h
 * @brief Which faces of the current mesh prove an original triangle, and which originals a face
 * proves.
 *
 * A covered element is an original triangle, a covering element a current face that proves a part
 * of it. The same class stores boundary edges of both meshes. A covered element has eight slots,
 * one cache line. The slots with one covering element form a linked list.
 *
 * A worker changes the slots of an element only if its range contains all their covering elements,
 * so it never changes the list of another worker. The version of a covered element tells whether
 * its slots have changed since it was read.
 */
#ifndef BoneDecimate_Core_Proof_ErrorBound_Coverage_h
#define BoneDecimate_Core_Proof_ErrorBound_Coverage_h

#include "Geometry/Surface.h"

#include <array>
#include <atomic>
#include <cstdint>
#include <limits>
#include <vector>

namespace bonedecimate
{
class Coverage
{
public:
  static constexpr int SlotsPerElement = 8;
  /// Counts changes. It may wrap around: an edit changes an element at most 16 times, and a version
  /// is compared before the next edit of that element.
  using Version = std::uint8_t;

  /// An empty coverage.
  Coverage() = default;
  /// Initially, no element is covered.
  Coverage(Index items, Index coverings)
    : Items(static_cast<std::size_t>(items))
    , Versions(Items.size(), 0)
    , Firsts(static_cast<std::size_t>(coverings), NoSlot)
  {
  }

  bool IsEmpty() const { return this->Items.empty(); }

  /// Calls visit(covered, slot) for all that the covering element covers.
  template <typename Visit>
  void VisitCovered(Index covering, Visit visit) const
  {
    for (SlotId s = this->Firsts[covering]; s != NoSlot; s = this->Slot(s).Next)
    {
      visit(static_cast<Index>(s / SlotsPerElement), static_cast<int>(s % SlotsPerElement));
    }
  }

  /// None where the slot is free.
  Index CoveringElement(Index item, int slot) const
  {
    return this->Items[item][slot].CoveringElement.load(std::memory_order_relaxed);
  }

  /// Only the worker that may change the element may call this.
  Version VersionOf(Index item) const { return this->Versions[item]; }

  /// Clears the list of the covering element; the caller must free its slots.
  void Forget(Index covering) { this->Firsts[covering] = NoSlot; }
  void Free(Index item, int slot)
  {
    this->Items[item][slot].CoveringElement.store(None, std::memory_order_relaxed);
    ++this->Versions[item];
  }

  /// There must be a free slot.
  void Add(Index item, Index covering)
  {
    int slot = 0;
    while (this->CoveringElement(item, slot) != None)
    {
      ++slot;
    }
    this->Items[item][slot].CoveringElement.store(covering, std::memory_order_relaxed);
    ++this->Versions[item];
    this->Items[item][slot].Next = this->Firsts[covering];
    this->Firsts[covering] =
      static_cast<SlotId>(item) * SlotsPerElement + static_cast<SlotId>(slot);
  }

private:
  /// covered * SlotsPerElement + slot. It fits, because a mesh has at most a quarter of the range
  /// of Index as faces.
  using SlotId = std::uint32_t;
  static constexpr SlotId NoSlot = std::numeric_limits<SlotId>::max();
  struct Entry
  {
    std::atomic<Index> CoveringElement{ None }; ///< Read by other workers.
    SlotId Next = NoSlot;                       ///< Next slot of the same covering element.
  };
  const Entry& Slot(SlotId s) const
  {
    return this->Items[s / SlotsPerElement][s % SlotsPerElement];
  }

  std::vector<std::array<Entry, SlotsPerElement>> Items;
  std::vector<Version> Versions; // of each item
  std::vector<SlotId> Firsts;    // of each covering element
};
}

#endif
