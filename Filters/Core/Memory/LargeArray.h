// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LargeArray.h
 * @brief Vectors for millions of records: in large pages where the system has them, and not filled before they are written.
 *
 * Neighbours in a mesh lie in many small pages, more than the processor remembers the places of; and every small page
 * is fetched and cleared by the system one by one. `LargeArray<T>(n)` and `resize` leave records as they were found:
 * whoever makes one writes every record; those of types with constructors are constructed as always.
 */
#ifndef BoneDecimate_Core_Memory_LargeArray_h
#define BoneDecimate_Core_Memory_LargeArray_h

#include <cstddef>
#include <new>
#include <utility>
#include <vector>

namespace bonedecimate
{
/// Throws std::bad_alloc.
void* AllocateLarge(std::size_t bytes);
void FreeLarge(void* memory, std::size_t bytes) noexcept;

template <typename T>
class LargeAllocator
{
public:
  using value_type = T;

  LargeAllocator() = default;
  template <typename Other>
  LargeAllocator(const LargeAllocator<Other>&) noexcept
  {
  }

  T* allocate(std::size_t count) { return static_cast<T*>(AllocateLarge(count * sizeof(T))); }
  void deallocate(T* memory, std::size_t count) noexcept { FreeLarge(memory, count * sizeof(T)); }

  template <typename Made>
  void construct(Made* place) noexcept
  {
    ::new (static_cast<void*>(place)) Made;
  }
  template <typename Made, typename... Arguments>
  void construct(Made* place, Arguments&&... arguments)
  {
    ::new (static_cast<void*>(place)) Made(std::forward<Arguments>(arguments)...);
  }

  friend bool operator==(const LargeAllocator&, const LargeAllocator&) { return true; }
  friend bool operator!=(const LargeAllocator&, const LargeAllocator&) { return false; }
};

template <typename T>
using LargeArray = std::vector<T, LargeAllocator<T>>;

/// Only a wish; of the pages that lie wholly within, before they are written.
void AskForLargePages(void* memory, std::size_t bytes) noexcept;

/// Room for so many in an ordinary vector that is empty, in large pages as far as they fit in.
template <typename T>
void ReserveLarge(std::vector<T>& values, std::size_t count)
{
  values.reserve(count);
  AskForLargePages(values.data(), count * sizeof(T));
}
}

#endif
