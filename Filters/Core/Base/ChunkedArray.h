// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ChunkedArray.h
 * @brief A list of millions of records that grows without copies: a vector needs three times its
 * memory while it grows.
 */
#ifndef BoneDecimate_Core_Base_ChunkedArray_h
#define BoneDecimate_Core_Base_ChunkedArray_h

#include <cstddef>
#include <memory>
#include <vector>

namespace bonedecimate
{
template <typename T>
class ChunkedArray
{
public:
  std::size_t Size() const { return this->Count; }
  T& operator[](std::size_t i) { return this->Chunks[i / OfChunk][i % OfChunk]; }
  const T& operator[](std::size_t i) const { return this->Chunks[i / OfChunk][i % OfChunk]; }

  void PushBack(const T& record)
  {
    if (this->Count == OfChunk * this->Chunks.size())
    {
      this->Chunks.push_back(std::make_unique<T[]>(OfChunk));
    }
    (*this)[this->Count++] = record;
  }

private:
  static constexpr std::size_t OfChunk = 1 << 12;

  std::vector<std::unique_ptr<T[]>> Chunks;
  std::size_t Count = 0;
};
}

#endif
