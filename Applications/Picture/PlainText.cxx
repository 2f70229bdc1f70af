// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PlainText.h"

#include <algorithm>
#include <cstdint>

namespace bonedecimate
{
namespace
{
unsigned int ByteAt(std::string_view text, std::size_t i)
{
  return static_cast<unsigned char>(text[i]);
}

/// By the first byte; 0 if no character begins with it.
std::size_t AnnouncedLength(unsigned int first)
{
  return first < 0x80 ? 1
    : first < 0xc2    ? 0
    : first < 0xe0    ? 2
    : first < 0xf0    ? 3
    : first < 0xf5    ? 4
                      : 0;
}

/// Overlong forms, halves of a pair and what is beyond Unicode are none.
bool IsCharacter(std::uint32_t code, std::size_t length)
{
  constexpr std::uint32_t least[] = { 0, 0, 0x80, 0x800, 0x10000 };
  return code >= least[length] && code <= 0x10ffff && (code < 0xd800 || code > 0xdfff);
}

bool IsPlain(std::uint32_t code)
{
  const bool isControl = code < 0x20 || (code >= 0x7f && code < 0xa0);
  const bool isLineEnd = code == 0x2028 || code == 0x2029;
  const bool isDirection = code == 0x200e || code == 0x200f || (code >= 0x202a && code <= 0x202e) ||
    (code >= 0x2066 && code <= 0x2069);
  const bool isNone = (code & 0xfffe) == 0xfffe || (code >= 0xfdd0 && code <= 0xfdef);
  return !isControl && !isLineEnd && !isDirection && !isNone;
}
}

std::size_t LengthOfPlainCharacter(std::string_view text)
{
  const std::size_t length = text.empty() ? 0 : AnnouncedLength(ByteAt(text, 0));
  if (length == 0 || length > text.size())
  {
    return 0;
  }
  std::uint32_t code = ByteAt(text, 0) & (length == 1 ? 0x7fU : 0xffU >> (length + 1));
  for (std::size_t i = 1; i < length; ++i)
  {
    const unsigned int byte = ByteAt(text, i);
    if ((byte & 0xc0) != 0x80)
    {
      return 0;
    }
    code = code << 6 | (byte & 0x3f);
  }
  return IsCharacter(code, length) && IsPlain(code) ? length : 0;
}

std::string PlainText(std::string_view text)
{
  std::string plain;
  while (!text.empty())
  {
    const std::size_t length = LengthOfPlainCharacter(text);
    plain += length > 0 ? text.substr(0, length) : std::string_view("?");
    text.remove_prefix(length > 0 ? length : 1);
  }
  return plain;
}

std::size_t NumberOfCharacters(std::string_view text)
{
  const std::string plain = PlainText(text);
  return static_cast<std::size_t>(std::count_if(plain.begin(), plain.end(),
    [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; }));
}
}
