// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ChunkedArray.h
 * @brief A list for millions of records. It grows without copying them, whereas a growing vector
 * needs three times its memory.
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
  T& operator[](std::size_t i) { return this->Chunks[i / RecordsPerChunk][i % RecordsPerChunk]; }
  const T& operator[](std::size_t i) const
  {
    return this->Chunks[i / RecordsPerChunk][i % RecordsPerChunk];
  }

  void PushBack(const T& record)
  {
    if (this->Count == RecordsPerChunk * this->Chunks.size())
    {
      this->Chunks.push_back(std::make_unique<T[]>(RecordsPerChunk));
    }
    (*this)[this->Count++] = record;
  }

private:
  static constexpr std::size_t RecordsPerChunk = 1 << 12;

  std::vector<std::unique_ptr<T[]>> Chunks;
  std::size_t Count = 0;
};
}

#endif
