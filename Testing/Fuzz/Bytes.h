// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Bytes.h
 * @brief Reads the bytes of a fuzzer from the front; 0 after the end.
 */
#ifndef BoneDecimate_Testing_Bytes_h
#define BoneDecimate_Testing_Bytes_h

#include <cstddef>
#include <cstdint>

namespace bonedecimate::testsupport
{
class Bytes
{
public:
  Bytes(const std::uint8_t* data, std::size_t size)
    : Data(data)
    , Left(size)
  {
  }

  bool IsEmpty() const { return this->Left == 0; }
  std::size_t Count() const { return this->Left; }
  const std::uint8_t* Rest() const { return this->Data; }

  int Next()
  {
    if (this->Left == 0)
    {
      return 0;
    }
    --this->Left;
    return *this->Data++;
  }

  bool Switch() { return this->Next() % 2 == 1; }

  /// 0 to count - 1.
  int Below(int count) { return this->Next() % count; }

private:
  const std::uint8_t* Data;
  std::size_t Left;
};
}

/// Ends the program if the condition does not hold.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

#endif
