// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LargeArray.h
 * @brief Vectors for millions of records: in large pages where the system has them, and without
 * initialization.
 *
 * The neighbors of a vertex spread over more small pages than the translation buffer of the
 * processor holds, and the system maps and clears small pages one by one. `LargeArray<T>(n)` and
 * `resize` leave trivial records uninitialized, so the caller has to write every record. Types with
 * constructors are constructed as usual.
 */
#ifndef BoneDecimate_Core_Base_LargeArray_h
#define BoneDecimate_Core_Base_LargeArray_h

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
  void construct(Made* object) noexcept
  {
    ::new (static_cast<void*>(object)) Made;
  }
  template <typename Made, typename... Arguments>
  void construct(Made* object, Arguments&&... arguments)
  {
    ::new (static_cast<void*>(object)) Made(std::forward<Arguments>(arguments)...);
  }

  friend bool operator==(const LargeAllocator&, const LargeAllocator&) { return true; }
  friend bool operator!=(const LargeAllocator&, const LargeAllocator&) { return false; }
};

template <typename T>
using LargeArray = std::vector<T, LargeAllocator<T>>;

/// Requests large pages within the memory, before it is written; may have no effect.
void RequestLargePages(void* memory, std::size_t bytes) noexcept;

/// Reserves capacity in an ordinary, empty vector, in large pages as far as they fit.
template <typename T>
void ReserveLarge(std::vector<T>& values, std::size_t count)
{
  values.reserve(count);
  RequestLargePages(values.data(), count * sizeof(T));
}
}

#endif
