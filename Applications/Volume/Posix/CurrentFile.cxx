// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "CurrentFile.h"

#include "FilePath.h"

#include <algorithm>
#include <cstddef>
#include <sys/mman.h>

namespace bonedecimate::volume
{
namespace
{
constexpr std::size_t Longest = 1024; // a name has 255 bytes at most

/// In memory that a child has in common with its parent.
char* SharedName()
{
  static char* const name = []
  {
    void* const memory =
      mmap(nullptr, Longest, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    return memory == MAP_FAILED ? nullptr : static_cast<char*>(memory);
  }();
  return name;
}
}

void ResetCurrentFile()
{
  SetCurrentFile(std::string());
}

void SetCurrentFile(const std::string& path)
{
  char* const name = SharedName();
  if (name)
  {
    const std::string text = FilePath(path).filename().string().substr(0, Longest - 1);
    std::copy(text.begin(), text.end(), name);
    name[text.size()] = '\0';
  }
}

std::string CurrentFile()
{
  const char* const name = SharedName();
  return name ? std::string(name, std::find(name, name + Longest, '\0')) : std::string();
}
}
