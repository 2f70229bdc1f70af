// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Readers/Encoding.h"

#include <algorithm>
#include <map>
#include <windows.h>

namespace bonedecimate::volume
{
namespace
{
constexpr UINT Unknown = 0;

UINT CodePageOf(const std::string& encoding)
{
  static const std::map<std::string, UINT> pages{ { "ISO-8859-1", 28591 }, { "ISO-8859-2", 28592 },
    { "ISO-8859-3", 28593 }, { "ISO-8859-4", 28594 }, { "ISO-8859-5", 28595 },
    { "ISO-8859-6", 28596 }, { "ISO-8859-7", 28597 }, { "ISO-8859-8", 28598 },
    { "ISO-8859-9", 28599 }, { "ISO-8859-15", 28605 }, { "TIS-620", 874 }, { "UTF-8", CP_UTF8 },
    { "GB18030", 54936 }, { "GBK", 936 } };
  const auto found = pages.find(encoding);
  return found != pages.end() && IsValidCodePage(found->second) ? found->second : Unknown;
}

std::string OnlyAscii(std::string text)
{
  std::replace_if(
    text.begin(), text.end(), [](char letter) { return static_cast<unsigned char>(letter) > 127; },
    '?');
  return text;
}
}

std::string Utf8From(const std::string& text, const std::string& encoding)
{
  const UINT page = CodePageOf(encoding);
  if (page == Unknown)
  {
    return OnlyAscii(text);
  }
  const auto size = static_cast<int>(text.size());
  std::wstring wide(text.size(), L'\0'); // no encoding has more of these than bytes
  wide.resize(
    static_cast<std::size_t>(MultiByteToWideChar(page, 0, text.data(), size, wide.data(), size)));
  std::replace(wide.begin(), wide.end(), L'\xFFFD', L'?');
  std::string converted(3 * wide.size(), '\0');
  converted.resize(static_cast<std::size_t>(
    WideCharToMultiByte(CP_UTF8, 0, wide.data(), static_cast<int>(wide.size()), converted.data(),
      static_cast<int>(converted.size()), nullptr, nullptr)));
  return converted;
}
}
