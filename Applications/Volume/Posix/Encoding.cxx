// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Readers/Encoding.h"

#include <array>
#include <iconv.h>

namespace bonedecimate::volume
{
std::string Utf8From(const std::string& text, const std::string& encoding)
{
  const iconv_t conversion = iconv_open("UTF-8", encoding.c_str());
  const bool isOpen = conversion != iconv_t(-1);
  std::string bytes = text;
  char* next = bytes.data();
  std::size_t left = bytes.size();
  std::string converted;
  while (left > 0)
  {
    std::array<char, 256> piece{};
    char* end = piece.data();
    std::size_t unused = piece.size();
    const bool isDone = isOpen && iconv(conversion, &next, &left, &end, &unused) != std::size_t(-1);
    converted.append(piece.data(), end);
    if (!isDone && unused > 8) // it did not stop because the piece is full
    {
      converted += !isOpen && static_cast<unsigned char>(*next) < 128 ? *next : '?';
      ++next;
      --left;
    }
  }
  if (isOpen)
  {
    iconv_close(conversion);
  }
  return converted;
}
}
