// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "GltfBytes.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <iterator>

namespace bonedecimate
{
namespace
{
template <typename Number>
double NumberAt(const char* bytes)
{
  Number number;
  std::memcpy(&number, bytes, sizeof(Number));
  return static_cast<double>(number);
}

const ComponentRow ComponentTypes[] = { { 5120, 1, NumberAt<std::int8_t>, 127.0 },
  { 5121, 1, NumberAt<std::uint8_t>, 255.0 }, { 5122, 2, NumberAt<std::int16_t>, 32767.0 },
  { 5123, 2, NumberAt<std::uint16_t>, 65535.0 }, { 5125, 4, NumberAt<std::uint32_t>, 4294967295.0 },
  { 5126, 4, NumberAt<float>, 1.0 } };
}

std::string BytesOfBase64(std::string_view text)
{
  static constexpr std::string_view digits =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  unsigned int bits = 0;
  int count = 0;
  for (const char character : text)
  {
    const std::size_t digit = digits.find(character);
    if (digit == std::string_view::npos)
    {
      break;
    }
    bits = bits << 6 | static_cast<unsigned int>(digit);
    count += 6;
    if (count >= 8)
    {
      count -= 8;
      bytes += static_cast<char>(bits >> count & 0xFF);
    }
  }
  return bytes;
}

const ComponentRow* FindComponent(int type)
{
  const auto* const found = std::find_if(std::begin(ComponentTypes), std::end(ComponentTypes),
    [type](const ComponentRow& row) { return row.Type == type; });
  return found == std::end(ComponentTypes) ? nullptr : found;
}
}
